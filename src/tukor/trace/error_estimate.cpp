#include "tukor/trace/error_estimate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace tukor::trace {

namespace {

/// A histogram of the variance that one more ray would take away: eight bins to the octave, those
/// of a float's exponent and the first three bits behind it.
constexpr int kBins = 512;
constexpr int kBinsPerOctave = 8;
constexpr int kBitsBelow = 20;
constexpr int kLeast = std::bit_cast<int>(0x1p-48f) >> kBitsBelow;

int binOfWorth(float worth) {
    return std::clamp((std::bit_cast<int>(worth) >> kBitsBelow) - kLeast, 0, kBins - 1);
}

float worthOf(int bin) {  // its middle
    return std::bit_cast<float>(((bin + kLeast) << kBitsBelow) + (1 << (kBitsBelow - 1)));
}

/// Of a radiance of at most white.
float codeOf(float x) {
    // Roots instead of a power: within 0.3 of a code, and differences matter here, not codes.
    const float s1 = std::sqrt(x), s2 = std::sqrt(s1), s3 = std::sqrt(s2);
    const float curve =
        0.662002687f * s1 + 0.684122060f * s2 - 0.323583601f * s3 - 0.0225411470f * x;
    return 255.0f * (x <= 0.0031308f ? 12.92f * x : curve);
}

constexpr float kSlopeAtWhite = 255.0f * 1.055f / 2.4f;

/// The square of the distance of two colours in codes, and of codes that go on beyond white.
struct Step {
    float shown, bright;
};

Step stepOf(glm::vec3 before, glm::vec3 now) noexcept {
    before = unclippedCode(before);
    now = unclippedCode(now);
    const glm::vec3 bright = before - now, shown = min(before, 255.0f) - min(now, 255.0f);
    return {dot(shown, shown), dot(bright, bright)};
}

constexpr int kReach = 2;

/// Sums over 5 values in a row, for every place of a line; fewer at its ends.
void boxLine(const float* in, float* out, int count) {
    float sum = 0.0f;
    for (int i = 0; i < std::min(kReach, count); ++i) sum += in[i];
    for (int i = 0; i < count; ++i) {
        if (i + kReach < count) sum += in[i + kReach];
        if (i - kReach - 1 >= 0) sum -= in[i - kReach - 1];
        out[i] = sum;
    }
}

/// Means over 5 x 5 pixels, of what is not negative. `lines` is for what comes between.
void smooth(std::vector<float>& values, int w, int h, std::vector<float>& lines) {
    lines.resize(values.size());
    const auto width = static_cast<std::size_t>(w);
    const auto line = [&](int y) { return &lines[static_cast<std::size_t>(y) * width]; };
    for (int y = 0; y < h; ++y) boxLine(&values[static_cast<std::size_t>(y) * width], line(y), w);
    // Down all columns at once, as memory lies.
    std::vector<float> sums(width, 0.0f);
    const auto take = [&](const float* from, float sign) {
        for (std::size_t x = 0; x < width; ++x) sums[x] += sign * from[x];
    };
    for (int y = 0; y < std::min(kReach, h); ++y) take(line(y), 1.0f);
    for (int y = 0; y < h; ++y) {
        if (y + kReach < h) take(line(y + kReach), 1.0f);
        if (y - kReach - 1 >= 0) take(line(y - kReach - 1), -1.0f);
        float* out = &values[static_cast<std::size_t>(y) * width];
        for (std::size_t x = 0; x < width; ++x) out[x] = std::max(sums[x], 0.0f) / 25.0f;
    }
}

}  // namespace

glm::vec3 srgbCode(glm::vec3 radiance) noexcept {
    glm::vec3 code;
    for (int c = 0; c < 3; ++c) code[c] = codeOf(std::clamp(radiance[c], 0.0f, 1.0f));
    return code;
}

glm::vec3 unclippedCode(glm::vec3 radiance) noexcept {
    glm::vec3 code = srgbCode(radiance);
    for (int c = 0; c < 3; ++c)
        if (radiance[c] > 1.0f) code[c] += kSlopeAtWhite * std::log(radiance[c]);
    return code;
}

