#include "tukor/environment/layout.h"

#include <random>

#include <gtest/gtest.h>

#include "tukor/environment/cube_texel.h"

namespace tukor {
namespace {

/// What `layout` looks like, told by geometry: each pixel's colour is its direction. `steps` leads
/// from the +Z face to each face through edges that the layout joins.
Image pictureOfDirections(int columns, int rows, int size,
                          const std::vector<std::pair<glm::ivec2, CubeFace>>& places,
                          bool turnLast) {
    Image picture(columns * size, rows * size);
    for (const auto& [place, face] : places)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const bool turned = turnLast && face == CubeFace::negZ;
                picture.at(place.x * size + column, place.y * size + row) = directionFromTexel(
                    {face, turned ? size - 1 - column : column, turned ? size - 1 - row : row},
                    size);
            }
    return picture;
}

void expectDirections(const CubeMap& cube) {
    const int size = cube.faceSize();
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < size * size; ++i)
            EXPECT_EQ(cube.texels(face)[static_cast<std::size_t>(i)],
                      directionFromTexel({face, i % size, i / size}, size));
}

const std::vector<std::pair<glm::ivec2, CubeFace>> kHcross = {
    {{2, 1}, CubeFace::posX}, {{0, 1}, CubeFace::negX}, {{1, 0}, CubeFace::posY},
    {{1, 2}, CubeFace::negY}, {{1, 1}, CubeFace::posZ}, {{3, 1}, CubeFace::negZ}};
const std::vector<std::pair<glm::ivec2, CubeFace>> kVcross = {
    {{2, 1}, CubeFace::posX}, {{0, 1}, CubeFace::negX}, {{1, 0}, CubeFace::posY},
    {{1, 2}, CubeFace::negY}, {{1, 1}, CubeFace::posZ}, {{1, 3}, CubeFace::negZ}};

TEST(CubeFromLayout, FindsTheFacesOfCrosses) {
    expectDirections(cubeFromLayout(pictureOfDirections(4, 3, 5, kHcross, false), Layout::hcross));
    expectDirections(cubeFromLayout(pictureOfDirections(3, 4, 5, kVcross, true), Layout::vcross));
}

TEST(CubeFromLayout, FindsTheFacesOfStrips) {
    std::vector<std::pair<glm::ivec2, CubeFace>> across, down;
    for (int i = 0; i < 6; ++i) {
        across.push_back({{i, 0}, static_cast<CubeFace>(i)});
        down.push_back({{0, i}, static_cast<CubeFace>(i)});
    }
    expectDirections(cubeFromLayout(pictureOfDirections(6, 1, 3, across, false), Layout::hstrip));
    expectDirections(cubeFromLayout(pictureOfDirections(1, 6, 3, down, false), Layout::vstrip));
}

TEST(Crosses, JoinFacesAlongTheEdgesTheyShareOnTheCube) {
    // Neighbouring pixels of a cross are neighbours on the cube: the directions of texel centres
    // half a texel from the fold differ by at most a texel's diagonal.
    const int size = 8;
    const auto expectContinuous = [&](const Image& cross) {
        const auto filled = [](glm::vec3 pixel) { return pixel != glm::vec3(0.0f); };
        for (int row = 0; row + 1 < cross.height(); ++row)
            for (int column = 0; column + 1 < cross.width(); ++column)
                for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
                    const glm::vec3 a = cross.at(column, row);
                    const glm::vec3 b = cross.at(column + step.x, row + step.y);
                    if (filled(a) && filled(b)) {
                        EXPECT_LT(glm::length(a - b), 2.1f / size);
                    }
                }
    };
    expectContinuous(pictureOfDirections(4, 3, size, kHcross, false));
    expectContinuous(pictureOfDirections(3, 4, size, kVcross, true));
}

TEST(LayoutOfShape, TellsTheLayoutsApart) {
    EXPECT_EQ(layoutOfShape(1024, 512), Layout::equirect);
    EXPECT_EQ(layoutOfShape(1024, 768), Layout::hcross);
    EXPECT_EQ(layoutOfShape(768, 1024), Layout::vcross);
    EXPECT_EQ(layoutOfShape(384, 64), Layout::hstrip);
    EXPECT_EQ(layoutOfShape(64, 384), Layout::vstrip);
    EXPECT_EQ(layoutOfShape(2047, 1024), std::nullopt);
    EXPECT_EQ(layoutOfShape(512, 512), std::nullopt);
}

}  // namespace
}  // namespace tukor
