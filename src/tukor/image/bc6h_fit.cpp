#include "tukor/image/bc6h_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "tukor/image/bc6h_endpoints.h"
#include "tukor/image/bc6h_modes.h"

namespace tukor {

namespace {

constexpr int kRounds = 3;  // more gain less than 0.1 % of the error

// Finest first: the first one whose differences reach is the best but for luck.
constexpr std::array<std::size_t, 4> kWholeModes{13, 12, 11, 10};
constexpr std::array<std::size_t, 10> kPartedModes{2, 3, 4, 0, 5, 6, 7, 8, 1, 9};

using Texels = std::array<float, 16>;

/// Which texels are where, and how finely they are indexed.
struct Parting {
    std::size_t partition;
    std::size_t subsets;
    float steps;     // the highest index
    Texels second;   // 1 in the second subset, else 0
    Texels highest;  // index allowed: anchors lack a bit
    std::array<std::size_t, 2> anchors;
    std::span<const std::size_t> modes;
};

Parting whole() noexcept {
    Parting parting{0, 1, 15.0f, {}, {}, {0, 0}, kWholeModes};
    parting.highest.fill(15.0f);
    parting.highest[0] = 7.0f;
    return parting;
}

Parting parted(std::size_t partition) noexcept {
    const Bc6hPartition& p = kBc6hPartitions[partition];
    Parting parting{partition, 2, 7.0f, {}, {}, {0, p.anchor}, kPartedModes};
    parting.highest.fill(7.0f);
    for (const std::size_t anchor : parting.anchors) parting.highest[anchor] = 3.0f;
    for (std::size_t i = 0; i < 16; ++i) parting.second[i] = static_cast<float>(p.second >> i & 1);
    return parting;
}

/// The weight of an index: 64 index / steps rounded, as the tables have it.
float weightOf(float index, float steps) noexcept {
    return std::floor(index * (64.0f / steps) + 0.5f) * (1.0f / 64.0f);
}

std::array<Bc6hNormal, 2> normalEquations(const Bc6hTargets& targets, const Parting& parting,
                                          const Texels& weights) noexcept {
    std::array<Bc6hNormal, 2> normals;
    for (std::size_t i = 0; i < 16; ++i) {
        Bc6hNormal& normal = normals[parting.second[i] > 0.0f ? 1 : 0];
        const float w = weights[i];
        const float v = 1.0f - w;
        const float vv = v * targets.texelWeights[i];
        const float ww = w * targets.texelWeights[i];
        normal.aa += v * vv;
        normal.ab += v * ww;
        normal.bb += w * ww;
        for (std::size_t c = 0; c < 3; ++c) {
            normal.atA[c] += vv * targets.at[c][i];
            normal.atB[c] += ww * targets.at[c][i];
        }
    }
    for (Bc6hNormal& n : normals) {
        n.perB = n.bb > 0.0f ? 1.0f / n.bb : 0.0f;
        const float whole = n.aa + 2.0f * n.ab + n.bb;
        const float determinant = n.aa * n.bb - n.ab * n.ab;
        // Two texels of different indices have at least (1 / 15)^2 times their weights.
        const bool differ = determinant > 1e-4f * whole;
        for (std::size_t c = 0; c < 3; ++c) {
            n.a[c] = differ         ? (n.bb * n.atA[c] - n.ab * n.atB[c]) / determinant
                     : whole > 0.0f ? (n.atA[c] + n.atB[c]) / whole
                                    : 0.0f;
            n.b[c] = differ ? (n.aa * n.atB[c] - n.ab * n.atA[c]) / determinant : n.a[c];
        }
    }
    return normals;
}

/// The principal axis of a subset cut into indices, the anchor in the lower half.
Texels firstWeights(const Bc6hTargets& targets, const Parting& parting) noexcept {
    Texels weights{};
    for (std::size_t s = 0; s < parting.subsets; ++s) {
        const auto inside = [&](std::size_t i) { return (parting.second[i] > 0.0f) == (s == 1); };
        float count = 0.0f;
        std::array<float, 3> mean{};
        for (std::size_t i = 0; i < 16; ++i) {
            if (!inside(i)) continue;
            count += targets.texelWeights[i];
            for (std::size_t c = 0; c < 3; ++c)
                mean[c] += targets.texelWeights[i] * targets.at[c][i];
        }
        for (float& m : mean) m /= count;
        float scale[3];
        for (std::size_t c = 0; c < 3; ++c) scale[c] = std::sqrt(targets.channelWeights[c]);
        float m[3][3] = {};
        for (std::size_t i = 0; i < 16; ++i) {
            if (!inside(i)) continue;
            float d[3];
            for (std::size_t c = 0; c < 3; ++c) d[c] = scale[c] * (targets.at[c][i] - mean[c]);
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) m[r][c] += targets.texelWeights[i] * d[r] * d[c];
        }
        int largest = m[1][1] > m[0][0] ? 1 : 0;
        if (m[2][2] > m[largest][largest]) largest = 2;
        float axis[3] = {m[largest][0], m[largest][1], m[largest][2]};
        for (int round = 0; round < 4; ++round) {
            const float size =
                std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2]), 1e-20f});
            const float x = axis[0] / size;
            const float y = axis[1] / size;
            const float z = axis[2] / size;
            for (int r = 0; r < 3; ++r) axis[r] = m[r][0] * x + m[r][1] * y + m[r][2] * z;
        }
        for (int c = 0; c < 3; ++c) axis[c] *= scale[c];
        float low = std::numeric_limits<float>::max();
        float high = -low;
        Texels along{};
        for (std::size_t i = 0; i < 16; ++i) {
            along[i] = axis[0] * targets.at[0][i] + axis[1] * targets.at[1][i] +
                       axis[2] * targets.at[2][i];
            if (!inside(i)) continue;
            low = std::min(low, along[i]);
            high = std::max(high, along[i]);
        }
        if (!(high > low)) continue;  // all alike: weights of 0
        if (along[parting.anchors[s]] - low > high - along[parting.anchors[s]])
            std::swap(low, high);
        for (std::size_t i = 0; i < 16; ++i)
            if (inside(i))
                weights[i] = weightOf(
                    std::min(std::floor(parting.steps * (along[i] - low) / (high - low) + 0.5f),
                             parting.highest[i]),
                    parting.steps);
    }
    return weights;
}

