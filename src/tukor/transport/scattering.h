// What one surface does to light that meets it: how much of it goes on which way. Shared source.
#pragma once
#include "tukor/optics/fresnel.h"
#include "tukor/transport/media.h"
#include "tukor/transport/surface.h"

TUKOR_SHARED_BEGIN(transport)
TUKOR_SHARED_USING(optics)

/// Values of TransportSettings::fresnel, those of FresnelForm.
TUKOR_CONST int kFresnelExact = 0;
TUKOR_CONST int kFresnelSchlick = 1;

/// Into what shares light is parted.
struct Scattering {
    vec3 R;     // reflectance; grey at a dielectric
    float T;    // transmittance; 0 at opaque surfaces and at total reflection
    float eta;  // etaT / etaI; dielectrics only
};

/// Reflectance of a dielectric in the chosen form; 1 at total reflection.
///
/// The approximation knows no total reflection: it takes the cosine on the thin side.
TUKOR_FN float dielectricReflectance(float cosThetaI, float eta, int fresnel) {
    if (fresnel == kFresnelExact) return fresnelDielectric(cosThetaI, eta);
    float g2 = scaledCos2ThetaT(cosThetaI, eta);
    if (g2 <= 0.0f) return 1.0f;
    float c = eta < 1.0f ? sqrt(g2) / eta : cosThetaI;
    vec3 R0 = reflectanceAtNormal(vec3(eta), vec3(0.0f));
    return fresnelSchlick(c, R0).x;
}

/// At a mirror or a metal that lies in a medium of index `etaI`.
TUKOR_FN Scattering opaqueScattering(SurfaceHit hit, Facing face, float etaI, int fresnel) {
    Scattering s;
    s.T = 0.0f;
    s.eta = 1.0f;
    if (hit.kind == kMirror) {
        s.R = hit.tint;
    } else if (fresnel == kFresnelExact) {
        s.R = fresnelConductor(face.cosThetaI, hit.eta / etaI, hit.k / etaI);
    } else {
        s.R = fresnelSchlick(face.cosThetaI, reflectanceAtNormal(hit.eta / etaI, hit.k / etaI));
    }
    return s;
}

/// Between two dielectrics, `eta` = etaT / etaI.
TUKOR_FN Scattering clearScattering(Facing face, float eta, int fresnel) {
    Scattering s;
    float R = dielectricReflectance(face.cosThetaI, eta, fresnel);
    s.R = vec3(R);
    s.T = 1.0f - R;
    s.eta = eta;
    return s;
}

TUKOR_SHARED_END
