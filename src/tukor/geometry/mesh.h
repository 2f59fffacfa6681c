// Triangle meshes with a normal at every corner: the one surface format every renderer consumes.
#pragma once
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
