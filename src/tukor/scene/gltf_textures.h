// Textures of glTF: which image on which texture coordinates, and the images themselves.
#pragma once
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "tukor/scene/finish.h"
#include "tukor/scene/gltf_document.h"
#include "tukor/scene/notes.h"

namespace tukor {

#ifdef __EMSCRIPTEN__
/// An image of the glTF file that is read next: browsers decode them.
void giveGltfImage(std::size_t index, Texels texels);
#endif

/// Images are asked for while materials are read, and decoded together at the end.
class GltfTextures {
public:
    GltfTextures(const GltfDocument& document, Notes& notes) : document_(document), notes_(notes) {}

    /// What a `textureInfo` says, with KHR_texture_transform. Its texels are empty until decode().
    /// `material` is the name for notes.
    [[nodiscard]] TextureMap mapOf(const JsonItem& textureInfo, std::string_view material);

    /// Decodes all that was asked for, on all cores. An image that cannot be read is noted, and
    /// stays empty. Throws Error where they are too large together.
    void decode();

private:
    const GltfDocument& document_;
    Notes& notes_;
    std::map<std::size_t, std::shared_ptr<Texels>> known_;  // by image
    std::vector<std::pair<std::size_t, JsonItem>> wanted_;  // images, not decoded yet
};

}  // namespace tukor
