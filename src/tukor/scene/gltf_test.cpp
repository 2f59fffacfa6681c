// What is read from well-formed glTF: shapes, transformations, cameras, materials.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/geometry/closedness.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/gltf_file.h"
#include "tukor/scene/gltf_test_file.h"

namespace tukor {
namespace {

using test::Bytes;
using test::kOneMesh;
using test::tetrahedron;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

Scene load(const std::string& text) {
    return loadGltf("folder/a.gltf", std::as_bytes(std::span(text)));
}

void expectNear(glm::vec3 actual, glm::vec3 expected, float tolerance = 1e-5f) {
    EXPECT_LT(glm::length(actual - expected), tolerance)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " instead of " << expected.x << ' '
        << expected.y << ' ' << expected.z;
}

std::string withNodes(const std::string& nodes) {
    return tetrahedron(R"("meshes": [{"name": "tetra",
        "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "nodes": [)" +
                       nodes + "]");
}

TEST(Gltf, ReadsASolidWithNormalsComputed) {
    const Scene scene = load(tetrahedron(kOneMesh));
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, "tetra");
    const ClosednessReport report = checkClosed(scene.parts[0].mesh);
    EXPECT_TRUE(report.closed());
    EXPECT_NEAR(report.volume, 1.0 / 6.0, 1e-6);
    EXPECT_EQ(report.againstNormals, 0);
    EXPECT_EQ(scene.parts[0].mesh.positions.size(), 12u) << "its edges are creases";
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Gltf, ReadsGlb) {
    std::string json = tetrahedron(kOneMesh);
    Bytes positions;
    positions.add({glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(0, 2, 0), glm::vec3(0, 0, 2)});
    positions.add<std::uint16_t>({0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
    const std::size_t uri = json.find(R"(, "uri")");
    json.erase(uri, json.find("\"}", uri) + 1 - uri);
    while (json.size() % 4 != 0) json += ' ';
    Bytes glb;
    glb.add<std::uint32_t>({0x46546c67, 2, std::uint32_t(12 + 16 + json.size() + 72)});
    glb.add<std::uint32_t>({std::uint32_t(json.size()), 0x4e4f534a});
    const std::string text =
        glb.text() + json + Bytes().add<std::uint32_t>({72, 0x4e4942}).text() + positions.text();
    EXPECT_NEAR(checkClosed(load(text).parts[0].mesh).volume, 8.0 / 6.0, 1e-5);
}

TEST(Gltf, AppliesMatricesOfParentsAndChildren) {
    const Scene scene = load(withNodes(R"(
        {"name": "parent", "translation": [10, 0, 0], "children": [1]},
        {"name": "child", "mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476],
         "scale": [2, 3, 4]})"));
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, "child");
    const Bounds bounds = boundsOf(scene);
    expectNear(bounds.least, {7, 0, 0});
    expectNear(bounds.most, {10, 2, 4});
    EXPECT_NEAR(checkClosed(scene.parts[0].mesh).volume, 4.0, 1e-5);
    const Scene same = load(
        withNodes(R"({"mesh": 0, "matrix": [0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 0, 0, 1]})"));
    expectNear(boundsOf(same).least, bounds.least);
    expectNear(boundsOf(same).most, bounds.most);
}

TEST(Gltf, TurnsMirroredMeshesBackOutside) {
    const Scene scene = load(withNodes(R"({"mesh": 0, "scale": [-1, 1, 1]})"));
    EXPECT_TRUE(checkClosed(scene.parts[0].mesh).closed());
    EXPECT_EQ(checkClosed(scene.parts[0].mesh).againstNormals, 0);
}

// A plane that leans: its normals stay perpendicular under uneven and mirrored scales.
TEST(Gltf, NormalsStayPerpendicularUnderUnevenScales) {
    Bytes bytes;
    bytes.add({glm::vec3(0), glm::vec3(1, 0, -1), glm::vec3(0, 1, 0)});
    const glm::vec3 n = glm::normalize(glm::vec3(1, 0, 1));
    bytes.add({n, n, n});
    for (const char* scale : {"[1, 2, 3]", "[-1, 2, 3]", "[1e-7, 1e-7, 2e-7]"}) {
        const Scene scene =
            load(R"({"asset": {"version": "2.0"}, "buffers": [)" + test::buffer(bytes) + R"(],
            "bufferViews": [{"buffer": 0, "byteLength": 72}], "accessors": [
              {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
              {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "type": "VEC3", "count": 3}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}],
            "nodes": [{"mesh": 0, "scale": )" +
                 std::string(scale) + "}]}");
        const Mesh& mesh = scene.parts.at(0).mesh;
        const glm::vec3 a = mesh.positions[mesh.triangles[0].x];
        const glm::vec3 across = glm::normalize(glm::cross(
            mesh.positions[mesh.triangles[0].y] - a, mesh.positions[mesh.triangles[0].z] - a));
        for (const glm::vec3 normal : mesh.normals) expectNear(normal, across);
    }
}

TEST(Gltf, DrawsTheDefaultSceneAndRepeatedMeshes) {
    const std::string rest = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0},
        "indices": 1}]}], "nodes": [{"mesh": 0}, {"mesh": 0, "name": "b", "translation": [5, 0, 0]},
        {"mesh": 0, "name": "c"}], "scenes": [{"nodes": [0]}, {"nodes": [1, 2]}])";
    EXPECT_EQ(load(tetrahedron(rest)).parts.size(), 1u);
    const Scene second = load(tetrahedron(rest + R"(, "scene": 1)"));
    ASSERT_EQ(second.parts.size(), 2u);
    EXPECT_EQ(second.parts[0].name, "b");
    expectNear(boundsOf(second.parts[0].mesh).least, {5, 0, 0});
}

