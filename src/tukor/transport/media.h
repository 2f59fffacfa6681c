// What a ray is inside of: sets of dielectrics, of which the one of highest priority is there.
// Shared source.
//
// The host numbers its dielectrics by ascending priority, at most 32; a set has one bit each. So
// water may be modelled as a solid that overlaps the glass it stands in.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(transport)

struct Medium {
    float eta;    // index against vacuum
    vec3 sigmaA;  // absorption, 1/m
};

TUKOR_CONST int kVacuum = -1;

TUKOR_FN Medium vacuum() {
    Medium m;
    m.eta = 1.0f;
    m.sigmaA = vec3(0.0f);
    return m;
}

/// The number of the medium that is there: the highest bit of the set; kVacuum for the empty set.
TUKOR_FN int mediumOf(uint media) {
    if (media == 0u) return kVacuum;
    // The exponent of a float that holds 16 bits exactly; GLSL ES 3.00 has no findMSB.
    bool high = media >= 65536u;
    uint half16 = high ? media >> 16u : media;
    int exponent = int(floatBitsToUint(float(half16)) >> 23u) - 127;
    return high ? exponent + 16 : exponent;
}

TUKOR_SHARED_END
