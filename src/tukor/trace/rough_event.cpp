#include "tukor/trace/rough_event.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tukor::trace {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kWidestSpread = 0.5f;  // radians, as far as differentials mean anything
constexpr int kSurestDepth = 3;        // events after which paths may end by chance
constexpr std::uint32_t kAsked = 4;    // bright directions, by event
constexpr float kAnyDistance = std::numeric_limits<float>::infinity();
constexpr int kMostSheets = 32;  // that a shadow ray passes

/// The power heuristic. [Veach 1997, sec. 9.2.4]
float shareOf(float pdf, float other) noexcept {
    const float a = pdf * pdf, b = other * other;
    return a / std::max(a + b, 1e-30f);
}

/// As wide as a sample is far from its neighbours.
transport::Footprint spreadFootprint(glm::vec3 direction, float spread) noexcept {
    transport::Footprint f = transport::thinFootprint();
    const glm::vec3 axis = std::abs(direction.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 x = glm::normalize(glm::cross(axis, direction));
    f.directionX = spread * x;
    f.directionY = spread * glm::cross(direction, x);
    return f;
}

}  // namespace

RoughEvent::RoughEvent(const Scene& scene, const SurfaceTable& surfaces, const RayCaster& caster,
                       const EnvironmentMap& environment, const EnvironmentMap* backdrop,
                       float expectedSamples)
    : surfaces_(surfaces),
      caster_(caster),
      environment_(environment),
      backdrop_(backdrop),
      finishes_(scene),
      lamps_(scene.lights),
      expectedSamples_(expectedSamples) {
    if (!finishes_.empty()) lights_ = std::make_unique<LightSampler>(environment);
    const bool ground = std::any_of(scene.parts.begin(), scene.parts.end(), [](const Part& part) {
        return part.material.finish && part.material.finish->catcher;
    });
    if (ground) skyOnGround_ = irradianceFromAbove(environment);
}

float RoughEvent::visible(const transport::Branch& at, glm::vec3 direction, float distance,
                          RayHit hit) const noexcept {
    float left = 1.0f;
    glm::vec3 origin = at.origin;
    for (int i = 0; i < kMostSheets; ++i) {
        if (hit.surface < 0 || hit.distance > distance) return left;
        if (!concerns(hit)) break;
        const Finish& finish = *finishes_.finishOf(hit.surface);
        if (finish.alphaMode == AlphaMode::opaque && !finish.catcher) break;
        const transport::SurfaceHit surface = surfaces_.at(hit, origin, direction);
        const bool fromBelow = direction.y >= 0.0f && finish.catcher;
        if (!fromBelow) left *= finishes_.clearness(hit, surface);
        if (!(left > 0.0f)) break;
        origin = surface.position;
        distance -= hit.distance;
        hit = caster_.cast(origin, direction, surface.triangle);
    }
    return 0.0f;
}

float RoughEvent::visible(const transport::Branch& at, glm::vec3 direction,
                          float distance) const noexcept {
    return visible(at, direction, distance, caster_.cast(at.origin, direction, at.skip));
}

glm::vec3 RoughEvent::lamplight(const Layered& layers, const transport::Branch& at) const noexcept {
    glm::vec3 sum(0.0f);
    for (const Light& lamp : lamps_) {
        const LightAt light = lightAt(lamp, at.origin);
        const glm::vec3 L = layers.eval(light.wi).value * light.E;
        if (transport::heaviness(L) > 0.0f) sum += L * visible(at, light.wi, light.distance);
    }
    return sum;
}

