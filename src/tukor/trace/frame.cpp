#include "tukor/trace/frame.h"

#include <algorithm>
#include <array>

namespace tukor::trace {

static_assert(static_cast<int>(Fidelity::single) == transport::kFidelitySingle);
static_assert(static_cast<int>(Fidelity::two) == transport::kFidelityTwo);
static_assert(static_cast<int>(Fidelity::exact) == transport::kFidelityExact);
static_assert(static_cast<int>(FresnelForm::exact) == transport::kFresnelExact);
static_assert(static_cast<int>(FresnelForm::schlick) == transport::kFresnelSchlick);

namespace {

using Crossings = std::array<int, 32>;  // outwards less inwards, per medium

void count(Crossings& crossings, std::uint32_t media, int sign) {
    for (std::size_t bit = 0; bit < crossings.size(); ++bit) {
        if (media >> bit & 1u) crossings[bit] += sign;
    }
}

std::uint32_t mediaAlong(glm::vec3 origin, glm::vec3 direction, const SurfaceTable& surfaces,
                         const RayCaster& caster) {
    Crossings crossings{};
    int skip = -1;
    for (int i = 0; i < 4096; ++i) {  // far above any real model; ends rays caught between doubles
        const RayHit hit = caster.cast(origin, direction, skip);
        if (hit.surface < 0) break;
        const transport::SurfaceHit surface = surfaces.at(hit, origin, direction);
        const int sign = dot(direction, cross(surface.e1, surface.e2)) > 0.0f ? 1 : -1;
        count(crossings, surface.inside, sign);
        count(crossings, surface.outside, -sign);
        origin = surface.position;
        skip = surface.triangle;
    }
    std::uint32_t media = 0;
    for (std::size_t bit = 0; bit < crossings.size(); ++bit) {
        if (crossings[bit] > 0) media |= 1u << bit;
    }
    return media;
}

}  // namespace

std::uint32_t mediaAround(glm::vec3 point, const SurfaceTable& surfaces,
                          const RayCaster& caster) noexcept {
    const Bounds& bounds = surfaces.bounds();
    if (bounds.empty() || glm::any(glm::lessThan(point, bounds.least)) ||
        glm::any(glm::greaterThan(point, bounds.most))) {
        return 0;
    }
    // Two of three: one ray may run along an edge or leave through a hole. The directions are
    // arbitrary but for not being parallel to anything that people model.
    const std::uint32_t a =
        mediaAlong(point, glm::normalize(glm::vec3(0.5377f, 0.7193f, -0.4399f)), surfaces, caster);
    const std::uint32_t b =
        mediaAlong(point, glm::normalize(glm::vec3(-0.6821f, 0.2753f, 0.6777f)), surfaces, caster);
    const std::uint32_t c =
        mediaAlong(point, glm::normalize(glm::vec3(0.1739f, -0.8807f, 0.4407f)), surfaces, caster);
    return (a & b) | (b & c) | (a & c);
}

transport::TransportSettings transportSettings(const RenderOptions& options) noexcept {
    transport::TransportSettings settings;
    settings.fidelity = static_cast<int>(options.fidelity);
    settings.fresnel = static_cast<int>(options.fresnel);
    settings.rayBudget = std::max(options.rayBudget, 1);
    settings.maxDepth = std::max(options.maxDepth, 1);
    // A look-up in place of a branch is wrong by what a sun makes of it: 1e-3 of 10^4 is a bright
    // pixel. Where light branches are not split they cost little, and can be followed to the end.
    settings.splitGain = options.splitGain;
    settings.weightCutoff =
        settings.splitGain > 0.0f ? std::min(options.weightCutoff, 1e-5f) : options.weightCutoff;
    return settings;
}

}  // namespace tukor::trace
