#version 300 es
// One case of cases.h on the inputs of one pixel.
#include "tests/parity/cases.h"

uniform int which;
uniform sampler2D inputA;
uniform sampler2D inputB;
uniform sampler2D inputC;
out vec4 result;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    result = caseResult(which, texelFetch(inputA, pixel, 0), texelFetch(inputB, pixel, 0), texelFetch(inputC, pixel, 0));
}
