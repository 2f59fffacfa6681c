#include "tukor/environment/brdf_table.h"

#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"

namespace tukor {

namespace {

/// Height-correlated Smith visibility: shadowing over 4 cos cos. [Heitz 2014]
double visibility(double cosOut, double cosIn, double a2) {
    return 0.5 / (cosIn * std::sqrt(cosOut * cosOut * (1.0 - a2) + a2) +
                  cosOut * std::sqrt(cosIn * cosIn * (1.0 - a2) + a2));
}

glm::vec3 entry(double cosOut, double roughness) {
    const double a2 = std::pow(roughness, 4);
    const double sinOut = std::sqrt(1.0 - cosOut * cosOut);
    // Half vectors of equal probability: midpoints of the radial quantile and of half the azimuths,
    // the other half being their mirror image.
    constexpr int kRadii = 64, kAzimuths = 16;
    double scale = 0.0, bias = 0.0;
    for (int i = 0; i < kRadii; ++i) {
        const double u = (i + 0.5) / kRadii;
        const double cosHalf = std::sqrt((1.0 - u) / (1.0 + (a2 - 1.0) * u));
        const double sinHalf = std::sqrt(1.0 - cosHalf * cosHalf);
        for (int j = 0; j < kAzimuths; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / kAzimuths;
            const double outHalf = sinOut * sinHalf * std::cos(phi) + cosOut * cosHalf;
            const double cosIn = 2.0 * outHalf * cosHalf - cosOut;
            if (cosIn <= 0.0 || outHalf <= 0.0) continue;
            const double weight = visibility(cosOut, cosIn, a2) * cosIn * 4.0 * outHalf / cosHalf;
            const double fresnel = std::pow(1.0 - outHalf, 5);
            scale += weight * (1.0 - fresnel);
            bias += weight * fresnel;
        }
    }
    return glm::vec3(glm::dvec3(scale, bias, 0.0) / static_cast<double>(kRadii * kAzimuths));
}

}  // namespace

Image brdfTable(int size) {
    Image table(size, size);
    parallelFor(0, size, 1, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < size; ++column)
                table.at(column, row) = entry((column + 0.5) / size, (row + 0.5) / size);
    });
    return table;
}

}  // namespace tukor