Accumulation::Accumulation(int w, int h, bool isTransparent, bool isBeyondWhite)
    : width(w), height(h), transparent(isTransparent), beyondWhite(isBeyondWhite) {
    const std::size_t count = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
    sums.resize(count);
    samples.assign(count, 0);
    halves.assign(count, -1.0f);
    halvesBefore.assign(count, -1.0f);
    if (beyondWhite) brightHalves.assign(count, -1.0f);
    active.assign(count, 1);
}

void Accumulation::add(std::size_t pixel, const PixelSum& sum, std::uint32_t count) noexcept {
    if (count == 0) return;
    const auto a = static_cast<float>(samples[pixel]), b = static_cast<float>(count);
    if (samples[pixel] > 0) {
        const float share = a * b / (3.0f * (a + b) * (a + b));
        Step step = stepOf(mean(pixel), sum.radiance / b);
        if (transparent) {
            const float clear = 1.0f - sums[pixel].coverage / a, clearNow = 1.0f - sum.coverage / b;
            const Step other = stepOf(mean(pixel) + clear, sum.radiance / b + clearNow);
            step.shown = 0.5f * (step.shown + other.shown);
            step.bright = 0.5f * (step.bright + other.bright);
        }
        halvesBefore[pixel] = halves[pixel];
        halves[pixel] = step.shown * share;
        if (beyondWhite) brightHalves[pixel] = step.bright * share;
    }
    sums[pixel].radiance += sum.radiance;
    sums[pixel].doubtful += sum.doubtful;
    sums[pixel].coverage += sum.coverage;
    sums[pixel].rays += sum.rays;
    samples[pixel] += count;
}

void Accumulation::settle(std::size_t pixel, std::uint32_t count) noexcept {
    PixelSum& sum = sums[pixel];
    const float scale = static_cast<float>(count) / static_cast<float>(samples[pixel]);
    sum = {scale * sum.radiance, scale * sum.coverage, scale * sum.rays, scale * sum.doubtful};
    samples[pixel] = count;
    halves[pixel] = 0.0f;
    if (beyondWhite) brightHalves[pixel] = 0.0f;
    halvesBefore[pixel] = -1.0f;  // tells nothing of how other pixels' differences shrink
}

float Accumulation::doubt(std::size_t pixel) const noexcept {
    if (sums[pixel].doubtful == glm::vec3(0.0f)) return 0.0f;
    const glm::vec3 all = mean(pixel);
    const glm::vec3 rest = all - sums[pixel].doubtful / static_cast<float>(samples[pixel]);
    const glm::vec3 step = srgbCode(all) - srgbCode(rest);
    return dot(step, step) / 9.0f;  // a third of the square, of the mean of three channels
}

void ErrorEstimate::update(const Accumulation& picture) {
    double now = 0.0, before = 0.0, first = 0.0;
    for (std::size_t i = 0; i < picture.samples.size(); ++i) {
        if (!picture.active[i] || picture.halves[i] < 0.0f) continue;
        first += 1.0;
        if (picture.halvesBefore[i] < 0.0f) continue;
        now += picture.halves[i];
        before += picture.halvesBefore[i];
    }
    if (first == 0.0) return;
    if (before > 0.0 && now > 0.0) decay_ = std::clamp(std::log2(before / now), 1.0, 3.0);
    const auto scale = static_cast<float>(1.0 / (std::exp2(decay_) - 1.0));
    const std::size_t count = picture.samples.size();
    raw_.resize(count, 0.0f);
    if (picture.beyondWhite) rawBright_.resize(count, 0.0f);
    rays_.resize(count);
    sum_ = 0.0;
    doubt_ = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        if (picture.active[i] && picture.halves[i] >= 0.0f) {
            raw_[i] = picture.halves[i] * scale;
            if (picture.beyondWhite) rawBright_[i] = picture.brightHalves[i] * scale;
        }
        sum_ += raw_[i];
        doubt_ += picture.doubt(i);
        rays_[i] = picture.raysEach(i);
    }
    known_ = true;
    std::vector<float> lines;
    variance_ = raw_;
    bright_ = rawBright_;
    for (std::vector<float>* values : {&variance_, &bright_, &rays_})
        if (!values->empty()) smooth(*values, picture.width, picture.height, lines);
}

