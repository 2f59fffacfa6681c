// Directions from which the environment is bright: what rough surfaces ask first.
#pragma once
#include <vector>

#include "tukor/trace/environment_map.h"

namespace tukor::trace {

/// A direction and its density per steradian.
struct LightDirection {
    glm::vec3 direction{0.0f};
    float pdf = 0.0f;  // 0: none
};

/// Samples directions in proportion to radiance, in cells of a world-aligned grid of longitude and
/// latitude. Read-only: threads may share it.
class LightSampler {
public:
    explicit LightSampler(const EnvironmentMap& environment);

    /// For uniform `u` in [0, 1)^2; a pdf of 0 where all is black.
    [[nodiscard]] LightDirection sample(glm::vec2 u) const noexcept;
    /// Of a unit direction.
    [[nodiscard]] float pdf(glm::vec3 direction) const noexcept;

private:
    [[nodiscard]] float cellPdf(int column, int row, float sinTheta) const noexcept;

    int width_;
    int height_;
    float total_ = 0.0f;
    std::vector<float> power_;     // of the cells
    std::vector<float> rowSums_;   // running, height + 1
    std::vector<float> cellSums_;  // running within each row, (width + 1) * height
};

}  // namespace tukor::trace
