// Reflectance of ideal smooth interfaces, unpolarised light. Shared source: C++ and GLSL ES 3.00.
//
// cosThetaI in [0, 1] is measured on the incident side. Transmittance is 1 - reflectance.
#pragma once
#include "tukor/optics/shared.h"
#include "tukor/optics/snell.h"

TUKOR_SHARED_BEGIN(optics)

/// Dielectric: air, water, glass. `eta` is etaT / etaI: 1.33 entering water, 1 / 1.33 leaving it.
///
/// (eta - 1)^2 / (eta + 1)^2 at normal incidence; exactly 1 beyond the critical angle and at
/// grazing incidence. [Born & Wolf 1999, sec. 1.5.2]
TUKOR_FN float fresnelDielectric(float cosThetaI, float eta) {
    float g2 = scaledCos2ThetaT(cosThetaI, eta);
    if (g2 <= 0.0f) return 1.0f;
    float g = sqrt(g2);  // eta * cosThetaT
    float eta2 = eta * eta;
    float rs = (cosThetaI - g) / (cosThetaI + g);
    float rp = (eta2 * cosThetaI - g) / (eta2 * cosThetaI + g);
    return 0.5f * (rs * rs + rp * rp);
}

/// Conductor of index eta + i k relative to the incident side, per colour channel; at k = 0 it is
/// the dielectric, total reflection included.
///
/// a + i b is the complex eta * cosThetaT. The usual a^2 = (|.|^2 + t0) / 2 cancels when t0 < 0 and
/// k is small (error 5e-4); the other root of the same quadratic does not (1.2e-6). [Born & Wolf
/// 1999, sec. 14.2]
TUKOR_FN vec3 fresnelConductor(float cosThetaI, vec3 eta, vec3 k) {
    float cos2 = cosThetaI * cosThetaI;
    float sin2 = 1.0f - cos2;
    vec3 t0 = ((eta - vec3(1.0f)) * (eta + vec3(1.0f)) - k * k) + vec3(cos2);
    vec3 q = 4.0f * eta * eta * k * k;
    vec3 ab = sqrt(t0 * t0 + q);  // a^2 + b^2
    vec3 stable = 0.5f * q / max(ab - t0, vec3(1e-30f));
    vec3 a = sqrt(mix(stable, 0.5f * (ab + t0), step(vec3(0.0f), t0)));
    vec3 t1 = ab + vec3(max(cos2, 1e-30f));  // 0 only for eta = 1, k = 0 along the surface: R = 1
    vec3 t2 = (2.0f * cosThetaI) * a;
    vec3 Rs = max(t1 - t2, vec3(0.0f)) / (t1 + t2);
    vec3 t3 = cos2 * ab + vec3(sin2 * sin2);
    vec3 t4 = sin2 * t2;
    vec3 Rp = Rs * max(t3 - t4, vec3(0.0f)) / (t3 + t4);
    return 0.5f * (Rs + Rp);
}

/// Reflectance at normal incidence, the lecture's R0, of index eta + i k relative to the incident
/// side.
TUKOR_FN vec3 reflectanceAtNormal(vec3 eta, vec3 k) {
    vec3 below = eta - vec3(1.0f);
    vec3 above = eta + vec3(1.0f);
    return (below * below + k * k) / (above * above + k * k);
}

/// The lecture's approximation, R0 + (1 - R0)(1 - cos)^5. [Schlick 1994; Lazanyi & Szirmay-Kalos
/// 2005]
///
/// For a dielectric left from inside, pass the cosine on the thin side: this function knows no
/// total reflection.
TUKOR_FN vec3 fresnelSchlick(float cosThetaI, vec3 R0) {
    float m = 1.0f - cosThetaI;
    float m2 = m * m;
    return R0 + (vec3(1.0f) - R0) * (m2 * m2 * m);
}

TUKOR_SHARED_END
