// Where the samples of a pixel lie: an Owen-scrambled Sobol sequence, another scrambling in each.
#pragma once
#include <cstdint>

#include <glm/glm.hpp>

namespace tukor::trace {

/// A well mixed 32-bit function. [Wellons 2018, lowbias32]
[[nodiscard]] constexpr std::uint32_t mixedBits(std::uint32_t x) noexcept {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

[[nodiscard]] constexpr std::uint32_t reversedBits(std::uint32_t x) noexcept {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Nested uniform scrambling by a hash: bit i depends on the bits above it. [Laine & Karras 2011;
/// constants of Vegdahl 2021]
[[nodiscard]] constexpr std::uint32_t owenScrambled(std::uint32_t x, std::uint32_t seed) noexcept {
    x = reversedBits(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reversedBits(x);
}

/// The second dimension of the Sobol sequence; the first is reversedBits.
[[nodiscard]] constexpr std::uint32_t sobolSecond(std::uint32_t index) noexcept {
    std::uint32_t result = 0;
    for (std::uint32_t v = 1u << 31; index != 0; index >>= 1, v ^= v >> 1) {
        if (index & 1u) result ^= v;
    }
    return result;
}

/// Sample `index` of a pixel, in [0, 1)^2. Every prefix of 2^k samples is a (0, k, 2)-net.
[[nodiscard]] inline glm::vec2 pixelSample(std::uint32_t pixelSeed, std::uint32_t index) noexcept {
    const std::uint32_t x = owenScrambled(reversedBits(index), mixedBits(pixelSeed + 1));
    const std::uint32_t y = owenScrambled(sobolSecond(index), mixedBits(pixelSeed + 2));
    constexpr float kScale = 1.0f / 16777216.0f;  // 24 bits: the result stays below 1
    return {static_cast<float>(x >> 8) * kScale, static_cast<float>(y >> 8) * kScale};
}

/// Points for the events of a path: for each, the sample's place in another shuffled and scrambled
/// sequence, so that the samples of a pixel cover what each of their events chooses from. [Burley
/// 2020]
struct PathSampler {
    std::uint32_t pixelSeed = 0;
    std::uint32_t index = 0;  // of the sample in its pixel
    std::uint32_t next = 0;   // sequence

    [[nodiscard]] glm::vec2 point() noexcept {
        const std::uint32_t seed = mixedBits(pixelSeed + 0x9e3779b9u * ++next);
        return pixelSample(seed, owenScrambled(index, mixedBits(seed)));
    }
};

}  // namespace tukor::trace
