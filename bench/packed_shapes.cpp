// Writes torus knots of one look in a row as a GLB, for docs/features.md: as floats, quantized
// (KHR_mesh_quantization), by Draco, by meshopt.
//
// usage: packed_shapes OUT.glb
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "tukor/base/file.h"
#include "tukor/geometry/shapes.h"

namespace {

using nlohmann::json;
using tukor::Mesh;

constexpr int kFloat = 5126, kShort = 5122, kUnsignedInt = 5125;

template <class T>
std::string bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::vector<unsigned> indicesOf(const Mesh& mesh) {
    std::vector<unsigned> indices;
    for (const glm::uvec3 t : mesh.triangles) indices.insert(indices.end(), {t.x, t.y, t.z});
    return indices;
}

// In [-1, 1], four shorts each, as vectors must begin at multiples of four bytes.
std::vector<std::int16_t> quantized(const std::vector<glm::vec3>& vectors, float scale) {
    std::vector<std::int16_t> values;
    for (const glm::vec3 v : vectors) {
        for (int i = 0; i < 3; ++i)
            values.push_back(static_cast<std::int16_t>(std::lround(v[i] * scale * 32767.0f)));
        values.push_back(0);
    }
    return values;
}

std::string draco(const Mesh& mesh) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(mesh.triangles.size()));
    using Attribute = draco::GeometryAttribute;
    const int positions = builder.AddAttribute(Attribute::POSITION, 3, draco::DT_FLOAT32);
    const int normals = builder.AddAttribute(Attribute::NORMAL, 3, draco::DT_FLOAT32);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto set = [&](int attribute, const std::vector<glm::vec3>& from) {
            const glm::uvec3 t = mesh.triangles[i];
            builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(i), &from[t.x],
                                              &from[t.y], &from[t.z]);
        };
        set(positions, mesh.positions);
        set(normals, mesh.normals);
    }
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(Attribute::POSITION, 16);
    encoder.SetAttributeQuantization(Attribute::NORMAL, 12);
    draco::EncoderBuffer buffer;
    const std::unique_ptr<draco::Mesh> built = builder.Finalize();
    if (!encoder.EncodeMeshToBuffer(*built, &buffer).ok())
        throw std::runtime_error("Draco cannot encode the shape");
    return {buffer.data(), buffer.size()};
}

class Writer {
public:
    explicit Writer(const Mesh& mesh) : mesh_(mesh), indices_(indicesOf(mesh)) {
        for (const glm::vec3 p : mesh.positions)
            for (int i = 0; i < 3; ++i) reach_ = std::max(reach_, std::abs(p[i]));
        file_ = {{"asset", {{"version", "2.0"}}},
                 {"scene", 0},
                 {"materials",
                  {{{"pbrMetallicRoughness",
                     {{"baseColorFactor", {1.0, 0.77, 0.34, 1.0}}, {"roughnessFactor", 0.25}}}}}}};
    }

