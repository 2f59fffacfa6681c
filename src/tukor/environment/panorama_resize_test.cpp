#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "tukor/base/test_folder.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/cube_texel.h"
#include "tukor/environment/environment_work.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/unblurred.h"

namespace tukor {
namespace {

Image noise(int width, float least, float most) {
    Image image(width, width / 2);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> even(least, most);
    for (glm::vec3& pixel : image.pixels()) pixel = {even(random), even(random), even(random)};
    return image;
}

TEST(GrownPanorama, ComesBackWhenItShrinks) {
    Image image = noise(64, 0.0f, 2.0f);
    image.at(20, 16) = glm::vec3(1e5f);
    for (const int times : {2, 3, 4}) {
        const Image grown = resizedPanorama(image, 64 * times);
        for (const glm::vec3& pixel : grown.pixels())
            ASSERT_GE(std::min({pixel.x, pixel.y, pixel.z}), 0.0f);
        const Image back = resizedPanorama(grown, 64);
        for (std::size_t i = 0; i < image.pixels().size(); ++i)
            ASSERT_LT(glm::length(back.pixels()[i] / image.pixels()[i] - 1.0f), 1e-5f)
                << times << " times, pixel " << i;
    }
}

TEST(GrownPanorama, ComesBackFromWhatIsNoMultiple) {
    Image image = noise(64, 0.1f, 1.0f);
    for (const int width : {96, 160, 220}) {
        const Image back = resizedPanorama(resizedPanorama(image, width), 64);
        for (std::size_t i = 0; i < image.pixels().size(); ++i)
            ASSERT_LT(glm::length(back.pixels()[i] - image.pixels()[i]), 2e-3f)
                << width << ", pixel " << i;
    }
}

TEST(GrownPanorama, FollowsWhatIsSmooth) {
    Image fine(1536, 768);
    for (int row = 0; row < fine.height(); ++row)
        for (int column = 0; column < fine.width(); ++column)
            fine.at(column, row) = 2.0f + directionFromEquirect((glm::vec2(column, row) + 0.5f) /
                                                                glm::vec2(1536, 768));
    const Image image = resizedPanorama(fine, 128);
    for (const int width : {192, 256, 384}) {
        const Image grown = resizedPanorama(image, width), expected = resizedPanorama(fine, width);
        for (std::size_t i = 0; i < grown.pixels().size(); ++i)
            // Around a pole the mean of a row lies at 2/3 of it, not in its middle: a sixth of 1
            // / 20.5 of a radian; more where rows do not fit, and means are kept all the same.
            // Elsewhere linear interpolation errs by an eighth of the square.
            ASSERT_LT(glm::length(grown.pixels()[i] - expected.pixels()[i]),
                      width % 128 == 0 ? 8.2e-3f : 1.15e-2f)
                << width << ": pixel " << i;
    }
}

TEST(PanoramaWithMeansOf, KeepsAConstantExactlyConstantAsMipsDo) {
    CubeMap cube(24);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : cube.texels(face)) texel = {0.1f, 0.7f, 1e5f};
    for (const int width : {16, 48, 96, 300})
        for (const Image& image : {panoramaFromCube(cube, width), panoramaWithMeansOf(cube, width)})
            for (const glm::vec3& pixel : image.pixels())
                ASSERT_EQ(pixel, glm::vec3(0.1f, 0.7f, 1e5f)) << width;
    for (const CubeMap& mip : cubeMips(cube)) EXPECT_TRUE(isConstant(mip));
    EXPECT_EQ(cubeMips(cube).back().texels(CubeFace::negY).front(), glm::vec3(0.1f, 0.7f, 1e5f));
    EXPECT_TRUE(isConstant(resizedCube(cube, 31)));
}

TEST(PanoramaWithMeansOf, ComesNearTheCubeMapAgain) {
    CubeMap cube(32);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> even(0.5f, 1.5f);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : cube.texels(face)) texel = glm::vec3(even(random));
    const auto lost = [&](const Image& panorama) {
        const CubeMap back = cubeFromEquirect(panorama, 32);
        double sum = 0.0;
        for (const CubeFace face : kCubeFaces)
            for (std::size_t i = 0; i < 32 * 32; ++i) {
                const double away =
                    static_cast<double>(back.texels(face)[i].x - cube.texels(face)[i].x);
                sum += away * away;
            }
        return std::sqrt(sum / (6 * 32 * 32));
    };
    // White noise deviates by 0.29; interpolation loses 0.48 of it.
    EXPECT_GT(lost(panoramaFromCube(cube, 256)), 0.1);
    EXPECT_LT(lost(panoramaWithMeansOf(cube, 256)), 0.05);
}

