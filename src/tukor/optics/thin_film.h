// Colours of thin films: reflectance of a film over a base, seen by three broad sensors. Shared
// source.
#pragma once
#include "tukor/optics/fresnel.h"

TUKOR_SHARED_BEGIN(optics)

/// What the sensitivities of XYZ make of a phase difference, as Gaussians of the frequency; linear
/// Rec. 709. `opd` in nm. [Belcour & Barla 2017]
TUKOR_FN vec3 filmSensitivity(float opd, vec3 shift) {
    float phase = 6.2831853f * opd * 1.0e-9f;
    vec3 value = vec3(5.4856e-13f, 4.4201e-13f, 5.2481e-13f);
    vec3 position = vec3(1.6810e+06f, 1.7953e+06f, 2.2084e+06f);
    vec3 variance = vec3(4.3278e+09f, 9.3046e+09f, 6.6121e+09f);
    vec3 xyz = value * sqrt(6.2831853f * variance) * cos(position * phase + shift) *
               exp(-(phase * phase) * variance);
    xyz = xyz + vec3(9.7470e-14f * sqrt(6.2831853f * 4.5282e+09f) *
                         cos(2.2399e+06f * phase + shift.x) * exp(-4.5282e+09f * phase * phase),
                     0.0f, 0.0f);
    xyz = xyz / 1.0685e-7f;
    return vec3(3.2404542f * xyz.x - 1.5371385f * xyz.y - 0.4985314f * xyz.z,
                -0.9692660f * xyz.x + 1.8760108f * xyz.y + 0.0415560f * xyz.z,
                0.0556434f * xyz.x - 0.2040259f * xyz.y + 1.0572252f * xyz.z);
}

/// Index, against air, of what reflects `R0` of light at normal incidence.
TUKOR_FN vec3 indexOfReflectance(vec3 R0) {
    vec3 root = sqrt(clamp(R0, vec3(0.0f), vec3(0.9999f)));
    return (vec3(1.0f) + root) / (vec3(1.0f) - root);
}

/// In air, over a base that reflects `R0` at normal incidence; the film has index `filmEta` and
/// `thickness` in nm. In [0, 1].
TUKOR_FN vec3 thinFilmReflectance(float cosThetaI, float filmEta, float thickness, vec3 R0) {
    // A film of no thickness is not there.
    float eta = mix(1.0f, filmEta, smoothstep(0.0f, 30.0f, thickness));
    float cos2 = 1.0f - (1.0f - cosThetaI * cosThetaI) / (eta * eta);
    if (cos2 < 0.0f) return vec3(1.0f);
    float cosThetaT = sqrt(cos2);
    float outer = (eta - 1.0f) / (eta + 1.0f);
    float R12 = fresnelSchlick(cosThetaI, vec3(outer * outer)).x;
    float T121 = 1.0f - R12;
    vec3 base = indexOfReflectance(R0);
    vec3 inner = (base - vec3(eta)) / (base + vec3(eta));
    vec3 R23 = fresnelSchlick(cosThetaT, inner * inner);
    vec3 shift = vec3(3.1415927f) + 3.1415927f * (vec3(1.0f) - step(vec3(eta), base));
    float opd = 2.0f * eta * thickness * cosThetaT;
    vec3 R123 = clamp(R12 * R23, vec3(1e-5f), vec3(0.9999f));
    vec3 r123 = sqrt(R123);
    vec3 Rs = T121 * T121 * R23 / (vec3(1.0f) - R123);
    vec3 sum = vec3(R12) + Rs;
    vec3 order = Rs - vec3(T121);
    order = order * r123;
    sum = sum + order * (2.0f * filmSensitivity(opd, shift));
    order = order * r123;
    sum = sum + order * (2.0f * filmSensitivity(2.0f * opd, 2.0f * shift));
    return clamp(sum, vec3(0.0f), vec3(1.0f));
}

/// The reflectance at normal incidence with which Schlick's approximation gives the film's at
/// `cosThetaI`.
TUKOR_FN vec3 filmAtNormal(float cosThetaI, float filmEta, float thickness, vec3 R0) {
    vec3 R = thinFilmReflectance(cosThetaI, filmEta, thickness, R0);
    float m = 1.0f - cosThetaI;
    float grazing = min(m * m * m * m * m, 0.999f);
    return clamp((R - vec3(grazing)) / (1.0f - grazing), vec3(0.0f), vec3(1.0f));
}

TUKOR_SHARED_END
