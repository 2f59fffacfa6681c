// glTF files that lie: each gives one clear error and costs nothing to speak of.
#include <cstdint>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/file.h"
#include "tukor/base/test_folder.h"
#include "tukor/scene/gltf_file.h"
#include "tukor/scene/gltf_test_file.h"

namespace tukor {
namespace {

namespace fs = std::filesystem;
using test::Bytes;
using test::kOneMesh;
using test::messageOf;
using test::tetrahedron;
using testing::HasSubstr;

std::string errorOf(const std::string& text, const fs::path& path = "a.gltf") {
    return messageOf([&] { (void)loadGltf(path, std::as_bytes(std::span(text))); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(GltfHostile, EveryTruncationIsAnError) {
    const std::string text = tetrahedron(kOneMesh);
    for (std::size_t length = 0; length < text.size(); ++length)
        EXPECT_THAT(errorOf(text.substr(0, length)), HasSubstr("not JSON")) << length;
}

TEST(GltfHostile, EveryTruncatedGlbIsAnError) {
    const std::string json = R"({"asset": {"version": "2.0"}})" + std::string(3, ' ');
    const std::string glb =
        Bytes().add<std::uint32_t>({0x46546c67, 2, 52, 32, 0x4e4f534a}).text() + json;
    EXPECT_EQ(errorOf(glb), "a.gltf: nothing to render: no triangles in its scene");
    for (std::size_t length = 4; length < glb.size(); ++length)
        EXPECT_THAT(errorOf(glb.substr(0, length)), HasSubstr("cut off")) << length;
    const auto header = [&](std::uint32_t version, std::uint32_t chunk, std::uint32_t type) {
        return errorOf(Bytes().add<std::uint32_t>({0x46546c67, version, 52, chunk, type}).text() +
                       json);
    };
    EXPECT_EQ(header(1, 32, 0x4e4f534a), "a.gltf: GLB version 1; expected 2");
    EXPECT_EQ(header(2, 0xffffffff, 0x4e4f534a),
              "a.gltf: a chunk of 4294967295 bytes where 32 are left");
    EXPECT_EQ(header(2, 32, 0x004e4942), "a.gltf: a GLB whose first chunk is not JSON");
}

TEST(GltfHostile, DeepNestingIsRefusedWithoutRecursion) {
    EXPECT_EQ(errorOf(std::string(5'000'000, '[')), "a.gltf: JSON nested deeper than 64 levels");
    std::string zeros = "[0";
    for (int i = 0; i < 2'500'000; ++i) zeros += ",0";
    EXPECT_EQ(errorOf(zeros), "a.gltf: JSON of more than 2000000 values");
    EXPECT_EQ(errorOf(R"({"asset": 1e999})"), "a.gltf: not JSON: a number is beyond all bounds");
}

TEST(GltfHostile, WrongTypesAreNamedWithTheirPlace) {
    EXPECT_EQ(errorOf("[]"), "a.gltf: found array; expected an object");
    EXPECT_EQ(errorOf("{}"), "a.gltf: 'asset' is missing");
    EXPECT_EQ(errorOf(R"({"asset": {"version": 2}})"),
              "a.gltf: asset.version: found number; expected a string");
    EXPECT_EQ(errorOf(R"({"asset": {"version": "1.0"}})"),
              "a.gltf: asset: glTF version '1.0'; expected 2.0");
    EXPECT_EQ(errorOf(tetrahedron(R"("nodes": {"mesh": 0})")),
              "a.gltf: nodes: found object; expected an array");
    EXPECT_EQ(errorOf(tetrahedron(R"("nodes": [{"mesh": -1}])")),
              "a.gltf: nodes[0].mesh: found -1; expected a whole number from 0 up");
    EXPECT_EQ(errorOf(tetrahedron(R"("nodes": [{"mesh": 7}], "meshes": [])")),
              "a.gltf: nodes[0]: refers to meshes[7]; there are 0");
    EXPECT_EQ(errorOf(tetrahedron(R"("nodes": [{"scale": [1, 2]}])")),
              "a.gltf: nodes[0].scale: 2 numbers; expected 3");
}

// Any single member of a good file with any other type in its place: an error or a scene, no crash.

TEST(GltfHostile, SurvivesEveryMemberOfAnotherType) {
    const std::string text = tetrahedron(kOneMesh);
    for (std::size_t colon = text.find(':'); colon != std::string::npos;
         colon = text.find(':', colon + 1))
        for (const char* other :
             {"null", "-1", "1e300", "\"x\"", "[]", "{}", "4294967296", "[{}]"}) {
            std::string changed = text;
            const std::size_t end = text.find_first_of(",}]", colon + 1);
            (void)errorOf(changed.replace(colon + 1, end - colon - 1, other));
        }
}

TEST(GltfHostile, NodeGraphsMustBeTrees) {
    const char* const kReached = "reached twice; nodes must form trees";
    EXPECT_THAT(errorOf(tetrahedron(R"("nodes": [{"children": [1]}, {"children": [0]}],
    "scenes": [{"nodes": [0]}])")),
                HasSubstr(kReached));
    EXPECT_THAT(errorOf(tetrahedron(R"("nodes": [{"children": [0]}], "scenes": [{"nodes": [0]}])")),
                HasSubstr(kReached));
    EXPECT_THAT(errorOf(tetrahedron(R"("nodes": [{"children": [1, 1]}, {}])")),
                HasSubstr(kReached));
    EXPECT_THAT(errorOf(tetrahedron(R"("nodes": [{"children": [9]}])")),
                HasSubstr("refers to nodes[9]; there are 1"));
}

TEST(GltfHostile, ALongChainOfNodesNeedsNoStack) {
    std::string nodes = R"("nodes": [)";
    for (int i = 1; i < 50'000; ++i) nodes += R"({"children":[)" + std::to_string(i) + "]},";
    EXPECT_EQ(errorOf(tetrahedron(nodes + "{}]")),
              "a.gltf: nothing to render: no triangles in its scene");
}

TEST(GltfHostile, RepeatedMeshesAreCountedBeforeTheyAreRead) {
    std::string nodes =
        R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 6}]}],
    "nodes": [)";
    for (int i = 1; i < 100; ++i) nodes += R"({"mesh": 0},)";
    const std::string text =
        replaced(tetrahedron(nodes + R"({"mesh": 0}])"),
                 R"({"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4})",
                 R"({"componentType": 5126, "type": "VEC3", "count": 4000000})");
    EXPECT_THAT(errorOf(text),
                HasSubstr("its nodes repeat meshes to more than 16777216 triangles"));
}

TEST(GltfHostile, AccessorsMustFitIntoTheirViews) {
    const std::string text = tetrahedron(kOneMesh);
    const std::string count = R"("type": "VEC3", "count": )";
    for (const char* n : {"5", "2147483648", "4294967295"})
        EXPECT_THAT(errorOf(replaced(text, count + "4", count + n)),
                    HasSubstr("accessors[0]: " + std::string(n) +
                              " elements of 12 bytes from byte 0 "
                              "do not fit into a view of 48"));
    EXPECT_THAT(errorOf(replaced(text, count + "4", count + "4294967296")),
                HasSubstr("at most 2^32 - 1"));
    EXPECT_THAT(
        errorOf(replaced(text, R"("bufferView": 0)", R"("byteOffset": 1, "bufferView": 0)")),
        HasSubstr("do not fit"));
    EXPECT_THAT(errorOf(replaced(text, R"("bufferView": 0)",
                                 R"("byteOffset": 9007199254740992, "bufferView": 0)")),
                HasSubstr("do not fit"));
    EXPECT_THAT(errorOf(replaced(text, R"("bufferView": 0, )", "")),
                testing::AnyOf(HasSubstr("nothing to render"), HasSubstr("scaled to nothing")));
    EXPECT_THAT(errorOf(replaced(
                    text, R"("bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4)",
                    R"("componentType": 5126, "type": "VEC3", "count": 2147483648)")),
                HasSubstr("elements without a buffer view"));
    EXPECT_THAT(errorOf(replaced(text, "5126", "5130")), HasSubstr("component type 5130"));
    EXPECT_THAT(errorOf(replaced(text, "VEC3", "VEC7")), HasSubstr("type 'VEC7'"));
    EXPECT_THAT(errorOf(replaced(text, "VEC3", "VEC2")), HasSubstr("expected type VEC3"));
    EXPECT_THAT(errorOf(replaced(text, "5123", "5122")), HasSubstr("not indices"));
    EXPECT_THAT(errorOf(replaced(text, R"("byteLength": 48)", R"("byteLength": 480)")),
                HasSubstr("bufferViews[0]: bytes 0 to 480 of a buffer of 72"));
    EXPECT_THAT(errorOf(replaced(text, R"({"byteLength": 72)", R"({"byteLength": 2147483648)")),
                HasSubstr("buffers[0]: 72 bytes; expected 2147483648"));
}

