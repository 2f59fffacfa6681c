#version 300 es
// The environment itself: lecture row 20.
#include "tukor/gl/shaders/environment.glsl"
uniform bool magnified;  // a pixel is smaller than a texel: one look-up shows all there is
in vec4 rayDir;
out vec4 fragmentColor;

void main() {
    vec3 d = rayDir.xyz;  // affine in the pixel's place, so that derivatives are exact; any length
    if (magnified)
        fragmentColor = vec4(
            environmentRadiance(d + footprintMiddle.x * dFdx(d) + footprintMiddle.y * dFdy(d), 0.0), 1.0);
    else
        fragmentColor = vec4(footprintRadiance(d), 1.0);
}
