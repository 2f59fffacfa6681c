#include "tukor/optics/spectrum.h"

#include <algorithm>
#include <cmath>

namespace tukor::optics {

namespace {

constexpr float kShortest = 380.0f;
constexpr float kStep = 0.25f;  // nm
constexpr std::size_t kSteps = 1360;

/// A bell of other widths below and above its middle, all in nm; in X, Y or Z.
struct Lobe {
    int axis;
    float height, middle, below, above;
};

/// The observer of CIE 1931. [Wyman, Sloan & Shirley 2013]
constexpr Lobe kObserver[] = {{0, 1.056f, 599.8f, 37.9f, 31.0f},  {0, 0.362f, 442.0f, 16.0f, 26.7f},
                              {0, -0.065f, 501.1f, 20.4f, 26.2f}, {1, 0.821f, 568.8f, 46.9f, 40.5f},
                              {1, 0.286f, 530.9f, 16.3f, 31.1f},  {2, 1.217f, 437.0f, 11.8f, 36.0f},
                              {2, 0.681f, 459.0f, 26.0f, 13.8f}};

/// To Rec. 709's primaries, by columns.
constexpr glm::mat3 kRgbFromXyz{3.2406f,  -0.9689f, 0.0557f, -1.5372f, 1.8758f,
                                -0.2040f, -0.4986f, 0.0415f, 1.0570f};

glm::vec3 response(float nm) noexcept {
    glm::vec3 xyz(0.0f);
    for (const Lobe& lobe : kObserver) {
        const float x = (nm - lobe.middle) / (nm < lobe.middle ? lobe.below : lobe.above);
        xyz[lobe.axis] += lobe.height * std::exp(-0.5f * x * x);
    }
    return glm::max(kRgbFromXyz * xyz, glm::vec3(0.0f));
}

float meanOf(glm::vec3 v) noexcept {
    return (v.x + v.y + v.z) / 3.0f;
}

}  // namespace

Spectrum visibleSpectrum() {
    std::array<glm::vec3, kSteps + 1> shares;
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i <= kSteps; ++i) {
        shares[i] = response(kShortest + kStep * static_cast<float>(i));
        sum += shares[i];
    }
    // A part ends where the shares so far come to its number.
    Spectrum spectrum;
    glm::vec3 weights(0.0f);
    float before = 0.0f;
    std::size_t part = 0;
    for (std::size_t i = 0; i <= kSteps; ++i) {
        const glm::vec3 share = shares[i] / sum;
        const float mean = meanOf(share);
        while (part <= kSpectrumParts &&
               (before + mean >= static_cast<float>(part) / kSpectrumParts || i == kSteps)) {
            const float within =
                glm::clamp((static_cast<float>(part) / kSpectrumParts - before) / mean, 0.0f, 1.0f);
            spectrum[part] = {kShortest + kStep * (static_cast<float>(i) + within - 0.5f),
                              share / mean};
            weights += (part == 0 || part == kSpectrumParts ? 0.5f : 1.0f) * spectrum[part].weight;
            ++part;
        }
        before += mean;
    }
    // Exactly white, although it is linear between few places.
    for (Wavelength& w : spectrum) w.weight *= static_cast<float>(kSpectrumParts) / weights;
    return spectrum;
}

Wavelength wavelengthAt(const Spectrum& spectrum, float u) noexcept {
    const float place = u * kSpectrumParts;
    const auto part =
        static_cast<std::size_t>(std::clamp(static_cast<int>(place), 0, kSpectrumParts - 1));
    const float within = place - static_cast<float>(part);
    const Wavelength &a = spectrum[part], &b = spectrum[part + 1];
    return {glm::mix(a.nm, b.nm, within), glm::mix(a.weight, b.weight, within)};
}

}  // namespace tukor::optics