TEST(GltfHostile, IndicesMustBeVertices) {
    EXPECT_EQ(errorOf(replaced(tetrahedron(kOneMesh), R"("count": 4)", R"("count": 3)")),
              "a.gltf: meshes[0].primitives[0]: triangle 1 refers to vertex 3 of 3");
}

TEST(GltfHostile, PositionsMustBeFinite) {
    const std::string text = tetrahedron(kOneMesh);
    for (const char* bits : {"AADAfwAA", "AACAfwAA"}) {  // NaN and infinity in the first six bytes
        const std::string bad = replaced(text, "base64,AAAAAAAA", std::string("base64,") + bits);
        EXPECT_THAT(errorOf(bad), HasSubstr("nodes[0]: vertex 0 is at ("));
    }
    EXPECT_THAT(errorOf(replaced(text, R"({"mesh": 0})", R"({"mesh": 0, "scale": [1e200, 1, 1]})")),
                HasSubstr("its transformation is too large"));
}

TEST(GltfHostile, UnknownRequiredExtensionsAreNamed) {
    EXPECT_EQ(errorOf(tetrahedron(R"("extensionsRequired": ["ACME_rooms"])")),
              "a.gltf: extensionsRequired[0]: the file requires the extension ACME_rooms, which is "
              "not supported");
}

