// Lamps without size on a rough surface; nothing shadows them. LAMPS: how many, if any.
#include "tukor/optics/microfacet.h"

struct TangentFrame {
    vec3 t;
    vec3 b;
    vec3 n;
};

#ifdef LAMPS
uniform vec4 lamps[4 * LAMPS];  // place and kind, direction and range, intensity, cone

// Of all lamps, at `position` as seen from the eye: the light on a diffuse white surface, and what facets of index `a` send to `wo` of a
// white one, for F0 and F90 apart. [KHR_lights_punctual]
struct Lamplight {
    vec3 matt;
    vec3 scale;
    vec3 bias;
};

Lamplight lamplight(TangentFrame f, vec3 wo, vec2 a, vec3 position) {
    Lamplight sum;
    sum.matt = vec3(0.0);
    sum.scale = vec3(0.0);
    sum.bias = vec3(0.0);
    vec3 o = vec3(dot(wo, f.t), dot(wo, f.b), max(dot(wo, f.n), 1e-3));
    float lambdaOut = ggxLambda(o, a);
    for (int i = 0; i < LAMPS; i++) {
        vec4 place = lamps[4 * i], direction = lamps[4 * i + 1], cone = lamps[4 * i + 3];
        vec3 E = lamps[4 * i + 2].rgb;
        vec3 to = -direction.xyz;
        if (place.w > 0.5) {
            to = place.xyz - position;
            float distance2 = max(dot(to, to), 1e-12);
            to *= inversesqrt(distance2);
            float part = distance2 / (direction.w * direction.w);
            E *= (direction.w > 0.0 ? clamp(1.0 - part * part, 0.0, 1.0) : 1.0) / distance2;
        }
        if (place.w > 1.5) {
            float share = clamp((-dot(to, direction.xyz) - cone.y) / max(cone.x - cone.y, 1e-4), 0.0, 1.0);
            E *= share * share;
        }
        vec3 wi = vec3(dot(to, f.t), dot(to, f.b), dot(to, f.n));
        if (wi.z <= 0.0) continue;
        vec3 h = normalize(wi + o);
        float m = 1.0 - clamp(dot(h, wi), 0.0, 1.0);
        float grazing = m * m * m * m * m;
        vec3 glint = E * (ggxDistribution(h, a) / (4.0 * o.z * (1.0 + lambdaOut + ggxLambda(wi, a))));
        sum.matt += E * (wi.z * 0.31830989);
        sum.scale += glint * (1.0 - grazing);
        sum.bias += glint * grazing;
    }
    return sum;
}

// What a metal sends of that, and what does something clear over `matt`; `terms` as in the split sum.
vec3 lampLook(Lamplight lit, vec2 terms, float metallic, vec3 metalF0, vec3 F0, float F90, vec3 matt) {
    float missing = 1.0 / max(terms.x + terms.y, 1e-3) - 1.0;
    vec3 metal = (metalF0 * lit.scale + lit.bias) * (vec3(1.0) + metalF0 * missing);
    vec3 clear = (F0 * lit.scale + F90 * lit.bias) * (vec3(1.0) + F0 * missing);
    return metallic * metal + (1.0 - metallic) * (clear + matt * lit.matt);
}
#endif
