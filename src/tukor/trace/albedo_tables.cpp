#include "tukor/trace/albedo_tables.h"

#include <algorithm>
#include <cmath>

#include "tukor/base/parallel.h"
#include "tukor/environment/brdf_table.h"
#include "tukor/optics/directions.h"
#include "tukor/optics/fresnel.h"
#include "tukor/optics/microfacet.h"
#include "tukor/trace/sampler.h"

namespace tukor::trace {

namespace {

constexpr int kSplit = 48;
constexpr int kAlphas = 32, kCosines = 48;  // even in the roots of both

float clearAlbedo(float cosTheta, float alpha, float eta) {
    constexpr std::uint32_t kPoints = 1024;
    const glm::vec3 wo(std::sqrt(1.0f - cosTheta * cosTheta), 0.0f, cosTheta);
    const glm::vec2 a(alpha);
    const float lambdaOut = optics::ggxLambda(wo, a);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const glm::vec3 h = optics::ggxVisibleNormal(wo, a, transport::pixelSample(1u, i));
        const float c = glm::dot(wo, h);
        const float R = optics::fresnelDielectric(std::clamp(c, 0.0f, 1.0f), eta);
        const auto seen = [&](glm::vec3 wi) {  // G2 / G1
            return (1.0f + lambdaOut) / (1.0f + lambdaOut + optics::ggxLambda(wi, a));
        };
        const glm::vec3 reflected = 2.0f * c * h - wo;
        if (reflected.z > 0.0f) sum += R * seen(reflected);
        const optics::Refraction refraction = optics::refractDirection(-wo, h, eta);
        if (!refraction.total && refraction.direction.z < 0.0f)
            sum += (1.0f - R) * seen(refraction.direction);
    }
    return static_cast<float>(sum / kPoints);
}

/// Bilinear between nodes, x and y from 0 to 1.
template <class At>
auto between(int columns, int rows, float x, float y, const At& at) {
    x = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(columns - 1);
    y = std::clamp(y, 0.0f, 1.0f) * static_cast<float>(rows - 1);
    const int column = std::min(static_cast<int>(x), columns - 2);
    const int row = std::min(static_cast<int>(y), rows - 2);
    const float u = x - static_cast<float>(column), v = y - static_cast<float>(row);
    return (1.0f - v) * ((1.0f - u) * at(column, row) + u * at(column + 1, row)) +
           v * ((1.0f - u) * at(column, row + 1) + u * at(column + 1, row + 1));
}

}  // namespace

glm::vec3 splitAlbedo(float cosTheta, float roughness) {
    static const Image table = brdfNodeTable(kSplit);
    return between(kSplit, kSplit, std::sqrt(std::max(cosTheta, 0.0f)), roughness,
                   [&](int column, int row) { return table.at(column, row); });
}

ClearAlbedo::ClearAlbedo(float eta) : table_(std::size_t{kAlphas} * kCosines) {
    parallelFor(0, kAlphas, 1, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < kCosines; ++column) {
                const float x = static_cast<float>(column) / (kCosines - 1);
                const float y = static_cast<float>(row) / (kAlphas - 1);
                table_[static_cast<std::size_t>(row * kCosines + column)] =
                    clearAlbedo(std::max(x * x, 1e-3f), std::max(y * y, 1e-3f), eta);
            }
    });
}

float ClearAlbedo::at(float cosTheta, float alpha) const noexcept {
    return between(kCosines, kAlphas, std::sqrt(std::max(cosTheta, 0.0f)), std::sqrt(alpha),
                   [&](int column, int row) {
                       return table_[static_cast<std::size_t>(row * kCosines + column)];
                   });
}

}  // namespace tukor::trace
