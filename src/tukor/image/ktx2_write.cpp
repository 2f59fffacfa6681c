#include <cstring>

#include <zstd.h>

#include "tukor/base/error.h"
#include "tukor/image/byte_writer.h"
#include "tukor/image/ktx_file.h"
#include "tukor/image/ktx_values.h"
#include "tukor/image/texel_format.h"
#include "tukor/image/texture_shape.h"

namespace tukor {

namespace {

constexpr std::string_view kIdentifier("\xabKTX 20\xbb\r\n\x1a\n", 12);
constexpr int kZstdLevel = 9;  // 12 gains 1 % on half floats and takes twice as long

// One sample of the basic data format descriptor. [Khronos Data Format Specification 1.3, sec. 5]
struct Sample {
    std::uint32_t offset;  // bits
    std::uint32_t length;  // bits
    std::uint32_t channel;
    std::uint32_t lower;
    std::uint32_t upper;
};

constexpr std::uint32_t kFloat = 0x80;
constexpr std::uint32_t kSigned = 0x40;
constexpr std::uint32_t kExponent = 0x20;
constexpr std::uint32_t kLinear = 0x10;
constexpr std::uint32_t kAlpha = 15;
constexpr std::uint32_t kOne = 0x3f800000;  // 1.0f
constexpr std::uint32_t kMinusOne = 0xbf800000;

std::vector<Sample> samplesOf(const TexelLayout& layout) {
    std::vector<Sample> samples;
    switch (layout.code) {
        case TexelCode::float32:
        case TexelCode::float16: {
            const std::uint32_t bits = layout.code == TexelCode::float32 ? 32 : 16;
            for (std::uint32_t c = 0; c < 4; ++c)
                samples.push_back(
                    {c * bits, bits, (c < 3 ? c : kAlpha) | kFloat | kSigned, kMinusOne, kOne});
            break;
        }
        case TexelCode::rgb9e5:
            // Each mantissa with the exponent that it shares; 8448 and the bias of 15 are the
            // specification's for this very format.
            for (std::uint32_t c = 0; c < 3; ++c) {
                samples.push_back({9 * c, 9, c, 0, 8448});
                samples.push_back({27, 5, c | kExponent, 15, 31});
            }
            break;
        case TexelCode::r11g11b10:
            samples = {{0, 11, 0 | kFloat, 0, kOne},
                       {11, 11, 1 | kFloat, 0, kOne},
                       {22, 10, 2 | kFloat, 0, kOne}};
            break;
        case TexelCode::unorm8:
        case TexelCode::srgb8:
            for (std::uint32_t c = 0; c < 4; ++c)
                samples.push_back({8 * c, 8, c < 3 ? c : kAlpha | kLinear, 0, 255});
            break;
        case TexelCode::bc6h:
        case TexelCode::signedBc6h:
            samples = {{0, 128, 0 | kFloat, 0, kOne}};
            break;
    }
    return samples;
}

/// What the texels are, for readers that do not know Vulkan's numbers.
void appendDescriptor(ByteWriter& out, const TexelLayout& layout, bool supercompressed) {
    constexpr std::uint32_t kRgbsda = 1;  // colour models
    constexpr std::uint32_t kBc6h = 133;
    constexpr std::uint32_t kBt709 = 1;  // primaries
    const std::vector<Sample> samples = samplesOf(layout);
    const auto block = static_cast<std::uint32_t>(24 + 16 * samples.size());
    const std::uint32_t transfer = layout.code == TexelCode::srgb8 ? 2 : 1;
    out.u32(block + 4);
    out.u32(0);                // Khronos, basic
    out.u32(2 | block << 16);  // version 1.3
    out.u32((layout.blockSize > 1 ? kBc6h : kRgbsda) | kBt709 << 8 | transfer << 16);
    const auto edge = static_cast<std::uint32_t>(layout.blockSize - 1);
    out.u32(edge | edge << 8);  // the size of a block, less one
    out.u32(supercompressed ? 0 : static_cast<std::uint32_t>(layout.bytes));
    out.u32(0);
    for (const Sample& sample : samples) {
        out.u32(sample.offset | (sample.length - 1) << 16 | sample.channel << 24);
        out.u32(0);
        out.u32(sample.lower);
        out.u32(sample.upper);
    }
}

std::vector<std::byte> compressed(std::span<const std::byte> data) {
    std::vector<std::byte> out(ZSTD_compressBound(data.size()));
    const std::size_t size =
        ZSTD_compress(out.data(), out.size(), data.data(), data.size(), kZstdLevel);
    if (ZSTD_isError(size) != 0) throw Error("out of memory while writing a KTX2 file");
    out.resize(size);
    return out;
}

void putNumber(std::vector<std::byte>& out, std::size_t at, std::uint64_t value) {
    std::memcpy(out.data() + at, &value, sizeof value);
}

}  // namespace

std::vector<std::byte> encodeKtx2(const TextureFile& texture, TexelFormat texels,
                                  Supercompression supercompression, const Progress& progress) {
    const TexelLayout& layout = layoutOf(texels);
    const bool zstd = supercompression == Supercompression::zstd;
    ByteWriter descriptor;
    appendDescriptor(descriptor, layout, zstd);
    ByteWriter values;
    appendKtxValue(values, "KTXorientation", "rd");
    appendKtxValue(values, "KTXwriter", "tukor");

    ByteWriter out;
    out.text(kIdentifier);
    out.u32(layout.vulkan);
    out.u32(layout.glTypeSize);
    out.u32(static_cast<std::uint32_t>(texture.width));
    out.u32(static_cast<std::uint32_t>(texture.height));
    out.u32(0);
    out.u32(0);
    out.u32(static_cast<std::uint32_t>(texture.faces));
    out.u32(static_cast<std::uint32_t>(texture.levels));
    out.u32(zstd ? 2 : 0);
    constexpr std::size_t kIndex = 80;
    const std::size_t afterIndex = kIndex + 24 * static_cast<std::size_t>(texture.levels);
    out.u32(static_cast<std::uint32_t>(afterIndex));
    out.u32(static_cast<std::uint32_t>(descriptor.size()));
    out.u32(static_cast<std::uint32_t>(afterIndex + descriptor.size()));
    out.u32(static_cast<std::uint32_t>(values.size()));
    out.u64(0);
    out.u64(0);
    out.data().resize(afterIndex);
    out.bytes(descriptor.data());
    out.bytes(values.data());
    FacePacker packer(texture, layout, progress);
    // The smallest level first, so that a viewer on a slow line has something to show.
    for (int level = texture.levels - 1; level >= 0; --level) {
        std::vector<std::byte> data;
        for (int face = 0; face < texture.faces; ++face)
            if (!packer.pack(level, face, data)) return {};
        const std::size_t size = data.size();
        if (zstd)
            data = compressed(data);
        else
            out.align(16);  // a multiple of every texel size that is written, and of 4
        const std::size_t entry = kIndex + 24 * static_cast<std::size_t>(level);
        putNumber(out.data(), entry, out.size());
        putNumber(out.data(), entry + 8, data.size());
        putNumber(out.data(), entry + 16, size);
        out.bytes(data);
    }
    return std::move(out.data());
}

}  // namespace tukor
