// Lamps as lamplight.glsl reads them.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "tukor/scene/light.h"

namespace tukor::gl {

/// Four vectors a lamp, in the axes of the environment, from the eye: place and kind, direction and
/// range, intensity times `factor`, cone. Sixteen lamps at most: the first.
[[nodiscard]] std::vector<glm::vec4> lampTable(const std::vector<Light>& lights, glm::vec3 eye,
                                               const glm::mat3& environmentFromWorld, float factor);

}  // namespace tukor::gl
