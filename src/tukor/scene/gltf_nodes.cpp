#include "tukor/scene/gltf_nodes.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "tukor/scene/gltf_instances.h"

namespace tukor {

namespace {

constexpr std::size_t kMostPlaced = 1 << 18;  // as many as parts are drawn

glm::dmat4 localTransform(const JsonItem& node, const GltfNodePose& pose) {
    if (const std::optional<std::array<double, 16>> m = node.numbers<16>("matrix")) {
        glm::dmat4 matrix;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix[column][row] = (*m)[static_cast<std::size_t>(4 * column + row)];
        return matrix;
    }
    glm::dmat4 matrix(1.0);
    if (pose.translation)
        matrix = glm::translate(matrix, *pose.translation);
    else if (const auto t = node.numbers<3>("translation"))
        matrix = glm::translate(matrix, glm::dvec3((*t)[0], (*t)[1], (*t)[2]));
    if (pose.rotation) {
        matrix *= glm::mat4_cast(*pose.rotation);
    } else if (const auto r = node.numbers<4>("rotation")) {
        const glm::dquat q((*r)[3], (*r)[0], (*r)[1], (*r)[2]);  // GLM's constructor has w first
        const double length = glm::length(q);
        if (!(length > 0.0 && std::isfinite(length))) node.fail("a rotation without a direction");
        matrix *= glm::mat4_cast(q / length);
    }
    if (pose.scale)
        matrix = glm::scale(matrix, *pose.scale);
    else if (const auto s = node.numbers<3>("scale"))
        matrix = glm::scale(matrix, glm::dvec3((*s)[0], (*s)[1], (*s)[2]));
    return matrix;
}

std::vector<double> weightsOf(const JsonItem& node, const GltfNodePose& pose) {
    if (!pose.weights.empty()) return pose.weights;
    std::vector<double> weights;
    for (const JsonItem weight : node.list("weights")) weights.push_back(weight.number());
    return weights;
}

/// Which nodes another one has for a child.
std::vector<bool> children(const JsonItem& root, std::size_t nodes) {
    std::vector<bool> isChild(nodes, false);
    for (const JsonItem node : root.list("nodes"))
        if (const JsonList list = node.list("children"); !list.empty())
            for (std::size_t i = 0; i < list.size(); ++i)
                if (const std::size_t child = list.countAt(i); child < nodes) isChild[child] = true;
    return isChild;
}

std::string nameOf(const GltfDocument& document, const JsonItem& node, const char* array,
                   std::size_t index) {
    std::string name = node.textOr("name", "");
    if (name.empty()) name = document.item(array, index, node).textOr("name", "");
    return name;
}

}  // namespace

GltfPlacements placementsOf(const GltfDocument& document, const GltfPose& pose) {
    constexpr std::size_t kWorld = static_cast<std::size_t>(-1);
    struct Pending {
        std::size_t node;
        std::size_t parent;  // in `matrices`, or kWorld
    };
    GltfPlacements placements;
    const JsonItem root = document.root();
    const std::optional<JsonItem> all = root.find("nodes");
    const std::size_t nodes = all ? all->size() : 0;
    std::vector<bool> reached(nodes, false);
    if (root.find("skins")) placements.worldFromNode.assign(nodes, glm::dmat4(1.0));
    const GltfNodePose still;
    std::vector<Pending> pending;
    std::vector<glm::dmat4> matrices;  // world from node, of nodes with children
    // Each node is noted once, so that lists of millions of children take no memory.
    const auto push = [&](const JsonItem& owner, const JsonList& list, std::size_t parent) {
        for (std::size_t i = list.size(); i-- > 0;) {
            const std::size_t node = list.countAt(i);
            if (node >= nodes)
                owner.fail(fmt::format("refers to nodes[{}]; there are {}", node, nodes));
            if (reached[node])
                document.item("nodes", node, root).fail("reached twice; nodes must form trees");
            reached[node] = true;
            pending.push_back({node, parent});
        }
    };
    if (root.find("scenes") || root.find("scene")) {
        const JsonItem scene = document.item("scenes", root.countOr("scene", 0), root);
        push(scene, scene.list("nodes"), kWorld);
    } else {
        const std::vector<bool> isChild = children(root, nodes);
        for (std::size_t i = nodes; i-- > 0;)
            if (!isChild[i]) {
                reached[i] = true;
                pending.push_back({i, kWorld});
            }
    }

    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        const JsonItem node = (*all)[next.node];
        const auto posed = pose.find(next.node);
        const GltfNodePose& moved = posed == pose.end() ? still : posed->second;
        const glm::dmat4 matrix =
            (next.parent == kWorld ? glm::dmat4(1.0) : matrices[next.parent]) *
            localTransform(node, moved);
        for (int column = 0; column < 4; ++column)
            if (!(glm::length(matrix[column]) < 1e15))  // beyond all that finishedMesh() accepts
                node.fail("its transformation is too large");
        if (!placements.worldFromNode.empty()) placements.worldFromNode[next.node] = matrix;
        const auto place = [&](std::deque<GltfPlaced>& placed, const char* what, std::size_t index,
                               std::string name) -> GltfPlaced& {
            if (placed.size() >= kMostPlaced)
                root.fail(fmt::format("more than {} nodes with a {}", kMostPlaced, what));
            return placed.emplace_back(GltfPlaced{index, std::move(name), matrix, next.node});
        };
        const std::optional<JsonItem> extensions = node.find("extensions");
        if (const std::optional<JsonItem> mesh = node.find("mesh")) {
            std::vector<glm::dmat4> instances{glm::dmat4(1.0)};
            if (extensions)
                if (const auto instancing = extensions->find("EXT_mesh_gpu_instancing"))
                    instances = instancesOf(document, *instancing, kMostPlaced);
            const std::string name = nameOf(document, node, "meshes", mesh->count());
            for (const glm::dmat4& instance : instances) {
                GltfPlaced& placed = place(placements.meshes, "mesh", mesh->count(), name);
                placed.worldFromNode = matrix * instance;
                if (const std::optional<JsonItem> skin = node.find("skin"))
                    placed.skin = skin->count();
                placed.weights = weightsOf(node, moved);
            }
        }
        if (const std::optional<JsonItem> camera = node.find("camera"))
            place(placements.cameras, "camera", camera->count(),
                  nameOf(document, node, "cameras", camera->count()));
        if (extensions) {
            if (const std::optional<JsonItem> light = extensions->find("KHR_lights_punctual"))
                place(placements.lights, "light", light->at("light").count(),
                      node.textOr("name", ""));
        }
        if (const JsonList list = node.list("children"); !list.empty()) {
            matrices.push_back(matrix);
            push(node, list, matrices.size() - 1);
        }
    }
    return placements;
}

}  // namespace tukor
