// What all threads share while one picture is traced.
#pragma once
#include <cstdint>
#include <span>

#include "tukor/optics/spectrum.h"
#include "tukor/scene/camera.h"
#include "tukor/scene/render_options.h"
#include "tukor/trace/environment_map.h"
#include "tukor/trace/ray_caster.h"

namespace tukor::trace {

/// Camera rays as an affine function of the place in the picture.
struct RayGenerator {
    RayGenerator(const Camera& camera, int width, int height) noexcept
        : eye(camera.eye), corner(rayDirection(camera, width, height, 0.0f, 0.0f)) {
        const auto w = static_cast<float>(width), h = static_cast<float>(height);
        perColumn = (rayDirection(camera, width, height, w, 0.0f) - corner) / w;
        perRow = (rayDirection(camera, width, height, 0.0f, h) - corner) / h;
        if (!(camera.lensDiameter > 0.0f)) return;
        const CameraAxes axes = axesOf(camera);
        forward = axes.forward;
        lensRight = 0.5f * camera.lensDiameter * axes.right;
        lensUp = 0.5f * camera.lensDiameter * axes.up;
        focus = camera.focus > 0.0f ? camera.focus : glm::distance(camera.eye, camera.target);
    }

    /// Not normalised: as long as the plane at distance 1 is away.
    [[nodiscard]] glm::vec3 direction(float x, float y) const noexcept {
        return corner + x * perColumn + y * perRow;
    }

    /// From the eye to a point of the lens, which is the unit disc.
    [[nodiscard]] glm::vec3 offset(glm::vec2 onLens) const noexcept {
        return onLens.x * lensRight + onLens.y * lensUp;
    }
    /// Not normalised either: from there to where the ray through the eye meets what is in focus.
    [[nodiscard]] glm::vec3 direction(glm::vec2 place, glm::vec2 onLens) const noexcept {
        return direction(place.x, place.y) - offset(onLens) / focus;
    }
    [[nodiscard]] bool hasLens() const noexcept { return lensUp != glm::vec3(0.0f); }

    glm::vec3 eye;
    glm::vec3 corner;
    glm::vec3 perColumn;
    glm::vec3 perRow;
    // Of a lens alone, which a pinhole has not.
    glm::vec3 lensRight{0.0f}, lensUp{0.0f};  // its radius
    glm::vec3 forward{0.0f};
    float focus = 1.0f;  // metres along that
};

class RoughEvent;

struct Frame {
    const SurfaceTable& surfaces;
    const RayCaster& caster;
    const EnvironmentMap& environment;
    RayGenerator camera;
    transport::TransportSettings settings;
    std::uint32_t eyeMedia;  // what the eye is inside of
    bool background;         // false: nothing is seen where the camera ray meets nothing
    int width;
    int height;
    std::uint32_t seed;
    bool splitGrazing = false;  // see RenderOptions
    bool retakeFaulty = true;
    const RoughEvent* rough = nullptr;           // null: all surfaces are ideally smooth
    const optics::Spectrum* spectrum = nullptr;  // null: light is not dispersed
    // What camera rays see that meet nothing; null: the environment.
    const EnvironmentMap* backdrop = nullptr;
    // Of every pixel, row by row, 0 where no surface is seen; empty: not known.
    std::span<const std::uint8_t> silhouette{};
};

/// The media that contain a point, by the surfaces that rays from there cross on their way out.
[[nodiscard]] std::uint32_t mediaAround(glm::vec3 point, const SurfaceTable& surfaces,
                                        const RayCaster& caster) noexcept;

[[nodiscard]] transport::TransportSettings transportSettings(const RenderOptions& options) noexcept;

}  // namespace tukor::trace
