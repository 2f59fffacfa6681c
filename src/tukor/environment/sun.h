// The sun, or another small bright light, in a panorama: found, measured and taken out.
#pragma once
#include <optional>
#include <string>

#include "tukor/image/image.h"

namespace tukor {

struct Sun {
    glm::vec3 direction;    // unit, towards it
    float angularRadius;    // radians, of a uniform disc of the same spread
    glm::vec3 irradiance;   // on a surface facing it, without what the sky behind it gives
    glm::vec3 skyRadiance;  // of the sky around it
    float brightness;       // luminance of the brightest pixel over that of the sky around it
};

/// The brightest place, if it is a light of its own: at least 10 times brighter than the sky around
/// it and than the panorama's mean, no wider than 3 degrees in radius, and alone: nothing more than
/// 7 degrees away is half as bright.
[[nodiscard]] std::optional<Sun> findSun(const Image& panorama);

/// The panorama with the sky's radiance where the sun was.
[[nodiscard]] Image withoutSun(Image panorama, const Sun& sun);

[[nodiscard]] std::string jsonOf(const Sun& sun);

}  // namespace tukor
