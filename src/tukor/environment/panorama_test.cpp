#include "tukor/environment/panorama.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/test_folder.h"
#include "tukor/environment/environment_info.h"
#include "tukor/environment/environment_work.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/layout.h"

namespace tukor {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 landscape(glm::vec3 d) {
    d = glm::normalize(d);
    return {2.0f + d.x, 2.0f + d.y, 2.0f + d.z};
}

CubeMap landscapeCube(int size) {
    Image image(4 * size, 2 * size);
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column)
            image.at(column, row) = landscape(directionFromEquirect(
                {(static_cast<float>(column) + 0.5f) / static_cast<float>(image.width()),
                 (static_cast<float>(row) + 0.5f) / static_cast<float>(image.height())}));
    return cubeFromEquirect(image, size);
}

const glm::vec3 kDirections[] = {
    {1, 0.2f, 0.1f}, {-0.3f, 1, 0.2f}, {0.1f, -0.4f, -1}, {-1, -1, 0.7f}, {0.3f, -1, 0.4f}};

void expectLandscape(const CubeMap& cube, float tolerance) {
    for (const glm::vec3 d : kDirections)
        EXPECT_LT(glm::length(cube.radiance(d) - landscape(d)), tolerance);
}

// Across a seam of the cube the rows of the two faces lie up to a quarter of a texel apart, 1 / 128
// of a radian: linear interpolation errs by less than that. The sides of octahedra and balls are
// coarser.
TEST(Layouts, BringEveryDirectionBack) {
    const CubeMap cube = landscapeCube(64);
    for (const Layout layout : {Layout::hcross, Layout::vcross, Layout::hstrip, Layout::vstrip}) {
        const CubeMap back = cubeFromLayout(pictureFromCube(cube, layout), layout);
        for (const CubeFace face : kCubeFaces)
            EXPECT_TRUE(std::equal(cube.texels(face).begin(), cube.texels(face).end(),
                                   back.texels(face).begin()));
    }
    expectLandscape(cubeFromEquirect(panoramaFromCube(cube, 256), 64), 8e-3f);
    expectLandscape(cubeFromOctahedral(octahedralFromCube(cube, 128), 64), 1e-2f);
    expectLandscape(cubeFromBall(ballFromCube(cube, 512), 64), 2e-2f);
}

TEST(Octahedral, HasUpInTheMiddleAndTheAxesOnItsDiamond) {
    const Image picture = octahedralFromCube(landscapeCube(64), 129);
    EXPECT_LT(glm::length(picture.at(64, 64) - landscape({0, 1, 0})), 0.02f);
    EXPECT_LT(glm::length(picture.at(128, 64) - landscape({1, 0, 0})), 0.02f);
    EXPECT_LT(glm::length(picture.at(64, 128) - landscape({0, 0, 1})), 0.02f);
    EXPECT_LT(glm::length(picture.at(0, 0) - landscape({0, -1, 0})), 0.03f);
}

TEST(Ball, ShowsTheCameraInTheMiddleAndTheSidesAtHalfItsArea) {
    const Image picture = ballFromCube(landscapeCube(64), 201);
    EXPECT_LT(glm::length(picture.at(100, 100) - landscape({0, 0, 1})), 0.01f);
    const int side = 100 + static_cast<int>(100.5f * std::sqrt(0.5f));
    EXPECT_LT(glm::length(picture.at(side, 100) - landscape({1, 0, 0})), 0.03f);
    EXPECT_EQ(picture.at(0, 0), glm::vec3(0.0f));
}

TEST(TurnedPanorama, TurnsCounterClockwiseSeenFromAbove) {
    // A quarter turn takes +X to -Z.
    Image image(64, 32);
    image.at(48, 16) = glm::vec3(1.0f);  // right of the middle by a quarter: +X
    const Image turned = turnedPanorama(image, kPi / 2);
    EXPECT_EQ(turned.at(32, 16), glm::vec3(1.0f));
    const Image back = turnedPanorama(turned, -kPi / 2);
    EXPECT_EQ(back.at(48, 16), glm::vec3(1.0f));
    // Half a pixel is shared by two.
    EXPECT_NEAR(turnedPanorama(image, kPi / 64).at(47, 16).x, 0.5f, 1e-5f);
}

TEST(TurnedCube, TurnsAsThePanoramaDoes) {
    const CubeMap turned = turnedCube(landscapeCube(64), kPi / 2);
    EXPECT_LT(glm::length(turned.radiance({0, 0, -1}) - landscape({1, 0, 0})), 8e-3f);
    EXPECT_LT(glm::length(turned.radiance({1, 0, 0}) - landscape({0, 0, 1})), 8e-3f);
}

