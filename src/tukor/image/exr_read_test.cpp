#include <cmath>
#include <limits>
#include <vector>

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/base/test_folder.h"
#include "tukor/image/exr_file.h"

namespace tukor {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A file for the library to write and for us to read.
class ExrRead : public testing::Test {
protected:
    [[nodiscard]] const char* path() const { return path_.c_str(); }
    [[nodiscard]] Image read() const { return decodeExr(readFile(path_), "x.exr"); }

private:
    TestFolder folder_;
    std::string path_ = folder_.path("a.exr");
};

/// Smooth, exact in half precision, and different in every pixel and channel.
Image ramp(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = glm::vec3(0.25f * float(x), 0.5f * float(y), 1.0f + 0.125f * float(x));
    return image;
}

void insertRgb(Imf::FrameBuffer& frame, Image& image, Imath::V2i origin) {
    const Imath::Box2i window(origin, origin + Imath::V2i(image.width() - 1, image.height() - 1));
    const char* names[] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c)
        frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, &image.pixels()[0][c], window,
                                                sizeof(glm::vec3)));
}

void insertChannels(Imf::Header& header, Imf::PixelType type) {
    for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(type));
}

TEST_F(ExrRead, ReadsEveryCompression) {
    Image image = ramp(70, 300);
    for (int c = Imf::NO_COMPRESSION; c < Imf::NUM_COMPRESSION_METHODS; ++c) {
        const auto compression = static_cast<Imf::Compression>(c);
        {
            Imf::Header header(70, 300);
            header.compression() = compression;
            insertChannels(header, Imf::FLOAT);
            Imf::OutputFile file(path(), header);
            Imf::FrameBuffer frame;
            insertRgb(frame, image, {0, 0});
            file.setFrameBuffer(frame);
            file.writePixels(300);
        }
        const Image back = read();
        ASSERT_EQ(back.width(), 70);
        ASSERT_EQ(back.height(), 300);
        // DWA quantises what the eye does not see; B44 and PXR24 leave exact halves as they are.
        const bool lossy =
            compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
        for (std::size_t i = 0; i < image.pixels().size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const float value = image.pixels()[i][k];
                ASSERT_NEAR(back.pixels()[i][k], value, lossy ? 0.01f * value + 0.02f : 0.0f)
                    << "compression " << c << " pixel " << i;
            }
        EXPECT_TRUE(back.alpha.empty());
    }
}

TEST_F(ExrRead, ReadsTiles) {
    Image image = ramp(50, 40);
    for (Imf::LevelMode mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS}) {
        {
            Imf::Header header(50, 40);
            header.setTileDescription(Imf::TileDescription(16, 16, mode));
            insertChannels(header, Imf::HALF);
            Imf::TiledOutputFile file(path(), header);
            // The library converts nothing when it writes: halves, one after the other.
            std::vector<half> halves;
            for (const glm::vec3& p : image.pixels())
                for (int c = 0; c < 3; ++c) halves.push_back(half(p[c]));
            for (int level = 0; level < file.numLevels(); ++level) {
                Imf::FrameBuffer frame;
                const char* names[] = {"R", "G", "B"};
                for (int c = 0; c < 3; ++c)
                    frame.insert(
                        names[c],
                        Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data() + c), 6, 300));
                file.setFrameBuffer(frame);
                file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
            }
        }
        const Image back = read();
        for (std::size_t i = 0; i < image.pixels().size(); ++i)
            ASSERT_EQ(back.pixels()[i], image.pixels()[i]) << i;
    }
}

TEST_F(ExrRead, ReadsIntegersAndAlpha) {
    {
        Imf::Header header(2, 1);
        insertChannels(header, Imf::UINT);
        header.channels().insert("A", Imf::Channel(Imf::FLOAT));
        Imf::OutputFile file(path(), header);
        unsigned values[] = {1, 2, 3, 4, 5, 6};
        float alpha[] = {0.25f, 1.0f};
        Imf::FrameBuffer frame;
        const char* names[] = {"R", "G", "B"};
        for (int c = 0; c < 3; ++c)
            frame.insert(names[c],
                         Imf::Slice(Imf::UINT, reinterpret_cast<char*>(values + c), 12, 24));
        frame.insert("A", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(alpha), 4, 8));
        file.setFrameBuffer(frame);
        file.writePixels(1);
    }
    const Image back = read();
    EXPECT_EQ(back.at(0, 0), glm::vec3(1, 2, 3));
    EXPECT_EQ(back.at(1, 0), glm::vec3(4, 5, 6));
    EXPECT_THAT(back.alpha, testing::ElementsAre(0.25f, 1.0f));
}

TEST_F(ExrRead, PlacesTheDataWindowInTheDisplayWindow) {
    Image image = ramp(10, 6);
    // Display 4..11 x 2..9; data -1..8 x 5..10: cropped on the left and at the bottom.
    {
        Imf::Header header(Imath::Box2i({4, 2}, {11, 9}), Imath::Box2i({-1, 5}, {8, 10}));
        insertChannels(header, Imf::FLOAT);
        Imf::OutputFile file(path(), header);
        Imf::FrameBuffer frame;
        insertRgb(frame, image, {-1, 5});
        file.setFrameBuffer(frame);
        file.writePixels(6);
    }
    const Image back = read();
    ASSERT_EQ(back.width(), 8);
    ASSERT_EQ(back.height(), 8);
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column) {
            const int x = column + 5;
            const int y = row - 3;
            const bool inside = x < 10 && y >= 0 && y < 6;
            EXPECT_EQ(back.at(column, row), inside ? image.at(x, y) : glm::vec3(0));
            EXPECT_EQ(back.alpha[static_cast<std::size_t>(row * 8 + column)], inside ? 1.0f : 0.0f);
        }
}

