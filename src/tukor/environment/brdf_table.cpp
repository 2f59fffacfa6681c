#include "tukor/environment/brdf_table.h"

#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"

namespace tukor {

namespace {

/// Smith's Lambda for GGX. [Heitz 2014]
double lambda(double cosTheta, double a2) {
    return 0.5 * (std::sqrt(1.0 + a2 * (1.0 / (cosTheta * cosTheta) - 1.0)) - 1.0);
}

/// Charlie's fibres with the visibility of [Neubelt & Pettineo 2013], by midpoints in the cosine
/// and in half of the azimuths.
double sheen(double cosOut, double alpha) {
    constexpr int kCosines = 64, kAzimuths = 32;
    const double sinOut = std::sqrt(1.0 - cosOut * cosOut);
    double sum = 0.0;
    for (int i = 0; i < kCosines; ++i) {
        const double cosIn = (i + 0.5) / kCosines, sinIn = std::sqrt(1.0 - cosIn * cosIn);
        for (int j = 0; j < kAzimuths; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / kAzimuths;
            const double cosBoth = sinOut * sinIn * std::cos(phi) + cosOut * cosIn;
            const double cosHalf = (cosOut + cosIn) / std::sqrt(2.0 + 2.0 * cosBoth);
            const double sinHalf = std::sqrt(std::max(1.0 - cosHalf * cosHalf, 0.0));
            const double density =
                (2.0 + 1.0 / alpha) * std::pow(sinHalf, 1.0 / alpha) / (2.0 * std::numbers::pi);
            sum += density * cosIn / (4.0 * (cosOut + cosIn - cosOut * cosIn));
        }
    }
    return sum * 2.0 * std::numbers::pi / (kCosines * kAzimuths);
}

glm::vec3 entry(double cosOut, double roughness) {
    const double alpha = roughness * roughness, a2 = alpha * alpha;
    const double sinOut = std::sqrt(1.0 - cosOut * cosOut), lambdaOut = lambda(cosOut, a2);
    // Facets as they are seen, by midpoints: what is left to average is smooth. [Dupuy & Benyoub
    // 2023]
    constexpr int kRadii = 40, kAzimuths = 20;
    const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha * sinOut, 0.0, cosOut));
    double scale = 0.0, bias = 0.0;
    for (int i = 0; i < kRadii; ++i) {
        const double z = (1.0 - (i + 0.5) / kRadii) * (1.0 + stretched.z) - stretched.z;
        const double r = std::sqrt(std::max(1.0 - z * z, 0.0));
        for (int j = 0; j < kAzimuths; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / kAzimuths;
            const glm::dvec3 cap = glm::dvec3(r * std::cos(phi), r * std::sin(phi), z) + stretched;
            const glm::dvec3 half = glm::normalize(glm::dvec3(alpha * cap.x, alpha * cap.y, cap.z));
            const double outHalf = sinOut * half.x + cosOut * half.z;
            const double cosIn = 2.0 * outHalf * half.z - cosOut;
            if (cosIn <= 0.0 || outHalf <= 0.0) continue;
            const double weight = (1.0 + lambdaOut) / (1.0 + lambdaOut + lambda(cosIn, a2));
            const double fresnel = std::pow(1.0 - outHalf, 5);
            scale += weight * (1.0 - fresnel);
            bias += weight * fresnel;
        }
    }
    return glm::vec3(glm::dvec3(scale, bias, 0.0) / static_cast<double>(kRadii * kAzimuths)) +
           glm::vec3(0.0f, 0.0f, sheen(cosOut, std::max(roughness * roughness, 1e-3)));
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

Image brdfNodeTable(int size) {
    Image table(size, size);
    parallelFor(0, size, 1, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < size; ++column) {
                const double x = std::max(static_cast<double>(column) / (size - 1), 0.02);
                table.at(column, row) =
                    entry(x * x, std::max(static_cast<double>(row) / (size - 1), 0.02));
            }
    });
    return table;
}

}  // namespace tukor
