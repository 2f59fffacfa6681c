#include "tukor/trace/rounding.h"

#include <algorithm>

namespace tukor::trace {

namespace {

// In barycentric coordinates. Rays meet edges with an error of some 1e-7 of the distance; at
// silhouettes, where that shows, triangles are seen a hundred times narrower than they are.
constexpr float kEdge = 1e-4f;

constexpr int kMostAtVertex = 8;  // triangles whose common corner a ray passes

bool onEdge(const RayHit& hit) {
    return std::min(std::min(hit.u, hit.v), 1.0f - hit.u - hit.v) < kEdge;
}

bool consistent(const Frame& frame, const transport::Branch& ray, const RayHit& hit) {
    if (hit.surface < 0) return ray.media == 0u;
    return transport::encounter(ray, frame.surfaces.at(hit)).consistent;
}

}  // namespace

RayHit withoutRounding(const Frame& frame, const transport::Branch& ray,
                       const RayHit& hit) noexcept {
    // A ray that starts at an edge may meet the neighbouring triangle at once, and one that passes
    // a silhouette the triangle behind it: look further along the ray.
    RayHit next = hit;
    for (int i = 0; i < kMostAtVertex && !consistent(frame, ray, next); ++i) {
        if (next.surface < 0 || !onEdge(next)) break;
        next = frame.caster.cast(ray.origin, ray.direction, ray.skip, next.distance);
    }
    if (consistent(frame, ray, next)) return next;
    if (ray.skip < 0) return hit;
    // Or it starts beyond the neighbour that it should meet: start a little further within its own
    // triangle.
    const glm::vec3 start = glm::mix(ray.origin, frame.surfaces.centre(ray.skip), kEdge);
    next = frame.caster.cast(start, ray.direction, ray.skip);
    return consistent(frame, ray, next) ? next : hit;
}

}  // namespace tukor::trace