// A quad as triangles, strip and fan with every index type.
TEST(Gltf, ReadsStripsFansAndAllIndexTypes) {
    Bytes bytes;
    bytes.add({glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(1, 1, 0)});
    bytes.add<std::uint8_t>({0, 1, 2, 2, 1, 3, 9, 9});  // triangles, at 48
    bytes.add<std::uint16_t>({0, 1, 3, 2});             // a fan, at 56
    bytes.add<std::uint32_t>({0, 1, 2, 3});             // a strip, at 64
    const std::string head = R"({"asset": {"version": "2.0"}, "buffers": [)" + test::buffer(bytes) +
                             R"(], "bufferViews": [{"buffer": 0, "byteLength": 80}], "accessors": [
        {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4},
        {"bufferView": 0, "byteOffset": 48, "componentType": 5121, "type": "SCALAR", "count": 6},
        {"bufferView": 0, "byteOffset": 56, "componentType": 5123, "type": "SCALAR", "count": 4},
        {"bufferView": 0, "byteOffset": 64, "componentType": 5125, "type": "SCALAR", "count": 4}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0})";
    for (const char* rest : {R"(, "indices": 1)", R"(, "indices": 2, "mode": 6)",
                             R"(, "indices": 3, "mode": 5)", R"(, "mode": 5)"}) {
        const Mesh mesh = load(head + rest + "}]}]}").parts.at(0).mesh;
        ASSERT_EQ(mesh.triangles.size(), 2u) << rest;
        float area = 0.0f;
        for (const glm::uvec3 t : mesh.triangles) {
            const glm::vec3 a = mesh.positions[t.x];
            const glm::vec3 across = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
            EXPECT_GT(across.z, 0.0f) << rest;
            area += 0.5f * across.z;
        }
        EXPECT_FLOAT_EQ(area, 1.0f) << rest;
        for (const glm::vec3 n : mesh.normals) expectNear(n, {0, 0, 1});
    }
}

