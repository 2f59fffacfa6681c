#include "tukor/image/image_file.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/base/test_folder.h"
#include "tukor/image/jpeg_file.h"

namespace tukor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ImageFile : public testing::Test {
protected:
    [[nodiscard]] fs::path in(const std::string& name) const { return folder_.path(name); }

private:
    TestFolder folder_;
};

/// Smooth colours from 0 to 1.
Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = glm::vec3(float(x) / float(width), float(y) / float(height), 0.25f);
    return image;
}

TEST_F(ImageFile, EveryFormatReadsBackWithinItsPrecision) {
    const Image image = gradient(64, 48);
    struct Case {
        const char* name;
        float absolute;
    };
    // RGBE: half a step of 1/128 of the largest. PNG: half a code, at most 1.06 * 2.4 / 255 / 2 of
    // linear light. JPEG at its best: two codes.
    SaveOptions options;
    options.jpegQuality = 100;
    for (const Case& c : {Case{"a.exr", 0.0f}, Case{"a.hdr", 0.004f}, Case{"a.png", 0.0051f},
                          Case{"a.jpg", 0.025f}, Case{"a.JPEG", 0.025f}}) {
        saveImage(in(c.name), image, options);
        const Image back = loadImage(in(c.name));
        ASSERT_EQ(back.width(), 64);
        ASSERT_EQ(back.height(), 48);
        for (std::size_t i = 0; i < image.pixels().size(); ++i)
            for (int k = 0; k < 3; ++k)
                ASSERT_NEAR(back.pixels()[i][k], image.pixels()[i][k], c.absolute) << c.name;
    }
}

TEST_F(ImageFile, SixteenBitPngIsFine) {
    SaveOptions options;
    options.pngDepth = PngDepth::bits16;
    const Image image = gradient(64, 48);
    saveImage(in("a.png"), image, options);
    const Image back = loadImage(in("a.png"));
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(back.pixels()[i][k], image.pixels()[i][k], 0.5f * 2.6f / 65535.0f + 1e-6f);
}

TEST_F(ImageFile, AlphaSurvivesInExrAndPng) {
    Image image(2, 1);
    image.at(0, 0) = glm::vec3(0.25f);
    image.at(1, 0) = glm::vec3(0.0f);
    image.alpha = {0.5f, 0.0f};
    for (const char* name : {"a.exr", "a.png"}) {
        saveImage(in(name), image);
        const Image back = loadImage(in(name));
        ASSERT_EQ(back.alpha.size(), 2u) << name;
        EXPECT_NEAR(back.alpha[0], 0.5f, 0.002f) << name;
        EXPECT_NEAR(back.at(0, 0).x, 0.25f, 0.004f) << name;
        EXPECT_EQ(back.at(1, 0), glm::vec3(0.0f)) << name;
    }
}

TEST_F(ImageFile, ExposureAndToneMapLeaveRadianceFilesAlone) {
    SaveOptions options;
    options.exposureStops = -1.0f;
    options.tonemap = Tonemap::reinhard;
    Image image(8, 8);
    for (glm::vec3& p : image.pixels()) p = glm::vec3(2.0f);
    saveImage(in("a.exr"), image, options);
    EXPECT_EQ(loadImage(in("a.exr")).at(0, 0), glm::vec3(2.0f));
    saveImage(in("a.hdr"), image, options);
    EXPECT_EQ(loadImage(in("a.hdr")).at(0, 0), glm::vec3(2.0f));
    saveImage(in("a.png"), image, options);
    EXPECT_NEAR(loadImage(in("a.png")).at(0, 0).x, 0.5f, 0.003f);
    saveImage(in("a.jpg"), image, options);
    EXPECT_NEAR(loadImage(in("a.jpg")).at(0, 0).x, 0.5f, 0.006f);
}

TEST_F(ImageFile, MetadataIsInEveryFormat) {
    SaveOptions options;
    options.metadata = {{"command", "tukor render sphere"}};
    for (const char* extension : {".exr", ".hdr", ".png", ".jpg"}) {
        const auto bytes = encodeImage(gradient(8, 8), extension, options);
        const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        EXPECT_THAT(text, HasSubstr("tukor render sphere")) << extension;
        EXPECT_EQ(decodeImage(bytes, "x").width(), 8) << extension;
    }
}

TEST_F(ImageFile, ContentDecidesNotTheName) {
    saveImage(in("a.png"), gradient(8, 8));
    fs::rename(in("a.png"), in("a.exr"));
    EXPECT_EQ(loadImage(in("a.exr")).width(), 8);
}

TEST_F(ImageFile, UnknownExtensionsListTheKnownOnes) {
    EXPECT_THAT([&] { saveImage(in("a.gif"), gradient(1, 1)); },
                ThrowsMessage<Error>(HasSubstr(
                    "a.gif: no image format is called `.gif`; known are .exr .hdr .png .jpg")));
    EXPECT_THAT([&] { checkSavable("picture"); },
                ThrowsMessage<Error>(HasSubstr("picture: no extension that says which")));
    EXPECT_THAT([&] { (void)encodeImage(gradient(1, 1), ".tif"); },
                ThrowsMessage<Error>(HasSubstr("no image format is called `.tif`")));
    EXPECT_THAT([&] { saveExrLayers(in("a.hdr"), {}); },
                ThrowsMessage<Error>(HasSubstr("a.hdr: only .exr holds several layers")));
}

TEST_F(ImageFile, LayersGoIntoOneExr) {
    const std::vector<ImageLayer> layers = {{"", gradient(8, 8)}, {"depth", Image(8, 8)}};
    saveExrLayers(in("a.exr"), layers);
    EXPECT_EQ(loadImage(in("a.exr")).at(7, 7), layers[0].image.at(7, 7));
}

TEST_F(ImageFile, AnImageTooLargeForJpegIsAnError) {
    EXPECT_THAT([&] { saveImage(in("a.jpg"), Image(70000, 1)); },
                ThrowsMessage<Error>(HasSubstr("70000 x 1 pixels cannot be written as JPEG")));
    EXPECT_FALSE(fs::exists(in("a.jpg")));
}

TEST(JpegRead, ReadsGreyAndRefusesCmyk) {
    const std::vector<unsigned char> samples(4 * 64, 128);
    const auto encode = [&](int format, int subsampling) {
        unsigned char* memory = nullptr;
        unsigned long size = 0;
        const tjhandle codec = tjInitCompress();
        EXPECT_EQ(
            tjCompress2(codec, samples.data(), 8, 0, 8, format, &memory, &size, subsampling, 95, 0),
            0);
        const auto* first = reinterpret_cast<const std::byte*>(memory);
        std::vector<std::byte> bytes(first, first + size);
        tjFree(memory);
        tjDestroy(codec);
        return bytes;
    };
    const Image grey = decodeJpeg(encode(TJPF_GRAY, TJSAMP_GRAY), "x.jpg");
    EXPECT_EQ(grey.at(3, 3), glm::vec3(linearFromSrgb8()[128]));
    EXPECT_THAT([&] { (void)decodeJpeg(encode(TJPF_CMYK, TJSAMP_444), "x.jpg"); },
                ThrowsMessage<Error>(HasSubstr("x.jpg: CMYK JPEG; expected grey or RGB")));
}

}  // namespace
}  // namespace tukor
