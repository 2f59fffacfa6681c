#include "tukor/environment/harmonics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/environment/legendre.h"
#include "tukor/environment/lobe.h"

namespace tukor {

namespace {

constexpr double kPi = std::numbers::pi;

std::size_t indexOf(int l, int m) {
    return static_cast<std::size_t>(l * (l + 1) + m);
}

/// Weights of the rows of a panorama that integrate polynomials of degree below `height` in cos
/// theta exactly. Fejer's first rule. [Davis & Rabinowitz 1984, sec. 2.5.5]
std::vector<double> fejerWeights(int height) {
    std::vector<double> weights;
    for (int row = 0; row < height; ++row) {
        const double theta = kPi * (row + 0.5) / height;
        double sum = 1.0;
        for (int k = 1; k <= height / 2; ++k)
            sum -= 2.0 * std::cos(2 * k * theta) / (4.0 * k * k - 1.0);
        weights.push_back(2.0 / height * sum);
    }
    return weights;
}

Harmonics scaled(Harmonics harmonics, const std::vector<double>& factors) {
    for (int l = 0; l < harmonics.bands; ++l)
        for (int m = -l; m <= l; ++m)
            harmonics.coefficients[indexOf(l, m)] *= factors[static_cast<std::size_t>(l)];
    return harmonics;
}

}  // namespace

std::vector<double> harmonicBasis(int bands, glm::dvec3 direction) {
    std::vector<double> basis(static_cast<std::size_t>(bands) * static_cast<std::size_t>(bands));
    const std::complex<double> across(direction.x, direction.y);
    std::complex<double> turn(1.0);  // (x + iy)^m = sin^m theta e^{i m phi}
    double factor = std::sqrt(1.0 / (4.0 * kPi));
    for (int m = 0; m < bands; ++m) {
        if (m > 0) {
            turn *= across;
            factor *= std::sqrt((2.0 * m + 1.0) / (2.0 * m));
        }
        double p = factor, previous = 0.0;
        for (int l = m; l < bands; ++l) {
            const double scale = m > 0 ? std::numbers::sqrt2 * p : p;
            basis[indexOf(l, m)] = scale * turn.real();
            if (m > 0) basis[indexOf(l, -m)] = scale * turn.imag();
            const auto ratio = [m](double degree) {
                return std::sqrt((4 * degree * degree - 1) /
                                 (degree * degree - static_cast<double>(m) * m));
            };
            const double rise = ratio(l + 1), fall = l > m ? rise / ratio(l) : 0.0;
            const double next = rise * direction.z * p - fall * previous;
            previous = p;
            p = next;
        }
    }
    return basis;
}

Harmonics harmonicsOf(const Spectrum& spectrum, int bands) {
    TUKOR_ASSERT(bands >= 1 && bands <= kMaxBands && spectrum.degree() >= bands - 1);
    // The spectrum's poles are on the world's y, those of the basis on its z. Radiance cut off at
    // the last band is summed against the basis by a quadrature that is exact for their product.
    const int height = static_cast<int>(std::bit_ceil(static_cast<unsigned>(2 * bands)));
    const Image image = panoramaFromSpectrum(
        spectrum, std::vector<double>(static_cast<std::size_t>(bands), 1.0), height);
    const std::vector<double> weights = fejerWeights(height);
    Harmonics harmonics{bands, std::vector<glm::dvec3>(static_cast<std::size_t>(bands) *
                                                       static_cast<std::size_t>(bands))};
    // In pieces of fixed size, added up in order, so that sums do not depend on the threads.
    constexpr int kRows = 8;
    std::vector<std::vector<glm::dvec3>> pieces(
        static_cast<std::size_t>((height + kRows - 1) / kRows), harmonics.coefficients);
    parallelFor(0, static_cast<int>(pieces.size()), 1, [&](int begin, int end) {
        for (int row = begin * kRows; row < std::min(end * kRows, height); ++row) {
            std::vector<glm::dvec3>& sums = pieces[static_cast<std::size_t>(row / kRows)];
            const double theta = kPi * (row + 0.5) / height;
            const double weight = weights[static_cast<std::size_t>(row)] * kPi / height;
            for (int column = 0; column < 2 * height; ++column) {
                const double longitude = kPi * ((column + 0.5) / height - 1.0);
                const glm::dvec3 direction(std::sin(theta) * std::sin(longitude), std::cos(theta),
                                           -std::sin(theta) * std::cos(longitude));
                const std::vector<double> basis = harmonicBasis(bands, direction);
                const glm::dvec3 radiance =
                    weight * (glm::dvec3(image.at(column, row)) - spectrum.mean);
                for (std::size_t i = 0; i < basis.size(); ++i) sums[i] += basis[i] * radiance;
            }
        }
    });
    for (const std::vector<glm::dvec3>& sums : pieces)
        for (std::size_t i = 0; i < sums.size(); ++i) harmonics.coefficients[i] += sums[i];
    harmonics.coefficients[0] += spectrum.mean * std::sqrt(4.0 * kPi);
    return harmonics;
}

Harmonics irradianceOf(Harmonics radiance) {
    std::vector<double> factors = lobeFactors({LobeShape::lambert, 1.0}, radiance.bands);
    for (double& factor : factors) factor *= kPi;
    return scaled(std::move(radiance), factors);
}

Harmonics windowed(Harmonics harmonics, HarmonicWindow window) {
    std::vector<double> factors;
    for (int l = 0; l < harmonics.bands; ++l) {
        const double x = kPi * l / harmonics.bands;
        factors.push_back(window == HarmonicWindow::hann               ? 0.5 * (1.0 + std::cos(x))
                          : window == HarmonicWindow::lanczos && l > 0 ? std::sin(x) / x
                                                                       : 1.0);
    }
    return scaled(std::move(harmonics), factors);
}

glm::dvec3 valueOf(const Harmonics& harmonics, glm::dvec3 direction) {
    const std::vector<double> basis = harmonicBasis(harmonics.bands, direction);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < basis.size(); ++i) sum += basis[i] * harmonics.coefficients[i];
    return sum;
}

std::string jsonOf(const Harmonics& harmonics, std::string_view quantity) {
    std::string text = fmt::format(
        "{{\n  \"quantity\": \"{}\",\n  \"basis\": \"real, orthonormal, no Condon-Shortley sign, y "
        "up\",\n"
        "  \"bands\": {},\n  \"coefficients\": [\n",
        quantity, harmonics.bands);
    for (std::size_t i = 0; i < harmonics.coefficients.size(); ++i) {
        const glm::dvec3& c = harmonics.coefficients[i];
        text += fmt::format("    [{:.9g}, {:.9g}, {:.9g}]{}\n", c.x, c.y, c.z,
                            i + 1 < harmonics.coefficients.size() ? "," : "");
    }
    return text + "  ]\n}\n";
}

std::string cHeaderOf(const Harmonics& harmonics, std::string_view quantity,
                      std::string_view name) {
    std::string text = fmt::format(
        "// Spherical harmonics of {}, {} bands: real, orthonormal, no Condon-Shortley sign, y "
        "up.\n"
        "static const float {}[{}][3] = {{\n",
        quantity, harmonics.bands, name, harmonics.coefficients.size());
    for (int l = 0; l < harmonics.bands; ++l)
        for (int m = -l; m <= l; ++m) {
            const glm::dvec3& c = harmonics.coefficients[indexOf(l, m)];
            text += fmt::format("    {{{:#.9g}f, {:#.9g}f, {:#.9g}f}},  // L{},{}\n", c.x, c.y, c.z,
                                l, m);
        }
    return text + "};\n";
}

}  // namespace tukor
