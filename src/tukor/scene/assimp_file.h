// All other model formats, through Assimp.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "tukor/scene/model_file.h"

namespace tukor {

/// A model with the contents `bytes` in a format that assimpReads(), told by the extension of
/// `path`. Files that it names are read below its folder only. Throws Error.
[[nodiscard]] Scene loadThroughAssimp(const std::filesystem::path& path,
                                      std::span<const std::byte> bytes,
                                      const ModelOptions& options = {});

/// Whether models with this extension are read: .fbx .dae .3ds .3mf .x .lwo .blend .ac .ms3d .x3d.
[[nodiscard]] bool assimpReads(const std::string& extension);

}  // namespace tukor
