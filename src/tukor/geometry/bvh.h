// A bounding volume hierarchy for traversal on the GPU, in the layout of bvh_traversal.h.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/geometry/bvh_fetch.h"
#include "tukor/geometry/mesh.h"

namespace tukor {

/// Texels in a row of each of the Bvh's textures.
inline constexpr int kBvhTextureWidth = 1024;

/// Where a triangle of the Bvh comes from.
struct BvhSource {
    std::uint32_t part;
    std::uint32_t triangle;  // within the part's mesh
};

/// Arrays ready to become textures: each is filled up with zeros to whole rows of kBvhTextureWidth
/// texels, and has at least one.
struct Bvh {
    std::vector<glm::uvec4> nodes;     // 3 a node, the root first
    std::vector<glm::vec4> triangles;  // 3 a triangle
    std::vector<glm::vec4> normals;    // 3 a triangle
    std::vector<BvhSource> sources;    // of every triangle, in the order of the Bvh
    int nodeCount = 0;
    int stackSize = 0;  // entries that the traversal may need, at most kBvhStackSize

    [[nodiscard]] int triangleCount() const noexcept { return static_cast<int>(sources.size()); }
    [[nodiscard]] geometry::BvhView view() const noexcept {
        return {nodes.data(), triangles.data(), normals.data()};
    }
};

/// A tree over the triangles of all parts, by the surface area heuristic, on all cores. The same
/// input gives the same tree on any number of threads.
///
/// Throws Error above 2^24 triangles or when a position is not finite.
[[nodiscard]] Bvh buildBvh(std::span<const Mesh* const> parts);

}  // namespace tukor
