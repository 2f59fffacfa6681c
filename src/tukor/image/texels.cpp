#include "tukor/image/texels.h"

#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/jpeg_file.h"
#include "tukor/image/png_file.h"

namespace tukor {

namespace {

[[noreturn]] void refuse(std::string_view name) {
    throw Error(fmt::format("{}: neither a PNG nor a JPEG image", name));
}

}  // namespace

TexelsSize sizeOfTexels(std::span<const std::byte> bytes, std::string_view name) {
    const auto byte = [&](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); };
    const auto word = [&](std::size_t i) { return byte(i) << 8 | byte(i + 1); };
    if (isPng(bytes) && bytes.size() >= 24)
        return {word(16) << 16 | word(18), word(20) << 16 | word(22)};
    if (!isJpeg(bytes)) refuse(name);
    // Segments up to the first start of frame: ff c0 to ff cf, but for c4, c8 and cc.
    for (std::size_t i = 2; i + 9 < bytes.size() && byte(i) == 0xff;) {
        const std::uint32_t marker = byte(i + 1);
        if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc)
            return {word(i + 7), word(i + 5)};
        i += marker == 0xff ? 1 : 2 + word(i + 2);
    }
    throw Error(fmt::format("{}: damaged JPEG file: no size in it", name));
}

Texels decodeTexels(std::span<const std::byte> bytes, std::string_view name) {
    EncodedPixels pixels;
    if (isPng(bytes))
        pixels = decodePngPixels(bytes, name);
    else if (isJpeg(bytes))
        pixels = decodeJpegPixels(bytes, name);
    else
        refuse(name);
    return {pixels.width, pixels.height, pixels.channels, std::move(pixels.bytes)};
}

}  // namespace tukor
