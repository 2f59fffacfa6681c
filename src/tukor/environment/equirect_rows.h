// Where a row of samples on a cube face lies in a panorama: the inner loop of its resampling.
#pragma once
#include <vector>

#include "tukor/environment/cube_map.h"

namespace tukor {

/// Panorama coordinates of samples along a line of constant t on a face.
class EquirectRow {
public:
    EquirectRow(int width, int height, int samples)
        : columns(static_cast<std::size_t>((samples + 7) / 8 * 8)),
          rows(columns.size()),
          width_(static_cast<float>(width)),
          height_(static_cast<float>(height)) {}

    /// Sample i lies at s = firstS + i * stepS. Right to 1e-6 radians.
    void place(CubeFace face, float t, float firstS, float stepS) noexcept;

    // Of as many samples as asked for, and some more up to a multiple of eight.
    std::vector<float> columns;  // in [0, width]: pixel i covers [i, i + 1)
    std::vector<float> rows;     // in [0, height]

private:
    float width_;
    float height_;
};

}  // namespace tukor
