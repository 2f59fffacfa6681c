// Draco and meshopt streams inside glTF: what the encoders of those libraries make, and damage to
// it.
#include <cstdint>
#include <string>
#include <vector>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "tukor/geometry/closedness.h"
#include "tukor/geometry/sphere.h"
#include "tukor/scene/gltf_file.h"
#include "tukor/scene/gltf_test_file.h"

namespace tukor {
namespace {

using test::Bytes;
using test::messageOf;
using testing::HasSubstr;

Scene load(const std::string& text) {
    return loadGltf("a.gltf", std::as_bytes(std::span(text)));
}

std::string errorOf(const std::string& text) {
    return messageOf([&] { (void)load(text); });
}

std::string draco(const Mesh& mesh, int method) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(mesh.triangles.size()));
    const int positions =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int normals =
        builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        const draco::FaceIndex face(i);
        builder.SetAttributeValuesForFace(positions, face, &mesh.positions[t.x],
                                          &mesh.positions[t.y], &mesh.positions[t.z]);
        builder.SetAttributeValuesForFace(normals, face, &mesh.normals[t.x], &mesh.normals[t.y],
                                          &mesh.normals[t.z]);
    }
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 10);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*builder.Finalize(), &buffer).ok());
    return {buffer.data(), buffer.size()};
}

std::string dracoGltf(const std::string& stream, std::size_t vertices, std::size_t indices) {
    return fmt::format(R"({{"asset": {{"version": "2.0"}},
        "extensionsRequired": ["KHR_draco_mesh_compression"],
        "buffers": [{{"byteLength": {0}, "uri": "data:;base64,{1}"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": {0}}}],
        "accessors": [{{"componentType": 5126, "type": "VEC3", "count": {2}}},
                      {{"componentType": 5123, "type": "SCALAR", "count": {3}}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "NORMAL": 0}}, "indices": 1,
            "extensions": {{"KHR_draco_mesh_compression":
                {{"bufferView": 0, "attributes": {{"POSITION": 0, "NORMAL": 1}}}}}}}}]}}],
        "nodes": [{{"mesh": 0}}]}})",
                       stream.size(), test::base64(stream), vertices, indices);
}

TEST(GltfDraco, DecodesBothMethodsToTheSameSolid) {
    const Mesh sphere = makeSphere(8);
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const Scene scene = load(
            dracoGltf(draco(sphere, method), sphere.positions.size(), 3 * sphere.triangles.size()));
        const Mesh& mesh = scene.parts.at(0).mesh;
        EXPECT_EQ(mesh.triangles.size(), sphere.triangles.size());
        const ClosednessReport report = checkClosed(mesh), expected = checkClosed(sphere);
        EXPECT_TRUE(report.closed());
        EXPECT_NEAR(report.volume, expected.volume, 1e-3);  // positions of 14 bits
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            EXPECT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 0.999f);
    }
}

TEST(GltfDraco, DamagedStreamsAreErrors) {
    const Mesh sphere = makeSphere(2);
    const std::string stream = draco(sphere, draco::MESH_EDGEBREAKER_ENCODING);
    const std::size_t vertices = sphere.positions.size(), indices = 3 * sphere.triangles.size();
    EXPECT_THAT(errorOf(dracoGltf(stream, vertices - 1, indices)), HasSubstr("announce"));
    EXPECT_THAT(errorOf(dracoGltf(stream, vertices, indices - 3)), HasSubstr("announce"));
    for (std::size_t length = 0; length < stream.size(); length += 7)
        EXPECT_THAT(errorOf(dracoGltf(stream.substr(0, length), vertices, indices)),
                    HasSubstr("damaged Draco stream"))
            << length;
}

// A sphere with 16-bit positions, as gltfpack makes them.
struct Packed {
    std::string vertices, triangles;  // encoded
    std::size_t vertexCount, indexCount;
};

