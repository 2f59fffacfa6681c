// What surfaces do to eight branches side by side: the transport's shared source in loops that the
// compiler turns into vectors.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "tukor/trace/ray_caster.h"
#include "tukor/transport/path_tree.h"

namespace tukor::trace {

/// One of each lane.
template <class Number>
struct alignas(32) Lanes {
    std::array<Number, kPacketWidth> of{};

    Number& operator[](int lane) noexcept { return of[static_cast<std::size_t>(lane)]; }
    Number operator[](int lane) const noexcept { return of[static_cast<std::size_t>(lane)]; }
};

struct VectorLanes {
    Lanes<float> x, y, z;

    [[nodiscard]] glm::vec3 operator[](int lane) const noexcept {
        return {x[lane], y[lane], z[lane]};
    }
    void set(int lane, glm::vec3 v) noexcept {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
};

/// Up to eight branches where they have met surfaces: put() them, face(), set eta, bend(), and read
/// where they go. Lanes without a branch may hold anything.
struct EventLanes {
    /// Of the branches, as they come.
    VectorLanes direction, originX, originY, directionX, directionY;
    /// Of the surfaces, as in SurfaceHit.
    Lanes<float> distance;
    VectorLanes position, e1, e2, normal, normalE1, normalE2;
    /// By face(): as in Facing.
    VectorLanes n, ng;
    Lanes<float> cosThetaI, side;
    /// etaT / etaI; 1 at opaque surfaces.
    Lanes<float> eta;
    /// By bend(): where the ways on begin and lead, and their footprints, of which originX and
    /// originY are those of both.
    struct Way {
        VectorLanes origin, direction, directionX, directionY;
    };
    VectorLanes surfaceX, surfaceY;
    Way reflected, refracted;
    Lanes<float> R;        // of clear surfaces
    Lanes<int> bendsAway;  // see grazing.h

    void put(int lane, const transport::Branch& branch, const transport::SurfaceHit& hit) noexcept {
        direction.set(lane, branch.direction);
        originX.set(lane, branch.footprint.originX);
        originY.set(lane, branch.footprint.originY);
        directionX.set(lane, branch.footprint.directionX);
        directionY.set(lane, branch.footprint.directionY);
        distance[lane] = hit.distance;
        position.set(lane, hit.position);
        e1.set(lane, hit.e1);
        e2.set(lane, hit.e2);
        normal.set(lane, hit.normal);
        normalE1.set(lane, hit.normalE1);
        normalE2.set(lane, hit.normalE2);
    }
    /// Turns the surfaces towards the rays.
    void face() noexcept;
    [[nodiscard]] transport::Facing facing(int lane) const noexcept {
        return {n[lane], ng[lane], cosThetaI[lane], side[lane], side[lane] > 0.0f};
    }
    /// Finds both ways on; only the reflected where none is `clear`. `fresnel` as in the settings.
    void bend(bool clear, int fresnel) noexcept;

    /// What transport::scatter() does at fidelity exact, by what is known here.
    [[nodiscard]] transport::Deposits scatter(
        int lane, transport::Tree& tree, const transport::SurfaceHit& hit,
        const transport::Encounter& met, const transport::Medium& from, const transport::Medium& to,
        const transport::TransportSettings& settings) const noexcept;

private:
    /// A share of what has arrived, on its way.
    [[nodiscard]] transport::Branch goneOn(int lane, transport::Branch at, const Way& way,
                                           glm::vec3 share) const noexcept {
        at.origin = way.origin[lane];
        at.direction = way.direction[lane];
        at.throughput *= share;
        at.footprint = {surfaceX[lane], surfaceY[lane], way.directionX[lane], way.directionY[lane]};
        return at;
    }
};

inline transport::Deposits EventLanes::scatter(
    int lane, transport::Tree& tree, const transport::SurfaceHit& hit,
    const transport::Encounter& met, const transport::Medium& from, const transport::Medium& to,
    const transport::TransportSettings& settings) const noexcept {
    if (!met.consistent) ++tree.inconsistencies;
    transport::Branch at = tree.branch;
    at.throughput *= optics::transmittance(from.sigmaA, distance[lane]);
    at.skip = hit.triangle;
    const bool clear = hit.kind == transport::kDielectric;
    if (clear && from.eta == to.eta) {
        at.media = met.beyond;
        at.origin = transport::leavingFrom(position[lane], at.direction);
        at.footprint.originX = surfaceX[lane];
        at.footprint.originY = surfaceY[lane];
        tree.branch = at;
        return transport::noDeposits();
    }
    ++at.depth;
    transport::Scattering s =
        clear ? transport::Scattering{glm::vec3(R[lane]), 1.0f - R[lane], eta[lane]}
              : transport::opaqueScattering(hit, met.face, from.eta, settings.fresnel);
    const auto reflectedBranch = [&] { return goneOn(lane, at, reflected, s.R); };
    const auto refractedBranch = [&] {
        transport::Branch branch = goneOn(lane, at, refracted, glm::vec3(s.T));
        branch.media = met.beyond;
        return branch;
    };
    transport::Deposits deposits = transport::noDeposits();
    const int way =
        transport::wayOn(tree, s, transport::heaviness(at.throughput), settings.splitGain);
    if (way == transport::kReflects) {
        tree.branch = reflectedBranch();
    } else if (way == transport::kRefracts) {
        tree.branch = refractedBranch();
    } else {
        deposits = transport::splitBranch(tree, refractedBranch(), reflectedBranch(),
                                          settings.weightCutoff);
    }
    transport::endIfLight(tree, deposits, settings.weightCutoff);
    return deposits;
}

}  // namespace tukor::trace
