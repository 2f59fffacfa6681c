// Directions from which the environment is bright: what rough surfaces ask first.
#pragma once
#include <cstdint>
#include <vector>

#include "tukor/trace/environment_map.h"

namespace tukor::trace {

/// A direction and its density per steradian.
struct LightDirection {
    glm::vec3 direction{0.0f};
    float pdf = 0.0f;  // 0: none
};

/// Samples directions in proportion to radiance, bilinear between the nodes of a world-aligned grid
/// of longitude and latitude, as environments are. Read-only: threads may share it.
class LightSampler {
public:
    explicit LightSampler(const EnvironmentMap& environment);

    /// For uniform `u` in [0, 1)^2; a pdf of 0 where all is black.
    [[nodiscard]] LightDirection sample(glm::vec2 u) const noexcept;
    /// Of a unit direction.
    [[nodiscard]] float pdf(glm::vec3 direction) const noexcept;

private:
    [[nodiscard]] float pdfAt(float x, float y, float sinTheta) const noexcept;

    float total_ = 0.0f;
    std::vector<float> density_;        // at the nodes, with a row of zeros at either pole
    std::vector<float> nodeSums_;       // running along each row
    std::vector<float> rowSums_;        // running
    std::vector<std::uint16_t> guide_;  // where searches along a row begin
};

}  // namespace tukor::trace
