// Texture coordinates, tangents and colours of meshes whose vertices are merged or parted.
#pragma once
#include <vector>

#include "tukor/geometry/mesh.h"

namespace tukor {

/// Whether the mesh has any of them.
[[nodiscard]] bool hasDetails(const Mesh& mesh) noexcept;

/// `target` with the details of `source`. Its triangles are those of `sources`, in the same order
/// and with the same corners, which refer to vertices of `source`; vertices are parted where
/// details differ.
[[nodiscard]] Mesh withDetailsOf(const Mesh& source, const std::vector<glm::uvec3>& sources,
                                 Mesh target);

}  // namespace tukor
