// Polygon files of Stanford's format, text or binary of either byte order.
#pragma once
#include <filesystem>
#include <span>

#include "tukor/scene/model_file.h"

namespace tukor {

/// The one part of a PLY file with the contents `bytes`, named after the file. Polygons are cut
/// into triangles; properties other than x, y, z, nx, ny, nz are passed over. Throws Error.
[[nodiscard]] Scene loadPly(const std::filesystem::path& path, std::span<const std::byte> bytes,
                            const ModelOptions& options = {});

}  // namespace tukor
