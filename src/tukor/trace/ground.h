// Ground that catches shadows and light: a plane that is not there but for them.
#pragma once
#include "tukor/scene/scene.h"
#include "tukor/trace/environment_map.h"

namespace tukor::trace {

/// The scene on ground at that height, of fifty times its size; the last part.
[[nodiscard]] Scene withGround(const Scene& scene, float height);

/// Of a surface that faces +Y.
[[nodiscard]] glm::vec3 irradianceFromAbove(const EnvironmentMap& environment) noexcept;

}  // namespace tukor::trace
