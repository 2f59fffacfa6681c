// What files dropped on a window ask for.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tukor/app/options.h"

namespace tukor {

/// Whether such a path is light from all around: a picture, a texture with a cube map, a folder.
[[nodiscard]] bool namesEnvironment(const std::filesystem::path& path);

/// The options with what was dropped: models instead of the old ones, and an environment.
///
/// Beside a model its other files are ignored: buffers, materials, and pictures, which are textures
/// then; only .hdr and .exr are light beside it. Without one, what is no environment is a model of
/// unknown extension.
[[nodiscard]] SessionOptions withDropped(SessionOptions options,
                                         const std::vector<std::string>& files);

}  // namespace tukor
