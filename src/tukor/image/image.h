// Images of linear radiance: the one pixel type that everything computes with.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/base/large_allocator.h"

namespace tukor {

/// `width` x `height` pixels of linear Rec. 709 radiance, row-major from the top-left corner, pixel
/// centres at (i + 0.5) / N.
///
/// Owns its pixels: copies copy them, moves are free. `alpha` is either empty (opaque) or one
/// coverage in [0, 1] a pixel.
class Image {
public:
    Image() = default;

    /// A black picture. Both sizes are at least 1.
    Image(int width, int height)
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                  glm::vec3(0.0f)) {}

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] bool empty() const noexcept { return pixels_.empty(); }

    [[nodiscard]] glm::vec3& at(int column, int row) noexcept {
        return pixels_[index(column, row)];
    }
    [[nodiscard]] const glm::vec3& at(int column, int row) const noexcept {
        return pixels_[index(column, row)];
    }

    [[nodiscard]] std::span<glm::vec3> pixels() noexcept { return pixels_; }
    [[nodiscard]] std::span<const glm::vec3> pixels() const noexcept { return pixels_; }

    std::vector<float> alpha;

private:
    [[nodiscard]] std::size_t index(int column, int row) const noexcept {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(column);
    }

    int width_ = 0;
    int height_ = 0;
    std::vector<glm::vec3, LargeAllocator<glm::vec3>> pixels_;
};

}  // namespace tukor
