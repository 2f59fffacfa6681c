// How a viewer moves its camera: each movement makes a new camera from the old one.
#pragma once
#include "tukor/scene/camera.h"

namespace tukor {

/// Around the target, which keeps its distance: `yaw` about `up`, positive to the right, `pitch`
/// upwards; radians. Stops half a degree short of the poles.
[[nodiscard]] Camera orbit(const Camera& camera, float yaw, float pitch) noexcept;

/// Sideways without turning. What lies at the target's distance moves by `right` and `up` in
/// fractions of the picture's height, so it stays under a pointer that moved as far.
[[nodiscard]] Camera pan(const Camera& camera, float right, float up) noexcept;

/// Multiplies the distance to the target by `factor` > 0.
[[nodiscard]] Camera dolly(const Camera& camera, float factor) noexcept;

/// Brings a point into the middle of the picture, seen from the same side and the same distance.
[[nodiscard]] Camera focus(const Camera& camera, glm::vec3 point) noexcept;

}  // namespace tukor
