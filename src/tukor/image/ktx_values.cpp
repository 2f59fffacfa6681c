#include "tukor/image/ktx_values.h"

#include <algorithm>
#include <cstring>

namespace tukor {

namespace {

/// The last row comes first.
void flipRows(TextureFile& texture) {
    for (Image& image : texture.images)
        for (int row = 0; row < image.height() / 2; ++row)
            std::swap_ranges(&image.at(0, row), &image.at(0, row) + image.width(),
                             &image.at(0, image.height() - 1 - row));
}

}  // namespace

bool startsWith(std::span<const std::byte> bytes, std::string_view identifier) noexcept {
    return bytes.size() >= identifier.size() &&
           std::memcmp(bytes.data(), identifier.data(), identifier.size()) == 0;
}

TextureShape readKtxShape(ByteReader& reader) {
    TextureShape shape;
    shape.width = reader.u32();
    shape.height = reader.u32();
    shape.depth = reader.u32();
    shape.layers = reader.u32();
    shape.faces = reader.u32();
    shape.levels = std::max(reader.u32(), 1u);  // 0 asks the reader to make them
    return shape;
}

void applyKtxOrientation(TextureFile& texture, std::span<const std::byte> values,
                         std::string_view upwards) {
    const auto orientation = ktxValue(values, "KTXorientation");
    if (texture.faces == 1 && orientation && orientation->find(upwards) != std::string_view::npos)
        flipRows(texture);
}

std::optional<std::string_view> ktxValue(std::span<const std::byte> list, std::string_view key) {
    while (list.size() >= 4) {
        std::uint32_t size = 0;
        std::memcpy(&size, list.data(), 4);
        list = list.subspan(4);
        if (size > list.size()) return std::nullopt;
        const std::string_view entry(reinterpret_cast<const char*>(list.data()), size);
        const std::size_t end = entry.find('\0');
        if (end != std::string_view::npos && entry.substr(0, end) == key) {
            std::string_view value = entry.substr(end + 1);
            return value.substr(0, value.find('\0'));
        }
        list = list.subspan(std::min<std::size_t>((std::size_t{size} + 3) / 4 * 4, list.size()));
    }
    return std::nullopt;
}

void appendKtxValue(ByteWriter& out, std::string_view key, std::string_view value) {
    out.u32(static_cast<std::uint32_t>(key.size() + 1 + value.size() + 1));
    out.text(key);
    out.text(std::string_view("\0", 1));
    out.text(value);
    out.text(std::string_view("\0", 1));
    out.align(4);
}

}  // namespace tukor
