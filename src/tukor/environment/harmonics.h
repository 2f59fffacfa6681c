// Environments as a few real spherical harmonics: the diffuse light of engines.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tukor/base/options.h"
#include "tukor/environment/spectrum.h"

namespace tukor {

/// Bands that the quadrature behind harmonicsOf takes a second for.
inline constexpr int kMaxBands = 64;

/// Real orthonormal spherical harmonics in world axes, without the Condon-Shortley sign, as
/// [Ramamoorthi & Hanrahan 2001]: 0.282095, 0.488603 y, 0.488603 z, 0.488603 x, 1.092548 xy, ...
///
/// `coefficients[l * (l + 1) + m]` for l below `bands` and m from -l to l.
struct Harmonics {
    int bands = 0;
    std::vector<glm::dvec3> coefficients;
};

/// The basis functions at a unit direction, in the order of Harmonics.
[[nodiscard]] std::vector<double> harmonicBasis(int bands, glm::dvec3 direction);

/// Radiance. `bands` is in [1, kMaxBands], the spectrum's degree at least bands - 1.
[[nodiscard]] Harmonics harmonicsOf(const Spectrum& spectrum, int bands);

/// What a surface facing each direction receives: pi, 2 pi / 3, pi / 4, 0, ... times the bands.
[[nodiscard]] Harmonics irradianceOf(Harmonics radiance);

/// How bands fade towards the last, against ringing and negative light opposite a sun.
enum class HarmonicWindow { none, hann, lanczos };

inline constexpr std::array<std::pair<HarmonicWindow, std::string_view>, 3>
    kHarmonicWindowSpellings = {{{HarmonicWindow::none, "none"},
                                 {HarmonicWindow::hann, "hann"},
                                 {HarmonicWindow::lanczos, "lanczos"}}};

[[nodiscard]] Harmonics windowed(Harmonics harmonics, HarmonicWindow window);

/// The sum at a unit direction.
[[nodiscard]] glm::dvec3 valueOf(const Harmonics& harmonics, glm::dvec3 direction);

/// `quantity` says what they are: radiance or irradiance.
[[nodiscard]] std::string jsonOf(const Harmonics& harmonics, std::string_view quantity);
/// A C array `name` of float[3].
[[nodiscard]] std::string cHeaderOf(const Harmonics& harmonics, std::string_view quantity,
                                    std::string_view name);

}  // namespace tukor