TEST(Gltf, ReadsInterleavedQuantizedAndSparseAccessors) {
    Bytes bytes;
    const std::int16_t corners[4][3] = {{0, 0, 0}, {32767, 0, 0}, {0, 32767, 0}, {0, 0, -32767}};
    for (const auto& corner : corners) {  // position, padding, normal, padding: 12 bytes each
        for (const std::int16_t c : corner) bytes.add(c);
        bytes.add<std::int16_t>(0).add<std::int8_t>({0, 0, 127, 0});
    }
    bytes.add<std::uint16_t>({2, 3}).add<std::int16_t>({0, 16384, 0, 0, 0, 16384});  // at 48, 52
    const Scene scene =
        load(R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_mesh_quantization"],
        "extensionsRequired": ["KHR_mesh_quantization"], "buffers": [)" +
             test::buffer(bytes) +
             R"(], "bufferViews": [{"buffer": 0, "byteLength": 48, "byteStride": 12},
        {"buffer": 0, "byteOffset": 48, "byteLength": 4},
        {"buffer": 0, "byteOffset": 52, "byteLength": 12}], "accessors": [
        {"bufferView": 0, "componentType": 5122, "normalized": true, "type": "VEC3", "count": 4,
         "sparse": {"count": 2, "indices": {"bufferView": 1, "componentType": 5123},
                    "values": {"bufferView": 2}}},
        {"bufferView": 0, "byteOffset": 8, "componentType": 5120, "normalized": true,
         "type": "VEC3", "count": 4}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "mode": 5}]}]})");
    const Mesh& mesh = scene.parts.at(0).mesh;
    ASSERT_EQ(mesh.positions.size(), 4u);
    expectNear(mesh.positions[1], {1, 0, 0});
    expectNear(mesh.positions[2], {0, 16384.0f / 32767.0f, 0});
    expectNear(mesh.positions[3], {0, 0, 16384.0f / 32767.0f});
    for (const glm::vec3 n : mesh.normals) expectNear(n, {0, 0, 1});
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Gltf, ReadsCameras) {
    const std::string cameras = R"(, "cameras": [{"type": "perspective",
        "perspective": {"yfov": 0.5, "znear": 0.1}}, {"type": "orthographic",
        "orthographic": {"xmag": 1, "ymag": 1, "zfar": 2, "znear": 1}}], "nodes": [{"mesh": 0},
        {"name": "front", "camera": 0, "translation": [0.25, 0.5, 3]}, {"name": "flat", "camera": 1},
        {"name": "down", "camera": 0, "translation": [0, 3, 0],
         "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476]}])";
    const std::string mesh = kOneMesh.substr(0, kOneMesh.find("\"nodes\"") - 8);
    const Scene scene = load(tetrahedron(mesh.substr(0, mesh.rfind(']') + 1) + cameras));
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "front");
    const Camera& front = scene.cameras[0].camera;
    expectNear(front.eye, {0.25f, 0.5f, 3});
    expectNear(front.target, {0.25f, 0.5f, 0.5f});
    expectNear(front.up, {0, 1, 0});
    EXPECT_FLOAT_EQ(front.verticalFov, 0.5f);
    expectNear(axesOf(scene.cameras[1].camera).forward, {0, -1, 0});
    expectNear(axesOf(scene.cameras[1].camera).up, {0, 0, -1});
    EXPECT_THAT(scene.warnings, ElementsAre("only perspective cameras are read: flat"));
}

Scene withMaterial(const std::string& material) {
    return load(tetrahedron(R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0},
        "indices": 1, "material": 0}]}], "nodes": [{"mesh": 0}], "materials": [)" +
                            material + "]"));
}

TEST(GltfMaterial, MetalReflectsItsBaseColourAtNormalIncidence) {
    const Scene scene = withMaterial(R"({"name": "gilt", "pbrMetallicRoughness":
        {"baseColorFactor": [1.0, 0.78, 0.34, 1], "roughnessFactor": 0}})");
    const Material& material = scene.parts[0].material;
    EXPECT_EQ(scene.parts[0].materialName, "gilt");
    ASSERT_EQ(material.kind, MaterialKind::metal);
    EXPECT_EQ(material, metalFromReflectance({1.0f, 0.78f, 0.34f}));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfMaterial, TransmissionIsGlassThatAbsorbs) {
    const Scene scene = withMaterial(R"({"pbrMetallicRoughness": {"metallicFactor": 0,
        "roughnessFactor": 0}, "extensions": {"KHR_materials_transmission":
        {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.33}, "KHR_materials_volume":
        {"thicknessFactor": 1, "attenuationDistance": 0.5, "attenuationColor": [1, 0.5, 0.25]}}})");
    const Material& material = scene.parts[0].material;
    ASSERT_EQ(material.kind, MaterialKind::dielectric);
    EXPECT_EQ(scene.parts[0].materialName, "material 0");
    EXPECT_FLOAT_EQ(material.eta.x, 1.33f);
    expectNear(glm::exp(-0.5f * material.sigmaA), {1, 0.5f, 0.25f});
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfMaterial, SaysOnceByNameWhatIsNotRendered) {
    const Scene scene = withMaterial(R"({"name": "felt", "extensions": {"ACME_felt": {}}})");
    EXPECT_THAT(scene.warnings, ElementsAre("not rendered: ACME_felt: felt"));
}

