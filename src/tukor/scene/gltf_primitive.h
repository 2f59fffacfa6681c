// The triangles of one glTF primitive, as the file has them: in the mesh's own space.
#pragma once
#include <cstdint>

#include "tukor/geometry/mesh.h"
#include "tukor/scene/gltf_deformation.h"
#include "tukor/scene/gltf_document.h"
#include "tukor/scene/notes.h"

namespace tukor {

/// How many triangles a primitive has, without reading them; 0 for points and lines.
[[nodiscard]] std::uint64_t triangleCountOf(const GltfDocument& document,
                                            const JsonItem& primitive);

/// Positions, normals if there are any, and triangles: only the vertices that are used. Indices are
/// in range. Moved by `deformation`. `part` is the name for notes.
[[nodiscard]] Mesh readPrimitive(const GltfDocument& document, const JsonItem& primitive,
                                 const GltfDeformation& deformation, std::string_view part,
                                 Notes& notes);

}  // namespace tukor
