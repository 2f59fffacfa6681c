#include "tukor/environment/lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"
#include "tukor/environment/spectrum.h"

namespace tukor {

double lobeWeight(const Lobe& lobe, double cosTheta) noexcept {
    if (cosTheta <= 0.0) return 0.0;
    const double cosHalf2 = 0.5 * (1.0 + cosTheta);  // squared cosine to the half vector
    switch (lobe.shape) {
        case LobeShape::ggx: {
            const double a2 = lobe.alpha * lobe.alpha;
            const double f = (a2 - 1.0) * cosHalf2 + 1.0;
            return a2 / (f * f) * cosTheta;
        }
        case LobeShape::charlie:
            return std::pow(1.0 - cosHalf2, 0.5 / lobe.alpha) * cosTheta;
        default:
            return cosTheta;
    }
}

std::vector<double> lobeFactors(const Lobe& lobe, int degree) {
    std::vector<double> factors(static_cast<std::size_t>(degree) + 1, 0.0);
    if (lobe.shape == LobeShape::gaussian) {
        for (int l = 0; l <= degree; ++l)
            factors[static_cast<std::size_t>(l)] =
                std::exp(-0.5 * l * (l + 1.0) * lobe.alpha * lobe.alpha);
        return factors;
    }
    // The midpoint rule in s with theta = pi/2 s^3: points crowd where sharp lobes have their
    // weight.
    const int points = 8 * degree + 4000;
    constexpr int kPieces = 16;  // fixed, so that sums do not depend on the number of threads
    std::vector<std::vector<double>> partial(kPieces, factors);
    parallelFor(0, kPieces, 1, [&](int begin, int end) {
        for (int piece = begin; piece < end; ++piece) {
            std::vector<double>& sums = partial[static_cast<std::size_t>(piece)];
            // Four points at once: the recurrence of one waits for itself.
            for (int first = 4 * piece; first < points; first += 4 * kPieces) {
                double x[4], weight[4], previous[4], current[4];
                for (int lane = 0; lane < 4; ++lane) {
                    const double s = (first + lane + 0.5) / points;
                    const double theta = 0.5 * std::numbers::pi * s * s * s;
                    x[lane] = std::cos(theta);
                    weight[lane] = first + lane < points
                                       ? lobeWeight(lobe, x[lane]) * std::sin(theta) * s * s
                                       : 0.0;
                    previous[lane] = 0.0;
                    current[lane] = weight[lane];
                }
                for (int l = 0; l <= degree; ++l) {
                    const double rise = (2.0 * l + 1.0) / (l + 1.0), fall = l / (l + 1.0);
                    double sum = 0.0;
                    for (int lane = 0; lane < 4; ++lane) {
                        sum += current[lane];
                        const double next = rise * x[lane] * current[lane] - fall * previous[lane];
                        previous[lane] = current[lane];
                        current[lane] = next;
                    }
                    sums[static_cast<std::size_t>(l)] += sum;
                }
            }
        }
    });
    for (std::size_t l = 0; l < factors.size(); ++l)
        for (const std::vector<double>& sums : partial) factors[l] += sums[l];
    const double whole = factors[0];
    for (double& factor : factors) factor /= whole;
    return factors;
}

int lobeDegree(const Lobe& lobe) noexcept {
    if (lobe.shape == LobeShape::lambert) return 128;
    return std::clamp(static_cast<int>(std::ceil(6.0 / lobe.alpha)), 128, kMaxDegree);
}

}  // namespace tukor