class GltfFolder : public testing::Test {
protected:
    GltfFolder() {
        fs::create_directories(folder_ / "model" / "sub dir");
        const std::string secret(72, 's');
        writeFile(folder_ / "secret.bin", secret);
        fs::create_symlink(folder_ / "secret.bin", folder_ / "model" / "link.bin");
        fs::create_symlink(folder_, folder_ / "model" / "up");
    }

    // The error for a model whose buffer has this URI.
    std::string errorFor(const std::string& uri) {
        const std::string text = tetrahedron(kOneMesh);
        const std::size_t from = text.find("data:"), to = text.find('"', from);
        return errorOf(text.substr(0, from) + uri + text.substr(to), folder_ / "model" / "a.gltf");
    }

    TestFolder own_;
    const fs::path& folder_ = own_.path();
};

TEST_F(GltfFolder, FilesOutsideAreRefused) {
    for (const char* uri :
         {"../secret.bin", "sub%20dir/../../secret.bin", "%2e%2e/secret.bin", "/etc/passwd",
          "link.bin", "up/secret.bin", "file:///etc/passwd", "http://example.org/a.bin",
          "C:secret.bin", "..\\\\secret.bin", "a%00b", ""})
        EXPECT_THAT(errorFor(uri), HasSubstr("a model may only name files below its own folder"))
            << uri;
    EXPECT_THAT(errorFor("a%2"), HasSubstr("'%' without two hexadecimal digits"));
    EXPECT_THAT(errorFor("data:text/plain,abc"), HasSubstr("a data URI that is not base64"));
    EXPECT_THAT(errorFor("data:;base64,ab!d"), HasSubstr("a character that is not base64"));
}

TEST_F(GltfFolder, FilesInsideAreReadAndMissingOnesNamed) {
    EXPECT_THAT(errorFor("missing.bin"), HasSubstr("missing.bin: no such file"));
    EXPECT_THAT(errorFor("sub%20dir"), HasSubstr("is a folder"));
    writeFile(folder_ / "model" / "sub dir" / "a.bin", std::string(72, '\0'));
    EXPECT_THAT(errorFor("sub%20dir/a.bin"), HasSubstr("nothing to render"));
    writeFile(folder_ / "model" / "short.bin", std::string(71, '\0'));
    EXPECT_THAT(errorFor("short.bin"), HasSubstr("71 bytes; expected 72"));
}

}  // namespace
}  // namespace tukor
