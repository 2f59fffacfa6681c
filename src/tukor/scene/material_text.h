// What `--material` calls a material: a smooth one, or with it a finish.
#pragma once
#include <string_view>

#include "tukor/materials/materials.h"

namespace tukor {

#ifdef __EMSCRIPTEN__  // pages have finishes of files alone
inline constexpr auto& materialFromText = parseMaterial;
#else

/// What parseMaterial() takes, rough where a perceptual roughness in [0, 1] follows; and matt
/// colours.
///
///     gold+rough:0.2  ior:1.5+rough:0.3     microfacets (GGX) whose alpha is its square
///     matt:0.8,0.2,0.1  matt:0.5            base colour, linear: glTF's metallic 0, roughness 1
///
/// Up to kPolished it is the smooth material. A rough metal has the reflectance of its index at
/// normal incidence, and at other angles Schlick's approximation: see docs/features.md. A rough
/// mirror of three like figures reflects alike at all angles. Colours of vertices do not count.
/// Throws Error.
[[nodiscard]] Material materialFromText(std::string_view text);
#endif

}  // namespace tukor
