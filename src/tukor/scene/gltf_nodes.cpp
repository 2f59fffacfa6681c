#include "tukor/scene/gltf_nodes.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace tukor {

namespace {

glm::dmat4 localTransform(const JsonItem& node) {
    if (const std::optional<std::array<double, 16>> m = node.numbers<16>("matrix")) {
        glm::dmat4 matrix;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix[column][row] = (*m)[static_cast<std::size_t>(4 * column + row)];
        return matrix;
    }
    glm::dmat4 matrix(1.0);
    if (const auto t = node.numbers<3>("translation"))
        matrix = glm::translate(matrix, glm::dvec3((*t)[0], (*t)[1], (*t)[2]));
    if (const auto r = node.numbers<4>("rotation")) {
        const glm::dquat q((*r)[3], (*r)[0], (*r)[1], (*r)[2]);  // GLM's constructor has w first
        const double length = glm::length(q);
        if (!(length > 0.0 && std::isfinite(length))) node.fail("a rotation without a direction");
        matrix *= glm::mat4_cast(q / length);
    }
    if (const auto s = node.numbers<3>("scale"))
        matrix = glm::scale(matrix, glm::dvec3((*s)[0], (*s)[1], (*s)[2]));
    return matrix;
}

std::vector<std::size_t> indices(const JsonItem& owner, const char* name) {
    std::vector<std::size_t> values;
    const JsonList list = owner.list(name);
    values.reserve(list.size());
    for (const JsonItem item : list) values.push_back(item.count());
    return values;
}

std::vector<std::size_t> rootNodes(const GltfDocument& document, std::size_t nodes) {
    const JsonItem root = document.root();
    if (root.find("scenes") || root.find("scene"))
        return indices(document.item("scenes", root.countOr("scene", 0), root), "nodes");
    std::vector<bool> isChild(nodes, false);
    for (const JsonItem node : root.list("nodes"))
        for (const std::size_t child : indices(node, "children"))
            if (child < nodes) isChild[child] = true;
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < nodes; ++i)
        if (!isChild[i]) roots.push_back(i);
    return roots;
}

std::string nameOf(const GltfDocument& document, const JsonItem& node, const char* array,
                   std::size_t index) {
    std::string name = node.textOr("name", "");
    if (name.empty()) name = document.item(array, index, node).textOr("name", "");
    return name;
}

}  // namespace

GltfPlacements placementsOf(const GltfDocument& document, Notes& notes) {
    struct Pending {
        std::size_t node;
        glm::dmat4 worldFromParent;
    };
    GltfPlacements placements;
    const JsonItem root = document.root();
    const std::optional<JsonItem> all = root.find("nodes");
    const std::size_t nodes = all ? all->size() : 0;
    std::vector<bool> reached(nodes, false);
    std::vector<Pending> pending;
    const auto push = [&](const std::vector<std::size_t>& some, const glm::dmat4& matrix) {
        for (auto i = some.rbegin(); i != some.rend(); ++i) pending.push_back({*i, matrix});
    };
    push(rootNodes(document, nodes), glm::dmat4(1.0));

    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        const JsonItem node = document.item("nodes", next.node, root);
        if (reached[next.node]) node.fail("reached twice; nodes must form trees");
        reached[next.node] = true;
        const glm::dmat4 matrix = next.worldFromParent * localTransform(node);
        for (int column = 0; column < 4; ++column)
            if (!(glm::length(matrix[column]) < 1e15))  // beyond all that finishedMesh() accepts
                node.fail("its transformation is too large");
        if (const std::optional<JsonItem> mesh = node.find("mesh"))
            placements.meshes.push_back({mesh->count(),
                                         nameOf(document, node, "meshes", mesh->count()), matrix,
                                         node.where()});
        if (const std::optional<JsonItem> camera = node.find("camera"))
            placements.cameras.push_back({camera->count(),
                                          nameOf(document, node, "cameras", camera->count()),
                                          matrix, node.where()});
        if (const std::optional<JsonItem> extensions = node.find("extensions");
            extensions && extensions->find("EXT_mesh_gpu_instancing"))
            notes.add("instances of EXT_mesh_gpu_instancing are not rendered",
                      node.textOr("name", ""));
        push(indices(node, "children"), matrix);
    }
    return placements;
}

}  // namespace tukor
