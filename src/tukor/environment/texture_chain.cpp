#include "tukor/environment/texture_chain.h"

#include <array>
#include <string>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/environment/layout.h"
#include "tukor/environment/repair.h"
#include "tukor/image/image_file.h"

namespace tukor {

bool hasTextureExtension(const std::filesystem::path& path) {
    const std::string extension = lowerExtension(path);
    return extension == ".dds" || extension == ".ktx" || extension == ".ktx2";
}

std::optional<TextureFile> loadIfTexture(const std::filesystem::path& path) {
    if (!hasTextureExtension(path)) return std::nullopt;
    return loadTexture(path);
}

Image loadPicture(const std::filesystem::path& path) {
    std::optional<TextureFile> texture = loadIfTexture(path);
    if (!texture) return loadImage(path);
    if (texture->faces != 1)
        throw Error(fmt::format("{}: a cube map; expected one picture", path.string()));
    return std::move(texture->images.front());
}

std::vector<std::string> repairFaces(std::string_view name, TextureFile& texture) {
    return repairPictures(name,
                          std::span(texture.images).first(static_cast<std::size_t>(texture.faces)));
}

CubeMap cubeFromTexture(const TextureFile& texture) {
    TUKOR_ASSERT(texture.faces == 6);
    std::array<std::string, 6> names;
    for (std::size_t i = 0; i < 6; ++i) names[i] = fmt::format("face {}", kFaceNames[0][i]);
    return cubeFromFaces(std::span<const Image, 6>(texture.images.data(), 6), names);
}

TextureFile textureFromCubes(std::span<const CubeMap> levels) {
    TextureFile texture;
    texture.width = texture.height = levels.front().faceSize();
    texture.faces = 6;
    texture.levels = static_cast<int>(levels.size());
    for (const CubeMap& level : levels)
        for (const CubeFace face : kCubeFaces) texture.images.push_back(pictureOfFace(level, face));
    return texture;
}

}  // namespace tukor
