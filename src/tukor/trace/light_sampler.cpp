#include "tukor/trace/light_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"

namespace tukor::trace {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kWidth = 1024;  // a sun of half a degree is a cell or two

glm::vec3 directionAt(float x, float y) noexcept {
    const float phi = 2.0f * kPi * x, theta = kPi * y;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// The cell of running sums that holds `value`, and how far into it.
int cellOf(const float* sums, int count, float value, float& within) noexcept {
    const float* const after = std::upper_bound(sums, sums + count + 1, value);
    const int cell = std::clamp(static_cast<int>(after - sums) - 1, 0, count - 1);
    const float size = sums[cell + 1] - sums[cell];
    within = size > 0.0f ? std::min((value - sums[cell]) / size, 0.9999999f) : 0.5f;
    return cell;
}

}  // namespace

LightSampler::LightSampler(const EnvironmentMap& environment)
    : width_(kWidth), height_(kWidth / 2) {
    const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    power_.resize(width * height);
    cellSums_.resize((width + 1) * height);
    rowSums_.resize(height + 1);
    parallelFor(0, height_, 16, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const float y = (static_cast<float>(row) + 0.5f) / static_cast<float>(height_);
            const float sinTheta = std::sin(kPi * y);
            float* const power = &power_[static_cast<std::size_t>(row) * width];
            float* const sums = &cellSums_[static_cast<std::size_t>(row) * (width + 1)];
            for (std::size_t column = 0; column < width; ++column) {
                const float x = (static_cast<float>(column) + 0.5f) / static_cast<float>(width_);
                const glm::vec3 d = directionAt(x, y);
                const glm::vec3 down = (kPi / static_cast<float>(height_)) *
                                       glm::vec3(d.y * std::cos(2.0f * kPi * x), -sinTheta,
                                                 d.y * std::sin(2.0f * kPi * x));
                const glm::vec3 right =
                    (2.0f * kPi / static_cast<float>(width_)) * glm::vec3(-d.z, 0.0f, d.x);
                const glm::vec3 L = environment.radiance(d, right, down, 4);
                power[column] = (L.x + L.y + L.z) * sinTheta;
                sums[column + 1] = sums[column] + power[column];
            }
        }
    });
    for (std::size_t row = 0; row < height; ++row)
        rowSums_[row + 1] = rowSums_[row] + cellSums_[row * (width + 1) + width];
    total_ = rowSums_.back();
}

float LightSampler::cellPdf(int column, int row, float sinTheta) const noexcept {
    const float share = power_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(column)] /
                        total_;
    return share * static_cast<float>(width_) * static_cast<float>(height_) /
           (2.0f * kPi * kPi * std::max(sinTheta, 1e-6f));
}

LightDirection LightSampler::sample(glm::vec2 u) const noexcept {
    if (!(total_ > 0.0f)) return {};
    float down = 0.0f, right = 0.0f;
    const int row = cellOf(rowSums_.data(), height_, u.y * total_, down);
    const float* const sums =
        &cellSums_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1)];
    const int column = cellOf(sums, width_, u.x * sums[width_], right);
    const float x = (static_cast<float>(column) + right) / static_cast<float>(width_);
    const float y = (static_cast<float>(row) + down) / static_cast<float>(height_);
    return {directionAt(x, y), cellPdf(column, row, std::sin(kPi * y))};
}

float LightSampler::pdf(glm::vec3 d) const noexcept {
    if (!(total_ > 0.0f)) return 0.0f;
    const float across = std::sqrt(d.x * d.x + d.z * d.z);
    float x = std::atan2(d.z, d.x) * (0.5f / kPi);
    if (x < 0.0f) x += 1.0f;
    const float y = std::atan2(across, d.y) / kPi;
    const int column = std::clamp(static_cast<int>(x * static_cast<float>(width_)), 0, width_ - 1);
    const int row = std::clamp(static_cast<int>(y * static_cast<float>(height_)), 0, height_ - 1);
    return cellPdf(column, row, across);
}

}  // namespace tukor::trace
