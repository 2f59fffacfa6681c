// A pool of water with ripples, and boxes.
#pragma once
#include "tukor/geometry/mesh.h"

namespace tukor {

/// A block of water 2 m square and half a metre deep, its rippled top about y = 0 in `steps` by
/// `steps` squares with the exact normals of the waves.
[[nodiscard]] Mesh makeWaterSurface(int steps = 180);

/// A box with flat sides.
[[nodiscard]] Mesh makeBox(glm::vec3 least, glm::vec3 most);

}  // namespace tukor
