// A drinking glass with water in it.
#pragma once
#include <string>
#include <vector>

#include "tukor/geometry/mesh.h"

namespace tukor {

/// Two closed surfaces that overlap: the water reaches into the wall of the glass, by less than its
/// thickness, and is to be rendered with the lower priority. y from -1 to 1.
struct Tumbler {
    Mesh glass;
    Mesh water;
};

[[nodiscard]] Tumbler makeTumbler();

/// An open surface between two media, by the names of their materials; empty is air.
struct MediumInterface {
    std::string front;  // the side that normals point to
    std::string back;
    Mesh mesh;
};

/// The same glass of water as surfaces between air, glass and water: what is left of the two meshes
/// of makeTumbler() when the water in the wall is taken away. Positions and normals are the same.
[[nodiscard]] std::vector<MediumInterface> makeTumblerInterfaces();

/// A stemmed glass, empty: one closed surface. y from -1 to 1.
[[nodiscard]] Mesh makeWineGlass();

}  // namespace tukor