TEST(ResizedPanorama, KeepsTheIntegralWhenItShrinks) {
    Image image(60, 30);
    image.at(17, 5) = glm::vec3(100.0f);
    const auto integral = [](const Image& picture) {
        double sum = 0;
        for (int row = 0; row < picture.height(); ++row)
            for (int column = 0; column < picture.width(); ++column)
                sum += static_cast<double>(picture.at(column, row).x) / picture.width() *
                       (std::cos(std::numbers::pi * row / picture.height()) -
                        std::cos(std::numbers::pi * (row + 1) / picture.height()));
        return sum;
    };
    for (const int width : {6, 14, 32, 60})
        EXPECT_NEAR(integral(resizedPanorama(image, width)) / integral(image), 1.0, 1e-5) << width;
    EXPECT_EQ(resizedPanorama(image, 120).width(), 120);
}

TEST(SaveWork, SaysWhatDoesNotSuit) {
    const auto messageOf = [](const std::string& path, PictureForm form) {
        try {
            checkWorkTarget(path, form);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(messageOf("a.exr", PictureForm::faces),
              "a.exr: six faces need a pattern with {} for the face, as sky_{}.exr");
    EXPECT_EQ(messageOf("a_{}.exr", PictureForm::equirect),
              "a_{}.exr: {} stands for the face, but this layout is one picture");
    EXPECT_EQ(messageOf("a.exr", PictureForm::equirect), "no error");
}

TEST(SaveWork, WritesWhatLoadWorkSourceReads) {
    const TestFolder folder;
    const std::pair<PictureForm, const char*> forms[] = {
        {PictureForm::equirect, "equirect.exr"}, {PictureForm::faces, "face_{}.exr"},
        {PictureForm::hcross, "hcross.exr"},     {PictureForm::vcross, "vcross.exr"},
        {PictureForm::hstrip, "hstrip.exr"},     {PictureForm::vstrip, "vstrip.exr"},
        {PictureForm::octahedral, "oct.exr"},    {PictureForm::ball, "ball.exr"}};
    for (const auto& [form, name] : forms) {
        WorkSource source;
        source.cube = landscapeCube(32);
        const std::string path = folder.path(name);
        saveWork(path, source,
                 {form, form == PictureForm::ball ? std::optional<int>(256) : std::nullopt});
        WorkSource back = loadWorkSource(path, form);
        const Image& panorama = panoramaOf(back);
        for (const glm::vec3 d : kDirections)
            EXPECT_LT(glm::length(equirectRadiance(panorama, d) - landscape(d)), 0.04f) << name;
    }
    EXPECT_THAT(textOf(infoOf(loadWorkSource(folder.path("vcross.exr"), std::nullopt))),
                testing::HasSubstr("layout     vertical cross\nsize       96 x 128\n"));
    const Image sheet =
        contactSheet(loadWorkSource(folder.path("oct.exr"), PictureForm::octahedral));
    EXPECT_EQ(sheet.width(), 768);
    EXPECT_EQ(sheet.height(), 3 * 384 + 128);
}

TEST(EnvironmentInfo, MeasuresTheTexelsOfTheFile) {
    WorkSource source;
    source.cube = CubeMap(8);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : source.cube->texels(face)) texel = {1.0f, 1.0f, 0.0f};
    source.cube->texels(CubeFace::posY)[9] = {0.25f, 70000.0f, 0.0f};
    const EnvironmentInfo info = infoOf(std::move(source));
    const std::string text = textOf(info);
    EXPECT_THAT(text, testing::HasSubstr("least      0.25 1 0\nmost       1 70000 0\n"));
    EXPECT_THAT(text, testing::HasSubstr("\nabove half 1 pixel, brighter than 65504\n"));
    EXPECT_THAT(text, testing::Not(testing::ContainsRegex(" -0[ \n]")));
    const std::string json = jsonOf(info);
    EXPECT_THAT(json, testing::HasSubstr("\"aboveHalf\": 1,"));
    EXPECT_THAT(json, testing::HasSubstr("\"sun\": null"));
}

TEST(SaveWork, BlursNoMoreThanPixelsDoWhereTexelsAreAsFine) {
    // A mean over a pixel of linear interpolation between pixels takes 1/8, 3/4, 1/8 of three along
    // each axis: of white noise 0.48 of its deviation is lost. The fit of the cube may lose some.
    Image image(128, 64);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> even(0.5f, 1.5f);
    for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(even(random));
    WorkSource source;
    source.cube = cubeFromEquirect(image, 64);
    const TestFolder folder;
    const std::string path = folder.path("a.exr");
    saveWork(path, source, {PictureForm::equirect, image.width()});
    const Image back = loadImage(path);
    double sum = 0.0, weights = 0.0;
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column) {
            const double weight = std::sin(std::numbers::pi * (row + 0.5) / image.height());
            const double lost =
                static_cast<double>(back.at(column, row).x - image.at(column, row).x);
            sum += weight * lost * lost;
            weights += weight;
        }
    EXPECT_LT(std::sqrt(sum / weights), 0.6 * std::sqrt(1.0 / 12.0));
}

}  // namespace
}  // namespace tukor
