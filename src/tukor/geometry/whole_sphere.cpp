#include "tukor/geometry/whole_sphere.h"

#include <cmath>
#include <numbers>

#include "tukor/geometry/closedness.h"

namespace tukor {

namespace {

using glm::dvec3;

constexpr double kTolerance = 1e-3;  // of the radius
constexpr double kRadial = 0.9999;   // cosine between a corner's normal and its radius

bool finite(dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::optional<Sphere> wholeSphere(const Mesh& mesh) {
    if (mesh.triangles.size() < 100 || mesh.normals.size() != mesh.positions.size()) return {};

    // What is no sphere usually shows in its box, or in its first corners.
    const Bounds bounds = boundsOf(mesh);
    const dvec3 box = dvec3(bounds.most) - dvec3(bounds.least);
    const dvec3 middle = 0.5 * (dvec3(bounds.most) + dvec3(bounds.least));
    const double half = 0.5 * std::max(box.x, std::max(box.y, box.z));
    if (!finite(box) || !(half > 0.0) ||
        std::min(box.x, std::min(box.y, box.z)) < 2.0 * half * (1.0 - 2.0 * kTolerance)) {
        return {};
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const dvec3 out = dvec3(mesh.positions[i]) - middle;
        const double r = glm::length(out);
        if (!(std::abs(r - half) <= 2.0 * kTolerance * half) ||
            !(glm::dot(out, dvec3(mesh.normals[i])) >= kRadial * r)) {
            return {};
        }
    }

    double area = 0.0;
    dvec3 moment(0.0);
    for (const glm::uvec3 t : mesh.triangles) {
        const dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const dvec3 twice = glm::cross(b - a, c - a);
        const double size = 0.5 * glm::length(twice);
        const dvec3 centroid = (a + b + c) / 3.0;
        // The middle of a triangle is as far inside as any point of it.
        if (glm::dot(twice, centroid - middle) < 0.0 ||
            glm::length(centroid - middle) < half * (1.0 - 3.0 * kTolerance)) {
            return {};
        }
        area += size;
        moment += size * centroid;
    }
    const double radius = std::sqrt(area / (4.0 * std::numbers::pi));
    const dvec3 centre = moment / area;
    if (std::abs(radius - half) > kTolerance * half ||
        glm::length(centre - middle) > kTolerance * half || !checkClosed(mesh).closed()) {
        return {};
    }
    return Sphere{glm::vec3(centre), static_cast<float>(radius)};
}

}  // namespace tukor
