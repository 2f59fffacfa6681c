#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "tukor/environment/environment_work.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/panorama.h"

namespace tukor {
namespace {

TEST(GrownPanorama, IsMeansOfBilinearLookUps) {
    Image image(32, 16);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> even(0.0f, 2.0f);
    for (glm::vec3& pixel : image.pixels()) pixel = {even(random), even(random), even(random)};
    for (const int width : {48, 64, 130}) {
        const Image grown = resizedPanorama(image, width);
        ASSERT_EQ(grown.height(), width / 2);
        for (int row = 0; row < grown.height(); ++row)
            for (int column = 0; column < width; ++column) {
                glm::vec3 mean(0.0f);
                for (int i = 0; i < 9; ++i) {
                    const glm::vec2 within = (glm::vec2(i % 3, i / 3) + 0.5f) / 3.0f;
                    const glm::vec2 place =
                        (glm::vec2(column, row) + within) / glm::vec2(width, grown.height());
                    mean += equirectRadiance(image, directionFromEquirect(place));
                }
                // Directions lose about 1e-5 of a pixel to rounding.
                ASSERT_LT(glm::length(grown.at(column, row) - mean / 9.0f), 1e-4f)
                    << width << ": " << column << " " << row;
            }
    }
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
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / "tukor_stopped_test";
    std::filesystem::create_directories(folder);
    for (const char* name : {"face_{}.exr", "cube.ktx2"})
        EXPECT_FALSE(saveWork((folder / name).string(), source, {.form = PictureForm::faces},
                              [](float fraction) { return fraction < 0.5f; }))
            << name;
    EXPECT_FALSE(saveWork((folder / "panorama.exr").string(), source, {},
                          [](float fraction) { return fraction < 0.3f; }));
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace tukor
