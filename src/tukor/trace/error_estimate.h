// How far a picture still is from its limit, and which pixels are worth more samples.
//
// Every doubling of a pixel's samples gives two means: of the samples before and of the new ones.
// For a mean of n samples whose variance falls as n^-p, the expected square of their difference is
// 4 (2^p - 1) times the variance of the mean of all; p itself shows in how the differences shrink
// from one doubling to the next. Derivation: docs/notes/adaptive-sampling.md.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "tukor/trace/path_pool.h"

namespace tukor::trace {

/// The picture under way: sums of samples and what is known of their error.
struct Accumulation {
    /// `transparent`: errors are those of the picture before black and before white, half each.
    /// `beyondWhite`: what displays do not show is to be as good as what they do.
    Accumulation(int w, int h, bool transparent = false, bool beyondWhite = true);

    /// Rays that a sample of the pixel takes.
    [[nodiscard]] float raysEach(std::size_t pixel) const noexcept {
        return samples[pixel] > 0 ? sums[pixel].rays / static_cast<float>(samples[pixel]) : 1.0f;
    }

    [[nodiscard]] glm::vec3 mean(std::size_t pixel) const noexcept {
        return samples[pixel] > 0 ? sums[pixel].radiance / static_cast<float>(samples[pixel])
                                  : glm::vec3(0.0f);
    }

    /// The expected square of how far off the pixel is because of what its wide look-ups saw: what
    /// is really there lies anywhere between none and all of it.
    [[nodiscard]] float doubt(std::size_t pixel) const noexcept;

    /// Adds `sum`, of `count` new samples, to a pixel.
    void add(std::size_t pixel, const PixelSum& sum, std::uint32_t count) noexcept;

    /// Counts what a pixel has as that of `count` samples: more would not change it.
    void settle(std::size_t pixel, std::uint32_t count) noexcept;

    int width;
    int height;
    bool transparent;
    bool beyondWhite;
    std::vector<PixelSum> sums;
    std::vector<std::uint32_t> samples;
    std::vector<float> halves;         // squared difference of the last two means, weighted so that
                                       // it is the variance of the mean for p = 1; -1: not known
    std::vector<float> halvesBefore;   // the same one doubling before
    std::vector<float> brightHalves;   // as halves, of codes that go on beyond white; empty
                                       // without `beyondWhite`
    std::vector<std::uint8_t> active;  // whether the last pass was for this pixel
};

/// 0 to 255 as displays encode it, not rounded; clipped.
[[nodiscard]] glm::vec3 srgbCode(glm::vec3 radiance) noexcept;

/// The same up to white, and beyond it its logarithm, as steep as the code is at white.
[[nodiscard]] glm::vec3 unclippedCode(glm::vec3 radiance) noexcept;

/// The state of a picture's error, in squared 8-bit sRGB codes.
class ErrorEstimate {
public:
    /// Call after each pass over the active pixels. Ignorant until the second sample.
    void update(const Accumulation& picture);

    /// Expected RMSE of the whole picture.
    [[nodiscard]] std::optional<double> rmse() const noexcept;
    /// The part of it that more samples take off.
    [[nodiscard]] std::optional<double> noise() const noexcept;
    /// How much of that an RMSE leaves room for; at least half of its square: where doubt alone is
    /// more, less noise would hardly be seen.
    [[nodiscard]] double noiseWithin(double rmse) const noexcept;

    /// Marks the pixels to double so that the noise falls to `target` with the fewest rays, and
    /// those brighter than white that are as far off in unclippedCode, where these count; false
    /// when there is none that may have more.
    bool chooseActive(Accumulation& picture, double target, std::uint32_t maxSamples) const;

    /// When the target is reached: marks those brighter than white that lag behind the others,
    /// where these count.
    bool chooseBright(Accumulation& picture, double target, std::uint32_t maxSamples) const;

private:
    /// In bins of worth: what half as many samples again take off.
    [[nodiscard]] int margin() const noexcept;
    /// The bin of the variance that one more ray for that pixel takes away, of `variance` that its
    /// mean has.
    [[nodiscard]] int binOf(const Accumulation& picture, const std::vector<float>& variance,
                            std::size_t pixel) const noexcept;
    /// Marks the pixels in that bin or higher; false if there are none.
    bool activate(Accumulation& picture, const std::vector<float>& variance, int least,
                  std::uint32_t maxSamples) const;

    std::vector<float> raw_;                 // variance of every pixel's mean, from its own samples
    std::vector<float> variance_;            // the same, averaged over its neighbourhood
    std::vector<float> rawBright_, bright_;  // the same of unclippedCode, or empty
    std::vector<float> rays_;                // that a sample takes, averaged likewise
    double sum_ = 0.0;                       // of raw_
    double doubt_ = 0.0;                     // of all pixels
    double decay_ = 1.15;                    // p
    bool known_ = false;
};

}  // namespace tukor::trace