TEST(PanoramaWithMeansOf, DrawsNoRimsAroundLamps) {
    CubeMap cube(64);
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < 64 * 64; ++i) {
            const glm::vec3 d = glm::normalize(
                directionFromCube({face, (2.0f * static_cast<float>(i % 64) + 1.0f) / 64.0f - 1.0f,
                                   (2.0f * static_cast<float>(i / 64) + 1.0f) / 64.0f - 1.0f}));
            const bool lamp = glm::dot(d, glm::normalize(glm::vec3(1.0f, 0.4f, 0.3f))) > 0.97f;
            cube.texels(face)[static_cast<std::size_t>(i)] = glm::vec3(lamp ? 300.0f : 0.2f);
        }
    for (const int width : {64, 128}) {
        const Image panorama = panoramaWithMeansOf(cube, width);
        for (const glm::vec3& pixel : panorama.pixels()) ASSERT_GE(pixel.x, 0.13f) << width;
        // Nor bright ones: some 3000ths of the lamp stay.
        for (int row = 0; row < width / 2; ++row)
            for (int column = 0; column < width; ++column) {
                const glm::vec3 d = directionFromEquirect((glm::vec2(column, row) + 0.5f) /
                                                          glm::vec2(width, width / 2));
                if (glm::dot(d, glm::normalize(glm::vec3(1.0f, 0.4f, 0.3f))) > 0.9f) continue;
                ASSERT_NEAR(panorama.at(column, row).x, 0.2f, 0.12f) << column << ' ' << row;
            }
    }
}

// Lamps of a single texel, which no panorama can give: beside an edge of a face, and within one.
TEST(PanoramaWithMeansOf, KeepsTheLightOfLamps) {
    for (const int size : {16, 32, 64}) {
        CubeMap cube(size);
        for (const CubeFace face : kCubeFaces)
            for (glm::vec3& texel : cube.texels(face)) texel = glm::vec3(0.3f);
        double light = 0.3;
        for (const auto& [face, x, y] :
             {std::tuple(CubeFace::posX, 1, size / 3), {CubeFace::negZ, size / 2, size / 3}}) {
            cube.texels(face)[static_cast<std::size_t>(y * size + x)] +=
                glm::vec3(20.0f * static_cast<float>(size * size));
            light += 20.0 * size * size * texelSolidAngle(size, x, y) / (4.0 * std::numbers::pi);
        }
        for (const int width : {48, 64, 80, 96, 128, 160, 192, 256}) {
            const Image panorama = panoramaWithMeansOf(cube, width);
            double sum = 0.0, area = 0.0;
            for (int row = 0; row < width / 2; ++row) {
                const double band = std::sin(std::numbers::pi * (row + 0.5) / (width / 2));
                for (int column = 0; column < width; ++column)
                    sum += band * static_cast<double>(panorama.at(column, row).x);
                area += band * width;
            }
            EXPECT_NEAR(sum / area / light, 1.0, 0.03) << size << " to " << width;
        }
    }
}

TEST(Unblurred, KeepsTheSumOfASunAndTurnsNothingNegative) {
    Image image(64, 32);
    for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(1.0f);
    image.at(20, 16) = glm::vec3(1e5f);
    const Image result = unblurred(image);
    double was = 0.0, is = 0.0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        was += static_cast<double>(image.pixels()[i].x);
        is += static_cast<double>(result.pixels()[i].x);
        EXPECT_GE(result.pixels()[i].x, 0.0f);
    }
    EXPECT_NEAR(is / was, 1.0, 1e-3);
}

TEST(GrownPanorama, KeepsAConstantExactlyConstant) {
    Image image(64, 32);
    for (glm::vec3& pixel : image.pixels()) pixel = {0.1f, 0.7f, 1e5f};
    const Image grown = resizedPanorama(image, 200);
    for (const glm::vec3& pixel : grown.pixels()) ASSERT_EQ(pixel, image.at(0, 0));
}

TEST(GrownPanorama, StopsWhenAsked) {
    Image image(64, 32);
    for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(1.0f);
    const Image some = resizedPanorama(image, 256, [](float fraction) { return fraction < 0.3f; });
    EXPECT_EQ(some.at(0, 0), glm::vec3(1.0f));
    EXPECT_EQ(some.at(0, 127), glm::vec3(0.0f));
}

TEST(StoppedWork, LeavesNothingBehind) {
    WorkSource source;
    source.cube = CubeMap(16);
    const TestFolder folder;
    for (const char* name : {"face_{}.exr", "cube.ktx2"})
        EXPECT_FALSE(saveWork(folder.path(name), source, {.form = PictureForm::faces},
                              [](float fraction) { return fraction < 0.5f; }))
            << name;
    EXPECT_FALSE(saveWork(folder.path("panorama.exr"), source, {},
                          [](float fraction) { return fraction < 0.3f; }));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace tukor
