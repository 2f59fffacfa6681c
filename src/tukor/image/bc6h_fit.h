// One BC6H block in one partition: endpoints by least squares in the modes that can hold them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "tukor/image/bc6h_partition.h"

namespace tukor {

/// Everything that a block stores.
struct Bc6hFit {
    std::size_t mode = 0;                           // in kBc6hModes
    std::size_t partition = 0;                      // where the mode has two subsets
    std::array<std::array<int, 3>, 4> endpoints{};  // as quantized, before differences are taken
    std::array<std::uint8_t, 16> indices{};
    float error = 0.0f;  // squared and weighted, of all targets
};

[[nodiscard]] Bc6hFit fitBc6hWhole(const Bc6hTargets& targets) noexcept;
[[nodiscard]] Bc6hFit fitBc6hPartition(const Bc6hTargets& targets, std::size_t partition) noexcept;

}  // namespace tukor
