#version 300 es
// The environment itself: lecture row 20.
#include "tukor/gl/shaders/environment.glsl"
in vec4 rayDir;
out vec4 fragmentColor;

void main() {
    // Affine in the pixel's place, so that derivatives are exact; of any length. Also where a texel
    // covers many pixels the mean of several look-ups counts: beside a sun the slope is steep.
    fragmentColor = vec4(footprintRadiance(rayDir.xyz), 1.0);
}
