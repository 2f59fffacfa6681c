// Cube maps whose faces stand otherwise than this project's: turned by quarters, mirrored, with
// other axes. Texels move whole: nothing is resampled.
#pragma once
#include <array>

#include "tukor/environment/cube_map.h"

namespace tukor {

/// World axes of a face as it is stored: to the right, downwards, and out of the cube. Each is a
/// unit vector along an axis, the three orthogonal; either handedness.
struct FaceAxes {
    glm::ivec3 s, t, out;
};

/// In the order of CubeFace.
using CubeAxes = std::array<FaceAxes, 6>;

/// This project's own: the table of cube_map.h.
[[nodiscard]] CubeAxes worldCubeAxes() noexcept;

/// Each axis sent through a function of glm::ivec3.
template <class Map>
[[nodiscard]] CubeAxes mapped(CubeAxes axes, const Map& map) {
    for (FaceAxes& face : axes) face = {map(face.s), map(face.t), map(face.out)};
    return axes;
}

/// The faces as one stores them whose faces have `axes`.
[[nodiscard]] CubeMap storedCube(const CubeMap& world, const CubeAxes& axes);

/// The opposite: this project's faces from those whose faces have `axes`.
[[nodiscard]] CubeMap worldCube(const CubeMap& stored, const CubeAxes& axes);

}  // namespace tukor
