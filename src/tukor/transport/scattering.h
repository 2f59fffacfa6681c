// What one surface does to light that meets it: reflectance and the directions in which it goes on.
// Shared source.
#pragma once
#include "tukor/optics/directions.h"
#include "tukor/optics/fresnel.h"
#include "tukor/transport/media.h"
#include "tukor/transport/surface.h"

TUKOR_SHARED_BEGIN(transport)
TUKOR_SHARED_USING(optics)

/// Values of TransportSettings::fresnel, those of FresnelForm.
TUKOR_CONST int kFresnelExact = 0;
TUKOR_CONST int kFresnelSchlick = 1;

/// Lecture rows 6 and 12 to 14, on the right side of the facet.
struct Scattering {
    vec3 R;           // reflectance; grey at a dielectric
    float T;          // transmittance; 0 at opaque surfaces and at total reflection
    vec3 reflected;   // unit
    vec3 refracted;   // unit; meaningless where T is 0
    float eta;        // etaT / etaI; dielectrics only
    float cosThetaT;  // dielectrics only
};

/// Reflectance of a dielectric in the chosen form; 1 at total reflection.
///
/// The approximation knows no total reflection: it takes the cosine on the thin side.
TUKOR_FN float dielectricReflectance(float cosThetaI, float cosThetaT, float eta, int fresnel) {
    if (fresnel == kFresnelExact) return fresnelDielectric(cosThetaI, eta);
    float c = eta < 1.0f ? cosThetaT : cosThetaI;
    vec3 R0 = reflectanceAtNormal(vec3(eta), vec3(0.0f));
    return fresnelSchlick(c, R0).x;
}

/// At a mirror or a metal that lies in a medium of index `etaI`.
TUKOR_FN Scattering opaqueScattering(SurfaceHit hit, Facing face, vec3 d, float etaI, int fresnel) {
    Scattering s;
    s.T = 0.0f;
    s.eta = 1.0f;
    s.cosThetaT = 0.0f;
    s.reflected = onSide(reflectDirection(d, face.n), face.ng, 1.0f);
    s.refracted = d;
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
TUKOR_FN Scattering clearScattering(Facing face, vec3 d, float eta, int fresnel) {
    Scattering s;
    Refraction refraction = refractDirection(d, face.n, eta);
    float R = 1.0f;
    if (!refraction.total) {
        R = dielectricReflectance(face.cosThetaI, refraction.cosThetaT, eta, fresnel);
    }
    s.R = vec3(R);
    s.T = 1.0f - R;
    s.eta = eta;
    s.cosThetaT = refraction.cosThetaT;
    s.reflected = onSide(reflectDirection(d, face.n), face.ng, 1.0f);
    s.refracted = onSide(refraction.direction, face.ng, -1.0f);
    return s;
}

TUKOR_SHARED_END
