// What the parity test computes in both languages: each case is one function of the project on one
// input. Shared source.
#pragma once
#include "tukor/image/tonemap.h"
#include "tukor/optics/absorption.h"
#include "tukor/optics/directions.h"
#include "tukor/optics/dispersion.h"
#include "tukor/optics/fresnel.h"
#include "tukor/transport/sampler.h"

TUKOR_SHARED_BEGIN(parity)
TUKOR_SHARED_USING(optics)
TUKOR_SHARED_USING(tonemap)
TUKOR_SHARED_USING(transport)

TUKOR_CONST int kFresnelDielectric = 0;
TUKOR_CONST int kFresnelConductor = 1;
TUKOR_CONST int kFresnelSchlick = 2;
TUKOR_CONST int kReflectanceAtNormal = 3;
TUKOR_CONST int kFacing = 4;
TUKOR_CONST int kReflect = 5;
TUKOR_CONST int kRefract = 6;
TUKOR_CONST int kTransmittance = 7;
TUKOR_CONST int kTonemap = 8;  // and on: kNone .. kNeutral
TUKOR_CONST int kSrgb = 13;
TUKOR_CONST int kLinear = 14;
TUKOR_CONST int kIndexAt = 15;
TUKOR_CONST int kSpectrumSample = 16;
TUKOR_CONST int kCases = 17;

/// Inputs: a = (unit d, eta), b = (unit n, cosThetaI), c = (colour or extinction, distance).
TUKOR_FN vec4 caseResult(int which, vec4 a, vec4 b, vec4 c) {
    vec3 d = vec3(a);
    vec3 n = vec3(b);
    vec3 colour = vec3(c);
    float eta = a.w;
    float cosThetaI = b.w;
    if (which == kFresnelDielectric) return vec4(fresnelDielectric(cosThetaI, eta));
    if (which == kFresnelConductor) {
        return vec4(fresnelConductor(cosThetaI, vec3(eta, 1.3f * eta, 0.7f * eta), colour), 0.0f);
    }
    if (which == kFresnelSchlick) {
        return vec4(fresnelSchlick(cosThetaI, min(colour, vec3(1.0f))), 0.0f);
    }
    if (which == kReflectanceAtNormal) return vec4(reflectanceAtNormal(vec3(eta), colour), 0.0f);
    if (which == kFacing) {
        Interface face = facing(d, n, eta);
        return vec4(face.n * face.eta, face.cosThetaI);
    }
    if (which == kReflect) return vec4(reflectDirection(d, n), 0.0f);
    if (which == kRefract) {
        Interface face = facing(d, n, eta);
        Refraction r = refractDirection(d, face.n, face.eta);
        return vec4(r.direction, r.total ? 2.0f : r.cosThetaT);
    }
    if (which == kTransmittance) return vec4(transmittance(colour, c.w), 0.0f);
    if (which == kSrgb) return vec4(srgbFromLinear(min(colour, vec3(1.0f))), 0.0f);
    if (which == kLinear) return vec4(linearFromSrgb(min(colour, vec3(1.0f))), 0.0f);
    if (which == kIndexAt) return vec4(indexAt(eta, c.w, 550.0f + 170.0f * n.x));
    if (which == kSpectrumSample) {
        return vec4(spectrumSample(floatBitsToUint(cosThetaI), floatBitsToUint(d.x) >> 20u));
    }
    return vec4(mapped(which - kTonemap, colour), 0.0f);
}

TUKOR_SHARED_END
