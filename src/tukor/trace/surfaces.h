// The surfaces of a scene as the transport wants them: from a hit to a SurfaceHit, on triangles by
// barycentric coordinates, on whole spheres in closed form.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tukor/geometry/sphere_hit.h"
#include "tukor/geometry/whole_sphere.h"
#include "tukor/optics/dispersion.h"
#include "tukor/scene/media.h"
#include "tukor/scene/scene.h"
#include "tukor/transport/path_tree.h"
#include "tukor/transport/rounding.h"

namespace tukor::trace {

/// A mesh with its material, and the media that it parts: bits of transport/media.h.
struct Surface {
    const Mesh* mesh;
    Material material;
    std::uint32_t inside = 0;
    std::uint32_t outside = 0;
    std::optional<Sphere> sphere{};  // what the mesh stands for
};

/// Where a ray met which triangle; `surface` is -1 where it met none. A sphere is its surface's one
/// triangle, met in the middle.
struct RayHit {
    float distance;
    float u;
    float v;
    int surface;
    int triangle;  // within the surface
};

/// All surfaces of a scene, by number, and their media. Read-only after construction: share it.
class SurfaceTable {
public:
    /// One surface per part.
    explicit SurfaceTable(const Scene& scene);
    /// `media` as in MediaTable. Throws Error when there are more than 2^31 triangles.
    SurfaceTable(const std::vector<Surface>& surfaces, const std::vector<DielectricMedium>& media);

    /// All that shading needs, in one place of memory.
    struct Triangle {
        glm::vec3 v0, e1, e2;
        glm::vec3 n0, normalE1, normalE2;
    };
    struct Entry {
        std::optional<Sphere> sphere;      // then there are no triangles
        std::vector<glm::vec3> positions;  // and one more, which Embree reads 4 bytes of
        std::vector<glm::uvec3> indices;
        std::vector<Triangle> triangles;
        Material material;
        std::uint32_t inside;
        std::uint32_t outside;
        int firstTriangle;  // number of its first triangle among all
    };
    [[nodiscard]] const std::vector<Entry>& entries() const noexcept { return entries_; }
    [[nodiscard]] const Bounds& bounds() const noexcept { return bounds_; }

    /// By its number, or transport::kVacuum.
    [[nodiscard]] const transport::Medium& medium(int number) const noexcept {
        return media_[static_cast<std::size_t>(number + 1)];
    }
    /// The same for light of one wavelength in nm; 0: of all.
    [[nodiscard]] transport::Medium medium(int number, float wavelength) const noexcept {
        transport::Medium m = medium(number);
        if (wavelength > 0.0f && disperses(number))
            m.eta = optics::indexAt(m.eta, dispersions_[static_cast<std::size_t>(number + 1)],
                                    wavelength);
        return m;
    }
    [[nodiscard]] bool disperses(int number) const noexcept {
        return dispersions_[static_cast<std::size_t>(number + 1)] > 0.0f;
    }
    /// Whether any medium does.
    [[nodiscard]] bool disperse() const noexcept;

    /// The number of the triangle that was hit, among all of the table.
    [[nodiscard]] int number(const RayHit& hit) const noexcept {
        return entries_[static_cast<std::size_t>(hit.surface)].firstTriangle + hit.triangle;
    }

    /// The origin of a ray that leaves the triangle or sphere of that number, off its edges.
    [[nodiscard]] glm::vec3 nudged(int number, glm::vec3 origin,
                                   glm::vec3 direction) const noexcept;

    /// Starts to bring in what at() reads.
    void prefetch(const RayHit& hit) const noexcept {
        if (hit.surface < 0) return;
        const Entry& entry = entries_[static_cast<std::size_t>(hit.surface)];
        if (entry.sphere) return;
        const Triangle* t = &entry.triangles[static_cast<std::size_t>(hit.triangle)];
        __builtin_prefetch(t);
        __builtin_prefetch(&t->normalE2);
    }

    /// What a ray met: `hit` must be one, of a ray from `origin` in the unit `direction`.
    [[nodiscard]] transport::SurfaceHit at(const RayHit& hit, glm::vec3 origin,
                                           glm::vec3 direction) const noexcept {
        const Entry& entry = entries_[static_cast<std::size_t>(hit.surface)];
        transport::SurfaceHit s;
        s.distance = hit.distance;
        if (entry.sphere) {
            const geometry::SpherePoint p = geometry::spherePoint(
                origin, direction, hit.distance, entry.sphere->centre, entry.sphere->radius);
            s.e1 = p.e1;
            s.e2 = p.e2;
            s.position = p.position;
            s.normalE1 = p.e1 / entry.sphere->radius;
            s.normalE2 = p.e2 / entry.sphere->radius;
            s.normal = p.normal;
        } else {
            const Triangle& t = entry.triangles[static_cast<std::size_t>(hit.triangle)];
            s.e1 = t.e1;
            s.e2 = t.e2;
            const glm::vec2 uv = transport::awayFromEdges(hit.u, hit.v);
            s.position = t.v0 + uv.x * t.e1 + uv.y * t.e2;
            s.normalE1 = t.normalE1;
            s.normalE2 = t.normalE2;
            s.normal = t.n0 + uv.x * t.normalE1 + uv.y * t.normalE2;
        }
        describe(hit, s);
        return s;
    }

    /// The part of at() that is not where it was met.
    void describe(const RayHit& hit, transport::SurfaceHit& s) const noexcept {
        const Entry& entry = entries_[static_cast<std::size_t>(hit.surface)];
        s.triangle = entry.firstTriangle + hit.triangle;
        s.kind = static_cast<int>(entry.material.kind);
        s.tint = entry.material.tint;
        s.eta = entry.material.eta;
        s.k = entry.material.k;
        s.inside = entry.inside;
        s.outside = entry.outside;
    }

private:
    SurfaceTable(const Scene& scene, const MediaTable& table);

    std::vector<Entry> entries_;
    std::array<transport::Medium, kMaxMedia + 1> media_;  // vacuum first
    std::array<float, kMaxMedia + 1> dispersions_{};      // likewise
    Bounds bounds_;
};

}  // namespace tukor::trace
