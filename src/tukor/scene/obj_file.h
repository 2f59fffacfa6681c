// Wavefront OBJ and its material library.
#pragma once
#include <filesystem>
#include <span>

#include "tukor/scene/model_file.h"

namespace tukor {

/// Objects or groups, by material, of an OBJ file with the contents `bytes`. Polygons are cut into
/// triangles; lines, points and free-form surfaces are left out with a warning. Throws Error.
[[nodiscard]] Scene loadObj(const std::filesystem::path& path, std::span<const std::byte> bytes,
                            const ModelOptions& options = {});

}  // namespace tukor
