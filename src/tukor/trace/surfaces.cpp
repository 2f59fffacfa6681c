#include "tukor/trace/surfaces.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor::trace {

static_assert(static_cast<int>(MaterialKind::mirror) == transport::kMirror);
static_assert(static_cast<int>(MaterialKind::metal) == transport::kMetal);
static_assert(static_cast<int>(MaterialKind::dielectric) == transport::kDielectric);

namespace {

std::vector<Surface> surfacesOf(const Scene& scene, const MediaTable& table) {
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const int medium = table.mediumOfPart[i];
        surfaces.push_back(
            {&scene.parts[i].mesh, scene.parts[i].material, medium < 0 ? 0u : 1u << medium, 0u});
    }
    return surfaces;
}

}  // namespace

SurfaceTable::SurfaceTable(const Scene& scene) : SurfaceTable(scene, mediaOf(scene)) {}

SurfaceTable::SurfaceTable(const Scene& scene, const MediaTable& table)
    : SurfaceTable(surfacesOf(scene, table), table.media) {}

SurfaceTable::SurfaceTable(const std::vector<Surface>& surfaces,
                           const std::vector<DielectricMedium>& media) {
    media_.fill(transport::vacuum());
    for (std::size_t i = 0; i < media.size() && i < kMaxMedia; ++i) {
        media_[i + 1].eta = media[i].eta;
        media_[i + 1].sigmaA = media[i].sigmaA;
    }
    std::size_t triangles = 0;
    for (const Surface& surface : surfaces) {
        Entry& entry = entries_.emplace_back();
        const Mesh& mesh = *surface.mesh;
        entry.vertices.resize(mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            entry.vertices[i] = {mesh.positions[i],
                                 i < mesh.normals.size() ? mesh.normals[i] : glm::vec3(0.0f)};
        }
        entry.triangles = mesh.triangles;
        entry.material = surface.material;
        entry.inside = surface.inside;
        entry.outside = surface.outside;
        entry.firstTriangle = static_cast<int>(triangles);
        triangles += mesh.triangles.size();
        if (triangles > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
            throw Error(fmt::format("{} triangles; at most 2^31 can be rendered", triangles));
        }
        const Bounds one = boundsOf(mesh);
        if (!one.empty()) {
            bounds_.include(one.least);
            bounds_.include(one.most);
        }
    }
}

glm::vec3 SurfaceTable::centre(int number) const noexcept {
    const auto after =
        std::upper_bound(entries_.begin(), entries_.end(), number,
                         [](int n, const Entry& entry) { return n < entry.firstTriangle; });
    const Entry& entry = *std::prev(after);
    const glm::uvec3 t = entry.triangles[static_cast<std::size_t>(number - entry.firstTriangle)];
    return (entry.vertices[t.x].position + entry.vertices[t.y].position +
            entry.vertices[t.z].position) /
           3.0f;
}

}  // namespace tukor::trace
