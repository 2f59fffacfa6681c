// Pictures of which something else is given: Richardson's steps, with momentum.
#pragma once
#include <functional>

#include "tukor/image/image.h"

namespace tukor {

/// By how much brighter what is given is than what would be made of the picture.
[[nodiscard]] inline glm::vec3 ratioOf(glm::vec3 given, glm::vec3 made) noexcept {
    return {made.x > 0.0f ? given.x / made.x : 1.0f, made.y > 0.0f ? given.y / made.y : 1.0f,
            made.z > 0.0f ? given.z / made.z : 1.0f};
}

/// Multiplies every pixel by that ratio; all steps together are done from `done` to `next`, of 1.
/// False to stop.
using RichardsonStep = std::function<bool(Image& image, float done, float next)>;

/// The picture after so many steps [Richardson 1972], each of which begins where the last two point
/// to [Biggs & Andrews 1997]: eight are as good as 25 without. Never negative where `image` is not.
[[nodiscard]] Image afterSteps(int steps, Image image, const RichardsonStep& step);

}  // namespace tukor
