#include <algorithm>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/byte_reader.h"
#include "tukor/image/byte_writer.h"
#include "tukor/image/ktx_file.h"
#include "tukor/image/ktx_values.h"
#include "tukor/image/texel_format.h"
#include "tukor/image/texture_shape.h"

namespace tukor {

namespace {

// [Khronos, KTX File Format Specification 1.0]
constexpr std::string_view kIdentifier("\xabKTX 11\xbb\r\n\x1a\n", 12);
constexpr std::uint32_t kSameEndian = 0x04030201;
constexpr std::uint32_t kRgb = 0x1907;
constexpr std::uint32_t kRowAlignment = 4;  // as glPixelStorei has it at first

std::uint64_t paddedTo4(std::uint64_t size) {
    return (size + 3) / 4 * 4;
}

/// Filament's cmgen names the internal format of packed texels where their type should be.
const TexelLayout* layoutOfGl(std::uint32_t internal, std::uint32_t format, std::uint32_t type) {
    for (const TexelLayout& layout : texelLayouts()) {
        const bool packed = layout.channels == 1;
        if (internal != 0 && layout.glInternal == internal && layout.glFormat == format &&
            (layout.glType == type || (packed && type == internal)))
            return &layout;
    }
    return nullptr;
}

}  // namespace

bool isKtx1(std::span<const std::byte> bytes) noexcept {
    return startsWith(bytes, kIdentifier);
}

TextureFile decodeKtx1(std::span<const std::byte> bytes, std::string_view name) {
    if (!isKtx1(bytes)) throw Error(fmt::format("{}: not a KTX file", name));
    ByteReader reader(bytes, name);
    reader.skip(12);
    if (reader.u32() != kSameEndian)
        throw Error(fmt::format("{}: a big-endian KTX file; expected little-endian", name));
    const std::uint32_t type = reader.u32();
    reader.skip(4);
    const std::uint32_t format = reader.u32();
    const std::uint32_t internal = reader.u32();
    reader.skip(4);
    const TextureShape shape = readKtxShape(reader);
    const auto values = reader.take(reader.u32());
    const TexelLayout* layout = layoutOfGl(internal, format, type);
    if (!layout)
        throw Error(
            fmt::format("{}: KTX with internal format {:#x}, format {:#x} and type {:#x} is "
                        "not read; known are float, half, RGB9E5, R11G11B10, BC6H and 8-bit RGBA",
                        name, internal, format, type));
    checkTextureShape(name, shape);
    std::uint64_t total = 0;
    for (std::uint32_t level = 0; level < shape.levels; ++level)
        total += 4 + paddedTo4(faceBytes(shape, *layout, level, kRowAlignment)) * shape.faces;
    (void)reader.slice(reader.position(), total);  // all of it is there

    TextureFile texture = emptyTexture(shape);
    for (std::uint32_t level = 0; level < shape.levels; ++level) {
        const std::uint64_t size = faceBytes(shape, *layout, level, kRowAlignment);
        const std::uint32_t declared = reader.u32();
        if (declared != size && declared != size * shape.faces)
            throw Error(fmt::format("{}: damaged KTX file: level {} of {} bytes; expected {}", name,
                                    level, declared, size));
        for (std::uint32_t face = 0; face < shape.faces; ++face)
            texture.images[std::size_t{level} * shape.faces + face] = unpackFace(
                shape, *layout, level, kRowAlignment, reader.take(paddedTo4(size)).first(size));
    }
    applyKtxOrientation(texture, values, "T=u");
    return texture;
}

std::vector<std::byte> encodeKtx1(const TextureFile& texture, TexelFormat texels,
                                  const Progress& progress) {
    const TexelLayout& layout = layoutOf(texels);
    ByteWriter values;
    appendKtxValue(values, "KTXorientation", "S=r,T=d");
    ByteWriter out;
    out.text(kIdentifier);
    out.u32(kSameEndian);
    out.u32(layout.glType);
    out.u32(layout.glTypeSize);
    out.u32(layout.glFormat);
    out.u32(layout.glInternal);
    // The base format: RGB or RGBA. What is in blocks has no other.
    out.u32(layout.blockSize > 1 ? kRgb : layout.glFormat);
    out.u32(static_cast<std::uint32_t>(texture.width));
    out.u32(static_cast<std::uint32_t>(texture.height));
    out.u32(0);
    out.u32(0);
    out.u32(static_cast<std::uint32_t>(texture.faces));
    out.u32(static_cast<std::uint32_t>(texture.levels));
    out.u32(static_cast<std::uint32_t>(values.size()));
    out.bytes(values.data());
    FacePacker packer(texture, layout, progress);
    for (int level = 0; level < texture.levels; ++level) {
        // Every layout that is written has texels of a multiple of four bytes: no padding.
        const TextureShape shape{.width = static_cast<std::uint32_t>(texture.width),
                                 .height = static_cast<std::uint32_t>(texture.height)};
        out.u32(static_cast<std::uint32_t>(
            faceBytes(shape, layout, static_cast<std::uint32_t>(level), kRowAlignment)));
        for (int face = 0; face < texture.faces; ++face)
            if (!packer.pack(level, face, out.data())) return {};
    }
    return std::move(out.data());
}

}  // namespace tukor
