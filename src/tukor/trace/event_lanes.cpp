#include "tukor/trace/event_lanes.h"

#include "tukor/transport/grazing.h"

namespace tukor::trace {

namespace {

void set(EventLanes::Way& way, int lane, const transport::Branch& branch) noexcept {
    way.origin.set(lane, branch.origin);
    way.direction.set(lane, branch.direction);
    way.directionX.set(lane, branch.footprint.directionX);
    way.directionY.set(lane, branch.footprint.directionY);
}

template <bool kClear>
[[gnu::flatten]] void bendAll(EventLanes& all, int fresnel) noexcept {
    for (int i = 0; i < kPacketWidth; ++i) {
        transport::SurfaceHit hit{};
        hit.e1 = all.e1[i];
        hit.e2 = all.e2[i];
        hit.normal = all.normal[i];
        hit.normalE1 = all.normalE1[i];
        hit.normalE2 = all.normalE2[i];
        transport::Encounter met{};
        met.face = all.facing(i);
        transport::Branch at{};
        at.origin = all.position[i];
        at.direction = all.direction[i];
        at.footprint = transport::footprintAtSurface(
            {all.originX[i], all.originY[i], all.directionX[i], all.directionY[i]}, at.direction,
            all.distance[i], met.face.ng);
        all.surfaceX.set(i, at.footprint.originX);
        all.surfaceY.set(i, at.footprint.originY);
        const transport::NormalChange change =
            transport::normalChangeOver(at.footprint, hit, met.face);
        set(all.reflected, i, transport::reflectedBranch(at, change, met, {}));
        if constexpr (kClear) {
            const float eta = all.eta[i];
            all.R[i] = transport::dielectricReflectance(met.face.cosThetaI, eta, fresnel);
            all.bendsAway[i] = transport::bendsAway(change, at.direction, met.face.cosThetaI);
            set(all.refracted, i, transport::refractedBranch(at, change, met, {{}, 0.0f, eta}));
        }
    }
}

}  // namespace

[[gnu::flatten]] void EventLanes::face() noexcept {
    for (int i = 0; i < kPacketWidth; ++i) {
        transport::SurfaceHit hit{};
        hit.e1 = e1[i];
        hit.e2 = e2[i];
        hit.normal = normal[i];
        const transport::Facing found = transport::facingSurface(hit, direction[i]);
        n.set(i, found.n);
        ng.set(i, found.ng);
        cosThetaI[i] = found.cosThetaI;
        side[i] = found.side;
    }
}

void EventLanes::bend(bool clear, int fresnel) noexcept {
    clear ? bendAll<true>(*this, fresnel) : bendAll<false>(*this, fresnel);
}

}  // namespace tukor::trace
