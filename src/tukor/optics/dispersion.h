// How the index of clear matter depends on wavelength. Shared source.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(optics)

/// Index at a wavelength in nm, by the first two terms of Cauchy's equation through the index at
/// the d line, 587.6 nm, and Abbe's number; `dispersion` is 20 over that, 0 for none. At least 1.
/// [KHR_materials_dispersion]
TUKOR_FN float indexAt(float etaD, float dispersion, float wavelength) {
    // 1 / (1 / F^2 - 1 / C^2) for the F and C lines, 486.1 and 656.3 nm; and that over d^2.
    float change = 523655.0f / (wavelength * wavelength) - 1.5168f;
    return max(etaD + (etaD - 1.0f) * (dispersion * 0.05f) * change, 1.0f);
}

TUKOR_SHARED_END
