// Snell's law once, for everyone who must agree on where total internal reflection begins. Shared
// source.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(optics)

/// (eta cosThetaT)^2 = eta^2 - sin^2 thetaI, for eta = etaT / etaI; 0 or less: total internal
/// reflection.
///
/// Written without 1 - cos^2, so that it does not cancel at grazing incidence with eta near 1.
TUKOR_FN float scaledCos2ThetaT(float cosThetaI, float eta) {
    return (eta - 1.0f) * (eta + 1.0f) + cosThetaI * cosThetaI;
}

TUKOR_SHARED_END
