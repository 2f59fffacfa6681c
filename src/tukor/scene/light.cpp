#include "tukor/scene/light.h"

#include <algorithm>
#include <cmath>

namespace tukor {

LightAt lightAt(const Light& light, glm::vec3 place) noexcept {
    if (light.kind == LightKind::directional) return {-light.direction, light.intensity, 1e30f};
    const glm::vec3 to = light.position - place;
    const float distance = std::max(glm::length(to), 1e-6f);
    LightAt at{to / distance, light.intensity / (distance * distance), distance};
    if (light.range > 0.0f) {  // as KHR_lights_punctual recommends
        const float part = distance / light.range, part2 = part * part;
        at.E *= std::clamp(1.0f - part2 * part2, 0.0f, 1.0f);
    }
    if (light.kind == LightKind::spot) {
        const float c = -glm::dot(at.wi, light.direction);
        const float share = std::clamp(
            (c - light.cosOuter) / std::max(light.cosInner - light.cosOuter, 1e-4f), 0.0f, 1.0f);
        at.E *= share * share;
    }
    return at;
}

}  // namespace tukor
