#include "tukor/scene/gltf_primitive.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tukor/scene/gltf_accessor.h"
#include "tukor/scene/gltf_draco.h"

namespace tukor {

namespace {

enum class Mode { points, lines, lineLoop, lineStrip, triangles, triangleStrip, triangleFan };

Mode modeOf(const JsonItem& primitive) {
    const std::size_t mode = primitive.countOr("mode", 4);
    if (mode > 6) primitive.fail(fmt::format("mode {}; expected 0 to 6", mode));
    return static_cast<Mode>(mode);
}

std::optional<GltfAccessor> accessorAt(const GltfDocument& document, const JsonItem& user,
                                       const char* member) {
    const std::optional<JsonItem> index = user.find(member);
    if (!index) return std::nullopt;
    return GltfAccessor(document, index->count(), *index);
}

std::uint64_t trianglesFrom(Mode mode, std::uint64_t corners) noexcept {
    if (mode < Mode::triangles) return 0;
    if (mode == Mode::triangles) return corners / 3;
    return corners < 3 ? 0 : corners - 2;
}

// Corners i of triangle t; strips turn every other triangle round to keep their winding.
glm::uvec3 cornersOf(Mode mode, unsigned t) noexcept {
    if (mode == Mode::triangleStrip) return {t, t + 1 + t % 2, t + 2 - t % 2};
    if (mode == Mode::triangleFan) return {t + 1, t + 2, 0};
    return {3 * t, 3 * t + 1, 3 * t + 2};
}

// Renumbers the vertices in use from 0; returns their old numbers.
std::vector<unsigned> compact(std::vector<glm::uvec3>& triangles, std::size_t vertices) {
    std::vector<unsigned> used;
    if (triangles.size() < vertices / 8) {  // few of many: a table of all would cost too much
        used.reserve(3 * triangles.size());
        for (const glm::uvec3 t : triangles) used.insert(used.end(), {t.x, t.y, t.z});
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        for (glm::uvec3& t : triangles)
            for (int i = 0; i < 3; ++i)
                t[i] = static_cast<unsigned>(std::lower_bound(used.begin(), used.end(), t[i]) -
                                             used.begin());
        return used;
    }
    constexpr unsigned kUnused = ~0u;
    std::vector<unsigned> number(vertices, kUnused);
    for (glm::uvec3& t : triangles)
        for (int i = 0; i < 3; ++i) {
            unsigned& n = number[t[i]];
            if (n == kUnused) {
                n = static_cast<unsigned>(used.size());
                used.push_back(t[i]);
            }
            t[i] = n;
        }
    return used;
}

// The primitive's Draco extension, if it has one.
std::optional<JsonItem> dracoOf(const JsonItem& primitive) {
    const std::optional<JsonItem> extensions = primitive.find("extensions");
    return extensions ? extensions->find("KHR_draco_mesh_compression") : std::nullopt;
}

// How many elements an accessor announces: those of Draco have no data of their own.
std::size_t announced(const GltfDocument& document, const JsonItem& user, const char* member) {
    return document.referred("accessors", user, member).at("count").count();
}

Mesh readDraco(const GltfDocument& document, const JsonItem& primitive, const JsonItem& draco) {
    const GltfView view = document.view(draco.at("bufferView").count(), draco);
    return dracoDecoded(draco, view.bytes,
                        announced(document, primitive.at("attributes"), "POSITION"),
                        announced(document, primitive, "indices") / 3);
}

// What textured surfaces need beside, of the vertices in use.
void readDetails(const GltfDocument& document, const JsonItem& attributes, std::size_t vertices,
                 const std::vector<unsigned>& used, Mesh& mesh) {
    const auto read = [&](const char* name, int least, int most, auto& values, auto&& convert) {
        const std::optional<GltfAccessor> accessor = accessorAt(document, attributes, name);
        if (!accessor) return;
        accessor->requireComponents(least, most);
        if (accessor->count() != vertices)
            attributes.fail(
                fmt::format("{} values of {} for {} positions", accessor->count(), name, vertices));
        values.resize(used.size());
        for (std::size_t i = 0; i < used.size(); ++i) values[i] = convert(accessor->vec4(used[i]));
    };
    read("TEXCOORD_0", 2, 2, mesh.uvs[0], [](glm::vec4 v) { return glm::vec2(v); });
    read("TEXCOORD_1", 2, 2, mesh.uvs[1], [](glm::vec4 v) { return glm::vec2(v); });
    read("TANGENT", 4, 4, mesh.tangents, [](glm::vec4 v) { return v; });
    read("COLOR_0", 3, 4, mesh.colors, [](glm::vec4 v) { return glm::clamp(v, 0.0f, 1.0f); });
}

}  // namespace

std::uint64_t triangleCountOf(const GltfDocument& document, const JsonItem& primitive) {
    const JsonItem attributes = primitive.at("attributes");
    if (dracoOf(primitive)) return announced(document, primitive, "indices") / 3;
    std::optional<GltfAccessor> corners = accessorAt(document, primitive, "indices");
    if (!corners) corners = accessorAt(document, attributes, "POSITION");
    return corners ? trianglesFrom(modeOf(primitive), corners->count()) : 0;
}

Mesh readPrimitive(const GltfDocument& document, const JsonItem& primitive,
                   const GltfDeformation& deformation, std::string_view part, Notes& notes) {
    Mesh mesh;
    const JsonItem attributes = primitive.at("attributes");
    const Mode mode = modeOf(primitive);
    if (mode < Mode::triangles) {
        notes.add("points and lines are not rendered", part);
        return mesh;
    }
    if (const std::optional<JsonItem> draco = dracoOf(primitive)) {
        if (!deformation.weights.empty() || !deformation.worldFromBind.empty())
            notes.add("morph targets and skins of compressed meshes are not rendered", part);
        return readDraco(document, primitive, *draco);
    }
    const std::optional<GltfAccessor> positions = accessorAt(document, attributes, "POSITION");
    if (!positions) {
        notes.add("shapes without positions", part);
        return mesh;
    }
    positions->requireVec3();
    const std::optional<GltfAccessor> indices = accessorAt(document, primitive, "indices");
    if (indices) indices->requireIndices();
    const std::size_t corners = indices ? indices->count() : positions->count();
    if (mode == Mode::triangles && corners % 3 != 0)
        notes.add("an incomplete last triangle, left out", part);

    mesh.triangles.resize(trianglesFrom(mode, corners));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        glm::uvec3 t = cornersOf(mode, static_cast<unsigned>(i));
        if (indices) t = {indices->index(t.x), indices->index(t.y), indices->index(t.z)};
        const unsigned largest = std::max({t.x, t.y, t.z});
        if (largest >= positions->count())
            primitive.fail(fmt::format("triangle {} refers to vertex {} of {}", i, largest,
                                       positions->count()));
        mesh.triangles[i] = t;
    }

    const std::vector<unsigned> used = compact(mesh.triangles, positions->count());
    mesh.positions.resize(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) mesh.positions[i] = positions->vec3(used[i]);
    if (const std::optional<GltfAccessor> normals = accessorAt(document, attributes, "NORMAL")) {
        normals->requireVec3();
        if (normals->count() != positions->count())
            primitive.fail(
                fmt::format("{} normals for {} positions", normals->count(), positions->count()));
        mesh.normals.resize(used.size());
        for (std::size_t i = 0; i < used.size(); ++i) mesh.normals[i] = normals->vec3(used[i]);
    }
    readDetails(document, attributes, positions->count(), used, mesh);
    deform(document, primitive, deformation, used, mesh);
    return mesh;
}

}  // namespace tukor
