// Single texels of a cube map: where they look, how much of the sphere they see, who is next.
#pragma once
#include <vector>

#include "tukor/environment/cube_map.h"

namespace tukor {

/// A texel's address. `column` and `row` count from the face's top-left corner.
struct CubeTexel {
    CubeFace face;
    int column;
    int row;

    friend bool operator==(const CubeTexel&, const CubeTexel&) = default;
};

/// World direction of the texel's centre, not normalised: its largest component is +-1.
[[nodiscard]] glm::vec3 directionFromTexel(CubeTexel texel, int faceSize) noexcept;

/// The texel that lies at an address up to `faceSize` beyond one edge of its face, as if the
/// neighbouring face were folded into the plane. Addresses within the face stay.
///
/// Not both `column` and `row` may lie outside: three texels meet at a corner of the cube, not
/// four.
[[nodiscard]] CubeTexel texelAcrossEdge(CubeTexel texel, int faceSize) noexcept;

/// Steradians of the texel, exact; all six faces alike. They sum to 4 pi.
[[nodiscard]] double texelSolidAngle(int faceSize, int column, int row) noexcept;

/// texelSolidAngle of a whole face, row-major, `faceSize` squared.
[[nodiscard]] std::vector<float> faceSolidAngles(int faceSize);

}  // namespace tukor
