// The lobes of finished surfaces keep energy, and sampling agrees with evaluation.
#include "tukor/trace/layered.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tukor/trace/sampler.h"

namespace tukor::trace {
namespace {

Appearance plain(float metallic, float roughness) {
    Appearance s{};
    s.n = s.coatNormal = {0, 0, 1};
    s.t = {1, 0, 0};
    s.b = {0, 1, 0};
    s.baseColor = s.metalF0 = glm::vec3(1.0f);
    s.alpha = 1.0f;
    s.metallic = metallic;
    s.roughness = roughness;
    s.a = glm::vec2(std::max(roughness * roughness, 1e-4f));
    s.F0 = glm::vec3(0.04f);
    s.F90 = glm::vec3(1.0f);
    return s;
}

glm::vec3 directionOf(float cosTheta) {
    return {std::sqrt(1.0f - cosTheta * cosTheta), 0.0f, cosTheta};
}

/// What comes back of uniform light, by sampling.
double albedo(const Layered& layers, int samples = 1 << 14) {
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        PathSampler sampler{17u, static_cast<std::uint32_t>(i), 0};
        const glm::vec2 u = sampler.point();
        sum += layers.sample(sampler.point().x, u).weight.y;
    }
    return sum / samples;
}

/// The same by evaluation over the sphere, without mirror-like lobes; and the integral of the
/// density.
glm::dvec2 integrals(const Layered& layers, int samples = 1 << 16) {
    glm::dvec2 sum(0.0);
    for (int i = 0; i < samples; ++i) {
        PathSampler sampler{5u, static_cast<std::uint32_t>(i), 0};
        const glm::vec2 u = sampler.point();
        const float z = 1.0f - 2.0f * u.x, r = std::sqrt(std::max(1.0f - z * z, 0.0f));
        const float phi = 2.0f * std::numbers::pi_v<float> * u.y;
        const LobeValue v = layers.eval({r * std::cos(phi), r * std::sin(phi), z});
        sum += glm::dvec2(v.value.y, v.pdf);
    }
    return sum * (4.0 * std::numbers::pi / samples);
}

// The white furnace: nothing is lost at any roughness and angle. 1 %: the tables have 64 rows.
TEST(Layered, KeepsAllLightOfWhiteMetalsAndDielectrics) {
    for (const float metallic : {0.0f, 0.5f, 1.0f})
        for (const float roughness : {0.0f, 0.1f, 0.3f, 0.5f, 0.7f, 0.9f, 1.0f})
            for (const float cosTheta : {0.1f, 0.3f, 0.6f, 0.95f}) {
                const Layered layers(plain(metallic, roughness), Layered::Base::opaque, 1.0f,
                                     nullptr, directionOf(cosTheta));
                EXPECT_NEAR(albedo(layers), 1.0, 0.01)
                    << metallic << ' ' << roughness << ' ' << cosTheta;
            }
}

TEST(Layered, KeepsAllLightOfRoughGlassFromBothSides) {
    for (const float eta : {1.33f, 1.5f, 2.4f, 1.0f / 1.5f, 1.0f / 2.4f}) {
        const ClearAlbedo clear(eta);
        for (const float roughness : {0.1f, 0.3f, 0.6f, 0.8f, 1.0f})
            for (const float cosTheta : {0.1f, 0.3f, 0.6f, 0.95f}) {
                Appearance look = plain(0.0f, roughness);
                look.transmission = 1.0f;
                const Layered layers(look, Layered::Base::solid, eta, &clear,
                                     directionOf(cosTheta));
                EXPECT_NEAR(albedo(layers), 1.0, 0.01)
                    << eta << ' ' << roughness << ' ' << cosTheta;
            }
    }
}

TEST(Layered, KeepsAllLightUnderCoatAndSheenAndInThinSheets) {
    for (const float roughness : {0.2f, 0.6f, 1.0f})
        for (const float cosTheta : {0.1f, 0.5f, 0.95f}) {
            Appearance look = plain(0.0f, roughness);
            look.coat = 1.0f;
            look.coatRoughness = 0.3f;
            const glm::vec3 wo = directionOf(cosTheta);
            EXPECT_NEAR(albedo(Layered(look, Layered::Base::opaque, 1.0f, nullptr, wo)), 1.0, 0.01)
                << roughness << ' ' << cosTheta;
            look.coat = 0.0f;
            look.sheen = glm::vec3(1.0f);
            look.sheenRoughness = roughness;
            EXPECT_NEAR(albedo(Layered(look, Layered::Base::opaque, 1.0f, nullptr, wo)), 1.0, 0.01)
                << roughness << ' ' << cosTheta;
            look.sheen = glm::vec3(0.0f);
            look.transmission = 0.7f;
            EXPECT_NEAR(albedo(Layered(look, Layered::Base::thin, 1.0f, nullptr, wo)), 1.0, 0.01)
                << roughness << ' ' << cosTheta;
        }
}

TEST(Layered, SamplesAsItEvaluates) {
    const ClearAlbedo clear(1.5f);
    for (const auto base : {Layered::Base::opaque, Layered::Base::thin, Layered::Base::solid})
        for (const float roughness : {0.5f, 0.9f}) {
            Appearance look = plain(0.3f, roughness);
            look.a.y *= 0.6f;
            look.coat = 0.5f;
            look.coatRoughness = 0.6f;
            look.sheen = glm::vec3(0.2f);
            look.sheenRoughness = 0.7f;
            look.transmission = base == Layered::Base::opaque ? 0.0f : 0.6f;
            const Layered layers(look, base, base == Layered::Base::solid ? 1.5f : 1.0f,
                                 base == Layered::Base::solid ? &clear : nullptr,
                                 directionOf(0.7f));
            const glm::dvec2 whole = integrals(layers);
            EXPECT_NEAR(whole.x, albedo(layers, 1 << 16), 0.01) << roughness;
            EXPECT_LT(whole.y, 1.01) << roughness;
            // Facets send some samples below the surface, where they end.
            EXPECT_GT(whole.y, 0.75) << roughness;
        }
}

}  // namespace
}  // namespace tukor::trace
