// Wavelengths, and what light of one wavelength counts in red, green and blue.
#pragma once
#include <array>

#include <glm/glm.hpp>

namespace tukor::optics {

/// A wavelength in nm with its weight: their mean over all samples is 1 for each channel.
struct Wavelength {
    float nm = 0.0f;
    glm::vec3 weight{1.0f};
};

inline constexpr int kSpectrumParts = 64;  // traced.frag has as many

/// The visible spectrum, 380 to 720 nm, in shares of red, green and blue: cut into parts of which
/// each counts as much in the mean of the channels. Between their ends it is linear.
///
/// White light of equal energy is white: each channel's response integrates to 1. Spectral colours
/// outside of Rec. 709 lose what would be negative. A coloured light is taken as having the
/// spectrum of white in each channel: right for grey light, near for the colours of photographs.
using Spectrum = std::array<Wavelength, kSpectrumParts + 1>;

[[nodiscard]] Spectrum visibleSpectrum();

/// For uniform `u` in [0, 1), in proportion to the mean of the channels. No weight is above 3.1.
[[nodiscard]] Wavelength wavelengthAt(const Spectrum& spectrum, float u) noexcept;

}  // namespace tukor::optics
