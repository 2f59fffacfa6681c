#include "tukor/transport/path_tree.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tukor/transport/test_host.h"

namespace tukor::transport {
namespace {

Medium mediumOfIndex(float eta, vec3 sigmaA = vec3(0.0f)) {
    Medium m;
    m.eta = eta;
    m.sigmaA = sigmaA;
    return m;
}

TestWorld glassSphere(float eta) {
    TestWorld world;
    world.media = {mediumOfIndex(eta)};
    TestSphere sphere;
    sphere.surface.inside = 1u;
    world.spheres = {sphere};
    return world;
}

std::vector<Deposit> depositsOf(const TestWorld& world, const Branch& ray,
                                const TransportSettings& settings, Tree* end = nullptr) {
    std::vector<Deposit> all;
    Tree tree =
        world.trace(ray, settings, 1u, [&](const Deposit& deposit) { all.push_back(deposit); });
    if (end) *end = tree;
    return all;
}

TEST(Media, TheHighestBitIsThere) {
    EXPECT_EQ(mediumOf(0u), kVacuum);
    for (int bit = 0; bit < 32; ++bit) {
        uint alone = 1u << bit;
        EXPECT_EQ(mediumOf(alone), bit);
        EXPECT_EQ(mediumOf(alone | (alone - 1u)), bit) << "all bits up to " << bit;
    }
}

TEST(PathTree, MirrorIsOneLookUpAlongTheReflection) {
    TestWorld world;
    TestSphere sphere;
    sphere.surface.kind = kMirror;
    sphere.surface.tint = vec3(0.9f, 0.5f, 0.1f);
    world.spheres = {sphere};
    auto all = depositsOf(world, testRay(vec3(0, 0, 4), vec3(0, 0, -1)), exactSettings());
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NEAR(all[0].direction.z, 1.0f, 1e-6f);
    EXPECT_EQ(all[0].throughput, sphere.surface.tint);
}

TEST(PathTree, GlassSphereGivesTheSeriesOfItsClosedForm) {
    // R along the reflection, then T^2 R^i after i inner reflections, each turned by pi - 2 beta.
    const float eta = 1.46f, height = 0.6f;
    TestWorld world = glassSphere(eta);
    auto all = depositsOf(world, testRay(vec3(height, 0, 4), vec3(0, 0, -1)), exactSettings());
    double alpha = std::asin(height), beta = std::asin(height / eta);
    float R = optics::fresnelDielectric(std::cos(static_cast<float>(alpha)), eta);
    ASSERT_GE(all.size(), 4u);
    double turn = 2.0 * (alpha - beta);  // deviation of the ray that goes straight through
    double weight = (1.0 - R) * (1.0 - R);
    int found = 0;
    for (int i = 0; i < 3; ++i, weight *= R, turn += std::numbers::pi - 2.0 * beta) {
        vec3 expected(-std::sin(turn), 0.0, -std::cos(turn));
        for (const Deposit& d : all) {
            if (std::abs(d.throughput.x - weight) > 1e-5) continue;
            EXPECT_LT(distance(d.direction, expected), 2e-6f) << "after " << i << " reflections";
            ++found;
        }
    }
    EXPECT_EQ(found, 3);
}

TEST(PathTree, LadderLooksUpAsTheLectureSays) {
    const float eta = 1.46f, height = 0.6f;
    TestWorld world = glassSphere(eta);
    Branch ray = testRay(vec3(height, 0, 4), vec3(0, 0, -1));
    vec3 n = vec3(height, 0, 0.8f);
    float R = optics::fresnelDielectric(0.8f, eta);
    vec3 inside = optics::refractDirection(ray.direction, n, eta).direction;
    TransportSettings settings = exactSettings();

    settings.fidelity = kFidelitySingle;
    auto single = depositsOf(world, ray, settings);
    ASSERT_EQ(single.size(), 2u);
    EXPECT_LT(distance(single[0].direction, optics::reflectDirection(ray.direction, n)), 1e-6f);
    EXPECT_NEAR(single[0].throughput.x, R, 1e-6f);
    EXPECT_LT(distance(single[1].direction, inside), 1e-6f);
    EXPECT_NEAR(single[1].throughput.x, 1.0f - R, 1e-6f);

    settings.fidelity = kFidelityTwo;
    auto two = depositsOf(world, ray, settings);
    ASSERT_EQ(two.size(), 2u);
    float turn = 2.0f * (std::asin(height) - std::asin(height / eta));
    EXPECT_LT(distance(two[1].direction, vec3(-std::sin(turn), 0, -std::cos(turn))), 1e-5f);
    EXPECT_NEAR(two[1].throughput.x, 1.0f - R, 1e-6f);

    settings.fidelity = kFidelitySingle;
    settings.fresnel = kFresnelSchlick;
    float R0 = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
    EXPECT_NEAR(depositsOf(world, ray, settings)[0].throughput.x,
                R0 + (1 - R0) * std::pow(0.2f, 5.0f), 1e-6f);
}

TEST(PathTree, AbsorbingSlabIsTheGeometricSeries) {
    // Seen head-on: all even orders leave forwards, with T^2 a / (1 - R^2 a^2).
    TestWorld world;
    vec3 sigmaA(0.5f, 2.0f, 0.0f);
    world.media = {mediumOfIndex(1.5f, sigmaA)};
    TestSurface surface;
    surface.inside = 1u;
    addBox(world, vec3(-1, -1, -0.35f), vec3(1, 1, 0.35f), surface);
    TransportSettings settings = exactSettings();
    settings.weightCutoff = 1e-7f;
    vec3 forwards(0.0f);
    for (const Deposit& d :
         depositsOf(world, testRay(vec3(0.1f, 0.2f, 3), vec3(0, 0, -1)), settings)) {
        if (d.direction.z < 0.0f) forwards += d.throughput;
    }
    for (int c = 0; c < 3; ++c) {
        double a = std::exp(-0.7 * sigmaA[c]), R = 0.04;
        EXPECT_NEAR(forwards[c], (1 - R) * (1 - R) * a / (1 - R * R * a * a), 1e-5);
    }
    world.media = {mediumOfIndex(1.0f, sigmaA)};  // invisible but for its colour
    auto all = depositsOf(world, testRay(vec3(0.1f, 0.2f, 3), vec3(0, 0, -1)), settings);
    ASSERT_EQ(all.size(), 1u);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(all[0].throughput[c], std::exp(-0.7 * sigmaA[c]), 1e-6);
    }
}

TEST(PathTree, OverlappingSolidsEqualExplicitInterfaces) {
    // A glass ball with a hollow of radius 0.5. The water in it is either a ball of radius 0.7 that
    // overlaps the glass, or the hollow's surface parts glass and water.
    TestWorld overlapping, explicitly;
    overlapping.media = explicitly.media = {mediumOfIndex(1.333f), mediumOfIndex(1.5f)};
    TestSphere outer, hollow, water, sheet;
    outer.surface.inside = 2u;
    hollow.radius = -0.5f;
    hollow.surface.inside = 2u;
    water.radius = 0.7f;
    water.surface.inside = 1u;
    overlapping.spheres = {outer, hollow, water};
    sheet.radius = 0.5f;
    sheet.surface.inside = 1u;
    sheet.surface.outside = 2u;
    explicitly.spheres = {outer, sheet};
    TransportSettings settings = exactSettings();
    settings.rayBudget = 4096;
    for (float height : {0.0f, 0.1f, 0.3f, 0.52f, 0.8f}) {
        Branch ray = testRay(vec3(height, 0.07f, 4), vec3(0, 0, -1));
        Tree a, b;
        vec3 sumA(0.0f), sumB(0.0f);  // a linear and a quadratic environment would tell them apart
        for (const Deposit& d : depositsOf(overlapping, ray, settings, &a)) {
            sumA += d.throughput * d.direction * (1.0f + d.direction.z);
        }
        for (const Deposit& d : depositsOf(explicitly, ray, settings, &b)) {
            sumB += d.throughput * d.direction * (1.0f + d.direction.z);
        }
        EXPECT_LT(distance(sumA, sumB), 1e-4f) << height;
        EXPECT_EQ(a.leaks + b.leaks + a.inconsistencies + b.inconsistencies, 0);
    }
}

TEST(PathTree, AnEyeInTheGlassSeesOut) {
    TestWorld world = glassSphere(1.5f);
    Branch ray = testRay(vec3(0.0f), vec3(0, 0, -1));
    ray.media = 1u;
    Tree end;
    auto all = depositsOf(world, ray, exactSettings(), &end);
    EXPECT_NEAR(all.at(0).throughput.x, 0.96f, 1e-6f);
    EXPECT_EQ(end.leaks + end.inconsistencies, 0);
}

TEST(PathTree, MetalInWaterHasTheIndexOfItsRatio) {
    TestWorld world;
    world.media = {mediumOfIndex(1.333f)};
    TestSphere ball;
    ball.surface.kind = kMetal;
    ball.surface.eta = vec3(0.21f, 0.485f, 1.29f);
    ball.surface.k = vec3(3.13f, 2.23f, 1.76f);
    world.spheres = {ball};
    Branch ray = testRay(vec3(0, 0, 4), vec3(0, 0, -1));
    ray.media = 1u;
    vec3 expected = optics::reflectanceAtNormal(ball.surface.eta / 1.333f, ball.surface.k / 1.333f);
    EXPECT_LT(distance(depositsOf(world, ray, exactSettings())[0].throughput, expected), 1e-5f);
}

TEST(PathTree, FollowingOneBranchByChanceHasTheMeanOfTheTree) {
    TestWorld world = glassSphere(1.8f);
    Branch ray = testRay(vec3(0.5f, 0.2f, 4), vec3(0, 0, -1));
    TransportSettings settings = exactSettings();
    settings.weightCutoff = 0.0f;
    settings.rayBudget = 4096;
    auto sum = [&](uint seed, double& total) {
        vec3 L(0.0f);
        world.trace(ray, settings, seed, [&](const Deposit& d) {
            L += d.throughput * (d.direction + vec3(1.0f));
            total += d.throughput.x;
        });
        return glm::dvec3(L);
    };
    double total = 0.0;
    settings.weightCutoff = 1e-7f;
    glm::dvec3 tree = sum(1u, total);
    settings.weightCutoff = 0.0f;
    settings.splitGain = 0.5f;
    glm::dvec3 mean(0.0), square(0.0);
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        total = 0.0;
        glm::dvec3 L = sum(static_cast<uint>(i) * 2654435769u, total);
        ASSERT_NEAR(total, 1.0, 1e-5);
        mean += L / double(n);
        square += L * L / double(n);
    }
    for (int c = 0; c < 3; ++c) {  // four standard errors
        double deviation = std::sqrt(std::max(square[c] - mean[c] * mean[c], 0.0) / n);
        EXPECT_NEAR(mean[c], tree[c], 4.0 * deviation + 1e-5);
    }
}

