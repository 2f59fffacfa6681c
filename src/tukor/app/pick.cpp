#include "tukor/app/pick.h"

#include <limits>

namespace tukor {
namespace {

/// Distance along the ray in lengths of `direction`. [Moeller & Trumbore 1997]
std::optional<float> hitDistance(const glm::vec3& origin, const glm::vec3& direction,
                                 const glm::vec3& a, const glm::vec3& b,
                                 const glm::vec3& c) noexcept {
    const glm::vec3 e1 = b - a, e2 = c - a;
    const glm::vec3 p = glm::cross(direction, e2);
    const float determinant = glm::dot(e1, p);
    if (determinant == 0.0f) return std::nullopt;
    const glm::vec3 s = origin - a;
    const float u = glm::dot(s, p) / determinant;
    if (!(u >= 0.0f && u <= 1.0f)) return std::nullopt;
    const glm::vec3 q = glm::cross(s, e1);
    const float v = glm::dot(direction, q) / determinant;
    if (!(v >= 0.0f && u + v <= 1.0f)) return std::nullopt;
    const float t = glm::dot(e2, q) / determinant;
    if (!(t > 0.0f)) return std::nullopt;
    return t;
}

}  // namespace

std::optional<Pick> pick(const Scene& scene, glm::vec3 origin, glm::vec3 direction) noexcept {
    std::optional<Pick> found;
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Mesh& mesh = scene.parts[i].mesh;
        for (const glm::uvec3& triangle : mesh.triangles) {
            const auto t = hitDistance(origin, direction, mesh.positions[triangle.x],
                                       mesh.positions[triangle.y], mesh.positions[triangle.z]);
            if (t && *t < nearest) {
                nearest = *t;
                found = Pick{i, origin + *t * direction};
            }
        }
    }
    return found;
}

}  // namespace tukor
