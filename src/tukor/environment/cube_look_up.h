// Many look-ups in one cube map.
#pragma once
#include <array>

#include "tukor/environment/cube_map.h"
#include "tukor/environment/float4.h"

namespace tukor {

/// CubeMap::radiance in few instructions where all four texels are on one face. The map must
/// outlive it.
class CubeLookUp {
public:
    explicit CubeLookUp(const CubeMap& cube)
        : cube_(cube), half_(0.5f * static_cast<float>(cube.faceSize())) {
        for (const CubeFace face : kCubeFaces)
            faces_[static_cast<std::size_t>(face)] = cube.texels(face).data();
    }

    [[nodiscard]] Float4 operator()(glm::vec3 direction) const noexcept {
        const CubePoint point = cubeFromDirection(direction);
        const float u = point.s * half_ + (half_ - 0.5f), v = point.t * half_ + (half_ - 0.5f);
        const int size = cube_.faceSize();
        // The last load reads one float beyond its texel: not where that is the last of all.
        if (!(u >= 0.0f && v >= 0.0f && u < static_cast<float>(size - 2) &&
              v < static_cast<float>(size - 1)))
            return float4(cube_.radiance(direction));
        const int column = static_cast<int>(u), row = static_cast<int>(v);
        const glm::vec3* const above =
            faces_[static_cast<std::size_t>(point.face)] +
            static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + column;
        const glm::vec3* const below = above + size;
        const float right = u - static_cast<float>(column), down = v - static_cast<float>(row);
        Float4 a = loadFloat4(above), b = loadFloat4(below);
        a += right * (loadFloat4(above + 1) - a);
        b += right * (loadFloat4(below + 1) - b);
        return a + down * (b - a);
    }

private:
    const CubeMap& cube_;
    float half_;
    std::array<const glm::vec3*, 6> faces_;
};

}  // namespace tukor
