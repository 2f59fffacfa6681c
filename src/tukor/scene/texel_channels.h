// Textures that a Finish keeps in one picture, put together from those of formats that keep
// several.
#pragma once
#include "tukor/image/texels.h"

namespace tukor {

// Empty texels stand for pictures that are not there. Where two differ in size the result is as
// wide and as high as the larger one, of nearest texels of the other.

/// Colours with the opacity of another picture: its alpha channel, or where it has none the red.
[[nodiscard]] Texels withOpacity(const Texels& colours, const Texels& opacity);

/// TextureRole::metallicRoughness of two grey pictures; 1 where one is not there.
[[nodiscard]] Texels metallicRoughnessOf(const Texels& metallic, const Texels& roughness);

/// TextureRole::normal of a relief: grey heights, between neighbours of which a difference from
/// black to white is a slope of `strength`. What has colours is taken for normals already, as
/// exporters write these under the same name.
[[nodiscard]] Texels normalsOf(const Texels& relief, float strength);

}  // namespace tukor
