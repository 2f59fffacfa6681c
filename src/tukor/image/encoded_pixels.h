// Pixels as 8- and 16-bit image files store them.
#pragma once
#include <cstdint>
#include <vector>

#include "tukor/image/image_file.h"

namespace tukor {

/// Encoded pixels, ready for a file: rows from the top, `channels` (3 or 4) components of one or
/// two bytes; two are most significant first.
struct EncodedPixels {
    int width = 0;
    int height = 0;
    int channels = 3;
    int bytesPerChannel = 1;
    std::vector<std::uint8_t> bytes;
};

/// Exposed, tone mapped and sRGB-encoded by the options. A fourth channel is the alpha that `image`
/// must have then, and the colours are divided by it.
[[nodiscard]] EncodedPixels encodePixels(const Image& image, const SaveOptions& options,
                                         int channels, int bytesPerChannel);

}  // namespace tukor
