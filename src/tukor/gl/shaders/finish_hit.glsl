// Surfaces with a finish as reflected and refracted rays meet them: the split sum of base and coat, with the textures of
// colour, metallic-roughness and emission at lower resolution. Their own reflection shows the environment alone, and
// nothing shadows anything.
//
// DETAILS: there are texture coordinates or colours. Figures of a part follow its three texels of traced.frag:
//
//     3   base colour, alpha                    6   emission, coat
//     4   metallic, roughness, specular weight, transmission
//     5   F0, alpha cutoff                      7   image from uv, by columns
//     8   its last column, layers and wrapping as bits of one, roughness of the coat
#include "tukor/gl/shaders/lamplight.glsl"
#include "tukor/gl/shaders/split_sum.glsl"

precision highp sampler2DArray;
#ifdef DETAILS
uniform usampler2D details;     // three texels a triangle: coordinates of its corners, and their colours, 8 bits of roots
uniform sampler2DArray layers;  // pictures, with wrapping done here
#endif
uniform float unlitFactor;  // from radiance to units of the environment's texels
uniform sampler2D raster;   // what the camera sees of them directly, alpha where it sees nothing else

const uint kFinished = 1u;  // bits of the fourth number of a part's first texel
const uint kMasked = 2u;
const uint kBlended = 4u;
const uint kUnlit = 8u;
const uint kThin = 16u;

vec4 partFigures(int part, int i) {
    return uintBitsToFloat(texelFetch(surfaces, ivec2(9 * (part & 127) + i, part >> 7), 0));
}

#ifdef DETAILS
vec4 rootsOf(uint word) {
    vec4 c = bvhBytes(word) / 255.0;
    return vec4(c.rgb * c.rgb, c.a);
}

float wrapped(float x, uint mode) {
    if (mode == 0u) return x;
    return mode == 1u ? 1.0 - abs(mod(x, 2.0) - 1.0) : clamp(x, 0.002, 0.998);
}
#endif

struct FinishLook {
    vec3 L;
    float alpha;
};

// `kind` holds the flags of the part, `at` is the branch on the surface.
FinishLook finishLook(uint kind, int part, BvhHit found, SurfaceHit hit, Encounter met, Branch at) {
    FinishLook look;
    vec4 base = partFigures(part, 3);
    vec4 figures = partFigures(part, 4);
    vec4 edge = partFigures(part, 5);
    vec4 Le = partFigures(part, 6);
    vec4 more = partFigures(part, 8);
#ifdef DETAILS
    int width = textureSize(details, 0).x;
    int texel = found.triangle < kFirstSphere ? 3 * found.triangle : 0;
    uvec4 a = texelFetch(details, ivec2(texel % width, texel / width), 0);
    uvec4 b = texelFetch(details, ivec2((texel + 1) % width, (texel + 1) / width), 0);
    uvec4 c = texelFetch(details, ivec2((texel + 2) % width, (texel + 2) / width), 0);
    base *= (1.0 - found.u - found.v) * rootsOf(b.z) + found.u * rootsOf(b.w) + found.v * rootsOf(c.x);
    uint bits = floatBitsToUint(more.z);
    if (bits != 0u) {
        vec2 uv = uintBitsToFloat(a.xy), d1 = uintBitsToFloat(a.zw) - uv, d2 = uintBitsToFloat(b.xy) - uv;
        vec4 m = partFigures(part, 7);
        uv += found.u * d1 + found.v * d2;
        vec2 place = m.xy * uv.x + m.zw * uv.y + more.xy;
        float share = abs((d1.x * d2.y - d1.y * d2.x) * (m.x * m.w - m.y * m.z)) /
                      max(length(cross(hit.e1, hit.e2)), 1e-30);
        float area = length(cross(at.footprint.originX, at.footprint.originY)) * share;
        float size = float(textureSize(layers, 0).x);
        float level = 0.5 * log2(max(area * size * size, 1.0));
        place = vec2(wrapped(place.x, bits & 3u), wrapped(place.y, (bits >> 2u) & 3u));
        uint first = bits >> 8u;
        if ((bits & 16u) != 0u) base *= textureLod(layers, vec3(place, float(first++)), level);
        if ((bits & 32u) != 0u) figures.xy *= textureLod(layers, vec3(place, float(first++)), level).bg;
        if ((bits & 64u) != 0u) Le.rgb *= textureLod(layers, vec3(place, float(first)), level).rgb;
    }
#endif
    look.alpha = 1.0;
    if ((kind & kMasked) != 0u) look.alpha = base.a < edge.a ? 0.0 : 1.0;
    if ((kind & kBlended) != 0u) look.alpha = base.a;
    if ((kind & kUnlit) != 0u) {
        look.L = base.rgb * unlitFactor;
        return look;
    }
    vec3 wo = environmentFromWorld * -at.direction;
    vec3 n = environmentFromWorld * met.face.n;
    vec3 F0 = min(edge.rgb, vec3(1.0)) * figures.z;
    float c1 = clamp(met.face.cosThetaI, 0.0, 1.0);
    NormalChange change = normalChangeOver(at.footprint, hit, met.face);
    float texels = kTexelsPerRadian * float(environmentFaceSize);
    float spread = sqrt(footprintSolidAngle(reflectedFootprint(at.footprint, change, met.face, at.direction)));
    float level = log2(clamp(spread * texels, 1.0, 16.0));

    vec3 reflected = reflectDirection(-wo, n);
    float roughness = figures.y;
    vec3 main = mix(reflected, n, roughness * roughness * roughness * roughness);
    vec3 sharp = environmentRadiance(reflected, level);
    vec3 specularLight = blurred(main, roughness, sharp);
    vec2 terms = split(c1, roughness).rg;
    vec3 metalR = compensatedReflectance(base.rgb, vec3(1.0), terms);
    vec3 matR = compensatedReflectance(F0, vec3(figures.z), terms);
    vec3 matt = base.rgb * textureLod(chain, n, lastLevel).rgb;
    if (figures.w > 0.0) {
        vec3 ahead = -wo;
        if ((kind & kThin) == 0u) {
            Refraction refraction = refractDirection(-wo, n, met.face.front ? hit.eta.x : 1.0 / hit.eta.x);
            ahead = refraction.total ? reflected : refraction.direction;
        }
        matt = mix(matt, base.rgb * blurred(ahead, roughness, environmentRadiance(ahead, level)), figures.w);
    }
    look.L = figures.x * metalR * specularLight + (1.0 - figures.x) * (matR * specularLight + (vec3(1.0) - matR) * matt);
#ifdef LAMPS
    TangentFrame frame;
    frame.n = n;
    frame.t = normalize(cross(n, abs(n.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    frame.b = cross(n, frame.t);
    Lamplight lit = lamplight(frame, wo, vec2(max(roughness * roughness, 1e-3)), environmentFromWorld * (at.origin - eye));
    look.L += lampLook(lit, terms, figures.x, base.rgb, F0, figures.z, (1.0 - figures.w) * (vec3(1.0) - matR) * base.rgb);
#endif
    if (Le.a > 0.0) {
        float coatR = Le.a * compensatedReflectance(vec3(0.04), vec3(1.0), split(c1, more.w).rg).x;
        look.L = look.L * (1.0 - coatR) + coatR * blurred(reflected, more.w, sharp);
    }
    look.L += Le.rgb * unlitFactor;
    return look;
}
