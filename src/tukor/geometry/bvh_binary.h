// The binary tree that a Bvh is folded from: binned surface area heuristic. Internal to geometry.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace tukor::detail {

/// A triangle as the builder sees it.
struct BvhItem {
    glm::vec3 least;
    std::uint32_t triangle;
    glm::vec3 most;
};

/// A node over items [first, first + count). An inner node has two children, `child` and `child`
/// + 1.
struct BinaryNode {
    glm::vec3 least;
    glm::vec3 most;
    std::uint32_t first;
    std::uint32_t count;
    std::uint32_t child = 0;  // 0: a leaf

    [[nodiscard]] bool leaf() const noexcept { return child == 0; }
    [[nodiscard]] float area() const noexcept {
        const glm::vec3 d = most - least;
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

/// The most triangles in a leaf; kinds of children have four bits, 15 meaning an inner node.
inline constexpr std::uint32_t kMaxLeafSize = 4;

/// Builds the tree and sorts `items` into the order of its leaves; the root is node 0.
///
/// No leaf is deeper than `maxDepth`, if 2^maxDepth leaves of kMaxLeafSize can hold all items:
/// halfway down to it, splits in the middle take over from the heuristic where it is needed.
[[nodiscard]] std::vector<BinaryNode> buildBinaryTree(std::vector<BvhItem>& items, int maxDepth);

}  // namespace tukor::detail
