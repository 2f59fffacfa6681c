// Primitives compressed by KHR_draco_mesh_compression.
#pragma once
#include <cstddef>
#include <span>

#include "tukor/geometry/mesh.h"
#include "tukor/scene/json_item.h"

namespace tukor {

/// The triangles that a Draco stream holds, with normals where the extension names them.
///
/// Throws Error where it is damaged, and where it holds more than the declared numbers of vertices
/// and triangles, which are those of the accessors.
[[nodiscard]] Mesh dracoDecoded(const JsonItem& extension, std::span<const std::byte> compressed,
                                std::size_t vertices, std::size_t triangles);

}  // namespace tukor
