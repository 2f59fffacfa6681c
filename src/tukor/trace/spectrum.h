// Wavelengths, and what light of one wavelength counts in red, green and blue.
#pragma once
#include <array>

#include <glm/glm.hpp>

namespace tukor::trace {

/// A wavelength in nm with its weight: their mean over all samples is 1 for each channel.
struct Wavelength {
    float nm = 0.0f;
    glm::vec3 weight{1.0f};
};

/// The visible spectrum, 380 to 720 nm, in shares of red, green and blue.
///
/// White light of equal energy is white: each channel's response integrates to 1. Spectral colours
/// outside of Rec. 709 lose what would be negative. A coloured light is taken as having the
/// spectrum of white in each channel: right for grey light, near for the colours of photographs.
class Spectrum {
public:
    Spectrum();

    /// For uniform `u` in [0, 1), in proportion to the mean of the channels. No weight is above 3.
    [[nodiscard]] Wavelength sample(float u) const noexcept;

private:
    static constexpr int kCells = 340;
    std::array<glm::vec3, kCells> response_;  // of cells of a nm
    std::array<float, kCells + 1> sums_;      // running, of their means; the last is 1
};

}  // namespace tukor::trace