TEST(GltfMaterial, WhatIsNotIdeallySmoothHasAFinish) {
    const Scene scene = withMaterial(R"({"name": "felt", "emissiveFactor": [1, 0, 0.5],
        "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true, "pbrMetallicRoughness":
        {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0, "roughnessFactor": 0.7},
        "extensions": {"KHR_materials_sheen": {"sheenColorFactor": [0.1, 0.2, 0.3]},
                       "KHR_materials_emissive_strength": {"emissiveStrength": 2},
                       "KHR_materials_clearcoat": {"clearcoatFactor": 0.5}}})");
    const Material& material = scene.parts[0].material;
    EXPECT_EQ(material.kind, MaterialKind::mirror);
    ASSERT_TRUE(material.finish);
    const Finish& finish = *material.finish;
    expectNear(finish.baseColor, {0.1f, 0.2f, 0.3f});
    expectNear(finish.emission, {2, 0, 1});
    expectNear(finish.sheenColor, {0.1f, 0.2f, 0.3f});
    EXPECT_FLOAT_EQ(finish.alpha, 0.4f);
    EXPECT_FLOAT_EQ(finish.roughness, 0.7f);
    EXPECT_FLOAT_EQ(finish.clearcoat, 0.5f);
    EXPECT_EQ(finish.alphaMode, AlphaMode::mask);
    EXPECT_FLOAT_EQ(finish.alphaCutoff, 0.25f);
    EXPECT_TRUE(finish.doubleSided);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfMaterial, PolishedMetalAndClearGlassHaveNone) {
    EXPECT_FALSE(withMaterial(R"({"pbrMetallicRoughness": {"roughnessFactor": 0.02}})")
                     .parts[0]
                     .material.finish);
    const Scene sheet = withMaterial(R"({"pbrMetallicRoughness": {"metallicFactor": 0,
        "roughnessFactor": 0}, "extensions": {"KHR_materials_transmission":
        {"transmissionFactor": 1}}})");
    ASSERT_TRUE(sheet.parts[0].material.finish) << "a thin sheet is not a solid";
    EXPECT_FALSE(sheet.parts[0].material.finish->solid);
    EXPECT_EQ(sheet.parts[0].material.kind, MaterialKind::mirror);
}

TEST(GltfMaterial, DefaultsToTheOptionsMaterialWhereTheFileNamesNone) {
    const std::string text = tetrahedron(kOneMesh);
    const Scene scene = loadGltf("a.gltf", std::as_bytes(std::span(text)), {.material = "water"});
    EXPECT_EQ(scene.parts[0].material, parseMaterial("water"));
    EXPECT_EQ(load(text).parts[0].material, parseMaterial("gold"));
    EXPECT_TRUE(scene.warnings.empty());
    const Scene mixed = load(tetrahedron(
        R"("materials": [{}], "meshes": [{"primitives": [
        {"attributes": {"POSITION": 0}, "indices": 1, "material": 0},
        {"attributes": {"POSITION": 0}, "indices": 1}]}], "nodes": [{"name": "n", "mesh": 0}])"));
    EXPECT_THAT(mixed.warnings, ElementsAre("without a material, shown as gold: n"));
}

TEST(GltfMaterial, ShowsVertexColoursWhereTheFileNamesNone) {
    const Scene scene = load(tetrahedron(R"("meshes": [{"primitives": [
        {"attributes": {"POSITION": 0, "COLOR_0": 0}, "indices": 1}]}], "nodes": [{"mesh": 0}])"));
    ASSERT_TRUE(scene.parts[0].material.finish);
    EXPECT_EQ(scene.parts[0].material.finish->baseColor, glm::vec3(1.0f));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Gltf, SaysWhatItDoesNotRender) {
    const Scene scene = load(tetrahedron(R"("meshes": [{"name": "m", "primitives": [
        {"attributes": {"POSITION": 0, "COLOR_0": 0}, "indices": 1, "targets": [{}]},
        {"attributes": {"POSITION": 0}, "mode": 1}]}], "nodes": [{"mesh": 0}],
        "animations": [{}], "skins": [{}], "extensionsUsed": ["ACME_thing"])"));
    EXPECT_THAT(scene.warnings,
                ElementsAre("extensions that are not rendered: ACME_thing",
                            "it is animated and shown at rest; --time-seconds chooses a moment",
                            "points and lines are not rendered: m"));
}

// The tetrahedron's corners, as places of four of it.
TEST(Gltf, DrawsInstances) {
    const auto nodes = [](const std::string& attributes) {
        return withNodes(R"({"mesh": 0, "translation": [10, 0, 0], "extensions":
            {"EXT_mesh_gpu_instancing": {"attributes": {)" +
                         attributes + "}}}}");
    };
    const Scene scene = load(nodes(R"("TRANSLATION": 0)"));
    ASSERT_EQ(scene.parts.size(), 4u);
    EXPECT_EQ(boundsOf(scene.parts[0].mesh).least, glm::vec3(10, 0, 0));
    EXPECT_EQ(boundsOf(scene.parts[1].mesh).least, glm::vec3(11, 0, 0));
    EXPECT_EQ(boundsOf(scene.parts[3].mesh).least, glm::vec3(10, 0, 1));
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_NE(test::messageOf([&] { (void)load(nodes(R"("TRANSLATION": 1)")); }), "no error");
    EXPECT_NE(test::messageOf([&] { (void)load(nodes(R"("TRANSLATION": 9)")); }), "no error");
}

}  // namespace
}  // namespace tukor