    void addFloats() {
        const int positions = accessor(view(bytesOf(mesh_.positions)), kFloat, "VEC3", reach_);
        const int normals = accessor(view(bytesOf(mesh_.normals)), kFloat, "VEC3");
        const int corners = accessor(view(bytesOf(indices_)), kUnsignedInt, "SCALAR");
        add({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", corners}});
    }

    void addQuantized() {
        const json stride = {{"byteStride", 8}};
        const int positions = accessor(
            view(bytesOf(quantized(mesh_.positions, 1 / reach_)), stride), kShort, "VEC3", 1.0f);
        const int normals =
            accessor(view(bytesOf(quantized(mesh_.normals, 1)), stride), kShort, "VEC3");
        const int corners = accessor(view(bytesOf(indices_)), kUnsignedInt, "SCALAR");
        add({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", corners}},
            reach_);
        uses("KHR_mesh_quantization");
    }

    void addDraco() {
        const int stream = view(draco(mesh_));
        const int positions = accessor(-1, kFloat, "VEC3", reach_);
        const int normals = accessor(-1, kFloat, "VEC3");
        const int corners = accessor(-1, kUnsignedInt, "SCALAR");
        add({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
             {"indices", corners},
             {"extensions",
              {{"KHR_draco_mesh_compression",
                {{"bufferView", stream}, {"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}}}}}});
        uses("KHR_draco_mesh_compression");
    }

    void addMeshopt() {
        const int positions =
            accessor(attributeView(quantized(mesh_.positions, 1 / reach_)), kShort, "VEC3", 1.0f);
        const int normals = accessor(attributeView(quantized(mesh_.normals, 1)), kShort, "VEC3");
        std::string stream(meshopt_encodeIndexBufferBound(indices_.size(), vertices()), '\0');
        stream.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(stream.data()),
                                                stream.size(), indices_.data(), indices_.size()));
        const int corners =
            accessor(meshoptView(stream, 4, indices_.size(), "TRIANGLES"), kUnsignedInt, "SCALAR");
        add({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", corners}},
            reach_);
        uses("EXT_meshopt_compression");
    }

    std::string glb() {
        file_["buffers"][0] = {{"byteLength", binary_.size()}};
        // What meshopt unpacks into, as far as the file knows.
        file_["buffers"][1] = {{"byteLength", unpacked_},
                               {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}};
        std::string text = file_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const auto chunk = [](const std::string& data, std::uint32_t type) {
            return bytesOf(std::vector{static_cast<std::uint32_t>(data.size()), type}) + data;
        };
        const std::string chunks = chunk(text, 0x4E4F534A) + chunk(binary_, 0x004E4942);
        return bytesOf(std::vector<std::uint32_t>{0x46546C67, 2,
                                                  static_cast<std::uint32_t>(12 + chunks.size())}) +
               chunks;
    }

private:
    [[nodiscard]] std::size_t vertices() const { return mesh_.positions.size(); }

    int view(const std::string& bytes, const json& more = json::object()) {
        json item = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
        item.update(more);
        binary_ += bytes;
        binary_.resize((binary_.size() + 3) / 4 * 4);
        file_["bufferViews"].push_back(std::move(item));
        return static_cast<int>(file_["bufferViews"].size()) - 1;
    }

    int attributeView(const std::vector<std::int16_t>& values) {
        std::string stream(meshopt_encodeVertexBufferBound(vertices(), 8), '\0');
        stream.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(stream.data()),
                                                 stream.size(), values.data(), vertices(), 8));
        return meshoptView(stream, 8, vertices(), "ATTRIBUTES");
    }

    int meshoptView(const std::string& stream, std::size_t stride, std::size_t count,
                    const char* mode) {
        const json packed = {{"buffer", 0},
                             {"byteOffset", binary_.size()},
                             {"byteLength", stream.size()},
                             {"byteStride", stride},
                             {"count", count},
                             {"mode", mode}};
        json item = {{"buffer", 1}, {"byteOffset", unpacked_}, {"byteLength", stride * count}};
        if (stride == 8) item["byteStride"] = 8;
        item["extensions"] = {{"EXT_meshopt_compression", packed}};
        unpacked_ += (stride * count + 3) / 4 * 4;
        binary_ += stream;
        binary_.resize((binary_.size() + 3) / 4 * 4);
        file_["bufferViews"].push_back(std::move(item));
        return static_cast<int>(file_["bufferViews"].size()) - 1;
    }

    int accessor(int view, int component, const char* type, float reach = 0.0f) {
        json item = {{"componentType", component},
                     {"type", type},
                     {"count", type[0] == 'S' ? indices_.size() : vertices()}};
        if (view >= 0) item["bufferView"] = view;
        if (component == kShort) item["normalized"] = true;
        if (reach > 0.0f) {
            const int most = component == kShort ? 32767 : 0;
            const json bound = most ? json(most) : json(reach);
            const json least = most ? json(-most) : json(-reach);
            item["max"] = {bound, bound, bound};
            item["min"] = {least, least, least};
        }
        file_["accessors"].push_back(std::move(item));
        return static_cast<int>(file_["accessors"].size()) - 1;
    }

    void add(json primitive, float scale = 1.0f) {
        primitive["material"] = 0;
        const std::size_t number = file_["meshes"].size();
        file_["meshes"].push_back({{"primitives", json::array({std::move(primitive)})}});
        const double across = 0.5 / static_cast<double>(reach_);
        file_["nodes"].push_back(
            {{"mesh", number},
             {"translation", {1.15 * static_cast<double>(number) - 1.725, 0, 0}},
             {"scale", json::array_t(3, across * static_cast<double>(scale))}});
        file_["scenes"][0]["nodes"].push_back(number);
    }

    void uses(const char* extension) {
        file_["extensionsUsed"].push_back(extension);
        file_["extensionsRequired"].push_back(extension);
    }

    const Mesh& mesh_;
    std::vector<unsigned> indices_;
    float reach_ = 0.0f;  // of positions from the middle
    json file_;
    std::string binary_;
    std::size_t unpacked_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 2) {
            std::fprintf(stderr, "usage: packed_shapes OUT.glb\n");
            return 2;
        }
        const auto parts = tukor::makeShape("torus-knot");
        Writer writer(parts.value().front().mesh);
        writer.addFloats();
        writer.addQuantized();
        writer.addDraco();
        writer.addMeshopt();
        tukor::writeFile(argv[1], writer.glb());
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "packed_shapes: %s\n", error.what());
        return 1;
    }
}
