#include <algorithm>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/byte_reader.h"
#include "tukor/image/image_size.h"
#include "tukor/image/ktx_file.h"
#include "tukor/image/ktx_values.h"
#include "tukor/image/texel_format.h"
#include "tukor/image/texture_shape.h"
#include "tukor/image/zstd_frame.h"

namespace tukor {

namespace {

// [Khronos, KTX File Format Specification 2.0]
constexpr std::string_view kIdentifier("\xabKTX 20\xbb\r\n\x1a\n", 12);
constexpr std::uint32_t kNoSupercompression = 0;
constexpr std::uint32_t kZstd = 2;
// zstd has no limit of its own: a frame of one repeated byte stores 128 KB blocks in 4 bytes. A
// black map above the trusted size in less than this is refused.
constexpr std::uint64_t kMostPixelsPerByte = 1 << 12;

const TexelLayout* layoutOfVulkan(std::uint32_t format) {
    for (const TexelLayout& layout : texelLayouts())
        if (format != 0 && layout.vulkan == format) return &layout;
    return nullptr;
}

struct Level {
    std::uint64_t offset;
    std::uint64_t stored;
    std::uint64_t size;
};

/// The texels of a level; `storage` holds them when they had to be expanded.
std::span<const std::byte> expanded(std::span<const std::byte> stored, std::uint64_t size,
                                    std::uint32_t scheme, std::string_view name,
                                    std::vector<std::byte>& storage) {
    if (scheme == kNoSupercompression) return stored;
    storage.resize(size);
    const std::size_t got = expandZstd(stored, storage, name);
    if (got != size)
        throw Error(fmt::format("{}: damaged KTX2 file: {} bytes in a level; expected {}", name,
                                got, size));
    return storage;
}

}  // namespace

bool isKtx2(std::span<const std::byte> bytes) noexcept {
    return startsWith(bytes, kIdentifier);
}

TextureFile decodeKtx2(std::span<const std::byte> bytes, std::string_view name) {
    if (!isKtx2(bytes)) throw Error(fmt::format("{}: not a KTX2 file", name));
    ByteReader reader(bytes, name);
    reader.skip(12);
    const std::uint32_t format = reader.u32();
    reader.skip(4);
    const TextureShape shape = readKtxShape(reader);
    const std::uint32_t scheme = reader.u32();
    reader.skip(8);  // the data format descriptor says what the Vulkan format says
    const std::uint32_t valuesOffset = reader.u32();
    const std::uint32_t valuesSize = reader.u32();
    reader.skip(16);
    if (scheme != kNoSupercompression && scheme != kZstd)
        throw Error(fmt::format("{}: KTX2 supercompression {}; known are none (0) and zstd (2)",
                                name, scheme));
    const TexelLayout* layout = layoutOfVulkan(format);
    if (!layout)
        throw Error(
            fmt::format("{}: KTX2 with Vulkan format {} is not read; known are float, half, "
                        "RGB9E5, R11G11B10, BC6H and 8-bit RGBA",
                        name, format));
    checkTextureShape(name, shape);
    if (scheme == kZstd)
        checkImageFits(name, shape.width, std::uint64_t{shape.height} * shape.faces, bytes.size(),
                       kMostPixelsPerByte);
    std::vector<Level> levels;
    for (std::uint32_t level = 0; level < shape.levels; ++level) {
        const std::uint64_t offset = reader.u64();
        const std::uint64_t stored = reader.u64();
        const std::uint64_t declared = reader.u64();
        const std::uint64_t size = faceBytes(shape, *layout, level, 1) * shape.faces;
        if ((scheme == kNoSupercompression ? stored : declared) != size)
            throw Error(fmt::format("{}: damaged KTX2 file: {} bytes in level {}; expected {}",
                                    name, scheme == kNoSupercompression ? stored : declared, level,
                                    size));
        (void)reader.slice(offset, stored);  // all of it is there
        levels.push_back({offset, stored, size});
    }
    TextureFile texture = emptyTexture(shape);
    std::vector<std::byte> storage;
    for (std::uint32_t level = 0; level < shape.levels; ++level) {
        const auto texels = expanded(reader.slice(levels[level].offset, levels[level].stored),
                                     levels[level].size, scheme, name, storage);
        const std::uint64_t size = faceBytes(shape, *layout, level, 1);
        for (std::uint32_t face = 0; face < shape.faces; ++face)
            texture.images[std::size_t{level} * shape.faces + face] =
                unpackFace(shape, *layout, level, 1, texels.subspan(face * size, size));
    }
    applyKtxOrientation(texture, reader.slice(valuesOffset, valuesSize), "ru");
    return texture;
}

}  // namespace tukor