/// The nearest index of every texel between given endpoints; returns the squared error.
float assign(const Bc6hTargets& targets, const Parting& parting, const Bc6hChoice& choice,
             Texels& indices, Texels& weights) noexcept {
    const int bits = kBc6hModes[choice.mode].endpointBits;
    std::array<std::array<float, 2>, 3> first{};
    std::array<std::array<float, 2>, 3> step{};
    std::array<float, 2> scale{};
    for (std::size_t s = 0; s < parting.subsets; ++s) {
        float length = 0.0f;
        for (std::size_t c = 0; c < 3; ++c) {
            const Bc6hGrid grid{bits, static_cast<float>(targets.centre[c])};
            const Bc6hPair& pair = choice.channels[c].pairs[s];
            first[c][s] = grid.value(pair.a);
            step[c][s] = grid.value(pair.b) - first[c][s];
            length += targets.channelWeights[c] * step[c][s] * step[c][s];
        }
        scale[s] = length > 0.0f ? parting.steps / length : 0.0f;
    }
    Texels errors{};
    for (std::size_t i = 0; i < 16; ++i) {
        const float m = parting.second[i];
        float offset[3];
        float way[3];
        for (std::size_t c = 0; c < 3; ++c) {
            offset[c] = targets.at[c][i] - (m > 0.0f ? first[c][1] : first[c][0]);
            way[c] = m > 0.0f ? step[c][1] : step[c][0];
        }
        const float along = (targets.channelWeights[0] * offset[0] * way[0] +
                             targets.channelWeights[1] * offset[1] * way[1] +
                             targets.channelWeights[2] * offset[2] * way[2]) *
                            (m > 0.0f ? scale[1] : scale[0]);
        indices[i] = std::floor(std::min(std::max(along, 0.0f) + 0.5f, parting.highest[i]));
        weights[i] = weightOf(indices[i], parting.steps);
        for (std::size_t c = 0; c < 3; ++c) {
            const float error = offset[c] - weights[i] * way[c];
            errors[i] += targets.texelWeights[i] * targets.channelWeights[c] * error * error;
        }
    }
    float sum = 0.0f;
    for (const float error : errors) sum += error;
    return sum;
}

Bc6hFit fit(const Bc6hTargets& targets, const Parting& parting) noexcept {
    Bc6hFit best;
    best.error = std::numeric_limits<float>::max();
    best.partition = parting.partition;
    Texels weights = firstWeights(targets, parting);
    for (int round = 0; round < kRounds; ++round) {
        const Bc6hChoice choice =
            chooseBc6hMode(targets, normalEquations(targets, parting, weights), parting.modes);
        Texels indices;
        const float error = assign(targets, parting, choice, indices, weights);
        if (!(error < best.error)) break;
        best.error = error;
        best.mode = choice.mode;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t s = 0; s < 2; ++s) {
                best.endpoints[2 * s][c] = choice.channels[c].pairs[s].a;
                best.endpoints[2 * s + 1][c] = choice.channels[c].pairs[s].b;
            }
        for (std::size_t i = 0; i < 16; ++i)
            best.indices[i] = static_cast<std::uint8_t>(indices[i]);
    }
    return best;
}

}  // namespace

Bc6hFit fitBc6hWhole(const Bc6hTargets& targets) noexcept {
    return fit(targets, whole());
}

Bc6hFit fitBc6hPartition(const Bc6hTargets& targets, std::size_t partition) noexcept {
    return fit(targets, parted(partition));
}

}  // namespace tukor
