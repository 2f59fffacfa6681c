// Quantized endpoints of a BC6H block for given indices: the least squared error a mode can hold.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "tukor/image/bc6h_modes.h"
#include "tukor/image/bc6h_partition.h"

namespace tukor {

/// The squared error of a subset's channel is a quadratic of its endpoints a and b:
/// aa a^2 + 2 ab a b + bb b^2 - 2 (a atA + b atB) + a constant.
struct Bc6hNormal {
    float aa = 0.0f;
    float ab = 0.0f;
    float bb = 0.0f;
    std::array<float, 3> atA{};
    std::array<float, 3> atB{};

    float perB = 0.0f;         // 1 / bb, or 0
    std::array<float, 3> a{};  // the best endpoints
    std::array<float, 3> b{};
};

/// Endpoint values of a mode on one channel.
struct Bc6hGrid {
    int bits;
    float centre;

    [[nodiscard]] int most() const noexcept { return (1 << bits) - 1; }
    [[nodiscard]] float value(int quantized) const noexcept {
        return static_cast<float>(unquantizedBc6h(quantized, bits)) - centre;
    }
    /// In steps: value(n) is at n + 1/2.
    [[nodiscard]] float place(float value) const noexcept {
        const float place = (value + centre) * static_cast<float>(1 << bits) / 65536.0f;
        return std::clamp(bits < 15 ? place : place + 0.5f, 0.0f, static_cast<float>(most()));
    }
    [[nodiscard]] int nearest(float value, int low, int high) const noexcept {
        return std::clamp(static_cast<int>(place(value)), low, high);
    }
};

/// A subset's endpoints on one channel.
struct Bc6hPair {
    int a = 0;
    int b = 0;
    float error = 0.0f;  // less the constant
    bool clamped = false;
};

/// Both subsets' endpoints on one channel: the first one's a is what others differ from.
struct Bc6hChannel {
    std::array<Bc6hPair, 2> pairs;
    float error = std::numeric_limits<float>::max();
    bool clamped = false;
};

struct Bc6hChoice {
    std::size_t mode = 0;
    std::array<Bc6hChannel, 3> channels;
};

/// The mode of the least error and its endpoints. `modes` are tried in order, finest first, up to
/// the first that holds the best endpoints as they are.
[[nodiscard]] Bc6hChoice chooseBc6hMode(const Bc6hTargets& targets,
                                        const std::array<Bc6hNormal, 2>& normals,
                                        std::span<const std::size_t> modes) noexcept;

}  // namespace tukor
