// What light does at a surface with a finish: asks the environment and the lamps, and goes on in
// one direction by chance.
#pragma once
#include "tukor/trace/frame.h"
#include "tukor/trace/ground.h"
#include "tukor/trace/layered.h"
#include "tukor/trace/light_sampler.h"
#include "tukor/trace/sampler.h"

namespace tukor::trace {

/// How a branch came by its direction.
struct Chosen {
    float pdf = 0.0f;  // where RoughEvent chose it, and light is to be weighted by that; else 0
    bool catching = false;   // from ground: light that arrives unhindered is counted already
    float asked = 1.0f;      // bright directions that the light was shared with
    glm::vec3 behind{0.0f};  // what the ground that it left would show, were the background drawn
};

/// The tracer's part for surfaces that are not ideally smooth. Threads may share it.
///
/// No fireflies: light that is found both by asking for it and by chance is weighted between the
/// two [Veach 1997]; what is only found by chance, through glass, is looked up over the solid angle
/// that the sample stands for, and surfaces met later are as rough as that at least; both shrink as
/// samples grow. No weight is ever larger than the albedo of a surface by more than the sampling of
/// one lobe misses, as paths end by chance only in proportion to it.
class RoughEvent {
public:
    RoughEvent(const Scene& scene, const SurfaceTable& surfaces, const RayCaster& caster,
               const EnvironmentMap& environment, const EnvironmentMap* backdrop,
               float expectedSamples);

    /// Whether the surface of a hit has a finish; then meet() is to be called instead of scatter().
    [[nodiscard]] bool concerns(const RayHit& hit) const noexcept {
        return hit.surface >= 0 && finishes_.finishOf(hit.surface) != nullptr;
    }

    /// On both sides of a surface.
    struct Media {
        transport::Medium from;
        transport::Medium to;
    };

    /// The current branch of a tree has met a surface with a finish. Returns the radiance found,
    /// and sets `chosen` to that of the branch's new direction where escape() is then to be used.
    /// On ground before no background that radiance is what things hide of `chosen.behind`.
    [[nodiscard]] glm::vec3 meet(transport::Tree& tree, const RayHit& hit,
                                 const transport::SurfaceHit& surface,
                                 const transport::Encounter& met, const Media& media,
                                 PathSampler& sampler, Chosen& chosen) const noexcept;

    /// The radiance of a branch that leaves the scene in the direction that meet() has chosen.
    [[nodiscard]] glm::vec3 escape(const transport::Branch& branch,
                                   const Chosen& chosen) const noexcept;

private:
    /// The share of light that comes over `distance` from `direction`.
    [[nodiscard]] float visible(const transport::Branch& at, glm::vec3 direction,
                                float distance) const noexcept;
    [[nodiscard]] float visible(const transport::Branch& at, glm::vec3 direction, float distance,
                                RayHit first) const noexcept;
    [[nodiscard]] glm::vec3 lamplight(const Layered& layers,
                                      const transport::Branch& at) const noexcept;
    /// Of ground; `at` lies on it.
    [[nodiscard]] glm::vec3 meetGround(transport::Tree& tree, transport::Branch at,
                                       PathSampler& sampler, Chosen& chosen) const noexcept;
    [[nodiscard]] glm::vec3 direct(const Layered& layers, const transport::Branch& at,
                                   PathSampler& sampler) const noexcept;

    const SurfaceTable& surfaces_;
    const RayCaster& caster_;
    const EnvironmentMap& environment_;
    const EnvironmentMap* backdrop_;  // what the ground shows the camera; null: nothing
    FinishTable finishes_;
    std::vector<Light> lamps_;
    std::unique_ptr<LightSampler> lights_;  // none where no part has a finish
    glm::vec3 skyOnGround_{0.0f};           // irradiance of ground that nothing shadows
    float expectedSamples_;
};

}  // namespace tukor::trace
