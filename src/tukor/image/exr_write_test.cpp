#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/image/exr_file.h"

namespace tukor {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Smooth, exact in half precision, and different in every pixel and channel.
Image ramp(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = glm::vec3(0.25f * float(x), 0.5f * float(y), 1.0f + 0.125f * float(x));
    return image;
}

TEST(ExrCheck, NamesWhatTheHeaderGetsWrong) {
    const auto complains = [](std::string file, const std::string& message) {
        EXPECT_THAT([&] { (void)decodeExr(std::as_bytes(std::span(file)), "x.exr"); },
                    ThrowsMessage<Error>(HasSubstr(message)));
    };
    using namespace std::string_literals;
    const std::string start = "\x76\x2f\x31\1\2\0\0\0"s;
    complains("\x76\x2f", "x.exr: not an OpenEXR file");
    complains(start + "channels", "x.exr: damaged OpenEXR file: its header does not end");
    complains(start + "channels\0chlist\0\xff\xff\xff\xff"s,
              "x.exr: damaged OpenEXR file: an attribute of 4294967295 bytes");
    complains(start + "\0"s, "x.exr: damaged OpenEXR file: ");
}

TEST(ExrWrite, FloatsSurviveAndHalvesAreClipped) {
    Image image(3, 1);
    image.at(0, 0) = glm::vec3(1.0f / 3.0f, 1e6f, -2.5f);
    image.at(1, 0) = glm::vec3(std::numeric_limits<float>::infinity());
    image.at(2, 0) = glm::vec3(0.0f, 1.0f, 65504.0f);
    image.alpha = {1.0f, 0.5f, 0.0f};
    const Image full = decodeExr(encodeExr(image, ExrPixels::full, {}), "x.exr");
    for (int i = 0; i < 3; ++i) EXPECT_EQ(full.at(i, 0), image.at(i, 0));
    EXPECT_EQ(full.alpha, image.alpha);
    const Image half = decodeExr(encodeExr(image, ExrPixels::half, {}), "x.exr");
    EXPECT_NEAR(half.at(0, 0).x, 1.0f / 3.0f, 2e-4f);
    EXPECT_EQ(half.at(0, 0).y, 65504.0f);
    EXPECT_EQ(half.at(1, 0).x, 65504.0f);
    EXPECT_EQ(half.at(2, 0), image.at(2, 0));
    EXPECT_EQ(half.alpha, image.alpha);
}

TEST(ExrWrite, LayersCarryTheirNamesAndTheFirstIsShown) {
    const std::vector<ImageLayer> layers = {{"", ramp(4, 3)}, {"normal", Image(4, 3)}};
    const std::pair<std::string, std::string> entry{"command", "tukor render"};
    const auto bytes = encodeExr(layers, ExrPixels::full, std::span(&entry, 1));
    EXPECT_EQ(decodeExr(bytes, "x.exr").at(3, 2), layers[0].image.at(3, 2));
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_THAT(text, HasSubstr("normal.R"));
    EXPECT_THAT(text, HasSubstr("tukor render"));
}

}  // namespace
}  // namespace tukor
