#include "tukor/trace/rounding.h"

#include "tukor/transport/rounding.h"

namespace tukor::trace {

RayHit withoutRounding(const Frame& frame, transport::Branch& ray, const RayHit& hit) noexcept {
    transport::Rounding rounding = transport::exactSoFar();
    RayHit next = hit;
    const auto triesAgain = [&] {
        if (next.surface < 0)
            return transport::triesAgain(rounding, ray, false, 0.0f, 0.0f, ray.media == 0u);
        const auto met =
            transport::encounter(ray, frame.surfaces.at(next, ray.origin, ray.direction));
        const float nearness =
            transport::nearnessToEdge(next.u, next.v, ray.direction, met.face.ng);
        return transport::triesAgain(rounding, ray, true, next.distance, nearness, met.consistent);
    };
    while (triesAgain()) {
        if (rounding.nudged)
            ray.origin = frame.surfaces.nudged(ray.skip, ray.origin, ray.direction);
        next = frame.caster.cast(ray.origin, ray.direction, ray.skip, rounding.beyond);
    }
    return next;
}

}  // namespace tukor::trace
