// Textures of glTF: which picture, on which coordinates, encoded how, and what becomes of damage.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/image/png_file.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/gltf_file.h"
#include "tukor/scene/gltf_test_file.h"

namespace tukor {
namespace {

using test::Bytes;
using test::messageOf;
using testing::Contains;
using testing::HasSubstr;

std::string pngUri(int width, int height) {
    EncodedPixels pixels;
    pixels.width = width;
    pixels.height = height;
    for (int i = 0; i < 3 * width * height; ++i)
        pixels.bytes.push_back(static_cast<std::uint8_t>(i));
    const std::vector<std::byte> bytes = encodePng(pixels, {});
    return "data:image/png;base64," +
           test::base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// A triangle with two sets of coordinates and colours; `rest` adds materials and what they need.
Scene triangleWith(const std::string& rest) {
    Bytes bytes;
    bytes.add({glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)});  // 36
    bytes.add({glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)});     // 24
    bytes.add<std::uint16_t>({0, 0, 65535, 0, 0, 65535});               // 12
    bytes.add<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 51});
    const std::string text = R"({"asset": {"version": "2.0"}, "buffers": [)" + buffer(bytes) +
                             R"(], "bufferViews": [{"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 24},
            {"buffer": 0, "byteOffset": 60, "byteLength": 12},
            {"buffer": 0, "byteOffset": 72, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
            {"bufferView": 1, "componentType": 5126, "type": "VEC2", "count": 3},
            {"bufferView": 2, "componentType": 5123, "type": "VEC2", "count": 3, "normalized": true},
            {"bufferView": 3, "componentType": 5121, "type": "VEC4", "count": 3, "normalized": true}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2,
            "COLOR_0": 3}, "material": 0}]}], "nodes": [{"mesh": 0}], )" +
                             rest + "}";
    return loadGltf("folder/a.gltf", std::as_bytes(std::span(text)));
}

std::string images(const std::string& uri) {
    return R"("images": [{"name": "picture", "uri": ")" + uri + R"("}],)";
}

const std::string kMaterial = R"("materials": [{"name": "cloth", "pbrMetallicRoughness":
    {"baseColorTexture": {"index": 0, "texCoord": 1}, "metallicRoughnessTexture": {"index": 0}}}],)";

TEST(GltfTextures, GiveCoordinatesColoursAndTexels) {
    const Scene scene = triangleWith(images(pngUri(4, 2)) + kMaterial +
                                     R"("samplers": [{"wrapS": 33071, "wrapT": 33648,
            "magFilter": 9728}], "textures": [{"source": 0, "sampler": 0}])");
    EXPECT_TRUE(scene.warnings.empty());
    const Mesh& mesh = scene.parts[0].mesh;
    ASSERT_EQ(mesh.uvs[0].size(), 3u);
    EXPECT_EQ(mesh.uvs[0][2], glm::vec2(0, 1));
    EXPECT_EQ(mesh.uvs[1][1], glm::vec2(1, 0)) << "normalised integers";
    EXPECT_NEAR(mesh.colors[2].w, 0.2f, 1e-6);
    const Finish& finish = *scene.parts[0].material.finish;
    const TextureMap& base = finish.map(TextureRole::baseColor);
    ASSERT_TRUE(finish.has(TextureRole::baseColor));
    EXPECT_EQ(base.uvSet, 1);
    EXPECT_EQ(base.wrapU, Wrap::clamp);
    EXPECT_EQ(base.wrapV, Wrap::mirror);
    EXPECT_FALSE(base.smooth);
    EXPECT_EQ(base.texels->width, 4);
    EXPECT_EQ(base.texels->bytes[5], 5) << "numbers as they are in the file";
    EXPECT_EQ(base.texels, finish.map(TextureRole::metallicRoughness).texels) << "decoded once";
    EXPECT_FALSE(finish.has(TextureRole::normal));
}

