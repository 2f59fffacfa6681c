// Where samples lie within a texel, a pixel or a unit square.
#pragma once

#include <glm/vec2.hpp>

namespace tukor {

/// The middle of cell i of a grid of n x n cells over [0, 1]^2, row by row; i in [0, n * n).
[[nodiscard]] constexpr glm::vec2 gridPoint(int i, int n) noexcept {
    const int column = i % n, row = i / n;
    return {(static_cast<float>(column) + 0.5f) / static_cast<float>(n),
            (static_cast<float>(row) + 0.5f) / static_cast<float>(n)};
}

}  // namespace tukor
