// A picture in passes, each over the pixels that want more samples, in tiles on all cores.
#pragma once
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "tukor/trace/error_estimate.h"

namespace tukor::trace {

/// When to end.
struct PassGoals {
    std::uint32_t samples;        // the most that a pixel gets
    std::optional<double> error;  // expected RMSE in 8-bit sRGB
    std::optional<double> timeSeconds;
    bool beyondWhite = true;  // whether what displays do not show is to be as good
};

class Passes {
public:
    Passes(const Frame& frame, const PassGoals& goals, const RenderProgress& progress);

    /// Runs until a goal is met or `progress` says stop.
    void run();

    [[nodiscard]] const Accumulation& picture() const noexcept { return picture_; }
    [[nodiscard]] const ErrorEstimate& estimate() const noexcept { return estimate_; }
    [[nodiscard]] TraceCounts counts() const;

private:
    /// Doubles the samples of the active pixels; those without any get one.
    void pass();
    void tile(int number);
    /// Whether nothing but what lies behind the scene is seen in a pixel.
    [[nodiscard]] bool isSky(std::size_t pixel) const noexcept {
        return !frame_.silhouette.empty() && frame_.silhouette[pixel] == 0;
    }
    /// The places, evenly spread, that stand for `count` samples of a pixel of the sky.
    void addSkySamples(std::vector<CameraSample>& samples, glm::vec2 corner, int target,
                       std::uint32_t count) const;
    void report(double fraction);
    [[nodiscard]] double elapsed() const;
    [[nodiscard]] std::uint32_t samplesAfter(std::uint32_t now) const noexcept;
    [[nodiscard]] std::unique_ptr<PathPool> takePool();
    void returnPool(std::unique_ptr<PathPool> pool);

    const Frame& frame_;
    PassGoals goals_;
    int skyLookUps_;  // in a pixel where only the sky is seen, across and down
    const RenderProgress& progress_;
    Accumulation picture_;
    ErrorEstimate estimate_;
    std::chrono::steady_clock::time_point start_;
    std::atomic<bool> stop_ = false;
    std::atomic<std::uint64_t> samplesDone_ = 0;
    std::atomic<std::uint64_t> raysDone_ = 0;
    std::uint64_t samplesWanted_ = 0;  // of this pass and all before
    double fractionBefore_ = 0.0;      // of the whole work, at the beginning of the pass
    double fractionAfter_ = 1.0;
    double lastReport_ = -1.0;
    std::mutex mutex_;  // of pools_ and progress_
    std::vector<std::unique_ptr<PathPool>> pools_;
};

}  // namespace tukor::trace