TEST(GltfTextures, AreTransformed) {
    const Scene scene = triangleWith(images(pngUri(1, 1)) + R"("materials": [{
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
        {"KHR_texture_transform": {"offset": [0.5, 0.25], "scale": [2, 3], "texCoord": 1,
        "rotation": 1.5707963267948966}}}}}], "textures": [{"source": 0}])");
    const TextureMap& map = scene.parts[0].material.finish->map(TextureRole::baseColor);
    EXPECT_EQ(map.uvSet, 1);
    // Scaled to (2, 6), turned a quarter, moved.
    const glm::vec2 place = map.imageFromUv * glm::vec3(1, 2, 1);
    EXPECT_NEAR(place.x, 6.5f, 1e-5);
    EXPECT_NEAR(place.y, -1.75f, 1e-5);
}

// The extension's own example: "only the lower left quadrant of the source image, rotated clockwise
// 90 degrees". [KHR_texture_transform]
TEST(GltfTextures, TurnTheWayTheSpecificationSays) {
    const Scene scene = triangleWith(images(pngUri(1, 1)) + R"("materials": [{
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
        {"KHR_texture_transform": {"offset": [0, 1], "rotation": 1.57079632679,
        "scale": [0.5, 0.5]}}}}}], "textures": [{"source": 0}])");
    const TextureMap& map = scene.parts[0].material.finish->map(TextureRole::baseColor);
    const auto expectAt = [&](glm::vec2 uv, glm::vec2 place) {
        EXPECT_LT(glm::length(map.imageFromUv * glm::vec3(uv, 1) - place), 1e-5f)
            << uv.x << ' ' << uv.y;
    };
    // The quadrant's corners, whose top lies to the right now: (0, 0) is the top left.
    expectAt({0, 0}, {0, 1});
    expectAt({1, 0}, {0, 0.5f});
    expectAt({1, 1}, {0.5f, 0.5f});
    expectAt({0, 1}, {0.5f, 1});
}

TEST(GltfTextures, ThatCannotBeReadAreLeftOutWithAWarning) {
    const std::string textures = R"("textures": [{"source": 0}])";
    const auto warnings = [&](const std::string& uri) {
        const Scene scene = triangleWith(images(uri) + kMaterial + textures);
        EXPECT_FALSE(scene.parts[0].material.finish->has(TextureRole::baseColor));
        return scene.warnings;
    };
    EXPECT_THAT(warnings("data:image/png;base64,AAAA"),
                Contains(HasSubstr("textures that cannot be read, left out: picture")));
    EXPECT_THAT(warnings("missing.png"), Contains(HasSubstr("missing.png")));
    EXPECT_THAT(warnings("../secret.png"), Contains(HasSubstr("a path with '..'")));
    EXPECT_THAT(triangleWith(kMaterial + R"("textures": [{}])").warnings,
                Contains(HasSubstr("formats that are not read")));
}

TEST(GltfTextures, RefuseMoreThanMemoryHolds) {
    // Headers alone count: 16384 x 16384, three times.
    Bytes header;
    header.add<std::uint8_t>({0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0,  0,
                              0,    13,  'I', 'H', 'D',  'R',  0,    0,    64, 0,
                              0,    0,   64,  0,   8,    2,    0,    0,    0});
    const std::string uri = "data:image/png;base64," + test::base64(header.text());
    std::string list;
    for (int i = 0; i < 3; ++i) list += std::string(i ? ", " : "") + R"({"uri": ")" + uri + R"("})";
    EXPECT_THAT(messageOf([&] {
                    (void)triangleWith(R"("images": [)" + list + R"(], "materials": [{
        "normalTexture": {"index": 0}, "occlusionTexture": {"index": 1},
        "emissiveTexture": {"index": 2}}], "textures": [{"source": 0}, {"source": 1},
        {"source": 2}])");
                }),
                HasSubstr("its textures have 805306368 texels together"));
}

TEST(GltfTextures, ReferToWhatIsThere) {
    EXPECT_THAT(messageOf([] { (void)triangleWith(kMaterial + R"("textures": [])"); }),
                HasSubstr("refers to textures[0]; there are 0"));
    EXPECT_THAT(messageOf([] {
                    (void)triangleWith(kMaterial + R"("textures": [{"source": 0, "sampler": 0}],
                        "samplers": [{"wrapS": 1}])");
                }),
                HasSubstr("wrapS 1; expected 10497, 33071 or 33648"));
}

}  // namespace
}  // namespace tukor