Packed packed(const Mesh& mesh) {
    std::vector<std::int16_t> positions;
    for (const glm::vec3 p : mesh.positions) {
        for (int i = 0; i < 3; ++i) positions.push_back(static_cast<std::int16_t>(p[i] * 16000.0f));
        positions.push_back(0);
    }
    std::vector<unsigned> indices;
    for (const glm::uvec3 t : mesh.triangles) indices.insert(indices.end(), {t.x, t.y, t.z});
    Packed result;
    result.vertexCount = mesh.positions.size();
    result.indexCount = indices.size();
    meshopt_encodeIndexVersion(1);
    result.vertices.resize(meshopt_encodeVertexBufferBound(result.vertexCount, 8));
    result.vertices.resize(meshopt_encodeVertexBuffer(
        reinterpret_cast<unsigned char*>(result.vertices.data()), result.vertices.size(),
        positions.data(), result.vertexCount, 8));
    result.triangles.resize(meshopt_encodeIndexBufferBound(result.indexCount, result.vertexCount));
    result.triangles.resize(
        meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(result.triangles.data()),
                                  result.triangles.size(), indices.data(), result.indexCount));
    return result;
}

std::string meshoptGltf(const Packed& p) {
    const std::string bytes = p.vertices + p.triangles;
    return fmt::format(R"({{"asset": {{"version": "2.0"}},
        "extensionsRequired": ["EXT_meshopt_compression", "KHR_mesh_quantization"],
        "buffers": [{{"byteLength": {0}, "uri": "data:;base64,{1}"}},
            {{"byteLength": 999999, "extensions": {{"EXT_meshopt_compression": {{"fallback": true}}}}}}],
        "bufferViews": [{{"buffer": 1, "byteLength": {2}, "byteStride": 8, "extensions":
              {{"EXT_meshopt_compression": {{"buffer": 0, "byteLength": {3}, "byteStride": 8,
                "count": {4}, "mode": "ATTRIBUTES"}}}}}},
            {{"buffer": 1, "byteLength": {5}, "extensions": {{"EXT_meshopt_compression":
                {{"buffer": 0, "byteOffset": {3}, "byteLength": {6}, "byteStride": 2,
                "count": {7}, "mode": "TRIANGLES"}}}}}}],
        "accessors": [{{"bufferView": 0, "componentType": 5122, "normalized": true, "type": "VEC3",
                        "count": {4}}},
                      {{"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": {7}}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
        "nodes": [{{"mesh": 0}}]}})",
                       bytes.size(), test::base64(bytes), 8 * p.vertexCount, p.vertices.size(),
                       p.vertexCount, 2 * p.indexCount, p.triangles.size(), p.indexCount);
}

TEST(GltfMeshopt, DecodesToTheSameSolid) {
    const Mesh sphere = makeSphere(20);
    const Scene scene = load(meshoptGltf(packed(sphere)));
    const Mesh& mesh = scene.parts.at(0).mesh;
    EXPECT_EQ(mesh.triangles.size(), sphere.triangles.size());
    EXPECT_TRUE(checkClosed(mesh).closed());
    const double scale = 16000.0 / 32767.0;
    EXPECT_NEAR(checkClosed(mesh).volume, checkClosed(sphere).volume * scale * scale * scale, 1e-3);
}

TEST(GltfMeshopt, DamagedStreamsAreErrors) {
    const Packed good = packed(makeSphere(2));
    for (std::size_t length = 0; length < good.vertices.size(); length += 3) {
        Packed cut = good;
        cut.vertices.resize(length);
        EXPECT_THAT(errorOf(meshoptGltf(cut)),
                    testing::AnyOf(HasSubstr("do not decode"), HasSubstr("cannot come out")));
    }
    Packed many = good;
    many.vertexCount = 1u << 31;
    EXPECT_THAT(errorOf(meshoptGltf(many)), HasSubstr("2147483648 elements cannot come out of"));
    many = good;
    many.indexCount = 3u << 29;
    EXPECT_THAT(errorOf(meshoptGltf(many)), HasSubstr("elements cannot come out of"));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = meshoptGltf(good);
        text.replace(text.find(from), from.size(), to);
        return errorOf(text);
    };
    EXPECT_THAT(with("ATTRIBUTES", "SURPRISES"), HasSubstr("mode 'SURPRISES'"));
    EXPECT_THAT(with(R"("mode": "ATTRIBUTES")", R"("mode": "ATTRIBUTES", "filter": "FANCY")"),
                HasSubstr("filter 'FANCY' for a stride of 8"));
    EXPECT_THAT(with(R"("byteStride": 2)", R"("byteStride": 3)"), HasSubstr("a stride of 3 bytes"));
}

}  // namespace
}  // namespace tukor
