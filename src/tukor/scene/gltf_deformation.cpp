#include "tukor/scene/gltf_deformation.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "tukor/scene/gltf_accessor.h"

namespace tukor {

namespace {

constexpr std::size_t kMostMoves = std::size_t{1} << 28;  // of vertices by targets: seconds

std::optional<GltfAccessor> accessorOf(const GltfDocument& document, const JsonItem& attributes,
                                       const char* name, std::size_t vertices, int components) {
    const std::optional<JsonItem> index = attributes.find(name);
    if (!index) return std::nullopt;
    GltfAccessor accessor(document, index->count(), *index);
    accessor.requireComponents(components, components);
    if (accessor.count() != vertices)
        attributes.fail(
            fmt::format("{} values of {} for {} positions", accessor.count(), name, vertices));
    return accessor;
}

std::size_t vertexCount(const GltfDocument& document, const JsonItem& primitive) {
    return document.referred("accessors", primitive.at("attributes"), "POSITION")
        .at("count")
        .count();
}

void morph(const GltfDocument& document, const JsonItem& primitive,
           const std::vector<double>& weights, const std::vector<unsigned>& used, Mesh& mesh) {
    const std::size_t vertices = vertexCount(document, primitive);
    std::size_t index = 0, moves = 0;
    for (const JsonItem target : primitive.list("targets")) {
        const auto weight = static_cast<float>(index < weights.size() ? weights[index] : 0.0);
        ++index;
        if (weight == 0.0f) continue;
        moves += used.size();
        if (moves > kMostMoves) primitive.fail("too many morph targets for so many vertices");
        const auto add = [&](const char* name, auto& to) {
            if (to.empty()) return;
            const auto deltas = accessorOf(document, target, name, vertices, 3);
            if (!deltas) return;
            for (std::size_t i = 0; i < used.size(); ++i) {
                const glm::vec3 delta = weight * glm::vec3(deltas->vec4(used[i]));
                for (int c = 0; c < 3; ++c) to[i][c] += delta[c];
            }
        };
        add("POSITION", mesh.positions);
        add("NORMAL", mesh.normals);
        add("TANGENT", mesh.tangents);
    }
}

void skin(const GltfDocument& document, const JsonItem& primitive,
          const std::vector<glm::dmat4>& joints, const std::vector<unsigned>& used, Mesh& mesh) {
    const JsonItem attributes = primitive.at("attributes");
    const std::size_t vertices = vertexCount(document, primitive);
    std::vector<glm::dmat4> sums(used.size(), glm::dmat4(0.0));
    std::vector<double> totals(used.size(), 0.0);
    for (const auto& [jointName, weightName] :
         {std::pair("JOINTS_0", "WEIGHTS_0"), std::pair("JOINTS_1", "WEIGHTS_1")}) {
        const auto indices = accessorOf(document, attributes, jointName, vertices, 4);
        const auto weights = accessorOf(document, attributes, weightName, vertices, 4);
        if (!indices || !weights) continue;
        for (std::size_t i = 0; i < used.size(); ++i) {
            const glm::vec4 index = indices->vec4(used[i]), weight = weights->vec4(used[i]);
            for (int c = 0; c < 4; ++c) {
                if (!(weight[c] > 0.0f)) continue;
                if (!(index[c] >= 0.0f && index[c] < static_cast<float>(joints.size())))
                    primitive.fail(fmt::format("vertex {} hangs on joint {} of {}", used[i],
                                               index[c], joints.size()));
                const auto w = static_cast<double>(weight[c]);
                sums[i] += w * joints[static_cast<std::size_t>(index[c])];
                totals[i] += w;
            }
        }
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        const glm::dmat4 m = totals[i] > 0.0 ? sums[i] / totals[i] : glm::dmat4(1.0);
        mesh.positions[i] = glm::vec3(m * glm::dvec4(glm::dvec3(mesh.positions[i]), 1.0));
        const glm::dmat3 linear(m);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]),
                                   glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        if (!mesh.normals.empty()) {
            const glm::dvec3 n = cofactors * glm::dvec3(mesh.normals[i]);
            const double length = glm::length(n);
            mesh.normals[i] = length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0f);
        }
        if (!mesh.tangents.empty())
            mesh.tangents[i] = glm::vec4(linear * glm::dvec3(mesh.tangents[i]), mesh.tangents[i].w);
    }
}

}  // namespace

std::vector<glm::dmat4> jointsOf(const GltfDocument& document, const JsonItem& skinItem,
                                 const std::vector<glm::dmat4>& worldFromNode) {
    const JsonList list = skinItem.list("joints");
    std::vector<glm::dmat4> joints;
    std::optional<GltfAccessor> inverses;
    if (const std::optional<JsonItem> index = skinItem.find("inverseBindMatrices")) {
        inverses.emplace(document, index->count(), *index);
        inverses->requireComponents(16, 16);
        if (inverses->count() < list.size())
            skinItem.fail(fmt::format("{} inverse bind matrices for {} joints", inverses->count(),
                                      list.size()));
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::size_t node = list[i].count();
        if (node >= worldFromNode.size())
            list[i].fail(
                fmt::format("refers to nodes[{}]; there are {}", node, worldFromNode.size()));
        joints.push_back(inverses ? worldFromNode[node] * glm::dmat4(inverses->mat4(i))
                                  : worldFromNode[node]);
    }
    return joints;
}

void deform(const GltfDocument& document, const JsonItem& primitive,
            const GltfDeformation& deformation, const std::vector<unsigned>& used, Mesh& mesh) {
    if (!deformation.weights.empty()) morph(document, primitive, deformation.weights, used, mesh);
    if (!deformation.worldFromBind.empty())
        skin(document, primitive, deformation.worldFromBind, used, mesh);
}

}  // namespace tukor
