// Lamps without size: of KHR_lights_punctual, and a sun.
#pragma once
#include <string>

#include <glm/glm.hpp>

namespace tukor {

enum class LightKind { directional, point, spot };

/// Seen by rough and diffuse surfaces alone: what is ideally smooth reflects no point.
struct Light {
    std::string name;
    LightKind kind = LightKind::directional;
    glm::vec3 position{0.0f};                // of points and spots
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  // in which it shines; unit
    glm::vec3 intensity{1.0f};    // directional: irradiance of what faces it; else per steradian
    float range = 0.0f;           // m, where it has faded to nothing; 0: never
    float cosInner = 1.0f;        // of a spot's cone: full light within,
    float cosOuter = 0.7071068f;  // none beyond
};

/// What arrives at a place.
struct LightAt {
    glm::vec3 wi;  // unit, to the light
    glm::vec3 E;   // irradiance of a surface that faces it
    float distance;
};

[[nodiscard]] LightAt lightAt(const Light& light, glm::vec3 place) noexcept;

}  // namespace tukor
