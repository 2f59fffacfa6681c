// Captured or computed light from all around: what `--environment` names, made ready for the
// renderers.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/base/options.h"
#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

struct EnvironmentOptions {
    /// Texels per cube edge; none: by the source's resolution, as faceSizeForEquirect has it and at
    /// most 2048, or 512 for what is built in.
    ///
    /// A look-up in the cube is bilinear between other places than one in the panorama. What is
    /// left of it, in 8-bit sRGB at 640 x 360 and a field of view of 40 degrees, over photographs
    /// of width 1024: faces of 512 differ by 0.6 to 3.2, 1024 by 0.2 to 1.0, 2048 by 0.1 to 0.5.
    std::optional<int> faceSize;

    /// Whether panoramas become cubes, too, as they do where `faceSize` says how fine: who looks up
    /// in the panorama itself needs none.
    bool cubeBesidePanorama = true;
};

inline constexpr Range<int> kFaceSizeRange{1, 8192};

/// An environment ready to light a scene. Texels are finite and non-negative.
struct Environment {
    std::string name;
    CubeMap radiance;  // a black texel a face where no cube was to be beside the panorama
    std::vector<std::string>
        warnings;  // replaced pixels and the like, one sentence each, without the file's name

    /// The panorama that `radiance` was made of, repaired likewise; null where it was none. A
    /// close-up look through equirectRadiance is exact at any magnification.
    std::shared_ptr<const Image> panorama = nullptr;
};

/// The names of what is built in.
[[nodiscard]] std::vector<std::string_view> builtInEnvironmentNames();

/// `studio` or `sky`; none when the name is unknown.
[[nodiscard]] std::optional<Environment> builtInEnvironment(std::string_view name,
                                                            const EnvironmentOptions& options = {});

/// From a picture that is an equirectangular panorama, cross or strip by its shape; `name` is for
/// messages. Throws Error.
[[nodiscard]] Environment environmentFromPicture(const std::string& name, Image picture,
                                                 const EnvironmentOptions& options = {});

/// From a built-in name (`studio`, `sky`), a texture file with a cube map, an image file that is an
/// equirectangular panorama, cross or strip by its shape, a pattern of six files (`sky_{}.png`) or
/// a folder with six.
///
/// A file wins over a built-in only when it is given with a folder or an extension. Throws Error.
[[nodiscard]] Environment loadEnvironment(const std::string& nameOrPath,
                                          const EnvironmentOptions& options = {});

}  // namespace tukor
