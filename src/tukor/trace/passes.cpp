#include "tukor/trace/passes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"
#include "tukor/transport/look_ups.h"
#include "tukor/transport/sampler.h"

namespace tukor::trace {

namespace {

constexpr int kTile = 16;
// Camera samples traced together: a tile at 16 samples a pixel; keeps the sums of longer passes in
// the cache.
constexpr std::size_t kBatch = 4096;

/// How many look-ups, in each direction, show what is in a pixel of the sky: so many to the texel,
/// for the sky bends at texels. The square of their distance is the error: with four to the texel
/// about 0.13 codes under photographs, so an error of E wants 4 / sqrt(E). Where texels are smaller
/// than the pixel each is a mean over its part. At least two, for one is up to 0.45 codes off,
/// which previews take.
int skyLookUpsAcross(const Frame& frame, const PassGoals& goals) {
    const EnvironmentMap& seen = frame.backdrop ? *frame.backdrop : frame.environment;
    const RayGenerator& camera = frame.camera;
    const glm::vec3 ahead = camera.direction(0.5f * static_cast<float>(frame.width),
                                             0.5f * static_cast<float>(frame.height));
    const float distance = length(ahead);  // of the widest pixel, that in the middle
    const float solidAngle = std::abs(dot(ahead, cross(camera.perColumn, camera.perRow))) /
                             (distance * distance * distance);
    const float texels = std::sqrt(seen.texelsPerSteradian() * solidAngle);
    const float across = std::sqrt(static_cast<float>(goals.samples));
    const float each = goals.error         ? 4.0f / std::sqrt(static_cast<float>(*goals.error))
                       : goals.timeSeconds ? 4.0f
                                           : 0.5f * std::max(across, 8.0f);
    const float wanted = std::clamp(each, 1.0f, 16.0f) * std::min(texels, 1.0f);
    const bool preview = goals.error && *goals.error >= 3.0;
    return static_cast<int>(std::min(
        preview ? std::max(std::round(wanted), 1.0f) : std::max(std::ceil(wanted), 2.0f), across));
}

}  // namespace

Passes::Passes(const Frame& frame, const PassGoals& goals, const RenderProgress& progress)
    : frame_(frame),
      goals_(goals),
      skyLookUps_(skyLookUpsAcross(frame, goals)),
      progress_(progress),
      picture_(frame.width, frame.height, !frame.background, goals.beyondWhite),
      start_(std::chrono::steady_clock::now()) {}

double Passes::elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::uint32_t Passes::samplesAfter(std::uint32_t now) const noexcept {
    return std::min(std::max(2 * now, 1u), goals_.samples);
}

std::unique_ptr<PathPool> Passes::takePool() {
    const std::lock_guard lock(mutex_);
    if (pools_.empty()) return std::make_unique<PathPool>(frame_);
    std::unique_ptr<PathPool> pool = std::move(pools_.back());
    pools_.pop_back();
    return pool;
}

void Passes::returnPool(std::unique_ptr<PathPool> pool) {
    const std::lock_guard lock(mutex_);
    pools_.push_back(std::move(pool));
}

TraceCounts Passes::counts() const {
    TraceCounts counts;
    for (const auto& pool : pools_) counts.add(pool->counts());
    return counts;
}

void Passes::report(double fraction) {
    if (!progress_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || elapsed() < lastReport_ + 0.05) return;  // 20 times a second are enough for eyes
    lastReport_ = elapsed();
    if (!progress_(static_cast<float>(std::clamp(fraction, 0.0, 1.0)), raysDone_)) stop_ = true;
}

void Passes::tile(int number) {
    const int across = (frame_.width + kTile - 1) / kTile;
    const int left = number % across * kTile, top = number / across * kTile;
    const int right = std::min(left + kTile, frame_.width);
    const int bottom = std::min(top + kTile, frame_.height);

    struct Job {
        std::size_t pixel;
        int x, y;
        std::uint32_t from, to;
    };
    std::vector<Job> jobs;
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) +
                static_cast<std::size_t>(x);
            const std::uint32_t from = picture_.samples[pixel];
            if (!picture_.active[pixel] || samplesAfter(from) <= from) continue;
            if (isSky(pixel) && from > 0) {
                samplesDone_ += samplesAfter(from) - from;
                picture_.settle(pixel, samplesAfter(from));
            } else {
                jobs.push_back({pixel, x, y, from, samplesAfter(from)});
            }
        }
    }
    if (jobs.empty()) return;

    std::unique_ptr<PathPool> pool = takePool();
    const std::uint64_t raysBefore = pool->counts().rays;
    std::vector<PixelSum> sums(jobs.size());
    std::vector<CameraSample> batch, sky;
    batch.reserve(kBatch);
    const auto flush = [&] {
        pool->trace(batch, sums);
        batch.clear();
    };
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const Job& job = jobs[i];
        const auto target = static_cast<int>(i);
        const glm::vec2 corner(job.x, job.y);
        samplesDone_ += job.to - job.from;
        if (isSky(job.pixel)) {
            addSkySamples(sky, corner, target, job.to - job.from);
            continue;
        }
        const std::uint32_t seed =
            transport::pixelSeed(static_cast<std::uint32_t>(job.pixel), frame_.seed);
        // Pictures of fixed samples are as sharp as these allow; otherwise at least as four do.
        const std::uint32_t density =
            goals_.error || goals_.timeSeconds ? std::max(job.to, 4u) : goals_.samples;
        const float width = transport::kSampleFootprint / std::sqrt(static_cast<float>(density));
        for (std::uint32_t s = job.from; s < job.to; ++s) {
            const transport::PixelPart part =
                goals_.samples == 1 ? transport::PixelPart{glm::vec2(0.5f), glm::vec2(width)}
                                    : transport::pixelPart(seed, s, width);
            CameraSample& sample =
                batch.emplace_back(CameraSample{.middle = corner + part.middle,
                                                .size = part.size,
                                                .target = target,
                                                .seed = transport::sampleSeed(seed, s),
                                                .sampler = {seed, s}});
            if (frame_.camera.hasLens()) {
                sample.onLens = onLens(lensSample(seed, s));
                sample.lensSize = std::sqrt(std::numbers::pi_v<float>) * width;
            }
            if (batch.size() == kBatch) flush();
        }
    }
    if (!batch.empty()) flush();
    pool->lookPast(sky, sums);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        picture_.add(jobs[i].pixel, sums[i], jobs[i].to - jobs[i].from);
    }
    raysDone_ += pool->counts().rays - raysBefore;
    returnPool(std::move(pool));
}

