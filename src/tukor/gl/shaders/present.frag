#version 300 es
// The accumulated picture on the screen: exposure, tone mapping, sRGB encoding.
#include "tukor/image/tonemap.h"
uniform sampler2D sum;
uniform vec2 sumPerPixel;  // texels of `sum` to one pixel of the target
uniform vec2 corner;       // of the target, in pixels of its framebuffer
uniform float factor;      // radiance times exposure of one unit of the sum
uniform float coverage;    // of one unit of the sum
uniform int tonemap;
uniform vec3 behind;  // linear colour where nothing was drawn
out vec4 fragmentColor;

// Bilinear by hand: 32-bit float textures need not filter.
vec4 sumAt(vec2 place) {
    vec2 low = floor(place - 0.5);
    vec2 part = place - 0.5 - low;
    ivec2 last = textureSize(sum, 0) - 1;
    ivec2 a = clamp(ivec2(low), ivec2(0), last);
    ivec2 b = clamp(ivec2(low) + 1, ivec2(0), last);
    return mix(mix(texelFetch(sum, a, 0), texelFetch(sum, ivec2(b.x, a.y), 0), part.x),
               mix(texelFetch(sum, ivec2(a.x, b.y), 0), texelFetch(sum, b, 0), part.x), part.y);
}

void main() {
    vec4 total = sumAt((gl_FragCoord.xy - corner) * sumPerPixel);
    vec3 shown = clamp(mapped(tonemap, total.rgb * factor), 0.0, 1.0);
    float part = clamp(total.a * coverage, 0.0, 1.0);
    fragmentColor = vec4(srgbFromLinear(shown + (1.0 - part) * behind), 1.0);
}
