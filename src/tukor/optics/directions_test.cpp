#include "tukor/optics/directions.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tukor/optics/fresnel.h"

namespace tukor::optics {
namespace {

constexpr int kTrials = 20000;
constexpr unsigned kSeed = 20090621;

vec3 randomUnit(std::mt19937& random) {
    std::normal_distribution<float> gauss;
    for (;;) {
        const vec3 v(gauss(random), gauss(random), gauss(random));
        const float length2 = dot(v, v);
        if (length2 > 1e-6f) return v / std::sqrt(length2);
    }
}

/// A direction towards a surface with a normal on the light's side.
struct Incidence {
    vec3 d;
    vec3 n;
    float eta;
};

Incidence randomIncidence(std::mt19937& random) {
    Incidence in{};
    in.n = randomUnit(random);
    in.d = randomUnit(random);
    if (dot(in.d, in.n) > 0.0f) in.d = -in.d;
    in.eta = std::uniform_real_distribution<float>(0.4f, 2.5f)(random);
    return in;
}

TEST(Facing, KeepsNormalAndIndexInFront) {
    const Interface face = facing(vec3(0, 0, -1), vec3(0, 0, 1), 1.46f);
    EXPECT_EQ(face.n, vec3(0, 0, 1));
    EXPECT_EQ(face.eta, 1.46f);
    EXPECT_EQ(face.cosThetaI, 1.0f);
}

TEST(Facing, FlipsNormalAndInvertsTheIndexFromBehind) {
    const Interface face = facing(vec3(0, 0.6f, 0.8f), vec3(0, 0, 1), 1.46f);
    EXPECT_EQ(face.n, vec3(0, 0, -1));
    EXPECT_FLOAT_EQ(face.eta, 1.0f / 1.46f);
    EXPECT_FLOAT_EQ(face.cosThetaI, 0.8f);
}

TEST(Facing, GivesACosineFromZeroToOneAndANormalAgainstTheLight) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < kTrials; ++i) {
        const vec3 d = randomUnit(random);
        const vec3 n = i % 3 == 0 ? (i % 2 == 0 ? d : -d) : randomUnit(random);
        const Interface face = facing(d, n, 1.5f);
        ASSERT_TRUE(face.cosThetaI >= 0.0f && face.cosThetaI <= 1.0f) << face.cosThetaI;
        ASSERT_LE(dot(d, face.n), 0.0f);
        ASSERT_TRUE(face.n == n || face.n == -n);
        ASSERT_EQ(face.eta, face.n == n ? 1.5f : 1.0f / 1.5f);
    }
}

TEST(ReflectDirection, IsTheMirrorImageInThePlaneOfIncidence) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < kTrials; ++i) {
        const Incidence in = randomIncidence(random);
        const vec3 r = reflectDirection(in.d, in.n);
        ASSERT_NEAR(length(r), 1.0f, 1e-6f);
        ASSERT_NEAR(dot(r, in.n), -dot(in.d, in.n), 1e-6f);
        ASSERT_NEAR(dot(r, cross(in.d, in.n)), 0.0f, 1e-6f);
        ASSERT_LT(length(reflectDirection(r, in.n) - in.d), 2e-6f);
        ASSERT_LT(length(reflectDirection(in.d, -in.n) - r), 1e-6f);           // either sign of n
        ASSERT_LT(length(r - (in.d - 2.0f * dot(in.n, in.d) * in.n)), 1e-6f);  // GLSL's reflect
    }
}

TEST(RefractDirection, ObeysSnellsLawInThePlaneOfIncidence) {
    std::mt19937 random(kSeed);
    int refracted = 0;
    for (int i = 0; i < kTrials; ++i) {
        const Incidence in = randomIncidence(random);
        const Refraction r = refractDirection(in.d, in.n, in.eta);
        if (r.total) continue;
        ++refracted;
        ASSERT_NEAR(length(r.direction), 1.0f, 1e-6f);
        const float sinThetaI = length(cross(in.d, in.n));
        const float sinThetaT = length(cross(r.direction, in.n));
        ASSERT_NEAR(sinThetaI, in.eta * sinThetaT, 2e-6f) << "eta " << in.eta;
        ASSERT_NEAR(dot(r.direction, cross(in.d, in.n)), 0.0f, 1e-6f);
        // Forward, to the far side, at the cosine that it reports. Near the critical angle a cosine
        // of rounding size is the square root of one.
        ASSERT_GE(dot(r.direction, in.d), 0.0f);
        ASSERT_NEAR(-dot(r.direction, in.n), r.cosThetaT, r.cosThetaT < 0.01f ? 1e-3f : 1e-5f);
    }
    EXPECT_GT(refracted, kTrials / 2);
}

TEST(RefractDirection, ThereAndBackIsTheIdentity) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < kTrials; ++i) {
        const Incidence in = randomIncidence(random);
        const Refraction there = refractDirection(in.d, in.n, in.eta);
        if (there.total || there.cosThetaT < 0.05f) continue;  // beyond, rounding rules
        const Refraction back = refractDirection(-there.direction, -in.n, 1.0f / in.eta);
        if (-dot(in.d, in.n) < 0.05f) continue;
        ASSERT_FALSE(back.total);
        ASSERT_LT(length(back.direction + in.d), 2e-5f) << "eta " << in.eta;
    }
}

