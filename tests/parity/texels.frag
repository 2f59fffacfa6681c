#version 300 es
// Every texel of a texture, as it is.
precision highp float;
precision highp sampler2D;
uniform sampler2D texels;
out vec4 fragmentColor;
void main() {
    fragmentColor = texelFetch(texels, ivec2(gl_FragCoord.xy), 0);
}