glm::vec3 RoughEvent::direct(const Layered& layers, const transport::Branch& at,
                             PathSampler& sampler) const noexcept {
    if (at.media != 0u) return glm::vec3(0.0f);  // the way out of a solid is never straight
    RayPacket rays;
    LookUpBatch lookUps;
    std::array<glm::vec3, kPacketWidth> weights;
    int count = 0;
    const PathSampler::Points points = sampler.begin(kAsked);
    for (std::uint32_t i = 0; i < kAsked; ++i) {
        const LightDirection light = lights_->sample(points.at(i));
        if (!(light.pdf > 0.0f)) continue;
        const LobeValue lobes = layers.eval(light.direction);
        if (!(transport::heaviness(lobes.value) > 0.0f)) continue;
        const float pdf = kAsked * light.pdf;
        weights[static_cast<std::size_t>(count)] = lobes.value * (shareOf(pdf, lobes.pdf) / pdf);
        environment_.add(lookUps, light.direction, 0.0f);
        rays.set(count++, at.origin, light.direction, at.skip);
    }
    glm::vec3 sum = lamplight(layers, at);
    if (count == 0) return sum;
    environment_.look(lookUps);
    std::array<RayHit, kPacketWidth> hits;
    caster_.cast(rays, count, Coherence::none, hits);
    for (int i = 0; i < count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const glm::vec3 wi(rays.directionX[n], rays.directionY[n], rays.directionZ[n]);
        if (const float seen = visible(at, wi, kAnyDistance, hits[n]); seen > 0.0f)
            sum += weights[n] * lookUps.sum(i, 1) * seen;
    }
    return sum;
}

glm::vec3 RoughEvent::escape(const transport::Branch& branch, const Chosen& chosen) const noexcept {
    const float share = branch.media != 0u
                            ? 1.0f
                            : shareOf(chosen.pdf, chosen.asked * lights_->pdf(branch.direction));
    return branch.throughput * environment_.radiance(branch.direction, 0.0f) * share;
}

glm::vec3 RoughEvent::meetGround(transport::Tree& tree, transport::Branch at, PathSampler& sampler,
                                 Chosen& chosen) const noexcept {
    if (at.direction.y >= 0.0f || at.media != 0u) {  // it has one side, and is nothing within glass
        tree.branch = at;
        return glm::vec3(0.0f);
    }
    glm::vec3 E = skyOnGround_;
    for (const Light& lamp : lamps_) {
        const LightAt light = lightAt(lamp, at.origin);
        E += light.E * std::max(light.wi.y, 0.0f);
    }
    // What is behind, in full; then what things take of that, and what they send.
    const bool drawn = at.depth > 1 || backdrop_;
    const EnvironmentMap& behind = at.depth > 1 || !backdrop_ ? environment_ : *backdrop_;
    glm::vec3 seen = behind.radiance(at.direction, transport::footprintSolidAngle(at.footprint));
    if (!drawn) seen = glm::max(seen, glm::vec3(1e-6f));
    const glm::vec3 radiance = drawn ? at.throughput * seen : glm::vec3(0.0f);
    if (at.depth > 1) seen = glm::min(seen, E / kPi);  // no ground reflects more than it gets
    const glm::vec3 perE = at.throughput * seen / glm::max(E, glm::vec3(1e-20f));
    glm::vec3 taken(0.0f);
    for (const Light& lamp : lamps_) {
        const LightAt light = lightAt(lamp, at.origin);
        if (light.wi.y > 0.0f)
            taken += light.E * (light.wi.y * (1.0f - visible(at, light.wi, light.distance)));
    }
    const LightDirection light = lights_->sample(sampler.point());
    if (light.pdf > 0.0f && light.direction.y > 0.0f) {
        const float hidden = 1.0f - visible(at, light.direction, kAnyDistance);
        if (hidden > 0.0f)
            taken += environment_.radiance(light.direction, 0.0f) *
                     (light.direction.y * hidden * shareOf(light.pdf, light.direction.y / kPi) /
                      light.pdf);
    }
    const glm::vec2 u = sampler.point();
    const float r = std::sqrt(u.x), phi = 2.0f * kPi * u.y;
    at.direction = glm::normalize(
        glm::vec3(r * std::cos(phi), std::sqrt(std::max(1.0f - u.x, 1e-8f)), r * std::sin(phi)));
    at.throughput = perE * kPi;
    chosen = {at.direction.y / kPi, true};
    if (!drawn) chosen.behind = seen;
    at.footprint = spreadFootprint(
        at.direction, std::min(1.0f / std::sqrt(chosen.pdf * expectedSamples_), kWidestSpread));
    tree.branch = at;
    if (!(transport::heaviness(at.throughput) > 0.0f)) transport::endBranch(tree);
    return radiance - perE * taken;
}

