#version 300 es
// One more frame on top of the sum so far.
uniform sampler2D frame;
uniform sampler2D sum;
uniform bool first;
out vec4 fragmentColor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 value = texelFetch(frame, pixel, 0);
    fragmentColor = first ? value : texelFetch(sum, pixel, 0) + value;
}
