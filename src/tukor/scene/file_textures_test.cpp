// Textures of OBJ files and of what Assimp reads: found, placed, put together, or left out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/file.h"
#include "tukor/base/test_folder.h"
#include "tukor/image/png_file.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/model_file.h"
#include "tukor/scene/texel_channels.h"

namespace tukor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A PNG of three channels.
std::vector<std::byte> png(int width, int height, std::vector<std::uint8_t> bytes) {
    EncodedPixels pixels;
    pixels.width = width;
    pixels.height = height;
    pixels.bytes = std::move(bytes);
    return encodePng(pixels, {});
}

class FileTexturesTest : public testing::Test {
protected:
    Scene load(const std::string& name, std::string_view text) {
        writeFile(folder_.path(name), text);
        return loadModel(folder_.path(name));
    }
    /// A triangle with that library's material `m`.
    Scene triangleOf(std::string_view library) {
        writeFile(folder_.path("a.mtl"), library);
        return load("a.obj",
                    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nvt 1 0.25\nvt 0 1\n"
                    "usemtl m\nf 1/1/1 2/2/1 3/3/1\n");
    }

    TestFolder folder_;
};

TEST_F(FileTexturesTest, ObjPutsPicturesOnSurfaces) {
    writeFile(folder_.path("a picture.png"), png(2, 1, {255, 0, 0, 0, 255, 0}));
    const Scene scene = triangleOf(
        "newmtl m\nKd 0 0 0\nPr 0.3\nmap_Kd -clamp on -s 2 4 -o 0.5 0.25 a picture.png\n");
    EXPECT_THAT(scene.warnings, IsEmpty());
    ASSERT_NE(scene.parts.at(0).material.finish, nullptr);
    const Finish& finish = *scene.parts[0].material.finish;
    EXPECT_EQ(finish.baseColor, glm::vec3(1.0f)) << "black beside a texture: it counts alone";
    EXPECT_EQ(finish.roughness, 0.3f);
    ASSERT_TRUE(finish.has(TextureRole::baseColor));
    const TextureMap& map = finish.map(TextureRole::baseColor);
    EXPECT_THAT(map.texels->bytes, ElementsAre(255, 0, 0, 0, 255, 0));
    EXPECT_EQ(map.wrapU, Wrap::clamp);
    // v runs up in OBJ, down here: 4 v + 0.25 from below is 1 - (4 (1 - w) + 0.25) from above.
    EXPECT_EQ(map.imageFromUv * glm::vec3(0.5f, 0.75f, 1.0f), glm::vec2(1.5f, -0.25f));
    EXPECT_THAT(scene.parts[0].mesh.uvs[0],
                ElementsAre(glm::vec2(0, 1), glm::vec2(1, 0.75f), glm::vec2(0, 0)));
}

TEST_F(FileTexturesTest, ObjPartsVerticesWhereCoordinatesDiffer) {
    writeFile(folder_.path("p.png"), png(1, 1, {9, 9, 9}));
    writeFile(folder_.path("a.mtl"), std::string_view("newmtl m\nmap_Kd p.png\nnewmtl plain\n"));
    const std::string text =
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\n"
        "vn 0 0 1\nusemtl ";
    const std::string faces = "\nf 1/1/1 2/2/1 3/3/1\nf 1/4/1 3/3/1 4//1\n";
    EXPECT_EQ(load("a.obj", text + "m" + faces).parts.at(0).mesh.positions.size(), 5u);
    const Mesh plain = load("b.obj", text + "plain" + faces).parts.at(0).mesh;
    EXPECT_EQ(plain.positions.size(), 4u);
    EXPECT_THAT(plain.uvs[0], IsEmpty());
}

TEST_F(FileTexturesTest, PathsOfOtherMachinesLeadToFilesBesideTheModel) {
    writeFile(folder_.path("p.png"), png(1, 1, {1, 2, 3}));
    for (const char* name : {"C:\\Users\\me\\p.png", "/home/me/textures/p.png", "..\\..\\p.png"}) {
        const Scene scene = triangleOf(std::string("newmtl m\nmap_Kd ") + name + "\n");
        EXPECT_THAT(scene.warnings, IsEmpty()) << name;
        EXPECT_TRUE(scene.parts.at(0).material.finish->has(TextureRole::baseColor)) << name;
    }
}

TEST_F(FileTexturesTest, WhatCannotBeReadIsSaidAndLeftOut) {
    writeFile(folder_.path("broken.png"), std::string_view("no picture"));
    const Scene scene = triangleOf("newmtl m\nmap_Kd broken.png\nnorm none.png\nmap_Ns p.png\n");
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_THAT(scene.warnings[0], HasSubstr("not rendered: map_Ns"));
    EXPECT_THAT(scene.warnings[1], HasSubstr("none.png: no such file"));
    EXPECT_THAT(scene.warnings[1], HasSubstr("broken.png"));
    EXPECT_FALSE(scene.parts.at(0).material.finish->has(TextureRole::baseColor));
}

