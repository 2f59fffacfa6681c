// Materials of glTF: metallic-roughness with the extensions of Khronos.
#pragma once
#include "tukor/scene/gltf_textures.h"
#include "tukor/scene/json_item.h"
#include "tukor/scene/notes.h"
#include "tukor/scene/surface.h"

namespace tukor {

/// What `materials[i]` says, with the specification's defaults. Notes, under the material's name,
/// what a Surface cannot hold. `fallbackName` names materials without a name.
[[nodiscard]] Surface readGltfMaterial(const JsonItem& material, std::string_view fallbackName,
                                       GltfTextures& textures, Notes& notes);

}  // namespace tukor
