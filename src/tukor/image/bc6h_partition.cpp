#include "tukor/image/bc6h_partition.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tukor/image/bc6h_modes.h"

namespace tukor {

namespace {

constexpr std::size_t kLanes = 32;
using Lanes = std::array<float, kLanes>;

/// 1 for texels of the second subset.
constexpr std::array<Lanes, 16> kSecond = [] {
    std::array<Lanes, 16> masks{};
    for (std::size_t texel = 0; texel < 16; ++texel) {
        for (std::size_t p = 0; p < 32; ++p)
            masks[texel][p] = static_cast<float>(kBc6hPartitions[p].second >> texel & 1);
    }
    return masks;
}();

// Of a subset: sums of values and of their products.
struct Moments {
    std::array<Lanes, 3> sum{};
    std::array<Lanes, 6> product{};  // rr gg bb rg gb br
    Lanes count{};
};

/// How a subset lies: the spread along its axis and off it, and its ends in each channel.
struct Line {
    Lanes along;
    Lanes off;
    std::array<Lanes, 3> low;
    std::array<Lanes, 3> high;
};

void fitLine(const Moments& moments, Line& line) {
    for (std::size_t p = 0; p < kLanes; ++p) {
        const float n = std::max(moments.count[p], 1e-6f);
        const float r = moments.sum[0][p] / n;
        const float g = moments.sum[1][p] / n;
        const float b = moments.sum[2][p] / n;
        const float rr = std::max(moments.product[0][p] - n * r * r, 0.0f);
        const float gg = std::max(moments.product[1][p] - n * g * g, 0.0f);
        const float bb = std::max(moments.product[2][p] - n * b * b, 0.0f);
        const float rg = moments.product[3][p] - n * r * g;
        const float gb = moments.product[4][p] - n * g * b;
        const float br = moments.product[5][p] - n * b * r;
        const float trace = rr + gg + bb;
        // The eighth power of the covariance is all but its longest axis.
        const float scale = 1.0f / (trace + 1e-6f);  // far below one step of any endpoint
        float m[6] = {rr * scale, gg * scale, bb * scale, rg * scale, gb * scale, br * scale};
        for (int i = 0; i < 3; ++i) {
            const float s[6] = {
                m[0] * m[0] + m[3] * m[3] + m[5] * m[5], m[1] * m[1] + m[3] * m[3] + m[4] * m[4],
                m[2] * m[2] + m[4] * m[4] + m[5] * m[5], m[3] * (m[0] + m[1]) + m[4] * m[5],
                m[4] * (m[1] + m[2]) + m[5] * m[3],      m[5] * (m[0] + m[2]) + m[3] * m[4]};
            const float whole = 1.0f / (s[0] + s[1] + s[2] + 1e-20f);
            for (int k = 0; k < 6; ++k) m[k] = s[k] * whole;
        }
        const float along = std::clamp(
            m[0] * rr + m[1] * gg + m[2] * bb + 2.0f * (m[3] * rg + m[4] * gb + m[5] * br), 0.0f,
            trace);
        line.along[p] = along;
        line.off[p] = trace - along;
        // Evenly spread values of variance v lie within sqrt(3 v) of their mean.
        const float reach = 3.0f * along / n;
        const float ends[3] = {std::sqrt(reach * m[0]), std::sqrt(reach * m[1]),
                               std::sqrt(reach * m[2])};
        line.low[0][p] = r - ends[0];
        line.low[1][p] = g - ends[1];
        line.low[2][p] = b - ends[2];
        line.high[0][p] = r + ends[0];
        line.high[1][p] = g + ends[1];
        line.high[2][p] = b + ends[2];
    }
}

}  // namespace

std::array<float, 32> estimateBc6h(const Bc6hTargets& targets) noexcept {
    float scale[3];
    for (std::size_t c = 0; c < 3; ++c) scale[c] = std::sqrt(targets.channelWeights[c]);
    Moments second;
    Moments first;
    for (std::size_t texel = 0; texel < 16; ++texel) {
        const float r = scale[0] * targets.at[0][texel];
        const float g = scale[1] * targets.at[1][texel];
        const float b = scale[2] * targets.at[2][texel];
        const float w = targets.texelWeights[texel];
        const float terms[10] = {w * r,     w * g,     w * b,     w * r * r, w * g * g,
                                 w * b * b, w * r * g, w * g * b, w * b * r, w};
        for (std::size_t k = 0; k < 10; ++k) {
            Lanes& in = k < 3 ? second.sum[k] : k < 9 ? second.product[k - 3] : second.count;
            Lanes& out = k < 3 ? first.sum[k] : k < 9 ? first.product[k - 3] : first.count;
            for (std::size_t p = 0; p < kLanes; ++p) {
                in[p] += kSecond[texel][p] * terms[k];
                out[p] += (1.0f - kSecond[texel][p]) * terms[k];
            }
        }
    }
    Line a;
    Line b;
    fitLine(first, a);
    fitLine(second, b);

    Lanes span{};
    for (std::size_t c = 0; c < 3; ++c) {
        const float unscale = 1.0f / scale[c];
        for (std::size_t p = 0; p < kLanes; ++p) {
            const float high = std::max(a.high[c][p], b.high[c][p]);
            const float low = std::min(a.low[c][p], b.low[c][p]);
            span[p] = std::max(span[p], (high - low) * unscale);
        }
    }
    // Endpoints are up to half a step of their mode off, which texels between two have half of.
    float noise = 0.0f;
    for (const float w : targets.texelWeights) noise += w;
    noise *=
        (targets.channelWeights[0] + targets.channelWeights[1] + targets.channelWeights[2]) / 24.0f;
    Lanes estimates{};
    for (std::size_t p = 0; p < 32; ++p) {
        // One step of the finest mode whose differences reach so far.
        const float step = span[p] < 384.0f     ? 32.0f
                           : span[p] < 1024.0f  ? 64.0f
                           : span[p] < 2048.0f  ? 128.0f
                           : span[p] < 6000.0f  ? 256.0f
                           : span[p] < 16384.0f ? 512.0f
                                                : 1024.0f;
        // Eight indices are off by up to half of a seventh: 1 / 49 of an even spread's squares.
        estimates[p] =
            a.off[p] + b.off[p] + (a.along[p] + b.along[p]) / 49.0f + noise * step * step;
    }
    return estimates;
}

}  // namespace tukor
