// What chance chooses along a light path, spread evenly over the samples of a pixel.
#pragma once
#include <cstdint>

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

}  // namespace tukor::trace
