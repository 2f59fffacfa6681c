// Which meshes are spheres: renderers then meet the sphere itself, not its triangles.
#pragma once
#include <optional>

#include "tukor/geometry/mesh.h"

namespace tukor {

struct Sphere {
    glm::vec3 centre;
    float radius;
};

/// The sphere that a mesh stands for, if it does: closed and the right way out, with radial
/// normals, every point of it within a thousandth of the radius. The radius is that of the same
/// area, so that on average over all views the outline stays what it was (see makeSphere).
[[nodiscard]] std::optional<Sphere> wholeSphere(const Mesh& mesh);

}  // namespace tukor
