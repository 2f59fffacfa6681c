#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spng.h>

#include "tukor/base/error.h"
#include "tukor/image/display.h"
#include "tukor/image/png_file.h"

namespace tukor {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A PNG of any type, by another writer than ours.
struct Writer {
    Writer(std::uint32_t width, std::uint32_t height, std::uint8_t type, std::uint8_t depth)
        : context(spng_ctx_new(SPNG_CTX_ENCODER)) {
        spng_set_option(context, SPNG_ENCODE_TO_BUFFER, 1);
        spng_ihdr header{width, height, depth, type, 0, 0, 0};
        spng_set_ihdr(context, &header);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { spng_ctx_free(context); }

    template <class T>
    std::vector<std::byte> write(const std::vector<T>& samples) {
        EXPECT_EQ(spng_encode_image(context, samples.data(), samples.size() * sizeof(T),
                                    SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE),
                  0);
        std::size_t size = 0;
        int error = 0;
        void* data = spng_get_png_buffer(context, &size, &error);
        const auto* first = static_cast<const std::byte*>(data);
        std::vector<std::byte> bytes(first, first + size);
        std::free(data);
        return bytes;
    }

    spng_ctx* context;
};

float linear(int code) {
    return linearFromSrgb8()[static_cast<std::size_t>(code)];
}

TEST(PngRead, ReadsGreyPaletteAndColour) {
    const Image grey =
        decodePng(Writer(2, 1, SPNG_COLOR_TYPE_GRAYSCALE, 8).write<std::uint8_t>({10, 200}), "x");
    EXPECT_EQ(grey.at(0, 0), glm::vec3(linear(10)));
    EXPECT_EQ(grey.at(1, 0), glm::vec3(linear(200)));
    EXPECT_TRUE(grey.alpha.empty());

    const Image bits = decodePng(
        Writer(4, 1, SPNG_COLOR_TYPE_GRAYSCALE, 1).write<std::uint8_t>({0b01010000}), "x");
    EXPECT_EQ(bits.at(0, 0), glm::vec3(0));
    EXPECT_EQ(bits.at(1, 0), glm::vec3(1));

    Writer indexed(2, 1, SPNG_COLOR_TYPE_INDEXED, 8);
    spng_plte palette{};
    palette.n_entries = 2;
    palette.entries[1] = {1, 2, 3, 255};
    spng_set_plte(indexed.context, &palette);
    EXPECT_EQ(decodePng(indexed.write<std::uint8_t>({0, 1}), "x").at(1, 0),
              glm::vec3(linear(1), linear(2), linear(3)));

    const Image colour = decodePng(
        Writer(1, 2, SPNG_COLOR_TYPE_TRUECOLOR, 8).write<std::uint8_t>({1, 2, 3, 4, 5, 6}), "x");
    EXPECT_EQ(colour.at(0, 1), glm::vec3(linear(4), linear(5), linear(6)));
}

TEST(PngRead, AlphaMultipliesTheColour) {
    const Image image = decodePng(
        Writer(1, 1, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 8).write<std::uint8_t>({255, 100, 0, 51}),
        "x");
    EXPECT_EQ(image.alpha.at(0), 0.2f);
    EXPECT_FLOAT_EQ(image.at(0, 0).x, 0.2f);
    EXPECT_FLOAT_EQ(image.at(0, 0).y, 0.2f * linear(100));
}

TEST(PngRead, DecodesSixteenBitsAndGamma) {
    const Image srgb = decodePng(
        Writer(1, 1, SPNG_COLOR_TYPE_TRUECOLOR, 16).write<std::uint16_t>({65535, 32768, 257}), "x");
    EXPECT_FLOAT_EQ(srgb.at(0, 0).x, 1.0f);
    EXPECT_NEAR(srgb.at(0, 0).y, 0.21404f, 2e-5f);
    EXPECT_FLOAT_EQ(srgb.at(0, 0).z, linear(1));

    Writer writer(1, 1, SPNG_COLOR_TYPE_GRAYSCALE, 16);
    spng_set_gama_int(writer.context, 100000);  // the samples are linear
    EXPECT_NEAR(decodePng(writer.write<std::uint16_t>({32768}), "x").at(0, 0).x, 0.5f, 1e-5f);

    Writer classic(1, 1, SPNG_COLOR_TYPE_GRAYSCALE, 8);
    spng_set_gama_int(classic.context, 45455);  // which everybody writes for sRGB
    EXPECT_EQ(decodePng(classic.write<std::uint8_t>({100}), "x").at(0, 0).x, linear(100));
}

TEST(PngRead, RefusesEveryTruncation) {
    const EncodedPixels pixels{8, 8, 3, 1, std::vector<std::uint8_t>(192, 7)};
    const auto whole = encodePng(pixels, {});
    for (std::size_t size = 8; size < whole.size(); ++size)
        EXPECT_THAT([&] { (void)decodePng(std::span(whole).first(size), "x.png"); },
                    ThrowsMessage<Error>(HasSubstr("x.png: ")))
            << size;
    EXPECT_THAT([&] { (void)decodePng(std::span(whole).first(whole.size() - 12), "x.png"); },
                ThrowsMessage<Error>(HasSubstr("x.png: cut off: the PNG file ends after")));
}

TEST(PngWrite, ReadsBackExactly) {
    for (int channels : {3, 4})
        for (int bytes : {1, 2})
            for (int width : {1, 2, 37}) {
                EncodedPixels pixels{width, 11, channels, bytes, {}};
                unsigned state = 1;
                for (int i = 0; i < width * 11 * channels * bytes; ++i) {
                    state = state * 1664525u + 1013904223u;
                    // Half noise, half ramp, so that both filters are chosen.
                    pixels.bytes.push_back(
                        static_cast<std::uint8_t>(i % 11 < 5 ? state >> 24 : unsigned(i)));
                }
                const auto file = encodePng(pixels, {});
                const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0),
                                                                             spng_ctx_free);
                spng_set_png_buffer(context.get(), file.data(), file.size());
                std::vector<std::uint8_t> back(pixels.bytes.size());
                ASSERT_EQ(
                    spng_decode_image(context.get(), back.data(), back.size(), SPNG_FMT_RAW, 0), 0);
                EXPECT_EQ(back, pixels.bytes) << channels << " " << bytes << " " << width;
            }
}

TEST(PngWrite, CarriesMetadataAsText) {
    const std::pair<std::string, std::string> entry{"Command", "tukor render kör.glb"};
    const auto file = encodePng({1, 1, 3, 1, {1, 2, 3}}, std::span(&entry, 1));
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), spng_ctx_free);
    spng_set_png_buffer(context.get(), file.data(), file.size());
    std::uint32_t count = 1;
    spng_text text{};
    ASSERT_EQ(spng_get_text(context.get(), &text, &count), 0);
    EXPECT_STREQ(text.keyword, "Command");
    EXPECT_STREQ(text.text, "tukor render kör.glb");
}

}  // namespace
}  // namespace tukor
