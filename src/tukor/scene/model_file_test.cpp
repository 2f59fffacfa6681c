// Models of every format but glTF, made here as text and bytes.
#include "tukor/scene/model_file.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/file.h"
#include "tukor/base/test_folder.h"
#include "tukor/geometry/closedness.h"
#include "tukor/geometry/sphere.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/gltf_test_file.h"
#include "tukor/scene/text_scanner.h"

namespace tukor {
namespace {

using test::Bytes;
using test::messageOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

// A cube of six quads, counter-clockwise from outside; corner i has bits x, y, z.
constexpr int kQuads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

std::string cubeObj() {
    std::string text = "# a cube\n";
    for (int i = 0; i < 8; ++i) text += fmt::format("v {} {} {}\n", i & 1, i >> 1 & 1, i >> 2 & 1);
    for (const auto& q : kQuads)
        text += fmt::format("f {} {} {} {}\n", q[0] + 1, q[1] + 1, q[2] + 1, q[3] + 1);
    return text;
}

class ModelFile : public testing::Test {
protected:
    Scene load(const std::string& name, const std::string& text) {
        writeFile(folder_.path(name), text);
        return loadModel(folder_.path(name));
    }
    std::string errorOf(const std::string& name, const std::string& text) {
        return messageOf([&] { (void)load(name, text); });
    }
    void expectUnitCube(const Scene& scene) {
        ASSERT_EQ(scene.parts.size(), 1u);
        const ClosednessReport report = checkClosed(scene.parts[0].mesh);
        EXPECT_TRUE(report.closed());
        EXPECT_NEAR(report.volume, 1.0, 1e-6);
        EXPECT_EQ(report.againstNormals, 0);
        EXPECT_EQ(scene.parts[0].mesh.positions.size(), 24u);
        EXPECT_EQ(scene.parts[0].material, parseMaterial("gold"));
        EXPECT_THAT(scene.warnings, IsEmpty());
    }

