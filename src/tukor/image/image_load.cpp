#include <algorithm>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/image/exr_file.h"
#include "tukor/image/image_file.h"
#include "tukor/image/jpeg_file.h"
#include "tukor/image/png_file.h"
#include "tukor/image/radiance_file.h"
#include "tukor/image/texture_file.h"

namespace tukor {

namespace {

/// The first bytes as a person can read them.
std::string opening(std::span<const std::byte> bytes) {
    std::string text;
    for (std::byte byte : bytes.first(std::min<std::size_t>(bytes.size(), 8))) {
        const auto c = static_cast<unsigned char>(byte);
        if (c >= 0x20 && c < 0x7f)
            text += static_cast<char>(c);
        else
            text += fmt::format("\\x{:02x}", c);
    }
    return text;
}

/// The full-size picture of a texture that is not a cube map.
Image decodePicture(std::span<const std::byte> bytes, std::string_view name) {
    TextureFile texture = decodeTexture(bytes, name);
    if (texture.faces != 1)
        throw Error(fmt::format("{}: a cube map; expected a single picture", name));
    return std::move(texture.images[0]);
}

}  // namespace

Image decodeImage(std::span<const std::byte> bytes, std::string_view name) {
    if (isExr(bytes)) return decodeExr(bytes, name);
    if (isRadiance(bytes)) return decodeRadiance(bytes, name);
    if (isPng(bytes)) return decodePng(bytes, name);
    if (isJpeg(bytes)) return decodeJpeg(bytes, name);
    if (isTexture(bytes)) return decodePicture(bytes, name);
    throw Error(fmt::format(
        "{}: {}; expected an OpenEXR, Radiance (.hdr), PNG or JPEG image", name,
        bytes.empty() ? "is empty"
                      : fmt::format("starts with `{}`, no format known here", opening(bytes))));
}

Image loadImage(const std::filesystem::path& path) {
    const MappedFile file(path);
    return decodeImage(file.bytes(), path.string());
}

}  // namespace tukor
