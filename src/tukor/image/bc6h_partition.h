// Which partitions of a BC6H block are worth a try: an estimate for all 32 at once.
#pragma once
#include <array>

namespace tukor {

/// What an encoder fits: the 16-bit values between which the decoder interpolates, less `centre`.
struct Bc6hTargets {
    std::array<std::array<float, 16>, 3> at;  // [channel][texel]
    std::array<int, 3> centre;
    std::array<float, 16> texelWeights;   // of squared errors, above 0 and at most 1
    std::array<float, 3> channelWeights;  // likewise
};

/// The weighted squared errors to be expected of each partition, in its finest mode that holds it.
[[nodiscard]] std::array<float, 32> estimateBc6h(const Bc6hTargets& targets) noexcept;

}  // namespace tukor
