#include "tukor/scene/gltf_draco.h"

#include <exception>
#include <optional>
#include <vector>

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

std::vector<glm::vec3> attribute(const draco::Mesh& mesh, const JsonItem& id) {
    const draco::PointAttribute* const values =
        mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id.count()));
    if (values == nullptr || values->num_components() != 3)
        id.fail("no attribute of three components in the Draco stream");
    std::vector<glm::vec3> result(mesh.num_points());
    for (std::uint32_t i = 0; i < mesh.num_points(); ++i)
        if (!values->ConvertValue<float, 3>(values->mapped_index(draco::PointIndex(i)),
                                            &result[i].x))
            id.fail("an attribute of the Draco stream that cannot be read");
    return result;
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
    mesh.positions = attribute(*decoded, attributes.at("POSITION"));
    if (const std::optional<JsonItem> normals = attributes.find("NORMAL"))
        mesh.normals = attribute(*decoded, *normals);
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