TEST_F(FileTexturesTest, TooLargeAPictureIsLeftOutAlone) {
    std::vector<std::byte> huge = png(1, 1, {1, 2, 3});
    huge[16] = huge[20] = std::byte{0x40};  // width and height: a thousand million and one
    writeFile(folder_.path("huge.png"), huge);
    writeFile(folder_.path("p.png"), png(1, 1, {1, 2, 3}));
    const Scene scene = triangleOf("newmtl m\nmap_Kd p.png\nmap_Ke huge.png\n");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.warnings[0], HasSubstr("huge.png: 1073741825 x 1073741825"));
    EXPECT_TRUE(scene.parts.at(0).material.finish->has(TextureRole::baseColor));
    EXPECT_FALSE(scene.parts[0].material.finish->has(TextureRole::emission));
}

TEST_F(FileTexturesTest, GlassStaysClear) {
    writeFile(folder_.path("p.png"), png(1, 1, {1, 2, 3}));
    EXPECT_EQ(triangleOf("newmtl m\nd 0.1\nmap_Kd p.png\n").parts.at(0).material.finish, nullptr);
    EXPECT_EQ(triangleOf("newmtl m\nillum 7\n").parts.at(0).material.finish, nullptr);
    EXPECT_NE(triangleOf("newmtl m\nillum 7\nmap_Kd p.png\n").parts.at(0).material.finish, nullptr);
}

TEST_F(FileTexturesTest, WhatHidesMostOfWhatIsBehindIsNoGlass) {
    const Scene scene = triangleOf("newmtl m\nd 0.7\n");
    const Finish& pane = *scene.parts.at(0).material.finish;
    EXPECT_EQ(pane.alphaMode, AlphaMode::blend);
    EXPECT_FLOAT_EQ(pane.alpha, 0.7f);
    EXPECT_EQ(triangleOf("newmtl m\nd 1\n").parts.at(0).material.finish->alphaMode,
              AlphaMode::opaque);
}

TEST_F(FileTexturesTest, MetalsHaveTheColourThatIsOne) {
    const auto tint = [&](const char* figures) {
        return triangleOf(std::string("newmtl m\nillum 3\nPr 0.3\n") + figures)
            .parts.at(0)
            .material.finish->baseColor;
    };
    EXPECT_EQ(tint("Kd 1 0.8 0.3\nKs 0.5 0.5 0.5\n"), glm::vec3(1, 0.8f, 0.3f));
    EXPECT_EQ(tint("Kd 0.1 0.1 0.1\nKs 1 0.8 0.3\n"), glm::vec3(1, 0.8f, 0.3f));
    EXPECT_EQ(tint("Kd 0.1 0.1 0.1\nKs 0.9 0.9 0.9\n"), glm::vec3(0.9f));
}

TEST_F(FileTexturesTest, ColladaPutsPicturesOnSurfaces) {
    writeFile(folder_.path("p.png"), png(1, 1, {1, 2, 3}));
    const auto source = [](const char* id, int count, int stride, const char* values) {
        std::string params;
        for (const char axis : std::string(stride == 3 ? "XYZ" : "ST"))
            params += std::string("<param name=\"") + axis + "\" type=\"float\"/>";
        return std::string("<source id=\"") + id + "\"><float_array id=\"" + id + "a\" count=\"" +
               std::to_string(count * stride) + "\">" + values +
               "</float_array><technique_common><accessor source=\"#" + id + "a\" count=\"" +
               std::to_string(count) + "\" stride=\"" + std::to_string(stride) + "\">" + params +
               "</accessor></technique_common></source>";
    };
    const Scene scene =
        load("a.dae",
             R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema"
 version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_images><image id="p" name="p"><init_from>p.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>p</init_from></surface></newparam>
<newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="common"><lambert><diffuse><texture texture="t" texcoord="UV"/></diffuse></lambert>
</technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="paper"><instance_effect url="#e"/></material>
</library_materials><library_geometries><geometry id="g"><mesh>)" +
                 source("x", 3, 3, "0 0 0 1 0 0 0 1 0") + source("u", 3, 2, "0 0 1 0 0 0.75") +
                 R"(<vertices id="v"><input semantic="POSITION" source="#x"/></vertices>
<triangles material="m" count="1"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#u" offset="1" set="0"/><p>0 0 1 1 2 2</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="w"><node>
<instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#m"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>)");
    EXPECT_THAT(scene.warnings, IsEmpty());
    const Part& part = scene.parts.at(0);
    ASSERT_NE(part.material.finish, nullptr);
    ASSERT_TRUE(part.material.finish->has(TextureRole::baseColor));
    EXPECT_THAT(part.material.finish->map(TextureRole::baseColor).texels->bytes,
                ElementsAre(1, 2, 3));
    EXPECT_THAT(part.mesh.uvs[0],
                ElementsAre(glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0, 0.25f)));
}

