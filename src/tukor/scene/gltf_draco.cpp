#include "tukor/scene/gltf_draco.h"

#include <cmath>
#include <exception>
#include <optional>
#include <vector>

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

template <int N>
std::vector<glm::vec<N, float>> attribute(const draco::Mesh& mesh, const JsonItem& id) {
    const draco::PointAttribute* const values =
        mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id.count()));
    if (values == nullptr || values->num_components() != N)
        id.fail(fmt::format("no attribute of {} components in the Draco stream", N));
    std::vector<glm::vec<N, float>> result(mesh.num_points());
    for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
        if (!values->ConvertValue<float, N>(values->mapped_index(draco::PointIndex(i)),
                                            &result[i].x))
            id.fail("an attribute of the Draco stream that cannot be read");
        if (N != 3)
            for (int c = 0; c < N; ++c)
                if (!std::isfinite(result[i][c])) result[i][c] = 0.0f;
    }
    return result;
}

// Colours may have three components or four, of integers or floats.
std::vector<glm::vec4> colours(const draco::Mesh& mesh, const JsonItem& id) {
    const draco::PointAttribute* const values =
        mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id.count()));
    if (values != nullptr && values->num_components() == 4) return attribute<4>(mesh, id);
    std::vector<glm::vec4> result;
    for (const glm::vec3 c : attribute<3>(mesh, id)) result.emplace_back(c, 1.0f);
    return result;
}

void readDetails(const draco::Mesh& source, const JsonItem& attributes, Mesh& mesh) {
    if (const std::optional<JsonItem> id = attributes.find("TEXCOORD_0"))
        mesh.uvs[0] = attribute<2>(source, *id);
    if (const std::optional<JsonItem> id = attributes.find("TEXCOORD_1"))
        mesh.uvs[1] = attribute<2>(source, *id);
    if (const std::optional<JsonItem> id = attributes.find("TANGENT"))
        mesh.tangents = attribute<4>(source, *id);
    if (const std::optional<JsonItem> id = attributes.find("COLOR_0"))
        for (const glm::vec4 c : colours(source, *id))
            mesh.colors.push_back(glm::clamp(c, 0.0f, 1.0f));
}

}  // namespace

Mesh dracoDecoded(const JsonItem& extension, std::span<const std::byte> compressed,
                  std::size_t vertices, std::size_t triangles) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(compressed.data()), compressed.size());
    draco::Decoder decoder;
    std::unique_ptr<draco::Mesh> decoded;
    try {
        draco::StatusOr<std::unique_ptr<draco::Mesh>> result =
            decoder.DecodeMeshFromBuffer(&buffer);
        if (!result.ok())
            extension.fail(fmt::format("a damaged Draco stream: {}",
                                       printable(result.status().error_msg_string())));
        decoded = std::move(result).value();
    } catch (const std::bad_alloc&) {
        extension.fail("a damaged Draco stream: it asks for too much memory");
    }
    if (decoded->num_points() > vertices || decoded->num_faces() > triangles)
        extension.fail(
            fmt::format("a Draco stream of {} vertices and {} triangles; its accessors "
                        "announce {} and {}",
                        decoded->num_points(), decoded->num_faces(), vertices, triangles));
    Mesh mesh;
    const JsonItem attributes = extension.at("attributes");
    mesh.positions = attribute<3>(*decoded, attributes.at("POSITION"));
    if (const std::optional<JsonItem> normals = attributes.find("NORMAL"))
        mesh.normals = attribute<3>(*decoded, *normals);
    readDetails(*decoded, attributes, mesh);
    mesh.triangles.resize(decoded->num_faces());
    for (std::uint32_t i = 0; i < decoded->num_faces(); ++i) {
        const draco::Mesh::Face& face = decoded->face(draco::FaceIndex(i));
        for (int c = 0; c < 3; ++c) {
            mesh.triangles[i][c] = face[static_cast<std::size_t>(c)].value();
            if (mesh.triangles[i][c] >= mesh.positions.size())
                extension.fail("a Draco stream with triangles of vertices that are not there");
        }
    }
    return mesh;
}

}  // namespace tukor
