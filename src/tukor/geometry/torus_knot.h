// A tube along a torus knot.
#pragma once
#include "tukor/geometry/mesh.h"

namespace tukor {

/// The knot winds `turns` times around the axis of a torus (+Z) and `windings` times around its
/// tube; the two have no common divisor.
struct TorusKnotOptions {
    int turns = 2;
    int windings = 3;
    float tubeRadius = 0.18f;  // of a knot that just fits into the unit sphere's equator
    int segments = 500;        // along the knot
    int sides = 70;            // around the tube
};

/// Fits between radius 0 and 1 around the z axis. Normals are exact: those of the tube itself.
[[nodiscard]] Mesh makeTorusKnot(const TorusKnotOptions& options = {});

}  // namespace tukor
