// What the paths of a pool do where their rays have ended.
#include <utility>

#include "tukor/optics/spectrum.h"
#include "tukor/trace/path_pool.h"
#include "tukor/trace/rough_event.h"
#include "tukor/trace/rounding.h"
#include "tukor/transport/grazing.h"

namespace tukor::trace {

namespace {

float meanShare(glm::vec3 part, glm::vec3 whole) noexcept {
    const glm::vec3 share = part / whole;
    return (share.x + share.y + share.z) / 3.0f;
}

}  // namespace

[[gnu::always_inline]] inline transport::Medium PathPool::mediumOf(const Path& path,
                                                                   int number) const noexcept {
    return frame_.surfaces.medium(number, path.wavelength);
}

// Everything in one function: passed from one to another, a branch is written in single floats and
// read in vectors, for which the processor waits.
[[gnu::flatten, gnu::noinline]] void PathPool::meet(Path& path, const RayHit& found) noexcept {
    transport::Branch& ray = path.tree.branch;
    transport::SurfaceHit surface;
    transport::Encounter met;
    RayHit hit = found;
    if (hit.surface < 0 && ray.media != 0u) hit = withoutRounding(frame_, ray, hit);
    for (int i = 0; i < 2 && hit.surface >= 0; ++i) {
        surface = frame_.surfaces.at(hit, ray.origin, ray.direction);
        met = transport::encounter(ray, surface);
        if (met.consistent || i > 0) break;
        hit = withoutRounding(frame_, ray, hit);
    }
    path.grazing = splits_ && ray.skip < 0 && ray.depth == 0 && hit.surface >= 0 &&
                   transport::grazes(ray.footprint, ray.direction, surface, met.face);
    if (path.grazing) {
        path.tree.alive = false;
        return;
    }
    if (frame_.spectrum && hit.surface >= 0 && surface.kind == transport::kDielectric)
        disperse(path, met);
    if (frame_.rough && meetRough(path, hit, surface, met)) return;
    if (hit.surface < 0) {
        collect(path, transport::escape(path.tree));
    } else {
        collect(path, transport::scatter(path.tree, surface, met, mediumOf(path, met.from),
                                         mediumOf(path, met.to), frame_.settings));
    }
}

[[gnu::flatten, gnu::noinline]] void PathPool::meetTogether(
    std::span<const std::uint8_t> numbers, const std::array<RayHit, kPacketWidth>& hits) noexcept {
    if (frame_.rough || frame_.settings.fidelity != transport::kFidelityExact) {
        for (std::size_t i = 0; i < numbers.size(); ++i) meet(paths_[numbers[i]], hits[i]);
        return;
    }
    struct Met {
        Path* path;
        const RayHit* hit;
        transport::Encounter met;
    };
    std::array<Met, kPacketWidth> all;
    int count = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        Path& path = paths_[numbers[i]];
        const transport::Branch& ray = path.tree.branch;
        if (hits[i].surface < 0) {
            if (ray.media == 0u) {  // transport::escape, without a copy of what is seen
                collect(samples_[path.sample], ray.throughput, ray.direction,
                        ray.footprint.directionX, ray.footprint.directionY);
                transport::endBranch(path.tree);
            } else {
                meet(path, hits[i]);
            }
            continue;
        }
        lanes_.put(count, ray, frame_.surfaces.at(hits[i], ray.origin, ray.direction));
        all[static_cast<std::size_t>(count++)] = {&path, &hits[i], {}};
    }
    if (count == 0) return;
    lanes_.face();
    bool anyClear = false;
    for (int lane = 0; lane < count; ++lane) {
        Met& one = all[static_cast<std::size_t>(lane)];
        transport::SurfaceHit surface{};
        frame_.surfaces.describe(*one.hit, surface);
        one.met = transport::encounterAt(lanes_.facing(lane), one.path->tree.branch.media, surface);
        const bool clear = surface.kind == transport::kDielectric;
        anyClear = anyClear || clear;
        if (clear && frame_.spectrum) disperse(*one.path, one.met);
        lanes_.eta[lane] =
            clear ? mediumOf(*one.path, one.met.to).eta / mediumOf(*one.path, one.met.from).eta
                  : 1.0f;
    }
    lanes_.bend(anyClear, frame_.settings.fresnel);
    for (int lane = 0; lane < count; ++lane) {
        Met& one = all[static_cast<std::size_t>(lane)];
        Path& path = *one.path;
        if (!one.met.consistent) {  // rounding perhaps
            meet(path, *one.hit);
            continue;
        }
        transport::SurfaceHit surface{};
        frame_.surfaces.describe(*one.hit, surface);
        const transport::Branch& ray = path.tree.branch;
        path.grazing = splits_ && ray.skip < 0 && ray.depth == 0 &&
                       surface.kind == transport::kDielectric && lanes_.bendsAway[lane] != 0;
        if (path.grazing) {
            path.tree.alive = false;
        } else {
            collect(path,
                    lanes_.scatter(lane, path.tree, surface, one.met, mediumOf(path, one.met.from),
                                   mediumOf(path, one.met.to), frame_.settings));
        }
    }
}

[[gnu::noinline]] void PathPool::disperse(Path& path,
                                          const transport::Encounter& met) const noexcept {
    const SurfaceTable& surfaces = frame_.surfaces;
    if (path.wavelength > 0.0f || !(surfaces.disperses(met.from) || surfaces.disperses(met.to)))
        return;
    const optics::Wavelength chosen = optics::wavelengthAt(
        *frame_.spectrum, transport::spectrumSample(path.sampler.pixelSeed, path.sampler.index));
    path.wavelength = chosen.nm;
    transport::filterTree(path.tree, chosen.weight);
}

[[gnu::noinline]] bool PathPool::meetRough(Path& path, const RayHit& hit,
                                           const transport::SurfaceHit& surface,
                                           const transport::Encounter& met) const noexcept {
    if (path.chosen.catching) {  // what arrives from there unhindered was counted: not this
        path.chosen.catching = false;
        const glm::vec3 behind = std::exchange(path.chosen.behind, glm::vec3(0.0f));
        if (hit.surface < 0) {
            path.chosen.pdf = 0.0f;
            (void)transport::escape(path.tree);
            return true;
        }
        const glm::vec3 hidden = frame_.rough->escape(path.tree.branch, path.chosen);
        if (behind != glm::vec3(0.0f)) {
            path.covered += meanShare(hidden, behind);
        } else {
            path.radiance -= hidden;
        }
    }
    if (frame_.rough->concerns(hit)) {
        const glm::vec3 found = frame_.rough->meet(
            path.tree, hit, surface, met, {mediumOf(path, met.from), mediumOf(path, met.to)},
            path.sampler, path.chosen);
        if (path.chosen.behind != glm::vec3(0.0f)) {
            path.covered = meanShare(-found, path.chosen.behind);
        } else {
            path.radiance += found;
        }
        return true;
    }
    const Chosen chosen = std::exchange(path.chosen, {});
    if (hit.surface >= 0 || chosen.pdf <= 0.0f) return false;
    path.radiance += frame_.rough->escape(path.tree.branch, chosen);
    (void)transport::escape(path.tree);
    return true;
}

}  // namespace tukor::trace
