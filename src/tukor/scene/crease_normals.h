// Normals for surfaces that come without: smooth where triangles meet gently, sharp at creases.
#pragma once
#include "tukor/geometry/mesh.h"

namespace tukor {

/// The same surface with normals; those of `mesh`, if any, are ignored. Vertices are merged by
/// place and parted again along creases.
///
/// Two triangles that share an edge are on one side of a crease where their normals differ by less
/// than `creaseAngle` (radians, in [0, pi]). A vertex normal is the mean of its side's triangles
/// weighted by their angle at the vertex, so that it does not depend on how the surface is cut into
/// triangles. [Thürmer & Wüthrich 1998] Triangles with two corners at one place are dropped.
[[nodiscard]] Mesh withCreaseNormals(const Mesh& mesh, float creaseAngle);

/// The same for vertices that are merged already: no two at one place, no triangle with two corners
/// alike.
[[nodiscard]] Mesh creaseNormalsOfWelded(std::vector<glm::vec3> positions,
                                         std::vector<glm::uvec3> triangles, float creaseAngle);

}  // namespace tukor
