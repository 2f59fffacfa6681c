#include "tukor/trace/path_pool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "tukor/optics/spectrum.h"
#include "tukor/trace/rough_event.h"
#include "tukor/trace/rounding.h"
#include "tukor/transport/grazing.h"
#include "tukor/transport/look_ups.h"
#include "tukor/transport/sampler.h"

namespace tukor::trace {

namespace {

// Eight packets: enough to keep them full, few enough for the trees to stay in the second-level
// cache.
constexpr std::size_t kPaths = 64;

// New ones begin when so few are left: those that began together cast rays that are alike.
constexpr std::size_t kFewPaths = 16;

// Radians: a wider footprint, extrapolated from one path, may reach what its neighbours do not see.
constexpr float kTrusted = 0.06f;
// What is so many times as bright as white, on the mean over a wide footprint, comes of a lamp.
constexpr float kLamp = 16.0f;

// Of so many samples one may be faulty, and one more, for it to come of rounding.
constexpr std::size_t kSamplesPerFault = 256;

// By how much of the distance of neighbours faulty samples are moved.
constexpr float kAside = 1.0f / 256.0f;

}  // namespace

PathPool::PathPool(const Frame& frame) : frame_(frame), paths_(kPaths) {
    owed_.reserve(LookUpBatch::kRoom);
}

transport::Branch PathPool::cameraBranch(const CameraSample& sample,
                                         float distance) const noexcept {
    const glm::vec3 direction = frame_.camera.direction(sample.middle, sample.onLens);
    transport::Branch ray;
    ray.origin = frame_.camera.eye + frame_.camera.offset(sample.onLens);
    ray.direction = glm::normalize(direction);
    ray.throughput = glm::vec3(1.0f);
    ray.footprint = transport::cameraFootprint(direction, frame_.camera.perColumn * sample.size.x,
                                               frame_.camera.perRow * sample.size.y);
    if (sample.lensSize > 0.0f) {
        // What lies beyond the focus is seen the other way round over the lens: there the sample's
        // parts of the lens and of the pixel add up where the lens is taken the other way round.
        const RayGenerator& camera = frame_.camera;
        const float size = distance * dot(ray.direction, camera.forward) > camera.focus
                               ? -sample.lensSize
                               : sample.lensSize;
        ray.footprint.originX = size * camera.lensRight;
        ray.footprint.originY = -size * camera.lensUp;  // rows go down
        ray.footprint.directionX -= ray.footprint.originX / camera.focus;
        ray.footprint.directionY -= ray.footprint.originY / camera.focus;
    }
    ray.media = frame_.eyeMedia;
    ray.skip = -1;
    ray.depth = 0;
    return ray;
}

void PathPool::castCameraRays() {
    const std::span<const CameraSample> samples = samples_;
    firstHits_.clear();
    RayPacket packet;
    std::array<RayHit, kPacketWidth> hits;
    for (std::size_t begin = 0; begin < samples.size(); begin += kPacketWidth) {
        const auto count =
            static_cast<int>(std::min<std::size_t>(kPacketWidth, samples.size() - begin));
        for (int i = 0; i < count; ++i) {
            const CameraSample& s = samples[begin + static_cast<std::size_t>(i)];
            packet.set(i, frame_.camera.eye + frame_.camera.offset(s.onLens),
                       glm::normalize(frame_.camera.direction(s.middle, s.onLens)), -1);
        }
        frame_.caster.cast(packet, count, Coherence::rays, hits);
        for (int i = 0; i < count; ++i) {
            const auto sample = static_cast<std::uint32_t>(begin) + static_cast<std::uint32_t>(i);
            const RayHit& hit = hits[static_cast<std::size_t>(i)];
            if (hit.surface >= 0) {
                firstHits_.push_back({hit, sample});
                continue;
            }
            sums_[static_cast<std::size_t>(samples[sample].target)].rays += 1.0f;
            miss(samples[sample]);
        }
    }
    counts_.rays += samples.size();
}

void PathPool::miss(const CameraSample& sample) noexcept {
    if (!frame_.background) return;
    PixelSum& sum = sums_[static_cast<std::size_t>(sample.target)];
    const transport::Branch ray = cameraBranch(sample, std::numeric_limits<float>::infinity());
    const float solidAngle = transport::footprintSolidAngle(ray.footprint);
    if (frame_.backdrop) {
        sum.radiance += sample.weight * frame_.backdrop->radiance(ray.direction, solidAngle);
        return;
    }
    if (lookUps_.room() < 1) settle();
    owed_.push_back({glm::vec3(sample.weight), sample.target,
                     frame_.environment.add(lookUps_, ray.direction, solidAngle)});
}

[[gnu::noinline]] void PathPool::collect(const CameraSample& sample, const glm::vec3& throughput,
                                         const glm::vec3& direction, const glm::vec3& directionX,
                                         const glm::vec3& directionY) noexcept {
    const int most =
        transport::lookUpsWorth(transport::heaviness(throughput), transport::kMostLookUps);
    if (lookUps_.room() < most) settle();
    const int lookUps = frame_.environment.add(lookUps_, direction, directionX, directionY, most);
    const float width2 = std::max(dot(directionX, directionX), dot(directionY, directionY));
    owed_.push_back({throughput * (sample.weight / static_cast<float>(lookUps)), sample.target,
                     lookUps, width2 > kTrusted * kTrusted});
}

void PathPool::collect(const Path& path, const transport::Deposits& deposits) noexcept {
    const auto add = [&](const transport::Deposit& d) {
        collect(samples_[path.sample], d.throughput, d.direction, d.directionX, d.directionY);
    };
    if (deposits.count > 0) add(deposits.first);
    if (deposits.count > 1) add(deposits.second);
}

void PathPool::settle() noexcept {
    frame_.environment.look(lookUps_);
    int first = 0;
    for (const Owed& one : owed_) {
        PixelSum& sum = sums_[static_cast<std::size_t>(one.target)];
        const glm::vec3 found = lookUps_.sum(first, one.lookUps);
        sum.radiance += one.weight * found;
        if (one.wide) {
            const float usual = kLamp * static_cast<float>(one.lookUps);
            sum.doubtful += one.weight * max(found - usual, 0.0f);
        }
        first += one.lookUps;
    }
    lookUps_.count = 0;
    owed_.clear();
}

void PathPool::start(Path& path, const FirstHit& first) const noexcept {
    const CameraSample& sample = samples_[first.sample];
    // In its place: a tree is a thousand bytes, of which few mean anything yet.
    new (&path) Path{.tree = transport::startTree(cameraBranch(sample, first.hit.distance),
                                                  sample.sampler.pixelSeed, sample.sampler.index),
                     .sample = first.sample,
                     .sampler = sample.sampler};
    path.tree.rays = 1;
}

bool PathPool::wantsRay(Path& path) noexcept {
    while (path.tree.alive && transport::spent(path.tree, frame_.settings)) {
        const bool counted = std::exchange(path.chosen, {}).catching;
        const transport::Deposits deposits = transport::cutBranch(path.tree);
        if (!counted) collect(path, deposits);
    }
    return path.tree.alive;
}

void PathPool::finish(const Path& path) noexcept {
    if (path.grazing) {
        grazing_.push_back(path.sample);
        return;
    }
    if (retakes_ && path.tree.leaks + path.tree.inconsistencies > 0) faulty_.push_back(path.sample);
    const CameraSample& sample = samples_[path.sample];
    PixelSum& sum = sums_[static_cast<std::size_t>(sample.target)];
    sum.radiance += sample.weight * path.radiance;
    sum.coverage += sample.weight * path.covered;
    sum.rays += static_cast<float>(path.tree.rays);
    counts_.rays += static_cast<std::uint64_t>(path.tree.rays - 1);  // its first was counted before
    counts_.leaks += static_cast<std::uint64_t>(path.tree.leaks);
    counts_.inconsistencies += static_cast<std::uint64_t>(path.tree.inconsistencies);
    counts_.truncated += static_cast<std::uint64_t>(path.tree.truncated);
}

std::vector<CameraSample> PathPool::splitGrazing() const {
    std::vector<CameraSample> finer;
    finer.reserve(grazing_.size() * transport::kFinerSamples);
    for (const std::uint32_t number : grazing_) {
        const CameraSample& sample = samples_[number];
        for (std::uint32_t i = 0; i < transport::kFinerSamples; ++i) {
            const glm::vec2 place = transport::finerSample(sample.seed, i);
            CameraSample& one = finer.emplace_back(sample);
            one.middle += sample.size * place;
            one.size *= transport::kFinerWidth;
            one.sampler = {sample.seed, i};
            one.weight = sample.weight / static_cast<float>(transport::kFinerSamples);
        }
    }
    return finer;
}

void PathPool::trace(std::span<const CameraSample> samples, std::span<PixelSum> sums) {
    samples_ = samples;
    sums_ = sums;
    splits_ = frame_.splitGrazing;
    traceConsistently();
    if (grazing_.empty()) return;
    const std::vector<CameraSample> finer = splitGrazing();
    grazing_.clear();
    splits_ = false;
    samples_ = finer;
    traceConsistently();
}

void PathPool::lookPast(std::span<const CameraSample> samples, std::span<PixelSum> sums) {
    sums_ = sums;
    for (const CameraSample& sample : samples) {
        sums_[static_cast<std::size_t>(sample.target)].rays += sample.weight;
        miss(sample);
    }
    settle();
}

void PathPool::traceConsistently() {
    faulty_.clear();
    retakes_ = frame_.retakeFaulty;
    traceAll();
    retakes_ = false;
    if (faulty_.empty() || faulty_.size() > 1 + samples_.size() / kSamplesPerFault) return;
    std::vector<CameraSample> again;
    for (const std::uint32_t number : faulty_) again.push_back(samples_[number]);
    const bool splits = std::exchange(splits_, false);
    const std::span<const CameraSample> samples = std::exchange(samples_, again);
    // The same once more, to be taken from the sums, and from what was counted but for rays.
    for (CameraSample& one : again) one.weight = -one.weight;
    const TraceCounts before = counts_;
    traceAll();
    const auto takeBack = [](std::uint64_t& now, std::uint64_t then) {
        now = then - std::min(then, now - then);
    };
    takeBack(counts_.leaks, before.leaks);
    takeBack(counts_.inconsistencies, before.inconsistencies);
    takeBack(counts_.truncated, before.truncated);
    for (CameraSample& one : again) {
        one.weight = -one.weight;
        one.middle += kAside * one.size;
    }
    traceAll();
    samples_ = samples;
    splits_ = splits;
}

void PathPool::traceAll() {
    castCameraRays();

    // live[0 .. alive) number the paths under way, the rest of it those that are free.
    std::array<std::uint8_t, kPaths> live;
    std::iota(live.begin(), live.end(), std::uint8_t{0});
    std::size_t alive = 0;
    std::size_t next = 0;  // of the first hits
    const auto meetAll = [&](std::size_t begin, const std::array<RayHit, kPacketWidth>& hits,
                             std::size_t count) {
        meetTogether(std::span(live).subspan(begin, count), hits);
    };
    const auto keepUnended = [&](std::size_t begin) {
        for (std::size_t i = begin; i < alive;) {
            if (wantsRay(paths_[live[i]])) {
                ++i;
            } else {
                finish(paths_[live[i]]);
                std::swap(live[i], live[--alive]);
            }
        }
    };
    const auto refill = [&] {
        std::array<RayHit, kPacketWidth> hits;
        while (alive < kPaths && next < firstHits_.size()) {
            const std::size_t begin = alive;
            const std::size_t count =
                std::min({kPacketWidth + 0ul, kPaths - alive, firstHits_.size() - next});
            for (std::size_t i = 0; i < count; ++i) {
                const FirstHit& first = firstHits_[next++];
                start(paths_[live[alive++]], first);
                hits[i] = first.hit;
            }
            for (std::size_t i = next; i < std::min(next + kPacketWidth, firstHits_.size()); ++i)
                frame_.surfaces.prefetch(firstHits_[i].hit);
            meetAll(begin, hits, count);
            keepUnended(begin);
        }
    };

    RayPacket packet;
    // While a packet is cast, the triangles that the one before has met arrive in the cache.
    std::array<std::array<RayHit, kPacketWidth>, 2> both;
    for (refill(); alive > 0;) {
        for (std::size_t begin = 0; begin < alive; begin += kPacketWidth) {
            const std::size_t count = std::min<std::size_t>(kPacketWidth, alive - begin);
            for (std::size_t i = 0; i < count; ++i) {
                transport::Tree& tree = paths_[live[begin + i]].tree;
                packet.set(static_cast<int>(i), tree.branch.origin, tree.branch.direction,
                           tree.branch.skip);
                ++tree.rays;
            }
            auto& hits = both[begin / kPacketWidth % 2];
            const auto& before = both[(begin / kPacketWidth + 1) % 2];
            frame_.caster.cast(packet, static_cast<int>(count), Coherence::none, hits);
            for (std::size_t i = 0; i < count; ++i) frame_.surfaces.prefetch(hits[i]);
            if (begin > 0) meetAll(begin - kPacketWidth, before, kPacketWidth);
            if (begin + kPacketWidth >= alive) meetAll(begin, hits, count);
        }
        keepUnended(0);
        if (alive < kFewPaths) refill();
    }
    settle();
}

}  // namespace tukor::trace
