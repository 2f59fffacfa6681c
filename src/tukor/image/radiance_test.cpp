#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/image/radiance_file.h"

namespace tukor {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Image decode(const std::string& text) {
    return decodeRadiance(std::as_bytes(std::span(text)), "x.hdr");
}

// Mantissas that tell pixels apart at exponent 136, where a mantissa is its own value.
std::string pixel(int value) {
    return {static_cast<char>(value), static_cast<char>(200), 0, static_cast<char>(136)};
}

const std::string kStart = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n";

TEST(RadianceRead, KnowsEveryAxisOrder) {
    // The picture as it must come out, from the top-left: 10 20 30 / 40 50 60.
    struct Case {
        const char* resolution;
        std::array<int, 6> stored;
    };
    const Case cases[] = {
        {"-Y 2 +X 3", {10, 20, 30, 40, 50, 60}}, {"+Y 2 +X 3", {40, 50, 60, 10, 20, 30}},
        {"-Y 2 -X 3", {30, 20, 10, 60, 50, 40}}, {"+Y 2 -X 3", {60, 50, 40, 30, 20, 10}},
        {"+X 3 -Y 2", {10, 40, 20, 50, 30, 60}}, {"+X 3 +Y 2", {40, 10, 50, 20, 60, 30}},
        {"-X 3 -Y 2", {30, 60, 20, 50, 10, 40}}, {"-X 3 +Y 2", {60, 30, 50, 20, 40, 10}},
    };
    for (const Case& c : cases) {
        std::string file = kStart + "\n" + c.resolution + "\n";
        for (int value : c.stored) file += pixel(value);
        const Image image = decode(file);
        ASSERT_EQ(image.width(), 3) << c.resolution;
        ASSERT_EQ(image.height(), 2) << c.resolution;
        for (int i = 0; i < 6; ++i)
            EXPECT_EQ(image.at(i % 3, i / 3), glm::vec3(10 * (i + 1), 200, 0))
                << c.resolution << " pixel " << i;
    }
}

TEST(RadianceRead, ExpandsTheOlderRuns) {
    using namespace std::string_literals;
    // One pixel, then 3 + 256 * 1 repeats of it, then another pixel.
    const Image image =
        decode(kStart + "\n-Y 1 +X 261\n" + pixel(7) + "\1\1\1\3"s + "\1\1\1\1"s + pixel(9));
    for (int i = 0; i < 260; ++i) ASSERT_EQ(image.at(i, 0).x, 7.0f) << i;
    EXPECT_EQ(image.at(260, 0).x, 9.0f);
}

TEST(RadianceRead, ExpandsPlanarRuns) {
    using namespace std::string_literals;
    const Image image = decode(kStart + "\n-Y 1 +X 8\n" + "\2\2\0\10"s +  // planar, 8 pixels
                               "\210\5"s +                                // eight times 5
                               "\3\1\2\3\205\4"s +                        // 1 2 3, five times 4
                               "\210\0"s + "\210\210"s);                  // blue 0, exponent 136
    for (int i = 0; i < 8; ++i) EXPECT_EQ(image.at(i, 0), glm::vec3(5, std::min(i + 1, 4), 0)) << i;
}

TEST(RadianceRead, DividesByAccumulatedExposureAndColourCorrection) {
    const Image image = decode(
        "#?RADIANCE\nEXPOSURE=2\n# a comment\nEXPOSURE= 4\n"
        "COLORCORR= 1 2 1\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" +
        pixel(80));
    EXPECT_EQ(image.at(0, 0), glm::vec3(10, 12.5f, 0));
}

TEST(RadianceRead, TurnsXyzIntoRec709) {
    // D65 white, X Y Z = 0.9505 1 1.089, is 1 1 1. Mantissas of 8 bits: 1 / 256.
    using namespace std::string_literals;
    const Image image =
        decode("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + "\171\200\213\201"s);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(0, 0)[c], 1.0f, 0.03f) << c;
}

TEST(RadianceRead, AnExponentOfZeroIsBlackAndOnesAreOnes) {
    using namespace std::string_literals;
    EXPECT_EQ(decode(kStart + "\n-Y 1 +X 1\n" + "\200\200\200\0"s).at(0, 0), glm::vec3(0));
    EXPECT_EQ(decode(kStart + "\n-Y 1 +X 1\n" + "\200\200\200\201"s).at(0, 0), glm::vec3(1));
}

TEST(RadianceRead, NamesWhatIsWrong) {
    const auto complains = [](const std::string& file, const std::string& message) {
        EXPECT_THAT([&] { (void)decode(file); }, ThrowsMessage<Error>(HasSubstr(message))) << file;
    };
    complains("#?RADIANCE\n", "x.hdr: the Radiance header does not end");
    complains("#?RADIANCE\nFORMAT=24-bit\n\n", "pixel format `24-bit`; expected 32-bit_rle_rgbe");
    complains("#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n", "exposure 0; expected a positive number");
    complains(kStart + "\n-Y 1 1\n", "no resolution line like `-Y 512 +X 1024`");
    complains(kStart + "\n-Y 1 +Y 1\n", "no resolution line");
    complains(kStart + "\n-Y 99999999999 +X 1\n", "no resolution line");
    complains(kStart + "\n-Y 0 +X 1\n", "1 x 0 pixels; expected at least 1 x 1");
    complains(kStart + "\n-Y -5 +X 9\n", "9 x -5 pixels");
    complains(kStart + "\n-Y 2147483647 +X 2147483647\n", "at most 268435456 pixels");
    complains(kStart + "\n-Y 2 +X 1\n" + pixel(1), "damaged or cut off in scanline 2 of 2");
    complains(kStart + "\n-Y 1 +X 9\n\x02\x02" + std::string("\0\x09\x8a\x05", 4),
              "damaged or cut off in scanline 1 of 1");
    complains(kStart + "\n-Y 1 +X 4\n\1\1\1\4", "damaged or cut off in scanline 1");
}

TEST(RadianceWrite, ReadsBackWithinHalfAStepOfTheLargestComponent) {
    for (int width : {1, 7, 8, 100, 300}) {
        Image image(width, 5);
        unsigned state = 12345;
        for (glm::vec3& p : image.pixels())
            for (int c = 0; c < 3; ++c) {
                state = state * 1664525u + 1013904223u;
                p[c] = state < 0x40000000u ? 0.25f : std::exp2(float(state >> 8) / 1e6f - 8.0f);
            }
        const auto bytes = encodeRadiance(image, {});
        const Image back = decodeRadiance(bytes, "x.hdr");
        for (std::size_t i = 0; i < image.pixels().size(); ++i) {
            const glm::vec3 p = image.pixels()[i];
            const float most = std::max({p.x, p.y, p.z});
            for (int c = 0; c < 3; ++c)  // 8 bits of the largest, whose mantissa is 128 or more
                ASSERT_NEAR(back.pixels()[i][c], p[c], most / 256.0f) << width << " " << i;
        }
    }
}

TEST(RadianceWrite, ClampsWhatTheFormatLacksAndCarriesMetadata) {
    Image image(3, 1);
    image.at(0, 0) = glm::vec3(-1.0f, 2.0f, std::nanf(""));
    image.at(1, 0) = glm::vec3(std::numeric_limits<float>::infinity(), 0.0f, 0.0f);
    image.at(2, 0) = glm::vec3(1e-42f);
    const std::pair<std::string, std::string> entry{"command", "a\nb"};
    const auto bytes = encodeRadiance(image, std::span(&entry, 1));
    const Image back = decodeRadiance(bytes, "x.hdr");
    EXPECT_EQ(back.at(0, 0), glm::vec3(0, 2, 0));
    EXPECT_GT(back.at(1, 0).x, 1.6e38f);
    EXPECT_EQ(back.at(2, 0), glm::vec3(0));
    EXPECT_THAT(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()),
                HasSubstr("\n# command: a b\n"));
}

}  // namespace
}  // namespace tukor
