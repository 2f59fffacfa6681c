#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <Imath/half.h>

#include "tukor/base/parallel.h"
#include "tukor/image/bc6h.h"
#include "tukor/image/bc6h_fit.h"

namespace tukor {

namespace {

// Of the partitions estimated to be best: all 32 leave 1 % less error and take
// three times as long.
constexpr int kMostPartitions = 4;

constexpr float kMostHalf = 65504.0f;

/// The middle of what decodes to a half: the decoder takes 31 / 64 and drops the fraction.
float targetOf(float half) noexcept {
    return (64.0f * half + 32.0f) / 31.0f;
}

/// Differences of halves' bits are those of logarithms. What they are worth falls with the square
/// root of a texel's radiance below the block's brightest, else lamps would lose power to texels
/// that they outshine, and with that of a channel below its texels' strongest.
void weigh(const Bc6hTexels& texels, Bc6hTargets& targets) noexcept {
    constexpr float kOctave = 1024.0f;           // in bits of halves
    constexpr float kLeastTexel = 1.0f / 32.0f;  // what is dark beside a lamp stays dark
    constexpr float kLeastChannel = 1.0f / 256.0f;
    std::array<float, 16> strongest;
    std::array<float, 3> below;
    below.fill(-65536.0f);
    for (std::size_t i = 0; i < 16; ++i) {
        strongest[i] = static_cast<float>(*std::max_element(texels[i].begin(), texels[i].end()));
        for (std::size_t c = 0; c < 3; ++c)
            below[c] = std::max(below[c], static_cast<float>(texels[i][c]) - strongest[i]);
    }
    const float most = *std::max_element(strongest.begin(), strongest.end());
    for (std::size_t i = 0; i < 16; ++i)
        targets.texelWeights[i] =
            std::max(std::exp2(0.5f * (strongest[i] - most) / kOctave), kLeastTexel);
    for (std::size_t c = 0; c < 3; ++c)
        targets.channelWeights[c] = std::max(std::exp2(below[c] / kOctave), kLeastChannel);
}

Bc6hTargets targetsOf(const Bc6hTexels& texels) noexcept {
    Bc6hTargets targets;
    for (std::size_t c = 0; c < 3; ++c) {
        float sum = 0.0f;
        for (std::size_t i = 0; i < 16; ++i) {
            targets.at[c][i] = targetOf(static_cast<float>(texels[i][c]));
            sum += targets.at[c][i];
        }
        targets.centre[c] = static_cast<int>(sum / 16.0f);
        for (float& value : targets.at[c]) value -= static_cast<float>(targets.centre[c]);
    }
    weigh(texels, targets);
    return targets;
}

/// The 128 bits of a block, lowest first.
class BitWriter {
public:
    void put(std::uint32_t value, int count) noexcept {
        const auto bits = static_cast<std::uint64_t>(value);
        words_[at_ / 64] |= bits << (at_ % 64);
        if (at_ < 64 && at_ + count > 64) words_[1] |= bits >> (64 - at_);
        at_ += count;
    }
    [[nodiscard]] std::array<std::byte, kBc6hBytes> bytes() const noexcept {
        std::array<std::byte, kBc6hBytes> out;
        std::memcpy(out.data(), words_, sizeof words_);
        return out;
    }

private:
    std::uint64_t words_[2] = {0, 0};
    int at_ = 0;
};

std::array<std::byte, kBc6hBytes> packed(const Bc6hFit& fit) noexcept {
    const Bc6hMode& mode = kBc6hModes[fit.mode];
    std::array<std::array<int, 3>, 4> stored = fit.endpoints;
    if (mode.transformed)
        for (std::size_t e = 1; e < 4; ++e)
            for (std::size_t c = 0; c < 3; ++c) stored[e][c] -= stored[0][c];
    BitWriter out;
    out.put(mode.number, mode.modeBits);
    const Bc6hBits& bits = kBc6hBits[fit.mode];
    for (int i = 0; i < bits.count; ++i) {
        const Bc6hBit bit = bits.at[static_cast<std::size_t>(i)];
        out.put(static_cast<std::uint32_t>(stored[bit.endpoint][bit.channel] >> bit.bit & 1), 1);
    }
    const bool two = mode.subsets == 2;
    if (two) out.put(static_cast<std::uint32_t>(fit.partition), 5);
    for (std::size_t i = 0; i < 16; ++i) {
        const bool anchor = i == 0 || (two && i == kBc6hPartitions[fit.partition].anchor);
        out.put(fit.indices[i], (two ? 3 : 4) - (anchor ? 1 : 0));
    }
    return out.bytes();
}

std::uint16_t halfBits(float value) noexcept {
    return value > 0.0f ? half(std::min(value, kMostHalf)).bits() : std::uint16_t{0};
}

/// Texels beyond the edge repeat those within, so that they weigh alike.
Bc6hTexels texelsOf(const Image& image, int x, int y) noexcept {
    const int width = std::min(4, image.width() - 4 * x);
    const int height = std::min(4, image.height() - 4 * y);
    Bc6hTexels texels;
    for (int i = 0; i < 16; ++i) {
        const glm::vec3 value = image.at(4 * x + i % 4 % width, 4 * y + i / 4 % height);
        for (int c = 0; c < 3; ++c)
            texels[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)] = halfBits(value[c]);
    }
    return texels;
}

}  // namespace

std::array<std::byte, kBc6hBytes> encodeBc6hBlock(const Bc6hTexels& texels) noexcept {
    const Bc6hTargets targets = targetsOf(texels);
    Bc6hFit best = fitBc6hWhole(targets);
    // Less than one code of the halves, which are 2 apart here: nothing is left to gain.
    constexpr float kExact = 48.0f * 4.0f;
    if (best.error <= kExact) return packed(best);
    std::array<float, 32> estimates = estimateBc6h(targets);
    for (int i = 0; i < kMostPartitions; ++i) {
        const auto next = std::min_element(estimates.begin(), estimates.end());
        if (*next > 2.0f * best.error) break;
        const auto partition = static_cast<std::size_t>(next - estimates.begin());
        *next = std::numeric_limits<float>::max();
        const Bc6hFit fit = fitBc6hPartition(targets, partition);
        if (fit.error < best.error) best = fit;
    }
    return packed(best);
}

bool encodeBc6h(const Image& image, std::vector<std::byte>& out, const Progress& progress) {
    const int across = (image.width() + 3) / 4;
    const std::size_t start = out.size();
    const std::size_t count = bc6hBlocks(image.width(), image.height());
    out.resize(start + count * kBc6hBytes);
    constexpr int kGrain = 64;  // half a millisecond
    return parallelFor(0, static_cast<int>(count), kGrain, progress, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const auto block = encodeBc6hBlock(texelsOf(image, i % across, i / across));
            std::memcpy(out.data() + start + static_cast<std::size_t>(i) * kBc6hBytes, block.data(),
                        block.size());
        }
    });
}

}  // namespace tukor
