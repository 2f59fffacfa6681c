// Camera rays that graze a curved clear surface: their samples are taken again as finer ones.
// Shared source.
//
// A pixel at the rim of a glass ball shows a wide strip of the environment, which its samples do
// not cover. Measured under small lamps: docs/notes/rims.md.
#pragma once
#include "tukor/transport/footprint.h"
#include "tukor/transport/sampler.h"

TUKOR_SHARED_BEGIN(transport)

TUKOR_CONST int kFinerSamples = 16;     // take the place of one that grazes, each with a sixteenth
TUKOR_CONST float kFinerWidth = 0.25f;  // of its weight and this part of its footprint's width

/// Whether the angle to a surface whose normal changes by `change` over the footprint of a ray `d`
/// changes by a sixteenth of its cosine.
TUKOR_FN bool bendsAway(NormalChange change, vec3 d, float cosThetaI) {
    return cosThetaI <= 0.5f && abs(dot(d, change.x)) + abs(dot(d, change.y)) > cosThetaI / 16.0f;
}

/// Whether a camera ray of footprint `f` and direction `d` meets a curved clear surface so near its
/// outline that this bends away.
TUKOR_FN bool grazes(Footprint f, vec3 d, SurfaceHit hit, Facing face) {
    if (hit.kind != kDielectric || face.cosThetaI > 0.5f) return false;
    NormalChange change =
        normalChangeOver(footprintAtSurface(f, d, hit.distance, face.ng), hit, face);
    return bendsAway(change, d, face.cosThetaI);
}

/// Where finer sample `index` lies from the one with `seed` that it is part of, in widths of that.
TUKOR_FN vec2 finerSample(uint seed, uint index) {
    return pixelSample(seed, index) - vec2(0.5f);
}

TUKOR_SHARED_END
