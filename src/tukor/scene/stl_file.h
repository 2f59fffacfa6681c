// Stereolithography files, binary or text.
#pragma once
#include <filesystem>
#include <span>

#include "tukor/scene/model_file.h"

namespace tukor {

/// The one part of an STL file with the contents `bytes`, named after the file. Corners at one
/// place are merged; the file's facet normals are passed over: the winding says the same. Throws
/// Error.
[[nodiscard]] Scene loadStl(const std::filesystem::path& path, std::span<const std::byte> bytes,
                            const ModelOptions& options = {});

}  // namespace tukor
