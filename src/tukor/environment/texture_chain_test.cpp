#include "tukor/environment/texture_chain.h"

#include <gtest/gtest.h>

#include "tukor/base/test_folder.h"
#include "tukor/environment/cube_mips.h"
#include "tukor/environment/environment.h"
#include "tukor/environment/procedural.h"

namespace tukor {
namespace {

TEST(TextureChain, BringsTheLevelsBack) {
    std::vector<CubeMap> levels{studioCube(16)};
    for (CubeMap& mip : cubeMips(levels.front())) levels.push_back(std::move(mip));
    const TextureFile texture = textureFromCubes(levels);
    EXPECT_EQ(texture.levels, 5);
    for (const char* extension : {".dds", ".ktx", ".ktx2"}) {
        const auto bytes = encodeTexture(texture, extension, {.texels = TexelFormat::rgba32f});
        const TextureFile back = decodeTexture(bytes, "back");
        ASSERT_EQ(back.levels, 5) << extension;
        const CubeMap cube = cubeFromTexture(back);
        for (const CubeFace face : kCubeFaces)
            for (std::size_t i = 0; i < 256; ++i)
                EXPECT_EQ(cube.texels(face)[i], levels.front().texels(face)[i]) << extension;
        for (int face = 0; face < 6; ++face)
            EXPECT_EQ(back.image(4, face).at(0, 0),
                      levels[4].texels(kCubeFaces[static_cast<std::size_t>(face)])[0]);
    }
}

TEST(TextureChain, IsReadAsAnEnvironment) {
    const TestFolder folder;
    const std::string path = folder.path("a.ktx2");
    const CubeMap cube = studioCube(16);
    saveTexture(path, textureFromCubes(std::span(&cube, 1)), {.texels = TexelFormat::rgba32f});
    const Environment environment = loadEnvironment(path);
    EXPECT_EQ(environment.radiance.faceSize(), 16);
    EXPECT_EQ(environment.radiance.texels(CubeFace::negZ)[40], cube.texels(CubeFace::negZ)[40]);
}

}  // namespace
}  // namespace tukor
