// Rough interfaces as many small mirrors: GGX with height-correlated Smith shadowing, stretched
// along the axes of a tangent frame. Shared source.
//
// Directions are unit, in the frame: x tangent, y bitangent, z normal. `a` holds the roughness
// along x and y, the square of the perceptual one. [Walter et al. 2007; Heitz 2014]
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(optics)

/// Density of microfacet normals `h` per steradian; its projection on the surface integrates to 1.
TUKOR_FN float ggxDistribution(vec3 h, vec2 a) {
    float x = h.x / a.x;
    float y = h.y / a.y;
    float s = x * x + y * y + h.z * h.z;
    return 0.31830989f / (a.x * a.y * s * s);
}

/// Smith's Lambda: 1 / (1 + it) of the facets turned towards `w` are seen from there.
TUKOR_FN float ggxLambda(vec3 w, vec2 a) {
    float x = a.x * w.x;
    float y = a.y * w.y;
    float z2 = max(w.z * w.z, 1e-12f);
    return 0.5f * (sqrt(1.0f + (x * x + y * y) / z2) - 1.0f);
}

/// A facet normal as seen from `wo`, wo.z > 0, for uniform `u`. [Dupuy & Benyoub 2023]
TUKOR_FN vec3 ggxVisibleNormal(vec3 wo, vec2 a, vec2 u) {
    vec3 w = normalize(vec3(a.x * wo.x, a.y * wo.y, wo.z));
    float phi = 6.2831853f * u.x;
    float z = (1.0f - u.y) * (1.0f + w.z) - w.z;
    float r = sqrt(max(1.0f - z * z, 0.0f));
    vec3 h = vec3(r * cos(phi), r * sin(phi), z) + w;
    return normalize(vec3(a.x * h.x, a.y * h.y, max(h.z, 1e-6f)));
}

/// What reflects of uniform light, with all that bounces between facets. `table` is the reflectance
/// for Schlick's two terms (environment/brdf_table.h). [Turquin 2019]
TUKOR_FN vec3 compensatedReflectance(vec3 F0, vec3 F90, vec2 table) {
    vec3 once = F0 * table.x + F90 * table.y;
    return once * (vec3(1.0f) + F0 * (1.0f / max(table.x + table.y, 1e-3f) - 1.0f));
}

TUKOR_SHARED_END
