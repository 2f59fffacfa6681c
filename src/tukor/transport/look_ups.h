// How a wide look-up in the environment is taken apart: a lattice of narrow ones over the
// parallelogram that the ray differentials span. Shared source.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(transport)

/// Look-ups at `first` + i `stepX` + j `stepY`, i < across, j < down, all at one level of detail.
struct LookUps {
    int across;
    int down;
    vec3 first;  // from the deposit's direction
    vec3 stepX;
    vec3 stepY;
    float level;  // log2 of the texels that one is wide, at least 0
};

/// Radians: linear extrapolation of directions means nothing over more.
TUKOR_CONST float kWidestFootprint = 0.5f;

/// Of one deposit: more cost more than a ray.
TUKOR_CONST int kMostLookUps = 17;

/// How wide a sample looks, of its distance from its neighbours: at 1 the picture is blurred by
/// what samples overlap, more than an error estimate can see; below 0.5 they miss what lies between
/// them.
TUKOR_CONST float kSampleFootprint = 0.7f;

/// Of a cube map, on the mean over the sphere, over its face size: sqrt(6 / 4 pi).
TUKOR_CONST float kTexelsPerRadian = 0.691f;

/// The face size of a cube map with as many texels as a panorama, over its width: 1 / sqrt(6 pi).
TUKOR_CONST float kFaceOfPanorama = 0.2303f;

/// At most `most` look-ups for a footprint that `dx` and `dy` span, in an environment of
/// `texelsPerRadian`; one, sharp, where differentials broke down in NaN or overflow.
TUKOR_FN LookUps lookUpsOver(vec3 dx, vec3 dy, float texelsPerRadian, int most) {
    LookUps l;
    l.across = 1;
    l.down = 1;
    l.first = vec3(0.0f);
    l.stepX = vec3(0.0f);
    l.stepY = vec3(0.0f);
    l.level = 0.0f;
    float width = length(dx) * texelsPerRadian;
    float height = length(dy) * texelsPerRadian;
    if (!(width < 1e6f) || !(height < 1e6f)) return l;
    float widest = kWidestFootprint * texelsPerRadian;
    if (width > widest) {
        dx = dx * (widest / width);
        width = widest;
    }
    if (height > widest) {
        dy = dy * (widest / height);
        height = widest;
    }
    l.across = clamp(int(width + 0.5f), 1, 64);
    l.down = clamp(int(height + 0.5f), 1, 64);
    while (l.across * l.down > most) {
        bool tall = width * float(l.down) < height * float(l.across);
        if (l.across > 1 && (l.down == 1 || tall)) {
            l.across = l.across - 1;
        } else {
            l.down = l.down - 1;
        }
    }
    float step = max(width / float(l.across), height / float(l.down));
    if (step > 1.0f) l.level = log2(step);
    l.stepX = dx / float(l.across);
    l.stepY = dy / float(l.down);
    l.first = (-0.5f * float(l.across - 1)) * l.stepX - (0.5f * float(l.down - 1)) * l.stepY;
    return l;
}

/// As many as a look-up of this weight is worth: what is seen through many events counts little.
/// From a quarter on all, lest lamps are blurred in what glass reflects.
TUKOR_FN int lookUpsWorth(float weight, int most) {
    return 1 + int(float(most - 1) * min(4.0f * weight, 1.0f));
}

TUKOR_SHARED_END