std::optional<double> ErrorEstimate::rmse() const noexcept {
    if (!known_ || variance_.empty()) return std::nullopt;
    return std::sqrt((sum_ + doubt_) / static_cast<double>(variance_.size()));
}

std::optional<double> ErrorEstimate::noise() const noexcept {
    if (!known_ || variance_.empty()) return std::nullopt;
    return std::sqrt(sum_ / static_cast<double>(variance_.size()));
}

double ErrorEstimate::noiseWithin(double rmse) const noexcept {
    const double doubt = doubt_ / static_cast<double>(std::max<std::size_t>(variance_.size(), 1));
    return std::sqrt(std::max(rmse * rmse - doubt, 0.5 * rmse * rmse));
}

bool ErrorEstimate::chooseActive(Accumulation& picture, double target,
                                 std::uint32_t maxSamples) const {
    const std::size_t count = picture.samples.size();
    std::array<double, kBins> variance{};
    for (std::size_t i = 0; i < count; ++i)
        variance[static_cast<std::size_t>(binOf(picture, variance_, i))] += variance_[i];
    // The cheapest way to a sum of variances: all pixels are worth the same per ray in the end.
    const double goal = target * target * static_cast<double>(count);
    // What is worth more than the threshold falls to (threshold / worth)^power of its variance.
    const double power = decay_ / (decay_ + 1.0);
    std::array<double, kBins> powers;
    for (std::size_t bin = 0; bin < kBins; ++bin)
        powers[bin] = std::pow(worthOf(static_cast<int>(bin)), power);
    int threshold = kBins - 1;
    for (; threshold > 0; --threshold) {
        const double least = powers[static_cast<std::size_t>(threshold)];
        double left = 0.0;
        for (std::size_t bin = 0; bin < kBins; ++bin)
            left += variance[bin] * std::min(least / powers[bin], 1.0);
        if (left <= goal) break;
    }
    // Those that need at least half as many again; if there are none, so many as it takes.
    const std::vector<float>& wanted = picture.beyondWhite ? bright_ : variance_;
    if (activate(picture, wanted, threshold + margin(), maxSamples)) return true;
    // Where some may not have what they need, the others still do their own share alone.
    for (std::size_t i = 0; i < count; ++i)
        if (picture.samples[i] >= maxSamples && binOf(picture, variance_, i) >= threshold)
            return activate(picture, wanted, threshold, maxSamples);
    const double gained = 1.0 - std::exp2(-decay_);  // by doubling, of a variance
    double left = sum_;
    int least = kBins - 1;
    for (; least > 0; --least) {
        left -= gained * variance[static_cast<std::size_t>(least)];
        if (left < goal) break;
    }
    for (; least >= 0; least -= margin())
        if (activate(picture, wanted, least, maxSamples)) return true;
    return activate(picture, wanted, 0, maxSamples);
}

bool ErrorEstimate::chooseBright(Accumulation& picture, double target,
                                 std::uint32_t maxSamples) const {
    if (!picture.beyondWhite) return false;
    std::vector<float> beyond = bright_;
    double rays = 0.0;
    for (std::size_t i = 0; i < beyond.size(); ++i) {
        beyond[i] -= variance_[i];
        rays += picture.sums[i].rays;
    }
    const double typical = target * target * static_cast<double>(beyond.size()) / rays;
    return activate(picture, beyond, binOfWorth(static_cast<float>(typical)) + margin(),
                    maxSamples);
}

int ErrorEstimate::binOf(const Accumulation& picture, const std::vector<float>& variance,
                         std::size_t pixel) const noexcept {
    const float n = static_cast<float>(std::max(picture.samples[pixel], 1u));
    return binOfWorth(variance[pixel] / (n * rays_[pixel]));
}

int ErrorEstimate::margin() const noexcept {
    return static_cast<int>(0.5 * (decay_ + 1.0) * kBinsPerOctave);
}

bool ErrorEstimate::activate(Accumulation& picture, const std::vector<float>& variance, int least,
                             std::uint32_t maxSamples) const {
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < variance.size(); ++i) {
        const bool more = variance[i] > 0.0f && picture.samples[i] < maxSamples &&
                          binOf(picture, variance, i) >= least;
        picture.active[i] = more;
        chosen += more;
    }
    return chosen > 0;
}

}  // namespace tukor::trace
