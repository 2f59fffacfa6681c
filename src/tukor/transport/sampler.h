// Where the samples of a pixel lie: an Owen-scrambled Sobol sequence, another scrambling in each.
// Shared source, so that both renderers look at the same places.
#pragma once
#include "tukor/optics/shared.h"

TUKOR_SHARED_BEGIN(transport)

/// A well mixed 32-bit function. [Wellons 2018, lowbias32]
TUKOR_FN uint mixedBits(uint x) {
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

TUKOR_FN uint reversedBits(uint x) {
    x = (x << 16u) | (x >> 16u);
    x = ((x & 0x00ff00ffu) << 8u) | ((x >> 8u) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4u) | ((x >> 4u) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2u) | ((x >> 2u) & 0x33333333u);
    return ((x & 0x55555555u) << 1u) | ((x >> 1u) & 0x55555555u);
}

/// Nested uniform scrambling by a hash: bit i depends on the bits above it. Of the number whose
/// bits in reverse are `x`. [Laine & Karras 2011; constants of Vegdahl 2021]
TUKOR_FN uint owenScrambledReverse(uint x, uint seed) {
    x = x ^ (x * 0x3d20adeau);
    x = x + seed;
    x = x * ((seed >> 16u) | 1u);
    x = x ^ (x * 0x05526c56u);
    x = x ^ (x * 0x53a22864u);
    return reversedBits(x);
}

TUKOR_FN uint owenScrambled(uint x, uint seed) {
    return owenScrambledReverse(reversedBits(x), seed);
}

/// The bits in reverse of the second dimension of the Sobol sequence, Pascal's triangle modulo 2;
/// of the first they are the index itself. [Ahmed 2024]
TUKOR_FN uint sobolSecondReverse(uint index) {
    uint x = index ^ (index >> 16u);
    x = x ^ ((x & 0xff00ff00u) >> 8u);
    x = x ^ ((x & 0xf0f0f0f0u) >> 4u);
    x = x ^ ((x & 0xccccccccu) >> 2u);
    return x ^ ((x & 0xaaaaaaaau) >> 1u);
}

/// The seed of a pixel by its number, row by row from the top, in the picture with `pictureSeed`.
TUKOR_FN uint pixelSeed(uint pixel, uint pictureSeed) {
    return mixedBits(pixel ^ mixedBits(pictureSeed));
}

/// Sample `index` of a pixel, in [0, 1)^2 from its top-left corner. Every prefix of 2^k samples is
/// a (0, k, 2)-net.
TUKOR_FN vec2 pixelSample(uint seed, uint index) {
    uint x = owenScrambledReverse(index, mixedBits(seed + 1u));
    uint y = owenScrambledReverse(sobolSecondReverse(index), mixedBits(seed + 2u));
    float scale = 1.0f / 16777216.0f;  // 24 bits: the result stays below 1
    return vec2(float(x >> 8u) * scale, float(y >> 8u) * scale);
}

/// What a sample of a pixel stands for, in pixels from its top-left corner.
struct PixelPart {
    vec2 middle;
    vec2 size;
};

/// The square of that `width` about sample `index`, cut off at the pixel's edges: a lamp just
/// outside of it would shine into it otherwise.
TUKOR_FN PixelPart pixelPart(uint seed, uint index, float width) {
    vec2 at = pixelSample(seed, index);
    vec2 least = max(at - vec2(0.5f * width), vec2(0.0f));
    vec2 most = min(at + vec2(0.5f * width), vec2(1.0f));
    PixelPart part;
    part.middle = 0.5f * (least + most);
    part.size = most - least;
    return part;
}

/// What chance does along the light path of a sample: see startTree.
TUKOR_FN uint sampleSeed(uint seed, uint index) {
    return mixedBits(seed + index * 0x9e3779b9u);
}

/// Where in the spectrum a sample lies, in [0, 1): those of a pixel cover it evenly, in an order of
/// their own. [Burley 2020]
TUKOR_FN float spectrumSample(uint seed, uint index) {
    uint own = mixedBits(seed ^ 0x5bd1e995u);
    return pixelSample(own, owenScrambled(index, mixedBits(own))).x;
}

TUKOR_SHARED_END
