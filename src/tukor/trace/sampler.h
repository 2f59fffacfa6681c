// What chance chooses along a light path, from the lens on, spread evenly over the samples of a
// pixel.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tukor/transport/sampler.h"

namespace tukor::trace {

/// Points for the events of a path: for each, the sample's place in another shuffled and scrambled
/// sequence, so that the samples of a pixel cover what each of their events chooses from. [Burley
/// 2020]
struct PathSampler {
    std::uint32_t pixelSeed = 0;
    std::uint32_t index = 0;  // of the sample in its pixel
    std::uint32_t next = 0;   // sequence

    [[nodiscard]] glm::vec2 point() noexcept { return begin(1).at(0); }

    /// Points of one sequence, as many for each sample.
    struct Points {
        std::uint32_t seed, first;
        [[nodiscard]] glm::vec2 at(std::uint32_t i) const noexcept {
            return transport::pixelSample(
                seed, transport::owenScrambled(first + i, transport::mixedBits(seed)));
        }
    };
    [[nodiscard]] Points begin(std::uint32_t each) noexcept {
        return {transport::mixedBits(pixelSeed + 0x9e3779b9u * ++next), each * index};
    }
};

/// Where on the lens a sample begins, in [0, 1)^2: those of a pixel cover it evenly, in an order of
/// their own.
[[nodiscard]] inline glm::vec2 lensSample(std::uint32_t pixelSeed, std::uint32_t index) noexcept {
    const std::uint32_t own = transport::mixedBits(pixelSeed ^ 0x2c1b3c6du);
    return transport::pixelSample(own, transport::owenScrambled(index, transport::mixedBits(own)));
}

/// The same in the unit disc: squares about the middle become circles. [Shirley & Chiu 1997]
[[nodiscard]] inline glm::vec2 onLens(glm::vec2 sample) noexcept {
    const glm::vec2 at = 2.0f * sample - 1.0f;
    if (at == glm::vec2(0.0f)) return at;
    const bool wide = std::abs(at.x) > std::abs(at.y);
    const float radius = wide ? at.x : at.y;
    const float turn = 0.25f * std::numbers::pi_v<float> * (wide ? at.y / at.x : at.x / at.y);
    const glm::vec2 along(std::cos(turn), std::sin(turn));
    return radius * (wide ? along : glm::vec2(along.y, along.x));
}

}  // namespace tukor::trace
