// From radiance to what a screen shows: tone mapping and the sRGB transfer function. Shared source.
//
// Colours are linear Rec. 709 in and out; a tone mapper's result is meant for [0, 1] and what lies
// outside is clipped by whoever stores it.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(tonemap)

// The values of tukor::Tonemap (image/display.h), as a shader gets them.
TUKOR_CONST int kNone = 0;
TUKOR_CONST int kReinhard = 1;
TUKOR_CONST int kAces = 2;
TUKOR_CONST int kAgx = 3;
TUKOR_CONST int kNeutral = 4;

/// The factor on radiance of an exposure in stops.
TUKOR_FN float exposureFactor(float stops) {
    return exp2(stops);
}

/// Encoded for an sRGB screen; c in [0, 1]. [IEC 61966-2-1]
TUKOR_FN vec3 srgbFromLinear(vec3 c) {
    vec3 low = 12.92f * c;
    vec3 high = 1.055f * pow(max(c, vec3(0.0031308f)), vec3(1.0f / 2.4f)) - vec3(0.055f);
    return mix(low, high, step(vec3(0.0031308f), c));
}

/// The inverse of srgbFromLinear; c in [0, 1].
TUKOR_FN vec3 linearFromSrgb(vec3 c) {
    vec3 low = c / 12.92f;
    vec3 high = pow((max(c, vec3(0.04045f)) + vec3(0.055f)) / 1.055f, vec3(2.4f));
    return mix(low, high, step(vec3(0.04045f), c));
}

/// L / (1 + L), channel by channel: 1 is reached only at infinity. [Reinhard et al. 2002, eq. 3]
TUKOR_FN vec3 reinhard(vec3 L) {
    return L / (vec3(1.0f) + L);
}

/// Stephen Hill's fit of the ACES reference and output transforms for sRGB screens.
///
/// [Hill 2016, in BakingLab's ACES.hlsl], with three.js's brighter pre-exposure of 1 / 0.6, so that
/// middle grey keeps its place.
TUKOR_FN vec3 aces(vec3 L) {
    mat3 acesFromRec709 =
        mat3(vec3(0.59719f, 0.07600f, 0.02840f), vec3(0.35458f, 0.90834f, 0.13383f),
             vec3(0.04823f, 0.01566f, 0.83777f));
    mat3 rec709FromAces =
        mat3(vec3(1.60475f, -0.10208f, -0.00327f), vec3(-0.53108f, 1.10813f, -0.07276f),
             vec3(-0.07367f, -0.00605f, 1.07602f));
    vec3 v = acesFromRec709 * (L / 0.6f);
    vec3 a = v * (v + vec3(0.0245786f)) - vec3(0.000090537f);
    vec3 b = v * (0.983729f * v + vec3(0.4329510f)) + vec3(0.238081f);
    return max(rec709FromAces * (a / b), vec3(0.0f));
}

/// The sigmoid of AgX between black (0) and white (1) of its log2 range, a fit of degree six.
/// [Wrensch 2023]
TUKOR_FN vec3 agxContrast(vec3 x) {
    vec3 x2 = x * x;
    vec3 x4 = x2 * x2;
    return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 +
           0.1191f * x - vec3(0.00232f);
}

/// Troy Sobotka's AgX, base look, as in Blender, Filament and three.js: bright colours go to white
/// along their hue.
///
/// Rec. 709 in and out; inset and outset act in Rec. 2020. 16.5 stops from 2^-12.47393 on.
TUKOR_FN vec3 agx(vec3 L) {
    mat3 rec2020FromRec709 = mat3(vec3(0.6274f, 0.0691f, 0.0164f), vec3(0.3293f, 0.9195f, 0.0880f),
                                  vec3(0.0433f, 0.0113f, 0.8956f));
    mat3 rec709FromRec2020 =
        mat3(vec3(1.6605f, -0.1246f, -0.0182f), vec3(-0.5876f, 1.1329f, -0.1006f),
             vec3(-0.0728f, -0.0083f, 1.1187f));
    mat3 inset = mat3(vec3(0.856627153f, 0.137318973f, 0.111898213f),
                      vec3(0.095121241f, 0.761241991f, 0.076799419f),
                      vec3(0.048251606f, 0.101439036f, 0.811302368f));
    mat3 outset = mat3(vec3(1.127100582f, -0.141329763f, -0.141329763f),
                       vec3(-0.110606643f, 1.157823702f, -0.110606643f),
                       vec3(-0.016493939f, -0.016493939f, 1.251936407f));
    vec3 v = max(inset * (rec2020FromRec709 * L), vec3(1e-10f));  // log2 of 0 is not wanted
    v = clamp((log2(v) + vec3(12.47393f)) / 16.5f, vec3(0.0f), vec3(1.0f));
    v = max(outset * agxContrast(v), vec3(0.0f));
    v = rec709FromRec2020 * pow(v, vec3(2.2f));
    return clamp(v, vec3(0.0f), vec3(1.0f));
}

/// Khronos PBR Neutral: colours below 0.76 stay as they are, but for the 4 % that a dielectric's
/// reflection adds; highlights are compressed towards white. [Khronos 2024]
TUKOR_FN vec3 neutral(vec3 L) {
    float start = 0.8f - 0.04f;
    float least = min(L.x, min(L.y, L.z));
    float offset = least < 0.08f ? least - 6.25f * least * least : 0.04f;
    vec3 c = L - vec3(offset);
    float peak = max(c.x, max(c.y, c.z));
    if (peak < start) return c;
    float room = 1.0f - start;
    float newPeak = 1.0f - room * room / (peak + room - start);
    float desaturation = 1.0f - 1.0f / (0.15f * (peak - newPeak) + 1.0f);
    return mix(c * (newPeak / peak), vec3(newPeak), desaturation);
}

/// `which` is one of the constants above; L >= 0, exposure already applied.
TUKOR_FN vec3 mapped(int which, vec3 L) {
    if (which == kReinhard) return reinhard(L);
    if (which == kAces) return aces(L);
    if (which == kAgx) return agx(L);
    if (which == kNeutral) return neutral(L);
    return L;
}

TUKOR_SHARED_END
