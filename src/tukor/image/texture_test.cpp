#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/base/test_folder.h"
#include "tukor/image/texel_format.h"
#include "tukor/image/texture_file.h"

namespace tukor {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Different values in every picture and pixel, between 2^-8 and 2^8.
TextureFile sample(int width, int height, int faces, int levels) {
    TextureFile texture{width, height, faces, levels, {}};
    unsigned state = 99;
    for (int level = 0; level < levels; ++level)
        for (int face = 0; face < faces; ++face) {
            Image image(std::max(width >> level, 1), std::max(height >> level, 1));
            for (glm::vec3& pixel : image.pixels())
                for (int c = 0; c < 3; ++c) {
                    state = state * 1664525u + 1013904223u;
                    pixel[c] = std::exp2(float(state >> 8) / float(1 << 20) - 8.0f);
                }
            texture.images.push_back(image);
        }
    return texture;
}

/// The largest error that a format may make in component `c` of a pixel.
float tolerance(TexelFormat format, glm::vec3 p, int c) {
    const float most = std::max({p.x, p.y, p.z});
    switch (format) {
        case TexelFormat::rgba32f:
            return 0.0f;
        case TexelFormat::rgba16f:
            return p[c] / 2048.0f;  // half of 2^-10
        case TexelFormat::rgb9e5:
            return most / 512.0f;  // half of 2^-8 of most
        case TexelFormat::r11g11b10f:
            return p[c] / (c < 2 ? 128.0f : 64.0f);  // half of 2^-6, 2^-5
        case TexelFormat::rgba8:
            return 0.0051f;  // half a code where the slope is 2.4 * 1.055
        case TexelFormat::bc6h:
            break;  // not by the texel: see bc6h_test.cpp
    }
    return 0.0f;
}

TEST(TextureFile, EveryFormatReadsBackWithinItsPrecision) {
    for (const char* extension : {".dds", ".ktx", ".ktx2"})
        for (const auto& [format, name] : kTexelFormatSpellings) {
            if (format == TexelFormat::bc6h) continue;
            for (const TextureFile& texture : {sample(16, 16, 6, 5), sample(13, 6, 1, 3)})
                for (auto supercompression : {Supercompression::none, Supercompression::zstd}) {
                    const auto bytes =
                        encodeTexture(texture, extension, {format, supercompression});
                    ASSERT_TRUE(isTexture(bytes));
                    const TextureFile back = decodeTexture(bytes, "x");
                    ASSERT_EQ(back.width, texture.width);
                    ASSERT_EQ(back.height, texture.height);
                    ASSERT_EQ(back.faces, texture.faces);
                    ASSERT_EQ(back.levels, texture.levels);
                    for (std::size_t i = 0; i < texture.images.size(); ++i)
                        for (std::size_t k = 0; k < texture.images[i].pixels().size(); ++k) {
                            glm::vec3 expected = texture.images[i].pixels()[k];
                            if (format == TexelFormat::rgba8)
                                expected = glm::min(expected, glm::vec3(1.0f));
                            for (int c = 0; c < 3; ++c)
                                ASSERT_NEAR(back.images[i].pixels()[k][c], expected[c],
                                            tolerance(format, expected, c))
                                    << extension << " " << name << " image " << i;
                        }
                }
        }
}

TEST(Texels, ClipToWhatTheFormatHolds) {
    const float inf = std::numeric_limits<float>::infinity();
    const auto roundTrip = [](TexelFormat format, glm::vec3 value) {
        std::vector<std::byte> bytes;
        packTexels(layoutOf(format), std::span(&value, 1), bytes);
        glm::vec3 out;
        unpackTexels(layoutOf(format), bytes.data(), std::span(&out, 1));
        return out;
    };
    EXPECT_EQ(roundTrip(TexelFormat::rgba16f, {inf, -1.0f, 1e9f}), glm::vec3(65504, -1, 65504));
    EXPECT_EQ(roundTrip(TexelFormat::rgb9e5, {inf, -1.0f, 0.0f}), glm::vec3(65408, 0, 0));
    EXPECT_EQ(roundTrip(TexelFormat::rgb9e5, {std::nanf(""), 1.0f, 0.5f}), glm::vec3(0, 1, 0.5f));
    EXPECT_EQ(roundTrip(TexelFormat::r11g11b10f, {inf, -1.0f, 1e9f}), glm::vec3(65024, 0, 64512));
    EXPECT_EQ(roundTrip(TexelFormat::r11g11b10f, glm::vec3(std::ldexp(1.0f, -19))),
              glm::vec3(std::ldexp(1.0f, -19)));  // blue's smallest
    EXPECT_EQ(roundTrip(TexelFormat::rgb9e5, glm::vec3(std::ldexp(1.0f, -24))),
              glm::vec3(std::ldexp(1.0f, -24)));  // one mantissa step at the least exponent
    for (TexelFormat format : {TexelFormat::rgb9e5, TexelFormat::r11g11b10f})
        for (float v : {0.0f, 1.0f, 0.5f, 2.0f, 1024.0f})
            EXPECT_EQ(roundTrip(format, glm::vec3(v)), glm::vec3(v));
    // Just below a power of two the mantissa rounds into the next exponent.
    EXPECT_EQ(roundTrip(TexelFormat::rgb9e5, glm::vec3(0.9999f)), glm::vec3(1.0f));
}

TEST(TextureFile, EveryTruncationIsAnError) {
    for (const char* extension : {".dds", ".ktx", ".ktx2"})
        for (const TextureOptions& options :
             {TextureOptions{TexelFormat::rgb9e5, Supercompression::none},
              TextureOptions{TexelFormat::rgb9e5, Supercompression::zstd},
              TextureOptions{TexelFormat::bc6h, Supercompression::none},
              TextureOptions{TexelFormat::bc6h, Supercompression::zstd}}) {
            const auto whole = encodeTexture(sample(8, 8, 6, 4), extension, options);
            for (std::size_t size = 12; size < whole.size(); size += 1 + size / 32)
                EXPECT_THAT([&] { (void)decodeTexture(std::span(whole).first(size), "x.tex"); },
                            ThrowsMessage<Error>(HasSubstr("x.tex: ")))
                    << extension << " " << size;
        }
}

/// Overwrites a number in a valid file and expects a complaint.
void complains(const std::string& extension, std::size_t at, std::uint32_t value,
               const std::string& message) {
    auto bytes = encodeTexture(sample(4, 4, 6, 3), extension);
    std::memcpy(bytes.data() + at, &value, 4);
    EXPECT_THAT([&] { (void)decodeTexture(bytes, "x"); }, ThrowsMessage<Error>(HasSubstr(message)))
        << extension << " " << at;
}

TEST(TextureFile, NamesWhatIsWrong) {
    complains(".dds", 4, 100, "x: damaged DDS file: its header is not of 124 bytes");
    complains(".dds", 16, 5, "cube faces of 5 x 4 pixels; expected squares");
    complains(".dds", 28, 9, "9 levels; 4 x 4 pixels can have 1 to 3");
    complains(".dds", 84, 0x31545844, "DDS with DXT1 is not read; known are float, half, RGB9E5");
    complains(".dds", 128, 98, "DXGI format 98 is not read");
    complains(".dds", 132, 4, "not a two-dimensional texture");
    complains(".dds", 140, 7, "an array of 7 textures; expected one");
    complains(".ktx", 12, 0x01020304, "a big-endian KTX file");
    complains(".ktx", 28, 0x8e8f, "KTX with internal format 0x8e8f");
    complains(".ktx", 36, 0, "0 x 24 pixels; expected at least 1 x 1");
    complains(".ktx", 52, 5, "5 faces; a cube map has six");
    complains(".ktx", 60, 0xffffffff, "cut off: the file ends after");
    complains(".ktx", 64 + 28, 77, "damaged KTX file: level 0 of 77 bytes; expected 128");
    complains(".ktx2", 12, 145, "KTX2 with Vulkan format 145 is not read");
    complains(".ktx2", 20, 0x40000000, "at most 268435456 pixels are accepted");
    complains(".ktx2", 28, 3, "a volume of depth 3; expected a picture or a cube map");
    complains(".ktx2", 44, 1, "KTX2 supercompression 1; known are none (0) and zstd (2)");
    complains(".ktx2", 80 + 8, 5, "damaged KTX2 file: 5 bytes in level 0; expected 768");
    complains(".ktx2", 80, 0x7fffffff, "cut off: the file ends after");
    EXPECT_THAT([] { (void)decodeTexture({}, "x"); },
                ThrowsMessage<Error>(HasSubstr("x: is empty; expected a .dds, .ktx or .ktx2")));
    EXPECT_THAT([] { saveTexture("a.exr", sample(1, 1, 1, 1)); },
                ThrowsMessage<Error>(
                    HasSubstr("no texture format is called `.exr`; known are .dds .ktx .ktx2")));
}

TEST(TextureFile, AHugeZstdClaimIsRefused) {
    auto bytes =
        encodeTexture(sample(4, 4, 1, 1), ".ktx2", {TexelFormat::rgba8, Supercompression::zstd});
    const std::uint32_t size = 16384;
    const std::uint64_t texels = 4ull * size * size;
    std::memcpy(bytes.data() + 20, &size, 4);
    std::memcpy(bytes.data() + 24, &size, 4);
    std::memcpy(bytes.data() + 96, &texels, 8);
    EXPECT_THAT([&] { (void)decodeTexture(bytes, "x"); },
                ThrowsMessage<Error>(HasSubstr("x: 16384 x 16384 pixels cannot be in")));
}

TEST(TextureFile, PicturesStoredBottomUpAreTurnedOver) {
    const TextureFile texture = sample(2, 3, 1, 1);
    for (const auto& [extension, from, to] :
         {std::tuple(".ktx", "T=d", "T=u"), std::tuple(".ktx2", "rd", "ru")}) {
        auto bytes = encodeTexture(texture, extension, {TexelFormat::rgba32f, {}});
        auto* first = reinterpret_cast<char*>(bytes.data());
        char* at = std::search(first, first + 300, from, from + std::strlen(from));
        std::memcpy(at, to, std::strlen(to));
        const TextureFile back = decodeTexture(bytes, "x");
        for (int row = 0; row < 3; ++row)
            EXPECT_EQ(back.images[0].at(1, row), texture.images[0].at(1, 2 - row)) << extension;
    }
}

TEST(TextureFile, ReadsKtxAsCmgenWritesIt) {
    auto bytes = encodeTexture(sample(4, 4, 6, 3), ".ktx", {TexelFormat::r11g11b10f, {}});
    const std::uint32_t internal = 0x8c3a;  // where 0x8c3b belongs
    std::memcpy(bytes.data() + 16, &internal, 4);
    EXPECT_EQ(decodeTexture(bytes, "x").levels, 3);
}

TEST(TextureFile, ReadsDdsWithoutTheNewHeader) {
    // 2 x 1, A8R8G8B8 as Direct3D 9 wrote it: blue first.
    std::vector<std::byte> bytes(128 + 8);
    const auto put = [&](std::size_t at, std::uint32_t value) {
        std::memcpy(bytes.data() + at, &value, 4);
    };
    put(0, 0x20534444);
    put(4, 124);
    put(12, 1);
    put(16, 2);
    put(80, 0x41);
    put(88, 32);
    put(92, 0xff0000);
    put(96, 0xff00);
    put(100, 0xff);
    put(128, 0xff0000ff);  // opaque blue
    put(132, 0xffff0000);  // opaque red
    const TextureFile back = decodeTexture(bytes, "x.dds");
    EXPECT_EQ(back.images[0].at(0, 0), glm::vec3(0, 0, 1));
    EXPECT_EQ(back.images[0].at(1, 0), glm::vec3(1, 0, 0));
    put(112, 0x200 | 0x400);  // a cube map with one face
    EXPECT_THAT([&] { (void)decodeTexture(bytes, "x.dds"); },
                ThrowsMessage<Error>(HasSubstr("x.dds: a cube map that lacks faces")));
}

TEST(TextureFile, TellsHowFarItIsAndStopsWithNothingWritten) {
    const TestFolder folder;
    const TextureFile texture = sample(64, 64, 6, 7);
    for (const char* extension : {".dds", ".ktx", ".ktx2"})
        for (const TexelFormat format : {TexelFormat::rgba16f, TexelFormat::bc6h}) {
            std::vector<float> fractions;
            const TextureOptions options{format, Supercompression::none};
            const auto bytes = encodeTexture(texture, extension, options, [&](float fraction) {
                fractions.push_back(fraction);
                return true;
            });
            EXPECT_EQ(bytes, encodeTexture(texture, extension, options));
            EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
            EXPECT_GE(fractions.size(), 42u);  // six faces of seven levels
            EXPECT_EQ(fractions.back(), 1.0f);
            const std::string path = folder.path(std::string("stopped") + extension);
            EXPECT_FALSE(saveTexture(path, texture, options,
                                     [](float fraction) { return fraction < 0.5f; }));
            EXPECT_FALSE(std::filesystem::exists(path));
        }
}

TEST(TextureFile, GoesThroughFiles) {
    const TestFolder folder;
    const std::string path = folder.path("a.KTX2");
    saveTexture(path, sample(4, 4, 6, 1));
    EXPECT_EQ(loadTexture(path).faces, 6);
}

}  // namespace
}  // namespace tukor