    TestFolder folder_;
};

TEST(LoadModel, KnowsTheBuiltInShapes) {
    const Scene sphere = loadModel("sphere", {.material = "silver"});
    ASSERT_EQ(sphere.parts.size(), 1u);
    EXPECT_EQ(sphere.parts[0].material, parseMaterial("silver"));
    const Scene tumbler = loadModel("tumbler");
    ASSERT_EQ(tumbler.parts.size(), 2u);
    EXPECT_EQ(tumbler.parts[1].materialName, "water");
    EXPECT_EQ(tumbler.parts[1].material, parseMaterial("water"));
}

TEST(LoadModel, NamesTheShapesWhenThereIsNoSuchModel) {
    EXPECT_THAT(messageOf([] { (void)loadModel("sfere"); }),
                HasSubstr("sfere: no such model; expected a file or one of sphere, torus-knot"));
    EXPECT_EQ(messageOf([] { (void)loadModel("no/such.obj"); }), "no/such.obj: no such file");
}

TEST_F(ModelFile, EmptyFoldersAndOtherThingsAreNoModels) {
    EXPECT_THAT(errorOf("a.obj", ""), EndsWith("a.obj: an empty file"));
    EXPECT_THAT(errorOf("a.xyz", "hello"), HasSubstr("not a model of a known format"));
    EXPECT_THAT(messageOf([&] { (void)loadModel(folder_.path("")); }), HasSubstr("folder"));
}

TEST_F(ModelFile, ObjPolygonsBecomeASolid) {
    expectUnitCube(load("cube.obj", cubeObj()));
}

TEST_F(ModelFile, ObjTakesNegativeIndicesNormalsAndContinuedLines) {
    const Scene scene = load("a.obj",
                             "v 0 0 0\nv 1 0 0\r\nv 0 1 0\nvn 0 0 2\n"
                             "f -3//-1 -2//1 \\\n -1//1\n");
    const Mesh& mesh = scene.parts.at(0).mesh;
    EXPECT_EQ(mesh.triangles.size(), 1u);
    for (const glm::vec3 n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
    EXPECT_EQ(load("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n").parts.size(), 1u);
}

TEST_F(ModelFile, ObjCutsConcavePolygonsInside) {
    const Scene scene = load("arrow.obj", "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 4 1 2 3\n");
    float area = 0.0f;
    const Mesh& mesh = scene.parts.at(0).mesh;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 across = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
        EXPECT_GT(across.z, 0.0f);
        area += 0.5f * across.z;
    }
    EXPECT_FLOAT_EQ(area, 1.0f);
}

TEST_F(ModelFile, ObjGroupsAndMaterialsBecomeParts) {
    writeFile(folder_.path("a lib.mtl"),
              std::string_view("newmtl clear\nd 0.1\nNi 1.45\n"
                               "newmtl shiny\nKs 0.5 0.6 0.7\nillum 3\nNs 1e9\n"
                               "newmtl old gold\nPm 1\nPr 0\nKd 1 0.8 0.3\n"));
    const Scene scene =
        load("a.obj",
             "mtllib a lib.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\no band\nusemtl old gold\nf 1 2 3\n"
             "o stone\nusemtl clear\nf 1 2 3\nusemtl shiny\nf 1 2 3\nusemtl missing\nf 1 2 3\n"
             "o band\nusemtl old gold\nf 3 2 1\n");
    ASSERT_EQ(scene.parts.size(), 4u);
    EXPECT_EQ(scene.parts[0].name, "band");
    EXPECT_EQ(scene.parts[0].materialName, "old gold");
    EXPECT_EQ(scene.parts[0].mesh.triangles.size(), 2u);
    EXPECT_EQ(scene.parts[0].material, metalFromReflectance({1, 0.8f, 0.3f}));
    EXPECT_EQ(scene.parts[1].material, dielectricMaterial(1.45f));
    EXPECT_EQ(scene.parts[2].material, metalFromReflectance({0.5f, 0.6f, 0.7f}));
    EXPECT_EQ(scene.parts[3].material, parseMaterial("gold"));
    EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(ModelFile, ObjDoesWithoutItsLibrary) {
    const Scene scene =
        load("a.obj", "mtllib ../a.mtl\nmtllib no.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.warnings[0], HasSubstr("a path with '..'"));
    EXPECT_THAT(scene.warnings[0], HasSubstr("no.mtl: no such file"));
}

TEST_F(ModelFile, ObjErrorsNameTheLine) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_THAT(errorOf("a.obj", points + "f 1 2 4\n"), HasSubstr("a.obj: line 4: index 4 of 3"));
    EXPECT_THAT(errorOf("a.obj", points + "f 1 2 0\n"), HasSubstr("line 4: index 0 of 3"));
    EXPECT_THAT(errorOf("a.obj", points + "f 1 2 -4\n"), HasSubstr("line 4: index -4 of 3"));
    EXPECT_THAT(errorOf("a.obj", points + "f 1 2\n"), HasSubstr("line 4: a face of 2 corners"));
    EXPECT_THAT(errorOf("a.obj", points + "f 1 2 x\n"),
                HasSubstr("line 4: 'x' where an index was expected"));
    EXPECT_THAT(errorOf("a.obj", "v 1 2\n"), HasSubstr("line 1: '' where a number was expected"));
    EXPECT_THAT(errorOf("a.obj", points), HasSubstr("nothing to render: no faces"));
    EXPECT_THAT(errorOf("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                HasSubstr("vertex 0 is at (nan, 0, 0)"));
}

std::string cubeStl(const std::string& header) {
    Bytes bytes;
    for (std::size_t i = 0; i < 80; ++i) bytes.add(i < header.size() ? header[i] : ' ');
    bytes.add<std::uint32_t>(12);
    for (const auto& q : kQuads)
        for (int half = 0; half < 2; ++half) {
            bytes.add(glm::vec3(0));
            for (const int corner : {q[0], q[1 + half], q[2 + half]})
                bytes.add(glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1));
            bytes.add<std::uint16_t>(0);
        }
    return bytes.text();
}

TEST_F(ModelFile, StlInBinaryIsWeldedEvenWhereItSaysSolid) {
    expectUnitCube(load("cube.stl", cubeStl("binary")));
    expectUnitCube(load("cube.stl", cubeStl("solid cube")));
    expectUnitCube(load("cube.stl", cubeStl("binary") + "something more"));
    EXPECT_EQ(loadModel(folder_.path("cube.stl")).parts[0].name, "cube");
}

TEST_F(ModelFile, StlInText) {
    std::string text = "solid cube\n";
    for (const auto& q : kQuads)
        for (int half = 0; half < 2; ++half) {
            text += "facet normal 0 0 0\n outer loop\n";
            for (const int c : {q[0], q[1 + half], q[2 + half]})
                text += fmt::format("  vertex {:e} {} {}\n", float(c & 1), c >> 1 & 1, c >> 2 & 1);
            text += " endloop\nendfacet\n";
        }
    expectUnitCube(load("cube.stl", text + "endsolid\n"));
}

TEST_F(ModelFile, StlErrors) {
    const std::string good = cubeStl("b");
    EXPECT_THAT(errorOf("a.stl", good.substr(0, 300)), HasSubstr("cut off: 300 bytes of 684"));
    EXPECT_THAT(errorOf("a.stl", good.substr(0, 50)), HasSubstr("at least 84"));
    EXPECT_THAT(errorOf("a.stl", good.substr(0, 80) + "\xff\xff\xff\xff"), HasSubstr("cut off"));
    EXPECT_THAT(errorOf("a.stl", "solid\nvertex 1 2 x\n"),
                HasSubstr("line 2: 'x' where a number was expected"));
    EXPECT_THAT(errorOf("a.stl", "solid\nendsolid\n"), HasSubstr("no triangles"));
}

std::string plyHeader(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment made here\nelement vertex 8\nproperty float x\nproperty uchar tag\n"
           "property double y\nproperty short z\nelement extra 2\nproperty list uchar int stuff\n"
           "element face 6\nproperty list uchar int vertex_indices\nproperty uchar "
           "flag\nend_header\n";
}

template <class T>
T swapped(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    std::reverse(std::begin(bytes), std::end(bytes));
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

std::string cubePly(bool big) {
    Bytes bytes;
    const auto add = [&](auto value) { bytes.add(big ? swapped(value) : value); };
    for (int i = 0; i < 8; ++i) {
        add(float(i & 1));
        add(std::uint8_t(7));
        add(double(i >> 1 & 1));
        add(std::int16_t(i >> 2 & 1));
    }
    add(std::uint8_t(2));
    add(std::int32_t(5));
    add(std::int32_t(6));
    add(std::uint8_t(0));
    for (const auto& q : kQuads) {
        add(std::uint8_t(4));
        for (const int corner : q) add(std::int32_t(corner));
        add(std::uint8_t(1));
    }
    return plyHeader(big ? "binary_big_endian" : "binary_little_endian") + bytes.text();
}

TEST_F(ModelFile, PlyInBothByteOrders) {
    expectUnitCube(load("cube.ply", cubePly(false)));
    expectUnitCube(load("cube.ply", cubePly(true)));
}

TEST_F(ModelFile, PlyInTextWithWhateverExtension) {
    std::string text = plyHeader("ascii");
    for (int i = 0; i < 8; ++i) text += fmt::format("{} 7 {} {}\n", i & 1, i >> 1 & 1, i >> 2 & 1);
    text += "2 5 6\n0\n";
    for (const auto& q : kQuads) text += fmt::format("4 {} {} {} {} 1\n", q[0], q[1], q[2], q[3]);
    expectUnitCube(load("cube.model", text));
}

TEST_F(ModelFile, PlyErrors) {
    const std::string good = cubePly(false);
    for (std::size_t length = 1; length < good.size(); length += 7)
        EXPECT_NE(errorOf("a.ply", good.substr(0, length)), "no error") << length;
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return errorOf("a.ply", text);
    };
    EXPECT_THAT(with("vertex 8", "vertex 2147483648"), HasSubstr("cannot fit into the"));
    EXPECT_THAT(with("face 6", "face 999999999999999999"), HasSubstr("cannot fit into the"));
    EXPECT_THAT(with("vertex 8", "vertex -8"), HasSubstr("'-8' where a count was expected"));
    EXPECT_THAT(with("float x", "floot x"), HasSubstr("line 5: type 'floot'"));
    EXPECT_THAT(with("float x", "float w"), HasSubstr("vertices without 'x'"));
    EXPECT_THAT(with("vertex_indices", "vortex_indices"), HasSubstr("faces without a list"));
    EXPECT_THAT(with("binary_little_endian", "binary_middle"), HasSubstr("format 'binary_middle'"));
    EXPECT_THAT(with("end_header", "and_header"), HasSubstr("a header without an end"));
    std::string text = good;
    text[text.size() - 3] = 9;  // the highest byte but one of the last index
    EXPECT_THAT(errorOf("a.ply", text), HasSubstr("a face with vertex"));
}

TEST_F(ModelFile, OtherFormatsAreReadThroughAssimp) {
    std::string text =
        "AC3Db\nMATERIAL \"\" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0\n"
        "OBJECT world\nkids 1\nOBJECT poly\nname \"cube\"\nnumvert 8\n";
    for (int i = 0; i < 8; ++i) text += fmt::format("{} {} {}\n", i & 1, i >> 1 & 1, i >> 2 & 1);
    text += "numsurf 6\n";
    for (const auto& q : kQuads) {
        text += "SURF 0x0\nmat 0\nrefs 4\n";
        for (const int corner : q) text += fmt::format("{} 0 0\n", corner);
    }
    expectUnitCube(load("cube.ac", text + "kids 0\n"));
    EXPECT_THAT(errorOf("bad.ac", "AC3D"), HasSubstr("bad.ac: cannot be read"));
    EXPECT_THAT(errorOf("bad.fbx", "Kaydara FBX Binary  \x00\x1a"),
                HasSubstr("bad.fbx: cannot be read"));
    EXPECT_THAT(errorOf("bad.dae", "<COLLADA><a></COLLADA>"), HasSubstr("bad.dae: cannot be read"));
}

TEST(FloatOf, ReadsWhatFilesWrite) {
    for (const char* word : {"0", "-1", "+2.5", ".5", "5.", "1e3", "-1.25E-2", "3.4028234e38",
                             "1e-45", "0.1", "123456789012345678901234567890", "1.17549435e-38",
                             "0.000000000000000000000000012345678"}) {
        const std::optional<float> value = floatOf(word);
        ASSERT_TRUE(value) << word;
        const float expected = std::strtof(word, nullptr);
        EXPECT_NEAR(*value, expected, std::abs(expected) * 1.2e-7f)
            << word;  // one unit of the last place
    }
    EXPECT_TRUE(std::isinf(*floatOf("1e999")));
    EXPECT_TRUE(std::isnan(*floatOf("nan")));
    for (const char* word : {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "0x10", "1f", "1e5.0"})
        EXPECT_FALSE(floatOf(word)) << word;
}

}  // namespace
}  // namespace tukor
