// JPEG images, 8 bits.
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

[[nodiscard]] bool isJpeg(std::span<const std::byte> bytes) noexcept;

/// Linear, the samples taken for sRGB. Grey and YCbCr; CMYK is refused. Throws Error.
[[nodiscard]] Image decodeJpeg(std::span<const std::byte> bytes, std::string_view name);

/// Its samples as they are, three channels: for textures, whose numbers need not be colours.
[[nodiscard]] EncodedPixels decodeJpegPixels(std::span<const std::byte> bytes,
                                             std::string_view name);

/// `pixels` have three channels of one byte; `quality` is in [1, 100]. Full chroma resolution from
/// 90 on. `metadata` becomes comments.
[[nodiscard]] std::vector<std::byte> encodeJpeg(
    const EncodedPixels& pixels, int quality,
    std::span<const std::pair<std::string, std::string>> metadata);

}  // namespace tukor