TEST_F(FileTexturesTest, FbxMetalTexturesCountAloneWithoutAFactor) {
    writeFile(folder_.path("p.png"), png(1, 1, {100, 100, 100}));
    const Scene scene = load("a.fbx", R"(; FBX 7.3.0 project file
FBXHeaderExtension: {
 FBXVersion: 7300
}
Objects: {
 Geometry: 1, "Geometry::a", "Mesh" {
  Vertices: *9 {
   a: 0,0,0,1,0,0,0,1,0
  }
  PolygonVertexIndex: *3 {
   a: 0,1,-3
  }
  LayerElementMaterial: 0 {
   MappingInformationType: "AllSame"
   ReferenceInformationType: "IndexToDirect"
   Materials: *1 {
    a: 0
   }
  }
  Layer: 0 {
   LayerElement:  {
    Type: "LayerElementMaterial"
    TypedIndex: 0
   }
  }
 }
 Model: 2, "Model::a", "Mesh" {
  Version: 232
 }
 Material: 3, "Material::m", "" {
  Version: 102
  ShadingModel: "phong"
 }
 Texture: 4, "Texture::p", "" {
  RelativeFilename: "p.png"
 }
}
Connections: {
 C: "OO",2,0
 C: "OO",1,2
 C: "OO",3,2
 C: "OP",4,3, "ReflectionFactor"
}
)");
    EXPECT_THAT(scene.warnings, IsEmpty());
    ASSERT_NE(scene.parts.at(0).material.finish, nullptr);
    const Finish& finish = *scene.parts[0].material.finish;
    EXPECT_EQ(finish.metallic, 1.0f);
    ASSERT_TRUE(finish.has(TextureRole::metallicRoughness));
    EXPECT_THAT(finish.map(TextureRole::metallicRoughness).texels->bytes,
                ElementsAre(255, 255, 100));
}

TEST_F(FileTexturesTest, FbxIsReadInMetres) {
    const auto size = [&](const char* unit) {
        const Scene scene = load(
            "a.fbx", std::string("; FBX 7.3.0 project file\nFBXHeaderExtension: {\n FBXVersion: "
                                 "7300\n}\nGlobalSettings: {\n Version: 1000\n Properties70: {\n  "
                                 "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",") +
                         unit +
                         "\n }\n}\nObjects: {\n Geometry: 1, \"Geometry::a\", \"Mesh\" {\n"
                         "  Vertices: *9 {\n   a: 0,0,0,200,0,0,0,200,0\n  }\n"
                         "  PolygonVertexIndex: *3 {\n   a: 0,1,-3\n  }\n }\n"
                         " Model: 2, \"Model::a\", \"Mesh\" {\n  Version: 232\n }\n}\n"
                         "Connections: {\n C: \"OO\",2,0\n C: \"OO\",1,2\n}\n");
        return boundsOf(scene.parts.at(0).mesh).most.x;
    };
    EXPECT_FLOAT_EQ(size("1"), 2.0f);
    EXPECT_FLOAT_EQ(size("100"), 200.0f);
}

TEST(TexelChannels, PutOpacityBesideColours) {
    const Texels colours{1, 1, 3, {10, 20, 30}};
    const Texels grey{2, 1, 3, {40, 40, 40, 50, 50, 50}};
    const Texels alpha{1, 1, 4, {1, 2, 3, 60}};
    EXPECT_THAT(withOpacity(colours, grey).bytes, ElementsAre(10, 20, 30, 40, 10, 20, 30, 50));
    EXPECT_THAT(withOpacity({}, alpha).bytes, ElementsAre(255, 255, 255, 60));
    EXPECT_THAT(withOpacity(colours, {}).bytes, ElementsAre(10, 20, 30));
}

TEST(TexelChannels, PutRoughnessBesideMetallic) {
    const Texels metallic{1, 2, 3, {10, 0, 0, 20, 0, 0}};
    const Texels roughness{1, 1, 3, {30, 0, 0}};
    EXPECT_THAT(metallicRoughnessOf(metallic, roughness).bytes,
                ElementsAre(255, 30, 10, 255, 30, 20));
    EXPECT_THAT(metallicRoughnessOf({}, roughness).bytes, ElementsAre(255, 30, 255));
    EXPECT_EQ(metallicRoughnessOf({}, {}).width, 0);
}

TEST(TexelChannels, NormalsLeanAwayFromWhatRises) {
    Texels ramp{4, 4, 3, {}};  // to the right and to the top by a quarter a texel
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            ramp.bytes.insert(ramp.bytes.end(), 3, static_cast<std::uint8_t>(32 * (x + 3 - y)));
    const Texels normals = normalsOf(ramp, 1.0f);
    const std::uint8_t* const inner = &normals.bytes[3 * 5];
    const float slope = 32.0f / 255.0f;
    const glm::vec3 expected = glm::normalize(glm::vec3(-slope, -slope, 1.0f));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(inner[c], 127.5f + 127.5f * expected[c], 0.51f) << c;
    const Texels blue{1, 1, 3, {128, 128, 255}};
    EXPECT_EQ(normalsOf(blue, 1.0f).bytes, blue.bytes) << "normals already";
}

}  // namespace
}  // namespace tukor
