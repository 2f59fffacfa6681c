// What a clear medium takes away on the way through it. Shared source.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(optics)

/// Beer-Lambert transmittance of `distance` metres of a medium with absorption `sigmaA` in 1/m; 1
/// where sigmaA is 0.
TUKOR_FN vec3 transmittance(vec3 sigmaA, float distance) {
    if (sigmaA == vec3(0.0f)) return vec3(1.0f);  // most media are clear, and exp is dear
    return exp(-sigmaA * distance);
}

TUKOR_SHARED_END
