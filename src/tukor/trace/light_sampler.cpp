#include "tukor/trace/light_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tukor/base/parallel.h"

namespace tukor::trace {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kWidth = 1024, kHeight = 512;  // a sun of half a degree is a node or two
constexpr int kGuides = 64;                  // in a row
// Nodes lie in the middle of pixels and at the poles; column kWidth is column 0 again.
constexpr std::size_t kStride = kWidth + 1, kRows = kHeight + 2;

/// Longitude and latitude in columns and rows of nodes.
glm::vec3 directionAt(float x, float y) noexcept {
    const float phi = 2.0f * kPi / kWidth * (x + 0.5f), theta = kPi / kHeight * (y - 0.5f);
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// How far from its node a share `u` of a tent lies that falls to nothing over `before` and
/// `after`.
float alongTent(float u, float before, float after) noexcept {
    u *= before + after;
    if (u < before) return std::sqrt(u * before) - before;
    return after - std::sqrt(std::max(before + after - u, 0.0f) * after);
}

/// The last of running sums, between two, that is not above `value`, and the share of its node that
/// is left.
int nodeAt(const float* sums, int first, int last, float value, float& share) noexcept {
    const float* const above = std::upper_bound(sums + first + 1, sums + last + 1, value);
    const int node = std::min(static_cast<int>(above - sums) - 1, last);
    const float size = sums[node + 1] - sums[node];
    share = size > 0.0f ? std::clamp((value - sums[node]) / size, 0.0f, 1.0f) : 0.5f;
    return node;
}

/// Of the tents of rows: those beside a pole end there.
float spanAbove(int row) noexcept {
    return row == 1 ? 0.5f : 1.0f;
}
float spanBelow(int row) noexcept {
    return row == kHeight ? 0.5f : 1.0f;
}

}  // namespace

LightSampler::LightSampler(const EnvironmentMap& environment)
    : density_(kStride * kRows),
      nodeSums_(kStride * kRows),
      rowSums_(kRows + 1),
      guide_((kGuides + 1) * kRows) {
    parallelFor(1, kHeight + 1, 16, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const auto line = static_cast<std::size_t>(row);
            float* const density = &density_[line * kStride];
            float* const sums = &nodeSums_[line * kStride];
            for (int column = 0; column < kWidth; ++column) {
                const glm::vec3 d =
                    directionAt(static_cast<float>(column), static_cast<float>(row));
                const float sinTheta = std::sqrt(d.x * d.x + d.z * d.z);
                const glm::vec3 right = 2.0f * kPi / kWidth * glm::vec3(-d.z, 0.0f, d.x);
                const glm::vec3 down =
                    kPi / kHeight *
                    glm::vec3(d.y * d.x / sinTheta, -sinTheta, d.y * d.z / sinTheta);
                const glm::vec3 L = environment.radiance(d, right, down, 4);
                density[column] = (L.x + L.y + L.z) * sinTheta;
                sums[column + 1] = sums[column] + density[column];
            }
            density[kWidth] = density[0];
            int node = 0;
            for (int i = 0; i <= kGuides; ++i) {
                const float value = sums[kWidth] * (static_cast<float>(i) / kGuides);
                while (node < kWidth - 1 && sums[node + 1] <= value) ++node;
                guide_[line * (kGuides + 1) + static_cast<std::size_t>(i)] =
                    static_cast<std::uint16_t>(node);
            }
        }
    });
    for (std::size_t row = 0; row < kRows; ++row) {
        const int line = static_cast<int>(row);
        rowSums_[row + 1] = rowSums_[row] + 0.5f * (spanAbove(line) + spanBelow(line)) *
                                                nodeSums_[(row + 1) * kStride - 1];
    }
    total_ = rowSums_.back();
}

float LightSampler::pdfAt(float x, float y, float sinTheta) const noexcept {
    if (x < 0.0f) x += static_cast<float>(kWidth);
    const int column = std::clamp(static_cast<int>(x), 0, kWidth - 1);
    const int row = std::clamp(static_cast<int>(y), 0, kHeight);
    const float s = x - static_cast<float>(column);
    float t = y - static_cast<float>(row);
    if (row == 0) t = 2.0f * t - 1.0f;  // half as high
    if (row == kHeight) t = 2.0f * t;
    const float* const above =
        &density_[static_cast<std::size_t>(row) * kStride + static_cast<std::size_t>(column)];
    const float* const below = above + kStride;
    const float a = above[0] + s * (above[1] - above[0]), b = below[0] + s * (below[1] - below[0]);
    constexpr float kNodesPerSteradian = kWidth * kHeight / (2.0f * kPi * kPi);
    return (a + t * (b - a)) / total_ * kNodesPerSteradian / std::max(sinTheta, 1e-6f);
}

LightDirection LightSampler::sample(glm::vec2 u) const noexcept {
    if (!(total_ > 0.0f)) return {};
    float down = 0.0f, right = 0.0f;
    const int row = nodeAt(rowSums_.data(), 1, kHeight, u.y * total_, down);
    const float* const sums = &nodeSums_[static_cast<std::size_t>(row) * kStride];
    const std::uint16_t* const guide =
        &guide_[static_cast<std::size_t>(row) * (kGuides + 1) +
                static_cast<std::size_t>(u.x * static_cast<float>(kGuides))];
    const int column = nodeAt(sums, guide[0], guide[1], u.x * sums[kWidth], right);
    const float x = static_cast<float>(column) + alongTent(right, 1.0f, 1.0f);
    const float y = static_cast<float>(row) + alongTent(down, spanAbove(row), spanBelow(row));
    const glm::vec3 d = directionAt(x, y);
    return {d, pdfAt(x, y, std::sqrt(d.x * d.x + d.z * d.z))};
}

float LightSampler::pdf(glm::vec3 d) const noexcept {
    if (!(total_ > 0.0f)) return 0.0f;
    const float across = std::sqrt(d.x * d.x + d.z * d.z);
    return pdfAt(std::atan2(d.z, d.x) * (0.5f / kPi * kWidth) - 0.5f,
                 std::atan2(across, d.y) * (kHeight / kPi) + 0.5f, across);
}

}  // namespace tukor::trace
