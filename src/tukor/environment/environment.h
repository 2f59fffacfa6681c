// Captured or computed light from all around: what `--environment` names, made ready for the
// renderers.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tukor/environment/cube_map.h"

namespace tukor {

struct EnvironmentOptions {
    std::optional<int> faceSize;  // texels per cube edge; none: by the source's resolution
};

/// An environment ready to light a scene. Texels are finite and non-negative.
struct Environment {
    std::string name;
    CubeMap radiance;
    std::vector<std::string>
        warnings;  // replaced texels and the like, one sentence each, without the file's name
};

/// From a built-in name (`studio`, `sky`) or an image file: equirectangular, cross, or six faces by
/// a pattern.
///
/// A file wins over a built-in only when it is given with a folder or an extension. Throws Error.
[[nodiscard]] Environment loadEnvironment(const std::string& nameOrPath,
                                          const EnvironmentOptions& options = {});

}  // namespace tukor
