#include "tukor/scene/media.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor {

namespace {

/// Parts that share a medium: all of one material.
struct Group {
    std::vector<std::size_t> parts;
    std::vector<Bounds> bounds;
};

bool disjoint(const Bounds& a, const Bounds& b) {
    return glm::any(glm::lessThan(a.most, b.least)) || glm::any(glm::lessThan(b.most, a.least));
}

/// By what its absorption has to be multiplied.
float colourScale(const Material& material, const std::vector<Bounds>& bounds) {
    if (material.colourSize == 0.0f) return 1.0f;
    float size = 0.0f;
    for (const Bounds& one : bounds) {
        const glm::vec3 extent = one.most - one.least;
        size = std::max({size, extent.x, extent.y, extent.z});
    }
    return material.colourSize / std::max(size, 1e-9f);
}

enum class Sharing { never, whereDisjoint, always };

std::vector<Group> grouped(const Scene& scene, const std::vector<std::size_t>& dielectrics,
                           Sharing sharing) {
    std::vector<Group> groups;
    for (const std::size_t part : dielectrics) {
        const Bounds bounds = boundsOf(scene.parts[part].mesh);
        Group* home = nullptr;
        for (Group& group : groups) {
            if (sharing == Sharing::never) break;
            if (scene.parts[group.parts.front()].material != scene.parts[part].material) continue;
            const bool apart =
                sharing == Sharing::always ||
                std::all_of(group.bounds.begin(), group.bounds.end(),
                            [&](const Bounds& other) { return disjoint(other, bounds); });
            if (apart) {
                home = &group;
                break;
            }
        }
        if (!home) home = &groups.emplace_back();
        home->parts.push_back(part);
        home->bounds.push_back(bounds);
    }
    return groups;
}

}  // namespace

MediaTable mediaOf(const Scene& scene) {
    std::vector<std::size_t> dielectrics;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        if (scene.parts[i].material.kind == MaterialKind::dielectric) dielectrics.push_back(i);
    }
    std::vector<Group> groups =
        grouped(scene, dielectrics,
                dielectrics.size() <= kMaxMedia ? Sharing::never : Sharing::whereDisjoint);
    if (groups.size() > kMaxMedia) groups = grouped(scene, dielectrics, Sharing::always);
    if (groups.size() > kMaxMedia) {
        throw Error(
            fmt::format("{} different dielectrics; at most {} can be told apart along a ray",
                        groups.size(), kMaxMedia));
    }

    std::vector<std::size_t> order(groups.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const int pa = scene.parts[groups[a].parts.front()].material.priority;
        const int pb = scene.parts[groups[b].parts.front()].material.priority;
        return pa != pb ? pa < pb : a > b;
    });
    MediaTable table;
    table.mediumOfPart.assign(scene.parts.size(), -1);
    for (const std::size_t group : order) {
        for (const std::size_t part : groups[group].parts) {
            table.mediumOfPart[part] = static_cast<int>(table.media.size());
        }
        const Material& material = scene.parts[groups[group].parts.front()].material;
        const float scale = colourScale(material, groups[group].bounds);
        table.media.push_back({material.eta.x, scale * material.sigmaA, material.dispersion});
    }
    return table;
}

}  // namespace tukor
