#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "tukor/environment/cube_function.h"
#include "tukor/environment/procedural.h"

namespace tukor {

namespace {

inline float smooth(float from, float to, float x) {
    const float t = std::clamp((x - from) * (1.0f / (to - from)), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// A rectangular light or flag around the object at the origin; lengths in metres.
struct Panel {
    glm::vec3 centre;
    glm::vec2 halfSize;  // across, along the panel's up
    glm::vec3 radiance;  // at the middle; a flag has 0
    float edgeRadiance;  // fraction of it that is left at the rim
    float softness;      // width of the rim, as a fraction of the half size
};

/// A round lamp: direction, angular radius in radians.
struct Lamp {
    glm::vec3 direction;
    float radius;
    glm::vec3 radiance;

    void cover(glm::vec3 unitDirection, glm::vec3& seen) const {
        const float limit = 1.0f - 0.5f * radius * radius;  // cos(radius)
        const float depth = (glm::dot(unitDirection, direction) - limit) / (1.0f - limit);
        if (depth > 0.0f) seen = glm::mix(seen, radiance, smooth(0.0f, 0.3f, depth));
    }
};

constexpr glm::vec3 kWarm{1.0f, 0.955f, 0.89f};
constexpr glm::vec3 kCool{0.90f, 0.955f, 1.0f};

// The camera stands at +Z. Later panels stand before earlier ones.
constexpr std::array kPanels = {
    Panel{{-2.6f, 2.3f, 2.6f}, {1.35f, 1.0f}, 10.0f * kWarm, 0.55f, 0.04f},      // key
    Panel{{3.6f, 0.9f, 1.6f}, {1.1f, 1.7f}, 2.4f * kCool, 0.5f, 0.06f},          // fill
    Panel{{0.0f, 3.4f, -0.6f}, {1.1f, 0.65f}, 6.0f * kWarm, 0.6f, 0.05f},        // overhead
    Panel{{-2.5f, 0.7f, -2.3f}, {0.22f, 1.7f}, 16.0f * kCool, 0.8f, 0.12f},      // strip, left rim
    Panel{{2.7f, 0.9f, -2.1f}, {0.22f, 1.7f}, 16.0f * kCool, 0.8f, 0.12f},       // strip, right rim
    Panel{{1.0f, 0.25f, 3.4f}, {0.10f, 1.1f}, 7.0f * kWarm, 0.8f, 0.15f},        // strip, front
    Panel{{-3.2f, 0.2f, -0.5f}, {0.55f, 1.9f}, glm::vec3(0.012f), 1.0f, 0.05f},  // flag, left
    Panel{{3.3f, 0.2f, -0.5f}, {0.55f, 1.9f}, glm::vec3(0.012f), 1.0f, 0.05f},   // flag, right
};

constexpr std::array kLamps = {
    Lamp{{0.35f, 0.80f, 0.75f}, 0.040f, 20.0f * kWarm},
    Lamp{{-0.15f, 0.95f, 0.55f}, 0.030f, 20.0f * kWarm},
    Lamp{{0.75f, 0.75f, 0.10f}, 0.035f, 18.0f * kCool},
    Lamp{{-0.80f, 0.70f, -0.15f}, 0.035f, 18.0f * kCool},
    Lamp{{0.25f, 0.55f, -0.95f}, 0.030f, 20.0f * kWarm},
};

/// A panel with its plane worked out.
struct PlacedPanel {
    explicit PlacedPanel(const Panel& source) : panel(source) {
        const glm::vec3 normal = glm::normalize(source.centre);
        const glm::vec3 up = std::abs(normal.y) > 0.9f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
        const glm::vec3 across = glm::normalize(glm::cross(up, normal));
        const float distance = glm::length(source.centre);
        facing = normal;
        x = across * distance / source.halfSize.x;
        y = glm::cross(normal, across) * distance / source.halfSize.y;
        // Cosine of the angle to a corner: what is farther off misses the panel.
        leastCosine =
            distance / std::sqrt(distance * distance + glm::dot(source.halfSize, source.halfSize));
    }

    void cover(glm::vec3 direction, glm::vec3& radiance) const {
        const float cosine = glm::dot(direction, facing);
        if (cosine < leastCosine) return;
        const float across = std::abs(glm::dot(direction, x) / cosine);
        const float along = std::abs(glm::dot(direction, y) / cosine);
        if (across >= 1.0f || along >= 1.0f) return;
        const float inside = (1.0f - std::max(across, along)) / panel.softness;
        const float fall =
            1.0f - (1.0f - panel.edgeRadiance) * 0.5f * (across * across + along * along);
        radiance = glm::mix(radiance, fall * panel.radiance, smooth(0.0f, 1.0f, inside));
    }

    Panel panel;
    glm::vec3 facing{};
    glm::vec3 x{}, y{};
    float leastCosine = 0.0f;
};

inline glm::vec3 backdrop(glm::vec3 direction) {
    // A pool of light on the wall behind the object, a floor lit from above, a dark ceiling.
    const float up = direction.y;
    const float wall = 0.05f + 0.30f * smooth(0.75f, -0.15f, up);
    const float ahead = glm::dot(direction, glm::vec3(0.0f, 0.06f, -0.998f));
    const float pool = 0.38f * smooth(0.35f, 1.0f, ahead);
    const float floor = 0.34f * smooth(0.05f, -0.35f, up) * smooth(-1.15f, -0.30f, up);
    return (wall + pool) * glm::vec3(0.97f, 0.985f, 1.0f) + floor * glm::vec3(1.0f, 0.985f, 0.96f);
}

}  // namespace

CubeMap studioCube(int faceSize) {
    const std::vector<PlacedPanel> panels(std::begin(kPanels), std::end(kPanels));

    return cubeFromFunction(faceSize, [&](Cone cone) {
        // Two cones overlap unless their axes are farther apart than their angles together.
        const auto overlaps = [&](glm::vec3 axis, float cosine) {
            const float apart = std::acos(std::clamp(glm::dot(axis, cone.axis), -1.0f, 1.0f));
            return apart <= std::acos(cosine) + std::acos(std::min(cone.cosine, 1.0f)) + 1e-3f;
        };
        std::vector<PlacedPanel> seenPanels;
        for (const PlacedPanel& placed : panels)
            if (overlaps(placed.facing, placed.leastCosine)) seenPanels.push_back(placed);
        std::vector<Lamp> seenLamps;
        for (Lamp lamp : kLamps) {
            lamp.direction = glm::normalize(lamp.direction);
            if (overlaps(lamp.direction, std::cos(lamp.radius))) seenLamps.push_back(lamp);
        }
        return [seenPanels = std::move(seenPanels), seenLamps = std::move(seenLamps)](
                   std::span<const glm::vec3> directions, glm::vec3* shown) {
            const std::size_t count = directions.size();
            const glm::vec3* to = directions.data();
            for (std::size_t i = 0; i < count; ++i) shown[i] = backdrop(to[i]);
            for (const PlacedPanel& placed : seenPanels)
                for (std::size_t i = 0; i < count; ++i) placed.cover(directions[i], shown[i]);
            for (const Lamp& lamp : seenLamps)
                for (std::size_t i = 0; i < count; ++i) lamp.cover(directions[i], shown[i]);
        };
    });
}

}  // namespace tukor
