#include "tukor/geometry/torus_knot.h"

#include <cmath>
#include <numbers>

#include "tukor/base/error.h"

namespace tukor {

Mesh makeTorusKnot(const TorusKnotOptions& options) {
    TUKOR_ASSERT(options.segments >= 3 && options.sides >= 3);
    using glm::dvec3;
    // The knot lies on a torus of radii 2 : 1; with its own tube it reaches out to 1.
    const double minor = (1.0 - options.tubeRadius) / 3.0;
    const double major = 2.0 * minor;
    Mesh mesh;
    mesh.positions.reserve(static_cast<std::size_t>(options.segments) * options.sides);
    mesh.normals.reserve(mesh.positions.capacity());
    mesh.triangles.reserve(2 * mesh.positions.capacity());

    for (int segment = 0; segment < options.segments; ++segment) {
        const double t = 2.0 * std::numbers::pi * segment / options.segments;
        const double phi = options.turns * t, theta = options.windings * t;
        const double radius = major + minor * std::cos(theta);
        const dvec3 centre(radius * std::cos(phi), radius * std::sin(phi), minor * std::sin(theta));
        const dvec3 tangent =
            glm::normalize(options.turns * radius * dvec3(-std::sin(phi), std::cos(phi), 0.0) +
                           options.windings * minor *
                               dvec3(-std::sin(theta) * std::cos(phi),
                                     -std::sin(theta) * std::sin(phi), std::cos(theta)));
        // The torus's own normal is perpendicular to every curve on it, smooth, and closes up.
        const dvec3 normal(std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi),
                           std::sin(theta));
        const dvec3 binormal = glm::cross(tangent, normal);
        for (int side = 0; side < options.sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / options.sides;
            const dvec3 outward = std::cos(angle) * normal + std::sin(angle) * binormal;
            mesh.positions.emplace_back(centre + static_cast<double>(options.tubeRadius) * outward);
            mesh.normals.emplace_back(outward);
        }
    }
    const auto vertex = [&](int segment, int side) {
        return static_cast<unsigned>(segment % options.segments * options.sides +
                                     side % options.sides);
    };
    for (int segment = 0; segment < options.segments; ++segment)
        for (int side = 0; side < options.sides; ++side) {
            const unsigned a = vertex(segment, side), b = vertex(segment + 1, side);
            const unsigned c = vertex(segment + 1, side + 1), d = vertex(segment, side + 1);
            mesh.triangles.emplace_back(a, c, b);
            mesh.triangles.emplace_back(a, d, c);
        }
    return mesh;
}

}  // namespace tukor
