// The last step of every loader: from what a file says to a mesh that renderers can rely on.
#pragma once
#include <string_view>

#include "tukor/geometry/mesh.h"
#include "tukor/scene/notes.h"

namespace tukor {

/// Checks and repairs a mesh read from a file.
///
/// Throws Error, opened by `name`, for indices out of range and positions that are not finite or
/// beyond 1e12 m. Drops triangles with two corners at one place. Normalises the normals, or
/// computes them by crease angle where there are none or one has no direction. Where most normals
/// oppose the winding, turns the triangles round. `part` is the name for notes.
[[nodiscard]] Mesh finishedMesh(Mesh mesh, float creaseAngle, std::string_view name,
                                std::string_view part, Notes& notes);

}  // namespace tukor
