#include "tukor/image/exr_zip.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/image/exr_file.h"

namespace tukor {
namespace {

TEST(ExrZip, PredictionComesUndone) {
    std::mt19937 random(5);
    for (const std::size_t size : {1u, 2u, 3u, 4u, 7u, 64u, 1001u}) {
        std::vector<std::uint8_t> bytes(size), back(size);
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
        unpredictedFromZip(predictedForZip(bytes), back);
        EXPECT_EQ(back, bytes) << size;
    }
}

Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = glm::vec3(0.25f * static_cast<float>(x), static_cast<float>(y), -1.0f);
    return image;
}

TEST(ExrZip, ReadsRowsOfBothDepthsAndLeavesOtherChannelsOut) {
    const Image image = gradient(37, 41);  // the last chunk has 9 rows
    for (const ExrPixels pixels : {ExrPixels::half, ExrPixels::full}) {
        const std::vector<std::byte> file = encodeExr(image, pixels, {});
        std::vector<float> green(37 * 41), red(2 * 37 * 41);
        const std::vector<ExrSlice> slices{{"G", green.data(), 1}, {"R", red.data(), 2}};
        ASSERT_TRUE(readZipScanlines(file, 0, slices));
        for (std::size_t i = 0; i < green.size(); ++i) {
            EXPECT_EQ(green[i], image.pixels()[i].y);
            EXPECT_EQ(red[2 * i], image.pixels()[i].x);
        }
    }
}

TEST(ExrZip, LeavesWhatItCannotReadToTheLibrary) {
    std::vector<std::byte> file = encodeExr(gradient(64, 64), ExrPixels::full, {});
    std::vector<float> values(64 * 64);
    const ExrSlice none{"Z", values.data(), 1}, green{"G", values.data(), 1};
    EXPECT_FALSE(readZipScanlines(file, 0, std::span(&none, 1)));
    EXPECT_FALSE(readZipScanlines(file, 1, std::span(&green, 1)));
    file[file.size() - 1] ^= std::byte{0xff};  // of the last chunk's checksum
    EXPECT_FALSE(readZipScanlines(file, 0, std::span(&green, 1)));
    try {
        (void)decodeExr(file, "torn.exr");
        FAIL() << "a damaged chunk was taken";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("torn.exr: damaged OpenEXR file"));
    }
}

}  // namespace
}  // namespace tukor
