// Radiance on the sphere as spherical harmonics: where blurring is one multiplication per degree.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// The highest degree that double precision carries through the recurrences without underflow.
inline constexpr int kMaxDegree = 1600;

/// A panorama's radiance up to a degree, without its mean, which is kept beside it: so a constant
/// panorama stays exactly constant through everything.
///
/// The polar axis is +Y; the azimuth is 2 pi times the panorama's x. With the orthonormal P of
/// [Driscoll & Healy 1994],
///     L(x, theta) = mean + sum over l, m >= 0 of (m > 0 ? 2 : 1) Re(a_lm P_lm(cos theta) e^{i m
///     x}).
class Spectrum {
public:
    /// Real and imaginary part of each channel: r.re, r.im, g.re, ...
    using Coefficient = std::array<double, 6>;

    explicit Spectrum(int degree);

    [[nodiscard]] int degree() const noexcept { return degree_; }
    /// m in [0, degree], l in [m, degree]; consecutive in l.
    [[nodiscard]] Coefficient& at(int l, int m) noexcept { return coefficients_[index(l, m)]; }
    [[nodiscard]] const Coefficient& at(int l, int m) const noexcept {
        return coefficients_[index(l, m)];
    }

    glm::dvec3 mean{0.0};

private:
    [[nodiscard]] std::size_t index(int l, int m) const noexcept {
        const auto order = static_cast<std::size_t>(m);
        return order * static_cast<std::size_t>(degree_ + 1) - order * (order - 1) / 2 +
               static_cast<std::size_t>(l - m);
    }

    int degree_;
    std::vector<Coefficient> coefficients_;
};

/// The spectrum of a panorama whose pixels are areas of one value, integrated exactly but for
/// aliasing from beyond the degree. `degree` is at most kMaxDegree.
[[nodiscard]] Spectrum spectrumOf(const Image& panorama, int degree);

/// The radiance in the directions of a cube map's texel centres, each degree multiplied by
/// `factors[l]`; degrees beyond the end of `factors` are left out. Texels are not negative.
[[nodiscard]] CubeMap cubeFromSpectrum(const Spectrum& spectrum, std::span<const double> factors,
                                       int faceSize);

/// The same in the directions of the pixels of a panorama of height `height`, a power of two that
/// is more than the number of factors. Values may be negative where the spectrum is cut off
/// sharply.
[[nodiscard]] Image panoramaFromSpectrum(const Spectrum& spectrum, std::span<const double> factors,
                                         int height);

}  // namespace tukor
