// Pictures in and out of files: the format is found by content when reading, by extension when
// writing.
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
#include "tukor/image/display.h"
#include "tukor/image/exr_file.h"
#include "tukor/image/image.h"

namespace tukor {

/// Reads OpenEXR, Radiance, PNG or JPEG, whatever the file is called.
///
/// OpenEXR and Radiance values are as in the file, non-finite and negative ones too. Throws Error.
[[nodiscard]] Image loadImage(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Image decodeImage(std::span<const std::byte> bytes, std::string_view name);

enum class PngDepth { bits8, bits16 };

/// Tone mapping and exposure act on .png and .jpg only: .exr and .hdr keep the radiance.
struct SaveOptions {
    Tonemap tonemap = Tonemap::none;
    float exposureStops = 0.0f;
    PngDepth pngDepth = PngDepth::bits8;
    int jpegQuality = 92;
    ExrPixels exrPixels = ExrPixels::full;
    std::vector<std::pair<std::string, std::string>> metadata;  // command line, version, seed, ...
};

inline constexpr std::array<std::pair<PngDepth, std::string_view>, 2> kPngDepthSpellings{{
    {PngDepth::bits8, "8"},
    {PngDepth::bits16, "16"},
}};

inline constexpr std::array<std::pair<ExrPixels, std::string_view>, 2> kExrPixelsSpellings{{
    {ExrPixels::full, "full"},
    {ExrPixels::half, "half"},
}};

/// Writes by extension: .exr .hdr .png .jpg .jpeg; the file appears whole or not at all.
///
/// Alpha goes where the format has it (.exr, .png). Throws Error.
void saveImage(const std::filesystem::path& path, const Image& image,
               const SaveOptions& options = {});

/// The bytes of such a file; `extension` in lower case with its dot. None where `progress` asked to
/// stop.
[[nodiscard]] std::vector<std::byte> encodeImage(const Image& image, const std::string& extension,
                                                 const SaveOptions& options = {},
                                                 const Progress& progress = {});

/// Throws the Error that saveImage would for an extension it does not know: ask before rendering.
void checkSavable(const std::filesystem::path& path);

/// Several pictures of one size in one .exr; the layer of the empty name is the one shown first.
void saveExrLayers(const std::filesystem::path& path, std::span<const ImageLayer> layers,
                   const SaveOptions& options = {});

}  // namespace tukor
