#version 300 es
// A sum of frames with the environment, blurred, where nothing was drawn.
uniform sampler2D sum;
uniform float frames;
uniform samplerCube blurred;
uniform float level;
in vec4 rayDir;
out vec4 fragmentColor;

void main() {
    vec4 drawn = texelFetch(sum, ivec2(gl_FragCoord.xy), 0);
    fragmentColor = vec4(drawn.rgb + (frames - drawn.a) * textureLod(blurred, rayDir.xyz, level).rgb, frames);
}
