// PNG images: 8 and 16 bits, grey, colour, palettes, alpha.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tukor/image/encoded_pixels.h"
#include "tukor/image/image.h"

namespace tukor {

[[nodiscard]] bool isPng(std::span<const std::byte> bytes) noexcept;

/// Linear, through the file's gAMA when it has one and sRGB otherwise; colour profiles are taken
/// for sRGB. Alpha multiplies the colour, as radiance wants it. Throws Error.
[[nodiscard]] Image decodePng(std::span<const std::byte> bytes, std::string_view name);

/// Its samples as they are, 8 bits of them: for textures, whose numbers need not be colours.
[[nodiscard]] EncodedPixels decodePngPixels(std::span<const std::byte> bytes,
                                            std::string_view name);

/// An sRGB PNG; `metadata` becomes UTF-8 text chunks.
[[nodiscard]] std::vector<std::byte> encodePng(
    const EncodedPixels& pixels, std::span<const std::pair<std::string, std::string>> metadata);

}  // namespace tukor
