#include "tukor/image/dds_file.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/byte_reader.h"
#include "tukor/image/byte_writer.h"
#include "tukor/image/texel_format.h"
#include "tukor/image/texture_shape.h"

namespace tukor {

namespace {

// [Microsoft, Programming Guide for DDS]
constexpr std::uint32_t kMagic = 0x20534444;  // "DDS "
constexpr std::uint32_t kHeaderBytes = 124;
constexpr std::uint32_t kPixelFormatBytes = 32;
constexpr std::uint32_t kCapsHeightWidthPixelFormat = 0x1 | 0x2 | 0x4 | 0x1000;
constexpr std::uint32_t kPitch = 0x8;
constexpr std::uint32_t kMipCount = 0x20000;
constexpr std::uint32_t kLinearSize = 0x80000;
constexpr std::uint32_t kFourCc = 0x4;
constexpr std::uint32_t kRgb = 0x40;
constexpr std::uint32_t kComplex = 0x8;
constexpr std::uint32_t kTexture = 0x1000;
constexpr std::uint32_t kMipmap = 0x400000;
constexpr std::uint32_t kCube = 0x200;
constexpr std::uint32_t kAllFaces = 0xfc00;
constexpr std::uint32_t kVolume = 0x200000;
constexpr std::uint32_t kTexture2d = 3;      // D3D10_RESOURCE_DIMENSION_TEXTURE2D
constexpr std::uint32_t kMiscCube = 0x4;     // D3D10_RESOURCE_MISC_TEXTURECUBE
constexpr std::uint32_t kDx10 = 0x30315844;  // "DX10"

struct PixelFormat {
    std::uint32_t flags;
    std::uint32_t fourCc;
    std::uint32_t bits;
    std::uint32_t red;
    std::uint32_t green;
    std::uint32_t blue;
};

const TexelLayout* layoutOfDxgi(std::uint32_t dxgi) {
    for (const TexelLayout& layout : texelLayouts())
        if (dxgi != 0 && layout.dxgi == dxgi) return &layout;
    return nullptr;
}

/// The format of a header without DX10.
const TexelLayout* legacyLayout(const PixelFormat& format) {
    if ((format.flags & kFourCc) != 0) {
        if (format.fourCc == 113) return layoutOfDxgi(10);  // D3DFMT_A16B16G16R16F
        if (format.fourCc == 116) return layoutOfDxgi(2);   // D3DFMT_A32B32G32R32F
        return nullptr;
    }
    if ((format.flags & kRgb) == 0 || format.green != 0xff00) return nullptr;
    const bool redFirst = format.red == 0xff && format.blue == 0xff0000;
    if (!redFirst && !(format.red == 0xff0000 && format.blue == 0xff)) return nullptr;
    if (format.bits == 32) return layoutOfDxgi(redFirst ? 29 : 91);
    static constexpr TexelLayout kBgr{TexelCode::srgb8, 3, 3, true, 0, 0, 0, 0, 0, 0};
    static constexpr TexelLayout kRgbBytes{TexelCode::srgb8, 3, 3, false, 0, 0, 0, 0, 0, 0};
    return format.bits == 24 ? (redFirst ? &kRgbBytes : &kBgr) : nullptr;
}

std::string describeFormat(const PixelFormat& format) {
    if ((format.flags & kFourCc) == 0)
        return fmt::format("{}-bit pixels of masks {:#x} {:#x} {:#x}", format.bits, format.red,
                           format.green, format.blue);
    std::string name;
    for (int shift = 0; shift < 32; shift += 8) {
        const char c = static_cast<char>(format.fourCc >> shift);
        if (c < 0x20 || c > 0x7e) return fmt::format("format {}", format.fourCc);
        name += c;
    }
    return name;
}

struct Header {
    TextureShape shape;
    const TexelLayout* layout = nullptr;
};

Header readHeader(ByteReader& reader, std::string_view name) {
    reader.skip(4);
    if (reader.u32() != kHeaderBytes)
        throw Error(fmt::format("{}: damaged DDS file: its header is not of 124 bytes", name));
    Header header;
    const std::uint32_t flags = reader.u32();
    header.shape.height = reader.u32();
    header.shape.width = reader.u32();
    reader.skip(4);  // the pitch, which many get wrong
    const std::uint32_t depth = reader.u32();
    const std::uint32_t levels = reader.u32();
    header.shape.levels = (flags & kMipCount) != 0 && levels > 0 ? levels : 1;
    reader.skip(11 * 4 + 4);  // reserved; the size of the pixel format
    PixelFormat format{};
    format.flags = reader.u32();
    format.fourCc = reader.u32();
    format.bits = reader.u32();
    format.red = reader.u32();
    format.green = reader.u32();
    format.blue = reader.u32();
    reader.skip(4 + 4);  // alpha mask, caps
    const std::uint32_t caps2 = reader.u32();
    reader.skip(3 * 4);
    if ((caps2 & kVolume) != 0) header.shape.depth = std::max(depth, 2u);
    if ((format.flags & kFourCc) != 0 && format.fourCc == kDx10) {
        const std::uint32_t dxgi = reader.u32();
        const std::uint32_t dimension = reader.u32();
        const std::uint32_t misc = reader.u32();
        header.shape.layers = reader.u32();
        reader.skip(4);
        if (dimension != kTexture2d)
            throw Error(fmt::format("{}: not a two-dimensional texture", name));
        header.shape.faces = (misc & kMiscCube) != 0 ? 6 : 1;
        header.layout = layoutOfDxgi(dxgi);
        if (!header.layout)
            throw Error(
                fmt::format("{}: DXGI format {} is not read; known are float, half, RGB9E5, "
                            "R11G11B10, BC6H and 8-bit RGBA",
                            name, dxgi));
        return header;
    }
    if ((caps2 & kCube) != 0) {
        if ((caps2 & kAllFaces) != kAllFaces)
            throw Error(fmt::format("{}: a cube map that lacks faces", name));
        header.shape.faces = 6;
    }
    header.layout = legacyLayout(format);
    if (!header.layout)
        throw Error(
            fmt::format("{}: DDS with {} is not read; known are float, half, RGB9E5, "
                        "R11G11B10, BC6H and 8-bit RGBA",
                        name, describeFormat(format)));
    return header;
}

}  // namespace

bool isDds(std::span<const std::byte> bytes) noexcept {
    return bytes.size() >= 4 && std::memcmp(bytes.data(), "DDS ", 4) == 0;
}

TextureFile decodeDds(std::span<const std::byte> bytes, std::string_view name) {
    if (!isDds(bytes)) throw Error(fmt::format("{}: not a DDS file", name));
    ByteReader reader(bytes, name);
    const auto [shape, layout] = readHeader(reader, name);
    checkTextureShape(name, shape);
    std::uint64_t total = 0;
    for (std::uint32_t level = 0; level < shape.levels; ++level)
        total += faceBytes(shape, *layout, level, 1) * shape.faces;
    (void)reader.slice(reader.position(), total);  // all of it is there

    TextureFile texture = emptyTexture(shape);
    for (std::uint32_t face = 0; face < shape.faces; ++face)
        for (std::uint32_t level = 0; level < shape.levels; ++level)
            texture.images[std::size_t{level} * shape.faces + face] = unpackFace(
                shape, *layout, level, 1, reader.take(faceBytes(shape, *layout, level, 1)));
    return texture;
}

std::vector<std::byte> encodeDds(const TextureFile& texture, TexelFormat texels,
                                 const Progress& progress) {
    const TexelLayout& layout = layoutOf(texels);
    const bool cube = texture.faces == 6;
    const bool mips = texture.levels > 1;
    ByteWriter out;
    out.u32(kMagic);
    out.u32(kHeaderBytes);
    // Bytes of a row, or of the whole first level where it is in blocks.
    const bool blocks = layout.blockSize > 1;
    const TextureShape shape{.width = static_cast<std::uint32_t>(texture.width),
                             .height = blocks ? static_cast<std::uint32_t>(texture.height) : 1};
    out.u32(kCapsHeightWidthPixelFormat | (blocks ? kLinearSize : kPitch) | (mips ? kMipCount : 0));
    out.u32(static_cast<std::uint32_t>(texture.height));
    out.u32(static_cast<std::uint32_t>(texture.width));
    out.u32(static_cast<std::uint32_t>(faceBytes(shape, layout, 0, 1)));
    out.u32(0);
    out.u32(static_cast<std::uint32_t>(texture.levels));
    for (int i = 0; i < 11; ++i) out.u32(0);
    out.u32(kPixelFormatBytes);
    out.u32(kFourCc);
    out.u32(kDx10);
    for (int i = 0; i < 5; ++i) out.u32(0);
    out.u32(kTexture | (mips ? kComplex | kMipmap : 0) | (cube ? kComplex : 0));
    out.u32(cube ? kCube | kAllFaces : 0);
    for (int i = 0; i < 3; ++i) out.u32(0);
    out.u32(layout.dxgi);
    out.u32(kTexture2d);
    out.u32(cube ? kMiscCube : 0);
    out.u32(1);  // textures in the array
    out.u32(3);  // alpha is opaque
    FacePacker packer(texture, layout, progress);
    for (int face = 0; face < texture.faces; ++face)
        for (int level = 0; level < texture.levels; ++level)
            if (!packer.pack(level, face, out.data())) return {};
    return std::move(out.data());
}

}  // namespace tukor
