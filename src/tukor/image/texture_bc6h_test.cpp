// BC6H in .dds, .ktx and .ktx2: the headers' fields, and the blocks as they are.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "tukor/image/bc6h.h"
#include "tukor/image/texture_file.h"

namespace tukor {
namespace {

/// Different values in every picture and pixel.
TextureFile sample(int width, int height, int faces, int levels) {
    TextureFile texture{width, height, faces, levels, {}};
    for (int i = 0; i < levels * faces; ++i) {
        const int level = i / faces;
        Image image(std::max(width >> level, 1), std::max(height >> level, 1));
        float value = 0.01f * static_cast<float>(i + 1);
        for (glm::vec3& pixel : image.pixels()) {
            value = std::fmod(value * 1.7f, 50.0f);
            pixel = {value, 0.5f * value + 0.1f, 3.0f};
        }
        texture.images.push_back(image);
    }
    return texture;
}

TEST(TextureBc6h, ReadsBackAsItsBlocks) {
    for (const char* extension : {".dds", ".ktx", ".ktx2"})
        for (const TextureFile& texture : {sample(16, 16, 6, 5), sample(13, 6, 1, 4)})
            for (auto supercompression : {Supercompression::none, Supercompression::zstd}) {
                const TextureFile back = decodeTexture(
                    encodeTexture(texture, extension, {TexelFormat::bc6h, supercompression}), "x");
                ASSERT_EQ(back.images.size(), texture.images.size());
                for (std::size_t i = 0; i < texture.images.size(); ++i) {
                    std::vector<std::byte> blocks;
                    EXPECT_TRUE(encodeBc6h(texture.images[i], blocks));
                    Image expected(texture.images[i].width(), texture.images[i].height());
                    decodeBc6h(blocks, Bc6hSign::none, expected);
                    EXPECT_TRUE(std::ranges::equal(back.images[i].pixels(), expected.pixels()))
                        << extension << " image " << i;
                }
            }
}

std::uint32_t numberAt(const std::vector<std::byte>& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, 4);
    return number;
}

TEST(TextureBc6h, HasTheHeadersThatTheFormatsAskFor) {
    const TextureFile texture = sample(10, 10, 6, 4);
    const TextureOptions options{TexelFormat::bc6h, Supercompression::none};
    const auto dds = encodeTexture(texture, ".dds", options);
    EXPECT_EQ(numberAt(dds, 8) & 0x80008u, 0x80000u);  // a linear size, not a pitch
    EXPECT_EQ(numberAt(dds, 20), 9u * 16);             // 3 x 3 blocks
    EXPECT_EQ(numberAt(dds, 128), 95u);
    EXPECT_EQ(dds.size(), 148u + 6 * 16 * (9 + 4 + 1 + 1));

    const auto ktx = encodeTexture(texture, ".ktx", options);
    EXPECT_EQ(numberAt(ktx, 16), 0u);       // type
    EXPECT_EQ(numberAt(ktx, 20), 1u);       // its size
    EXPECT_EQ(numberAt(ktx, 24), 0u);       // format
    EXPECT_EQ(numberAt(ktx, 28), 0x8e8fu);  // COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT
    EXPECT_EQ(numberAt(ktx, 32), 0x1907u);  // RGB
    EXPECT_EQ(numberAt(ktx, 64 + numberAt(ktx, 60)), 9u * 16);

    const auto ktx2 = encodeTexture(texture, ".ktx2", options);
    EXPECT_EQ(numberAt(ktx2, 12), 143u);  // VK_FORMAT_BC6H_UFLOAT_BLOCK
    EXPECT_EQ(numberAt(ktx2, 16), 1u);
    const std::size_t descriptor = numberAt(ktx2, 48);
    EXPECT_EQ(numberAt(ktx2, descriptor), 44u);
    EXPECT_EQ(numberAt(ktx2, descriptor + 12) & 0xffu, 133u);              // KHR_DF_MODEL_BC6H
    EXPECT_EQ(numberAt(ktx2, descriptor + 16), 0x303u);                    // 4 x 4
    EXPECT_EQ(numberAt(ktx2, descriptor + 20), 16u);                       // bytes
    EXPECT_EQ(numberAt(ktx2, descriptor + 28), 0x80u << 24 | 127u << 16);  // a float of 128 bits
    for (std::size_t level = 0; level < 4; ++level)
        EXPECT_EQ(numberAt(ktx2, 80 + 24 * level) % 16, 0u);
}

TEST(TextureBc6h, IsReadOfEitherSignAndOfNone) {
    const struct {
        const char* extension;
        std::size_t at;
        std::uint32_t written;
        std::uint32_t other;
        bool isSigned;
    } cases[] = {{".dds", 128, 95, 94, false},
                 {".dds", 128, 95, 96, true},
                 {".ktx", 28, 0x8e8f, 0x8e8e, true},
                 {".ktx2", 12, 143, 144, true}};
    const TextureFile texture = sample(4, 4, 1, 1);
    std::vector<std::byte> blocks;
    EXPECT_TRUE(encodeBc6h(texture.images[0], blocks));
    for (const auto& c : cases) {
        auto bytes = encodeTexture(texture, c.extension, {TexelFormat::bc6h, {}});
        ASSERT_EQ(numberAt(bytes, c.at), c.written);
        std::memcpy(bytes.data() + c.at, &c.other, 4);
        Image expected(4, 4);
        decodeBc6h(blocks, c.isSigned ? Bc6hSign::one : Bc6hSign::none, expected);
        const TextureFile back = decodeTexture(bytes, "x");
        EXPECT_TRUE(std::ranges::equal(back.images[0].pixels(), expected.pixels())) << c.extension;
    }
}

}  // namespace
}  // namespace tukor
