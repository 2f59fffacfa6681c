#version 300 es
// Tells every pixel where it is, and a shared function's value there.
#include "tukor/optics/fresnel.h"
uniform float eta;
out vec4 fragmentColor;
void main() {
    fragmentColor = vec4(gl_FragCoord.xy, fresnelDielectric(gl_FragCoord.x / 16.0, eta), FROM_DEFINE);
}
