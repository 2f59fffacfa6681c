// Triangle meshes with a normal at every corner: the one surface format every renderer consumes.
#pragma once
#include <array>
#include <vector>

#include <glm/glm.hpp>

namespace tukor {

/// Indexed triangles, counter-clockwise seen from outside. Metres.
///
/// `normals` are unit, one per position; a crease or a flat facet has its vertices doubled. Shading
/// normals point to the same side as the winding for well-formed meshes.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::uvec3> triangles;

    // For textured surfaces; each is empty or has one per position.
    std::array<std::vector<glm::vec2>, 2> uvs{};
    std::vector<glm::vec4> tangents{};  // unit; w: 1 or -1, the bitangent is w cross(n, tangent)
    std::vector<glm::vec4> colors{};    // linear, with alpha: factors on the base colour
};

/// An axis-aligned box; empty when `least` exceeds `most`.
struct Bounds {
    glm::vec3 least{1e30f};
    glm::vec3 most{-1e30f};

    void include(glm::vec3 point) noexcept {
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    [[nodiscard]] bool empty() const noexcept { return least.x > most.x; }
    [[nodiscard]] glm::vec3 centre() const noexcept { return 0.5f * (least + most); }
    /// Half of the diagonal.
    [[nodiscard]] float radius() const noexcept { return 0.5f * glm::length(most - least); }
};

[[nodiscard]] Bounds boundsOf(const Mesh& mesh) noexcept;

}  // namespace tukor
