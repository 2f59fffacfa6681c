#include "tukor/image/bc6h_endpoints.h"

#include <algorithm>
#include <cmath>

namespace tukor {

namespace {

float errorOf(const Bc6hNormal& n, std::size_t c, float a, float b) noexcept {
    return a * (n.aa * a + 2.0f * (n.ab * b - n.atA[c])) + b * (n.bb * b - 2.0f * n.atB[c]);
}

/// The best second endpoint beside a given first, within [low, high].
Bc6hPair besideFirst(const Bc6hGrid& grid, const Bc6hNormal& n, std::size_t c, int a, int low,
                     int high) noexcept {
    const float first = grid.value(a);
    const float best = n.bb > 0.0f ? (n.atB[c] - n.ab * first) * n.perB : first;
    const int free = grid.nearest(best, 0, grid.most());
    Bc6hPair pair{a, std::clamp(free, low, high), 0.0f, false};
    pair.clamped = pair.b != free;
    pair.error = errorOf(n, c, first, grid.value(pair.b));
    return pair;
}

/// The two grid places around a value.
std::array<int, 2> around(const Bc6hGrid& grid, float value) noexcept {
    const float place = grid.place(value);
    const int nearest = static_cast<int>(place);
    const int other = place - static_cast<float>(nearest) < 0.5f ? nearest - 1 : nearest + 1;
    return {nearest, std::clamp(other, 0, grid.most())};
}

Bc6hChannel fitChannel(const Bc6hMode& mode, const Bc6hTargets& targets,
                       const std::array<Bc6hNormal, 2>& normals, std::size_t c) noexcept {
    const Bc6hGrid grid{mode.endpointBits, static_cast<float>(targets.centre[c])};
    const int reach = 1 << (mode.deltaBits[c] - 1);
    Bc6hChannel best;
    for (const int base : around(grid, normals[0].a[c])) {
        const int low = mode.transformed ? std::max(base - reach, 0) : 0;
        const int high = mode.transformed ? std::min(base + reach - 1, grid.most()) : grid.most();
        Bc6hChannel channel;
        channel.pairs[0] = besideFirst(grid, normals[0], c, base, low, high);
        channel.error = channel.pairs[0].error;
        channel.clamped = channel.pairs[0].clamped;
        if (mode.subsets == 2) {
            Bc6hPair& second = channel.pairs[1];
            second.error = std::numeric_limits<float>::max();
            for (const int free : around(grid, normals[1].a[c])) {
                const int a = std::clamp(free, low, high);
                Bc6hPair pair = besideFirst(grid, normals[1], c, a, low, high);
                pair.clamped = pair.clamped || a != free;
                if (pair.error < second.error) second = pair;
            }
            channel.error += second.error;
            channel.clamped = channel.clamped || second.clamped;
        }
        if (channel.error < best.error) best = channel;
    }
    return best;
}

/// Whether clamped endpoints would be far from the best: by more than half of the reach.
bool isOutOfReach(const Bc6hMode& mode, const std::array<Bc6hNormal, 2>& normals) noexcept {
    if (!mode.transformed) return false;
    for (std::size_t c = 0; c < 3; ++c) {
        const float reach = static_cast<float>(3 << (mode.deltaBits[c] - 2)) * 65536.0f /
                            static_cast<float>(1 << mode.endpointBits);
        const float base = normals[0].a[c];
        float most = std::abs(normals[0].b[c] - base);
        if (mode.subsets == 2)
            most = std::max(
                {most, std::abs(normals[1].a[c] - base), std::abs(normals[1].b[c] - base)});
        if (most > reach) return true;
    }
    return false;
}

}  // namespace

Bc6hChoice chooseBc6hMode(const Bc6hTargets& targets, const std::array<Bc6hNormal, 2>& normals,
                          std::span<const std::size_t> modes) noexcept {
    Bc6hChoice best;
    float least = std::numeric_limits<float>::max();
    for (const std::size_t mode : modes) {
        if (isOutOfReach(kBc6hModes[mode], normals)) continue;
        Bc6hChoice choice{mode, {}};
        float error = 0.0f;
        bool clamped = false;
        for (std::size_t c = 0; c < 3; ++c) {
            choice.channels[c] = fitChannel(kBc6hModes[mode], targets, normals, c);
            error += targets.channelWeights[c] * choice.channels[c].error;
            clamped = clamped || choice.channels[c].clamped;
        }
        if (error < least) {
            least = error;
            best = choice;
        }
        if (!clamped) break;  // coarser ones hold nothing more
    }
    return best;
}

}  // namespace tukor
