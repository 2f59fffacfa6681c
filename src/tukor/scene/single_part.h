// The scene of a file format that holds one nameless surface.
#pragma once
#include <filesystem>

#include "tukor/scene/model_file.h"

namespace tukor {

/// A scene of one finished part, named after the file without its extension, of the default
/// material. Throws Error where there are no triangles.
[[nodiscard]] Scene singlePart(const std::filesystem::path& path, Mesh mesh,
                               const ModelOptions& options);

}  // namespace tukor
