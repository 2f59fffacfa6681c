// Cube maps with their levels, to and from texture files.
#pragma once
#include <filesystem>
#include <optional>
#include <span>

#include "tukor/environment/cube_map.h"
#include "tukor/image/texture_file.h"

namespace tukor {

/// Whether the extension is that of a texture file: .dds .ktx .ktx2.
[[nodiscard]] bool hasTextureExtension(const std::filesystem::path& path);

/// The texture in a file that is called one; none for other files. Throws Error.
[[nodiscard]] std::optional<TextureFile> loadIfTexture(const std::filesystem::path& path);

/// A picture from an image file, or the first level of a texture of one face. Throws Error.
[[nodiscard]] Image loadPicture(const std::filesystem::path& path);

/// Repairs the first level of every face, as repairPictures does.
[[nodiscard]] std::vector<std::string> repairFaces(std::string_view name, TextureFile& texture);

/// The first level of a texture of six faces.
[[nodiscard]] CubeMap cubeFromTexture(const TextureFile& texture);

/// A texture of six faces whose levels are the given cube maps, each of half the size of the one
/// before.
[[nodiscard]] TextureFile textureFromCubes(std::span<const CubeMap> levels);

}  // namespace tukor