void Passes::addSkySamples(std::vector<CameraSample>& samples, glm::vec2 corner, int target,
                           std::uint32_t count) const {
    const auto across = static_cast<float>(skyLookUps_);
    CameraSample sample{};
    sample.size = glm::vec2(transport::kSampleFootprint / across);
    sample.target = target;
    sample.weight = static_cast<float>(count) / (across * across);
    for (int row = 0; row < skyLookUps_; ++row) {
        for (int column = 0; column < skyLookUps_; ++column) {
            sample.middle = corner + (glm::vec2(column, row) + 0.5f) / across;
            samples.push_back(sample);
        }
    }
}

void Passes::pass() {
    for (std::size_t i = 0; i < picture_.samples.size(); ++i) {
        if (picture_.active[i]) {
            samplesWanted_ += samplesAfter(picture_.samples[i]) - picture_.samples[i];
        }
    }
    const std::uint64_t before = samplesDone_;
    const double span = static_cast<double>(std::max<std::uint64_t>(samplesWanted_ - before, 1));
    const int across = (frame_.width + kTile - 1) / kTile;
    const int down = (frame_.height + kTile - 1) / kTile;
    parallelFor(0, across * down, 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            if (stop_) return;
            if (goals_.timeSeconds && elapsed() > *goals_.timeSeconds) {
                stop_ = true;
                return;
            }
            tile(i);
            const double done = static_cast<double>(samplesDone_ - before) / span;
            report(fractionBefore_ + (fractionAfter_ - fractionBefore_) * done);
        }
    });
    if (!stop_) estimate_.update(picture_);
}

void Passes::run() {
    const double all = static_cast<double>(picture_.samples.size()) * goals_.samples;
    std::uint32_t each = 0;  // samples that every pixel has at least
    while (!stop_) {
        fractionBefore_ = fractionAfter_ < 1.0 ? fractionAfter_ : 0.0;
        const std::optional<double> noise = estimate_.noise();
        // Against the clock: a little better each time.
        const double target =
            goals_.error ? estimate_.noiseWithin(*goals_.error) : noise.value_or(0.0) / 1.5;
        if (each < std::min(2u, goals_.samples) || (!goals_.error && !goals_.timeSeconds)) {
            if (each >= goals_.samples) break;
            each = samplesAfter(each);
        } else {
            const bool more = goals_.error && noise && *noise <= target
                                  ? estimate_.chooseBright(picture_, target, goals_.samples)
                                  : estimate_.chooseActive(picture_, target, goals_.samples);
            if (!more) break;
        }
        if (goals_.error) {
            // Work grows about as noise^-1.5.
            fractionAfter_ = noise ? std::pow(target / std::max(*noise / 1.6, 1e-6), 1.5) : 0.01;
        } else {
            fractionAfter_ = static_cast<double>(picture_.samples.size()) * each / all;
        }
        if (goals_.timeSeconds) {
            fractionAfter_ = std::max(fractionAfter_, elapsed() / *goals_.timeSeconds);
        }
        fractionAfter_ = std::clamp(fractionAfter_, fractionBefore_, 0.999);
        pass();
    }
    if (progress_ && !stop_) (void)progress_(1.0f, raysDone_);
}

}  // namespace tukor::trace
