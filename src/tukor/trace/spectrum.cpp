#include "tukor/trace/spectrum.h"

#include <algorithm>
#include <cmath>

namespace tukor::trace {

namespace {

constexpr float kShortest = 380.0f;

float lobe(float nm, float middle, float before, float after) noexcept {
    const float x = (nm - middle) / (nm < middle ? before : after);
    return std::exp(-0.5f * x * x);
}

/// The observer of CIE 1931. [Wyman, Sloan & Shirley 2013]
glm::vec3 xyzOf(float nm) noexcept {
    return {1.056f * lobe(nm, 599.8f, 37.9f, 31.0f) + 0.362f * lobe(nm, 442.0f, 16.0f, 26.7f) -
                0.065f * lobe(nm, 501.1f, 20.4f, 26.2f),
            0.821f * lobe(nm, 568.8f, 46.9f, 40.5f) + 0.286f * lobe(nm, 530.9f, 16.3f, 31.1f),
            1.217f * lobe(nm, 437.0f, 11.8f, 36.0f) + 0.681f * lobe(nm, 459.0f, 26.0f, 13.8f)};
}

/// Rec. 709's primaries.
glm::vec3 rgbOf(glm::vec3 xyz) noexcept {
    return {3.2406f * xyz.x - 1.5372f * xyz.y - 0.4986f * xyz.z,
            -0.9689f * xyz.x + 1.8758f * xyz.y + 0.0415f * xyz.z,
            0.0557f * xyz.x - 0.2040f * xyz.y + 1.0570f * xyz.z};
}

}  // namespace

Spectrum::Spectrum() {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kCells; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const float nm = kShortest + static_cast<float>(i) + 0.5f;
        response_[at] = glm::max(rgbOf(xyzOf(nm)), glm::vec3(0.0f));
        sum += glm::dvec3(response_[at]);
    }
    for (glm::vec3& r : response_) r = glm::vec3(glm::dvec3(r) / sum);
    double running = 0.0;
    sums_[0] = 0.0f;
    for (std::size_t i = 0; i < kCells; ++i) {
        running += static_cast<double>(response_[i].x + response_[i].y + response_[i].z) / 3.0;
        sums_[i + 1] = static_cast<float>(running);
    }
}

Wavelength Spectrum::sample(float u) const noexcept {
    const auto after = std::upper_bound(sums_.begin(), sums_.end(), u);
    const auto cell = static_cast<std::size_t>(
        std::clamp<long>(static_cast<long>(after - sums_.begin()) - 1, 0, kCells - 1));
    const float width = sums_[cell + 1] - sums_[cell];
    const float within = width > 0.0f ? std::clamp((u - sums_[cell]) / width, 0.0f, 1.0f) : 0.5f;
    const glm::vec3 r = response_[cell];
    return {kShortest + static_cast<float>(cell) + within, 3.0f * r / (r.x + r.y + r.z)};
}

}  // namespace tukor::trace