glm::vec3 RoughEvent::meet(transport::Tree& tree, const RayHit& hit,
                           const transport::SurfaceHit& surface, const transport::Encounter& met,
                           const Media& media, PathSampler& sampler,
                           Chosen& chosen) const noexcept {
    transport::Branch at = tree.branch;
    const glm::vec3 d = at.direction;
    const auto& [from, to] = media;
    const Finish& finish = *finishes_.finishOf(hit.surface);
    at.throughput *= optics::transmittance(from.sigmaA, hit.distance);
    const transport::Footprint footprint =
        transport::footprintAtSurface(at.footprint, d, hit.distance, met.face.ng);
    at.origin = surface.position;
    at.skip = surface.triangle;
    at.depth = at.depth + 1;
    if (finish.catcher) {
        at.footprint = footprint;
        return meetGround(tree, at, sampler, chosen);
    }
    Appearance look = finishes_.at(hit, surface, met.face, d, footprint);

    if (look.alpha < 1.0f && transport::nextRandom(tree) >= look.alpha) {  // straight on
        at.footprint.originX += hit.distance * at.footprint.directionX;
        at.footprint.originY += hit.distance * at.footprint.directionY;
        tree.branch = at;
        return glm::vec3(0.0f);
    }
    chosen.pdf = 0.0f;
    if (finish.unlit) {
        transport::endBranch(tree);
        return at.throughput * look.baseColor;
    }
    glm::vec3 radiance = at.throughput * look.emission;

    // As rough at least as the footprint is wide: what a sharper highlight holds would be found by
    // few samples, and be bright.
    const float width = std::sqrt(transport::footprintSolidAngle(at.footprint));
    look.a =
        glm::max(look.a, glm::vec2(std::min(0.5f * width, 0.3f) * (width > 0.02f ? 1.0f : 0.0f)));

    const bool solid = surface.kind == transport::kDielectric;
    // What is opaque may be a sheet, and be seen from behind.
    if (solid && !met.consistent) tree.inconsistencies = tree.inconsistencies + 1;
    if (solid && from.eta == to.eta) {  // nothing to be seen
        at.media = met.beyond;
        at.footprint = footprint;
        tree.branch = at;
        return glm::vec3(0.0f);
    }
    const Layered::Base base = solid                      ? Layered::Base::solid
                               : look.transmission > 0.0f ? Layered::Base::thin
                                                          : Layered::Base::opaque;
    const Layered layers(look, base, solid ? to.eta / from.eta : 1.0f,
                         solid ? finishes_.clearAlbedo(hit.surface, to.eta > from.eta) : nullptr,
                         -d);
    radiance += at.throughput * direct(layers, at, sampler);

    const glm::vec2 u = sampler.point();
    LobeSample sample = layers.sample(sampler.point().x, u);
    float weight = transport::heaviness(sample.weight);
    if (weight > 0.0f && at.depth > kSurestDepth && weight < 1.0f) {
        if (transport::nextRandom(tree) >= weight) weight = 0.0f;
        sample.weight = weight > 0.0f ? sample.weight / weight : sample.weight;
    }
    if (!(weight > 0.0f)) {
        transport::endBranch(tree);
        return radiance;
    }
    const bool enclosed = at.media != 0u;  // then the environment was not asked
    at.direction = transport::onSide(sample.wi, met.face.ng, sample.through ? -1.0f : 1.0f);
    at.throughput *= sample.weight;
    if (solid && sample.through) at.media = met.beyond;
    if (sample.pdf > 0.0f) {
        const float spread =
            std::min(1.0f / std::sqrt(sample.pdf * expectedSamples_), kWidestSpread);
        at.footprint = spreadFootprint(at.direction, spread);
        if (!enclosed) chosen = {sample.pdf, false, kAsked};
    } else if (!sample.through) {
        at.footprint = transport::reflectedFootprint(
            footprint, transport::normalChangeOver(footprint, surface, met.face), met.face, d);
    } else {
        at.footprint = footprint;
    }
    tree.branch = at;
    return radiance;
}

}  // namespace tukor::trace
