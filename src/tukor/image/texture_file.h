// Textures as engines store them: all mips of a picture or a cube map in one .dds, .ktx or .ktx2.
#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tukor/base/progress.h"
#include "tukor/image/image.h"

namespace tukor {

/// Pictures of one texture, linear; alpha is neither read nor written.
///
/// A cube map has six faces in OpenGL's order, which these formats share: +X -X +Y -Y +Z -Z, each
/// from its top-left corner as seen from inside with the face's own up (see CubeFace).
struct TextureFile {
    int width = 0;
    int height = 0;
    int faces = 1;              // 1 or 6
    int levels = 1;             // each half of the one before, rounded down, at least 1
    std::vector<Image> images;  // [level * faces + face]

    [[nodiscard]] const Image& image(int level, int face) const noexcept {
        return images[static_cast<std::size_t>(level * faces + face)];
    }
};

/// True when the bytes start as one of these formats does.
[[nodiscard]] bool isTexture(std::span<const std::byte> bytes) noexcept;

/// Reads float, half, RGB9E5, R11G11B10, BC6H and 8-bit texels, sRGB or linear; KTX2 plain or in
/// zstd.
///
/// Other block-compressed, array and volume textures are refused by name. Throws Error.
[[nodiscard]] TextureFile loadTexture(const std::filesystem::path& path);
[[nodiscard]] TextureFile decodeTexture(std::span<const std::byte> bytes, std::string_view name);

/// How texels are stored. Values are clipped to what the format holds; negative ones survive in
/// rgba32f and rgba16f only.
enum class TexelFormat {
    rgba32f,
    rgba16f,     // to 65504, relative error 5e-4
    rgb9e5,      // to 65408, error 1 / 512 of the largest component
    r11g11b10f,  // to 64512, relative error 1 / 128, blue 1 / 64
    rgba8,       // sRGB, clipped to [0, 1]
    bc6h,        // to 65504; blocks of 4 x 4 at a byte a texel, see bc6h.h
};

inline constexpr std::array<std::pair<TexelFormat, std::string_view>, 6> kTexelFormatSpellings{{
    {TexelFormat::rgba32f, "float"},
    {TexelFormat::rgba16f, "half"},
    {TexelFormat::rgb9e5, "rgb9e5"},
    {TexelFormat::r11g11b10f, "r11g11b10"},
    {TexelFormat::rgba8, "rgba8"},
    {TexelFormat::bc6h, "bc6h"},
}};

enum class Supercompression { none, zstd };

struct TextureOptions {
    TexelFormat texels = TexelFormat::rgba16f;
    Supercompression supercompression = Supercompression::none;  // .ktx2 only
};

/// Writes .dds, .ktx or .ktx2 by extension. False where `progress` asked to stop, before anything
/// was written. Throws Error.
bool saveTexture(const std::filesystem::path& path, const TextureFile& texture,
                 const TextureOptions& options = {}, const Progress& progress = {});

/// The bytes of such a file; `extension` in lower case with its dot. None where `progress` asked to
/// stop.
[[nodiscard]] std::vector<std::byte> encodeTexture(const TextureFile& texture,
                                                   const std::string& extension,
                                                   const TextureOptions& options = {},
                                                   const Progress& progress = {});

}  // namespace tukor
