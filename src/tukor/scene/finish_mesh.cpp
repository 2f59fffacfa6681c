#include "tukor/scene/finish_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/crease_normals.h"

namespace tukor {

namespace {

constexpr float kFarthest = 1e12f;  // m; squares of squares of it are still floats

bool inRange(glm::vec3 p) noexcept {
    const glm::vec3 a = glm::abs(p);
    return a.x <= kFarthest && a.y <= kFarthest && a.z <= kFarthest;  // false for NaN
}

void check(const Mesh& mesh, std::string_view name) {
    const std::size_t count = mesh.positions.size();
    for (std::size_t i = 0; i < count; ++i)
        if (!inRange(mesh.positions[i]))
            throw Error(fmt::format(
                "{}: vertex {} is at ({}, {}, {}); expected finite coordinates "
                "up to {:g}",
                name, i, mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z, kFarthest));
    for (const glm::uvec3 t : mesh.triangles)
        if (t.x >= count || t.y >= count || t.z >= count)
            throw Error(fmt::format("{}: a triangle refers to vertex {} of {}", name,
                                    std::max({t.x, t.y, t.z}), count));
}

// Unit normals; false where one has no direction.
bool normalise(std::vector<glm::vec3>& normals) noexcept {
    for (glm::vec3& n : normals) {
        const float length2 = glm::dot(n, n);
        if (!(length2 > 1e-30f && length2 < 1e30f)) return false;
        n /= std::sqrt(length2);
    }
    return true;
}

bool mostlyAgainstNormals(const Mesh& mesh) noexcept {
    std::size_t against = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 across = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
        const glm::vec3 mean = mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z];
        if (glm::dot(mean, across) < 0.0f) ++against;
    }
    return 2 * against > mesh.triangles.size();
}

}  // namespace

Mesh finishedMesh(Mesh mesh, float creaseAngle, std::string_view name, std::string_view part,
                  Notes& notes) {
    check(mesh, name);
    std::erase_if(mesh.triangles, [&](glm::uvec3 t) {
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        return a == b || b == c || c == a;
    });
    if (!mesh.normals.empty() &&
        (mesh.normals.size() != mesh.positions.size() || !normalise(mesh.normals))) {
        notes.add("normals without a direction, computed anew", part);
        mesh.normals.clear();
    }
    const bool bare = mesh.normals.empty();
    if (bare) mesh.tangents.clear();  // they belong to normals
    if (bare) return withCreaseNormals(mesh, creaseAngle);
    if (mostlyAgainstNormals(mesh)) {
        notes.add("triangles wound against their normals, turned round", part);
        for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    }
    return mesh;
}

}  // namespace tukor
