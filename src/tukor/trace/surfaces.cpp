#include "tukor/trace/surfaces.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/scene/spheres.h"

namespace tukor::trace {

static_assert(static_cast<int>(MaterialKind::mirror) == transport::kMirror);
static_assert(static_cast<int>(MaterialKind::metal) == transport::kMetal);
static_assert(static_cast<int>(MaterialKind::dielectric) == transport::kDielectric);

namespace {

std::vector<Surface> surfacesOf(const Scene& scene, const MediaTable& table) {
    const std::vector<std::optional<Sphere>> spheres = spheresOf(scene);
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const int medium = table.mediumOfPart[i];
        surfaces.push_back({&scene.parts[i].mesh, scene.parts[i].material,
                            medium < 0 ? 0u : 1u << medium, 0u, spheres[i]});
    }
    return surfaces;
}

SurfaceTable::Triangle triangleOf(const Mesh& mesh, glm::uvec3 corners) {
    const auto normal = [&](unsigned i) {
        return i < mesh.normals.size() ? mesh.normals[i] : glm::vec3(0.0f);
    };
    SurfaceTable::Triangle t;
    t.v0 = mesh.positions[corners.x];
    t.e1 = mesh.positions[corners.y] - t.v0;
    t.e2 = mesh.positions[corners.z] - t.v0;
    t.n0 = normal(corners.x);
    t.normalE1 = normal(corners.y) - t.n0;
    t.normalE2 = normal(corners.z) - t.n0;
    return t;
}

void addTriangles(SurfaceTable::Entry& entry, const Mesh& mesh) {
    entry.positions.reserve(mesh.positions.size() + 1);
    entry.positions = mesh.positions;
    entry.positions.emplace_back(0.0f);
    entry.indices = mesh.triangles;
    entry.triangles.resize(mesh.triangles.size());
    parallelFor(0, static_cast<int>(mesh.triangles.size()), 4096, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            entry.triangles[i] = triangleOf(mesh, mesh.triangles[i]);
        }
    });
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
        dispersions_[i + 1] = media[i].dispersion;
    }
    std::size_t triangles = 0;
    for (const Surface& surface : surfaces) {
        Entry& entry = entries_.emplace_back();
        const Mesh& mesh = *surface.mesh;
        entry.firstTriangle = static_cast<int>(triangles);
        triangles += surface.sphere ? 1 : mesh.triangles.size();
        if (triangles > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
            throw Error(fmt::format("{} triangles; at most 2^31 can be rendered", triangles));
        }
        entry.sphere = surface.sphere;
        if (!surface.sphere) addTriangles(entry, mesh);
        entry.material = surface.material;
        entry.inside = surface.inside;
        entry.outside = surface.outside;
        const Bounds one = boundsOf(mesh);
        if (!one.empty()) {
            bounds_.include(one.least);
            bounds_.include(one.most);
        }
    }
}

bool SurfaceTable::disperse() const noexcept {
    return std::any_of(dispersions_.begin(), dispersions_.end(), [](float d) { return d > 0.0f; });
}

glm::vec3 SurfaceTable::nudged(int number, glm::vec3 origin, glm::vec3 direction) const noexcept {
    const auto after =
        std::upper_bound(entries_.begin(), entries_.end(), number,
                         [](int n, const Entry& entry) { return n < entry.firstTriangle; });
    const Entry& entry = *std::prev(after);
    if (entry.sphere) return glm::mix(origin, entry.sphere->centre, transport::kEdge);
    const Triangle& t = entry.triangles[static_cast<std::size_t>(number - entry.firstTriangle)];
    return transport::nudgedOrigin(origin, direction, t.v0, t.e1, t.e2);
}

}  // namespace tukor::trace