TEST(PathTree, BothChildrenAreFollowedWhereThatGainsMore) {
    EXPECT_TRUE(followsBoth(1.0f, 0.04f, 1, 0.01f));
    EXPECT_TRUE(followsBoth(1e-6f, 0.04f, 100, 0.0f)) << "always at 0";
    EXPECT_TRUE(followsBoth(0.04f, 0.04f, 5, 0.01f)) << "among the first rays";
    EXPECT_FALSE(followsBoth(0.04f, 0.04f, 50, 0.01f));
    EXPECT_FALSE(followsBoth(1.0f, 0.001f, 50, 0.01f));
    EXPECT_FALSE(followsBoth(1.0f, 0.999f, 50, 0.01f));
}

TEST(PathTree, ChanceIsSpreadEvenlyOverTreesOfOneSeed) {
    for (uint seed = 0; seed < 100u; ++seed) {
        int first = 0, second = 0;
        for (uint index = 0; index < 64u; ++index) {
            Tree tree = startTree(testRay(vec3(0.0f), vec3(0, 0, 1)), seed, index);
            first += nextRandom(tree) < 0.25f;
            second += nextRandom(tree) < 0.25f;
        }
        EXPECT_EQ(first, 16);
        EXPECT_EQ(second, 16);
    }
}

TEST(PathTree, FootprintIsTheDerivativeOfTheDirection) {
    TestWorld world = glassSphere(1.5f);
    auto out = [&](float x, float y) {
        Branch ray = testRay(vec3(0, 0, 4), vec3(0.12f + x, 0.05f + y, -1));
        ray.footprint =
            cameraFootprint(vec3(0.12f + x, 0.05f + y, -1), vec3(1, 0, 0), vec3(0, 1, 0));
        TransportSettings settings = exactSettings();
        settings.fidelity = kFidelityTwo;
        return depositsOf(world, ray, settings);
    };
    const float h = 2e-3f;
    for (std::size_t i : {0u, 1u}) {
        vec3 dx = (out(h, 0)[i].direction - out(-h, 0)[i].direction) / (2 * h);
        vec3 dy = (out(0, h)[i].direction - out(0, -h)[i].direction) / (2 * h);
        float numeric = length(cross(dx, dy));
        EXPECT_NEAR(out(0, 0)[i].solidAngle / numeric, 1.0f, 0.01f) << i;
    }
}

}  // namespace
}  // namespace tukor::transport
