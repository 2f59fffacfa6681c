// Where light goes at an ideal smooth interface: the flip of the normal, reflection, refraction.
// Shared source.
//
// `d` is the unit direction of travel along the light path, towards the surface (the lecture's d;
// wo = -d).
#pragma once
#include "tukor/optics/shared.h"
#include "tukor/optics/snell.h"

TUKOR_SHARED_BEGIN(optics)

/// A surface as light meets it: the normal on the side it comes from, the index ratio across in
/// that sense.
struct Interface {
    vec3 n;           // unit, dot(d, n) <= 0
    float cosThetaI;  // in [0, 1]
    float eta;        // etaT / etaI
};

/// Lecture row 12: when d comes from behind `n`, flip the normal and invert `eta` (outside over
/// inside -> inside over out).
TUKOR_FN Interface facing(vec3 d, vec3 n, float eta) {
    Interface face;
    float c = -dot(d, n);
    if (c < 0.0f) {
        face.n = -n;
        face.cosThetaI = min(-c, 1.0f);
        face.eta = 1.0f / eta;
    } else {
        face.n = n;
        face.cosThetaI = min(c, 1.0f);
        face.eta = eta;
    }
    return face;
}

/// Lecture row 13: the mirror image of d; unit when d and n are. Equals GLSL's reflect(d, n) for
/// either sign of n.
TUKOR_FN vec3 reflectDirection(vec3 d, vec3 n) {
    vec3 perpendicular = dot(n, d) * n;
    vec3 parallel = d - perpendicular;
    return parallel - perpendicular;
}

/// The refracted ray, or the news that there is none.
struct Refraction {
    vec3 direction;   // unit; meaningless when `total`
    float cosThetaT;  // 0 when `total`
    bool total;       // total internal reflection
};

/// Lecture row 14, Snell's law: `n` faces the light, `eta` = etaT / etaI = sin thetaI / sin thetaT
/// (the lecture's mu).
///
/// `total` is decided by the same expression as in fresnelDielectric, which is then exactly 1. A
/// shader compiler may still round the two differently: take R = 1 where `total`, and no light is
/// lost. GLSL's own refract() wants 1 / eta; nothing but this file may call it, and this file need
/// not.
TUKOR_FN Refraction refractDirection(vec3 d, vec3 n, float eta) {
    Refraction r;
    float c = -dot(d, n);
    float g2 = scaledCos2ThetaT(min(c, 1.0f), eta);
    r.total = g2 <= 0.0f;
    r.cosThetaT = sqrt(max(g2, 0.0f)) / eta;
    vec3 parallel = d + c * n;
    vec3 t = parallel / eta - r.cosThetaT * n;
    r.direction = t * (1.5f - 0.5f * dot(t, t));  // unit but for rounding: a step of Newton's
    return r;
}

TUKOR_SHARED_END
