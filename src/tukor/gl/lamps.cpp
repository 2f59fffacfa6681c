#include "tukor/gl/lamps.h"

namespace tukor::gl {

namespace {

constexpr std::size_t kMostLamps = 16;  // the brightest would be better; the first is what it takes

}  // namespace

std::vector<glm::vec4> lampTable(const std::vector<Light>& lights, glm::vec3 eye,
                                 const glm::mat3& environmentFromWorld, float factor) {
    std::vector<glm::vec4> lamps;
    for (const Light& light : lights) {
        if (lamps.size() / 4 == kMostLamps) break;
        lamps.emplace_back(environmentFromWorld * (light.position - eye),
                           static_cast<float>(light.kind));
        lamps.emplace_back(environmentFromWorld * light.direction, light.range);
        lamps.emplace_back(light.intensity * factor, 0.0f);
        lamps.emplace_back(light.cosInner, light.cosOuter, 0.0f, 0.0f);
    }
    return lamps;
}

}  // namespace tukor::gl
