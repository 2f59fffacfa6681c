// Cube maps of linear radiance: the one environment format every renderer consumes.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/base/large_allocator.h"

namespace tukor {

/// Faces in OpenGL layer order. World axes are right-handed, +Y up; s runs right, t runs down.
///
///     face  posX negX posY negY posZ negZ
///     +s     -Z   +Z   +X   +X   +X   -X
///     +t     -Y   -Y   +Z   -Z   -Y   -Y
enum class CubeFace { posX, negX, posY, negY, posZ, negZ };

inline constexpr std::array kCubeFaces = {CubeFace::posX, CubeFace::negX, CubeFace::posY,
                                          CubeFace::negY, CubeFace::posZ, CubeFace::negZ};

/// Six square faces of linear Rec. 709 radiance, in W sr^-1 m^-2 up to one common scale.
///
/// Owns its texels: copies copy texels, moves are free. Concurrent reads are safe.
class CubeMap {
public:
    /// A black map. `faceSize` is in texels, at least 1.
    explicit CubeMap(int faceSize);

    [[nodiscard]] int faceSize() const noexcept { return faceSize_; }

    /// The faceSize() x faceSize() texels of a face, row-major from its top-left corner.
    [[nodiscard]] std::span<const glm::vec3> texels(CubeFace face) const noexcept;
    [[nodiscard]] std::span<glm::vec3> texels(CubeFace face) noexcept;

    /// Bilinear radiance from a world direction of any non-zero length; seamless across edges, as
    /// GLES 3 samples it.
    [[nodiscard]] glm::vec3 radiance(glm::vec3 direction) const noexcept;

private:
    int faceSize_;
    std::vector<glm::vec3, LargeAllocator<glm::vec3>> texels_;  // [face][row][column]
};

/// A place on the surface of the cube: s and t in [-1, 1], s right, t down.
struct CubePoint {
    CubeFace face;
    float s;
    float t;
};

/// The world direction of a place on the cube, not normalised: its largest component is +-1.
[[nodiscard]] glm::vec3 directionFromCube(CubePoint point) noexcept;

/// Where a direction of any non-zero length meets the cube.
[[nodiscard]] inline CubePoint cubeFromDirection(glm::vec3 direction) noexcept {
    const glm::vec3 size = glm::abs(direction);
    if (size.x >= size.y && size.x >= size.z) {
        const float scale = 1.0f / size.x;
        return direction.x > 0.0f
                   ? CubePoint{CubeFace::posX, -direction.z * scale, -direction.y * scale}
                   : CubePoint{CubeFace::negX, direction.z * scale, -direction.y * scale};
    }
    if (size.y >= size.z) {
        const float scale = 1.0f / size.y;
        return direction.y > 0.0f
                   ? CubePoint{CubeFace::posY, direction.x * scale, direction.z * scale}
                   : CubePoint{CubeFace::negY, direction.x * scale, -direction.z * scale};
    }
    const float scale = 1.0f / size.z;
    return direction.z > 0.0f
               ? CubePoint{CubeFace::posZ, direction.x * scale, -direction.y * scale}
               : CubePoint{CubeFace::negZ, -direction.x * scale, -direction.y * scale};
}

}  // namespace tukor