TEST(RefractDirection, GoesStraightWhereTheIndexDoesNotChange) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < kTrials; ++i) {
        const Incidence in = randomIncidence(random);
        const Refraction r = refractDirection(in.d, in.n, 1.0f);
        ASSERT_FALSE(r.total);
        ASSERT_LT(length(r.direction - in.d), 1e-6f);
    }
}

TEST(RefractDirection, GoesStraightAtNormalIncidence) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < kTrials; ++i) {
        const vec3 n = randomUnit(random);
        for (const float eta : {0.4f, 1.333f, 2.42f}) {
            const Refraction r = refractDirection(-n, n, eta);
            ASSERT_FALSE(r.total);
            ASSERT_LT(length(r.direction + n), 1e-6f);
            ASSERT_NEAR(r.cosThetaT, 1.0f, 4e-7f / (eta * eta));  // |n|^2 errs by 4e-7
        }
    }
}

TEST(RefractDirection, IsTotalExactlyWhereFresnelIsOne) {
    // Directions crowded around the critical angle, where one ulp decides. If one said total and
    // the other let light through, that light would be lost.
    std::mt19937 random(kSeed);
    int total = 0;
    for (int i = 0; i < kTrials; ++i) {
        const vec3 n = randomUnit(random);
        vec3 tangent = cross(n, randomUnit(random));
        tangent = normalize(tangent);
        const float eta = std::uniform_real_distribution<float>(0.3f, 0.999f)(random);
        const float off = std::normal_distribution<float>(0.0f, 3e-7f)(random);
        const float sinThetaI = eta * (1.0f + off);
        const vec3 d = normalize(sinThetaI * tangent -
                                 std::sqrt(std::max(0.0f, 1.0f - sinThetaI * sinThetaI)) * n);
        const Interface face = facing(d, -n, 1.0f / eta);  // seen from inside
        const Refraction r = refractDirection(d, face.n, face.eta);
        const float R = fresnelDielectric(face.cosThetaI, face.eta);
        ASSERT_EQ(r.total, R == 1.0f) << "eta " << eta << " cosThetaI " << face.cosThetaI;
        ASSERT_EQ(r.total, r.cosThetaT == 0.0f);
        ASSERT_NEAR(length(r.direction), 1.0f, 1e-6f);  // usable even then
        total += r.total ? 1 : 0;
    }
    EXPECT_GT(total, kTrials / 4);
    EXPECT_LT(total, 3 * kTrials / 4);
}

TEST(RefractDirection, StaysFiniteAtGrazingIncidence) {
    const vec3 n(0, 1, 0);
    for (const float eta : {0.4f, 0.999f, 1.0f, 1.0003f, 1.333f, 2.42f}) {
        for (float c = 1.0f; c > 1e-44f; c *= 0.1f) {
            const vec3 d(std::sqrt(1.0f - c * c), -c, 0.0f);
            const Refraction r = refractDirection(d, n, eta);
            if (r.total) {
                ASSERT_TRUE(std::isfinite(length(r.direction)));
            } else {
                ASSERT_NEAR(length(r.direction), 1.0f, 1e-6f)
                    << "eta " << eta << " cosThetaI " << c;
            }
            ASSERT_TRUE(r.cosThetaT >= 0.0f && r.cosThetaT <= 1.0f + 1e-6f);
        }
    }
}

TEST(RefractDirection, CarriesBasicRadianceThroughAnInterface) {
    // Conservation of etendue: etaI^2 cosThetaI dOmegaI = etaT^2 cosThetaT dOmegaT, from a finite
    // patch of directions. Together with T it is what makes L / eta^2 the invariant.
    const vec3 n(0, 1, 0);
    const double h = 0.02;  // rad: curvature error h^2 / 3, rounding 1e-7 / h
    for (const float eta : {1.333f, 1.46f, 1.0f / 1.333f}) {
        for (const double thetaI : {0.2, 0.5, 0.7}) {
            const auto direction = [](double theta, double phi) {
                return vec3(static_cast<float>(std::sin(theta) * std::cos(phi)),
                            static_cast<float>(-std::cos(theta)),
                            static_cast<float>(std::sin(theta) * std::sin(phi)));
            };
            const auto refracted = [&](double theta, double phi) {
                return refractDirection(direction(theta, phi), n, eta).direction;
            };
            const double s = std::sin(thetaI);
            const double dOmegaI =
                length(cross(direction(thetaI + h, 0) - direction(thetaI - h, 0),
                             direction(thetaI, h / s) - direction(thetaI, -h / s)));
            const double dOmegaT =
                length(cross(refracted(thetaI + h, 0) - refracted(thetaI - h, 0),
                             refracted(thetaI, h / s) - refracted(thetaI, -h / s)));
            const double cosThetaT = refractDirection(direction(thetaI, 0), n, eta).cosThetaT;
            EXPECT_NEAR(eta * eta * cosThetaT * dOmegaT / (std::cos(thetaI) * dOmegaI), 1.0, 2e-3)
                << "eta " << eta << " thetaI " << thetaI;
        }
    }
}

}  // namespace
}  // namespace tukor::optics