TEST_F(ExrRead, RefusesDataOutsideTheDisplayWindow) {
    Image image = ramp(2, 2);
    {
        Imf::Header header(Imath::Box2i({0, 0}, {7, 7}), Imath::Box2i({20, 20}, {21, 21}));
        insertChannels(header, Imf::FLOAT);
        Imf::OutputFile file(path(), header);
        Imf::FrameBuffer frame;
        insertRgb(frame, image, {20, 20});
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    EXPECT_THAT([&] { (void)read(); },
                ThrowsMessage<Error>(HasSubstr("x.exr: all of its pixels lie outside")));
}

TEST_F(ExrRead, ReadsLuminanceAndChroma) {
    Imf::Array2D<Imf::Rgba> pixels(16, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) pixels[y][x] = Imf::Rgba(0.5f, 2.0f, 0.25f, 1.0f);
    for (Imf::RgbaChannels channels : {Imf::WRITE_YC, Imf::WRITE_Y}) {
        {
            Imf::RgbaOutputFile file(path(), 16, 16, channels);
            file.setFrameBuffer(&pixels[0][0], 1, 16);
            file.writePixels(16);
        }
        const glm::vec3 back = read().at(5, 9);
        const float luminance = 0.2126f * 0.5f + 0.7152f * 2.0f + 0.0722f * 0.25f;
        const glm::vec3 expected =
            channels == Imf::WRITE_Y ? glm::vec3(luminance) : glm::vec3(0.5f, 2.0f, 0.25f);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], expected[c], 0.02f) << c;
    }
}

TEST_F(ExrRead, TakesTheFirstPartWithColour) {
    Image image = ramp(4, 4);
    std::vector<float> depth(16, 3.0f);
    {
        std::vector<Imf::Header> headers(2, Imf::Header(4, 4));
        headers[0].setName("depth");
        headers[0].setType(Imf::SCANLINEIMAGE);
        headers[0].channels().insert("Z", Imf::Channel(Imf::FLOAT));
        headers[1].setName("colour");
        headers[1].setType(Imf::SCANLINEIMAGE);
        insertChannels(headers[1], Imf::FLOAT);
        Imf::MultiPartOutputFile file(path(), headers.data(), 2);
        Imf::FrameBuffer first;
        first.insert("Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(depth.data()), 4, 16));
        Imf::OutputPart(file, 0).setFrameBuffer(first);
        Imf::OutputPart(file, 0).writePixels(4);
        Imf::FrameBuffer second;
        insertRgb(second, image, {0, 0});
        Imf::OutputPart(file, 1).setFrameBuffer(second);
        Imf::OutputPart(file, 1).writePixels(4);
    }
    EXPECT_EQ(read().at(3, 2), image.at(3, 2));
}

TEST_F(ExrRead, NamesTheChannelsWhenNoneIsColour) {
    std::vector<float> depth(4, 3.0f);
    {
        Imf::Header header(2, 2);
        header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        Imf::OutputFile file(path(), header);
        Imf::FrameBuffer frame;
        frame.insert("Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(depth.data()), 4, 8));
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    EXPECT_THAT([&] { (void)read(); },
                ThrowsMessage<Error>(
                    HasSubstr("x.exr: no colour in it: found Z; expected channels R, G, B or Y")));
}

TEST_F(ExrRead, ConvertsOtherPrimaries) {
    const auto converted = [&](glm::vec3 pixel, const Imf::Chromaticities& primaries) {
        Image image(1, 1);
        image.at(0, 0) = pixel;
        {
            Imf::Header header(1, 1);
            insertChannels(header, Imf::FLOAT);
            Imf::addChromaticities(header, primaries);
            Imf::OutputFile file(path(), header);
            Imf::FrameBuffer frame;
            insertRgb(frame, image, {0, 0});
            file.setFrameBuffer(frame);
            file.writePixels(1);
        }
        return read().at(0, 0);
    };
    // ACES' green lies far outside Rec. 709; its white, like every other, becomes white.
    const Imf::Chromaticities aces({0.7347f, 0.2653f}, {0.0f, 1.0f}, {0.0001f, -0.077f},
                                   {0.32168f, 0.33767f});
    const glm::vec3 green = converted({0, 1, 0}, aces);
    EXPECT_LT(green.x, -0.5f);
    EXPECT_GT(green.y, 1.2f);
    EXPECT_LT(glm::distance(converted(glm::vec3(1.0f), aces), glm::vec3(1.0f)), 1e-5f);
    // Rec. 709 as ICC profiles name it, adapted to D50.
    const Imf::Chromaticities adapted({0.6484f, 0.3309f}, {0.3212f, 0.5978f}, {0.1559f, 0.0660f},
                                      {0.3457f, 0.3585f});
    const glm::vec3 sky(0.2f, 0.5f, 0.9f);
    EXPECT_LT(glm::distance(converted(sky, adapted), sky), 1e-3f);
}

TEST_F(ExrRead, RefusesEveryTruncationWithOneError) {
    const auto whole = encodeExr(ramp(40, 40), ExrPixels::full, {});
    for (std::size_t size = 4; size < whole.size(); size += 1 + size / 16)
        EXPECT_THAT([&] { (void)decodeExr(std::span(whole).first(size), "x.exr"); },
                    ThrowsMessage<Error>(HasSubstr("x.exr: ")))
            << size;
}

}  // namespace
}  // namespace tukor
