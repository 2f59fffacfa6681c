// The oracles themselves: laws that their pictures must obey whatever the renderers do.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "oracle/closed_form.h"
#include "oracle/equirect.h"
#include "tukor/materials/materials.h"

namespace tukor::oracle {
namespace {

using glm::dvec3;

const dvec3 kEye(0.0, 0.0, 4.0);
const dvec3 kForward(0.0, 0.0, -1.0);

glm::vec3 white(glm::vec3) {
    return glm::vec3(1.0f);
}

/// A smooth environment that tells all directions apart.
glm::vec3 directionAsRadiance(glm::vec3 d) {
    return 0.5f * (d + glm::vec3(1.0f));
}

void expectNear(dvec3 a, dvec3 b, double tolerance) {
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(a[channel], b[channel], tolerance);
}

/// Rays from kEye that hit the unit sphere at all impact parameters.
dvec3 rayAt(double impact) {
    const double sinAngle = impact / 4.0;
    return {sinAngle * 0.6, sinAngle * 0.8, -std::sqrt(1.0 - sinAngle * sinAngle)};
}

TEST(ReflectingSphere, ShowsWhatIsBehindTheEyeInItsCentre) {
    const Material gold = parseMaterial("gold");
    const dvec3 centre = reflectingSphere(gold, directionAsRadiance)(kEye, kForward);
    expectNear(centre, dvec3(0.925406, 0.729742, 0.381420) * dvec3(0.5, 0.5, 1.0), 1e-5);
}

TEST(ReflectingSphere, ReflectsTheEdgeForwards) {
    const Material mirror = mirrorMaterial(glm::vec3(0.9f, 0.5f, 0.1f));
    const dvec3 direction = rayAt(1.0 - 1e-9);
    const dvec3 seen = reflectingSphere(mirror, directionAsRadiance)(kEye, direction);
    expectNear(seen, dvec3(mirror.tint) * dvec3(directionAsRadiance(glm::vec3(direction))), 1e-3);
}

TEST(ReflectingSphere, FollowsTheRequestedFresnelForm) {
    const Material silver = parseMaterial("silver");
    const dvec3 direction = rayAt(0.95);
    const dvec3 exact = reflectingSphere(silver, white)(kEye, direction);
    const dvec3 schlick = reflectingSphere(silver, white, FresnelForm::schlick)(kEye, direction);
    EXPECT_GT(glm::length(exact - schlick), 1e-4);
    expectNear(exact, schlick, 0.0164);  // the approximation's largest error for silver
}

TEST(SolidSphere, IsInvisibleInAWhiteFurnace) {
    for (const float eta : {1.0f / 1.333f, 1.2f, 1.333f, 1.46f, 2.42f}) {
        const View view = solidSphere(dielectricMaterial(eta), white);
        const View single = singleInterfaceSphere(dielectricMaterial(eta), white);
        for (int i = 0; i <= 1000; ++i) {
            const dvec3 direction = rayAt(i / 1000.0);
            expectNear(view(kEye, direction), dvec3(1.0), 1e-12);
            expectNear(single(kEye, direction), dvec3(1.0), 1e-12);
        }
    }
}

TEST(SolidSphere, IsInvisibleWithTheIndexOfItsSurroundings) {
    const View view = solidSphere(dielectricMaterial(1.0f), directionAsRadiance);
    for (int i = 0; i < 100; ++i) {
        const dvec3 direction = rayAt(i / 100.0);
        expectNear(view(kEye, direction), dvec3(directionAsRadiance(glm::vec3(direction))), 1e-6);
    }
}

TEST(SolidSphere, TurnsTheWorldUpsideDown) {
    // Paraxial ball lens: the ray at height b leaves with slope -b (2 eta - 2) / eta times its own
    // sign: light from below is seen in the upper half. The single interface keeps it upright.
    const auto height = [](glm::vec3 d) { return glm::vec3(d.y); };
    const dvec3 upper(0.0, 0.4 / 4.0, -std::sqrt(1.0 - 0.01));
    EXPECT_LT(solidSphere(dielectricMaterial(1.46f), height)(kEye, upper).x, -0.05);
    // Entering refracts towards the normal, so the ray's rise is smaller but not yet reversed.
    const dvec3 gentle(0.0, 0.05 / 4.0, -std::sqrt(1.0 - 0.05 * 0.05 / 16.0));
    EXPECT_LT(singleInterfaceSphere(dielectricMaterial(1.46f), height)(kEye, gentle).x, 0.0125);
}

TEST(SolidSphere, DeviatesTheFirstExitAsGeometryPredicts) {
    // Deviation of the once refracted ray: 2 (alpha - beta), with sin alpha = impact parameter.
    const double eta = 1.46;
    const double impact = 0.6;
    const dvec3 eye(0.0, impact, 1000.0);
    const double alpha = std::asin(impact);
    const double beta = std::asin(impact / eta);
    const double deviation = 2.0 * (alpha - beta);
    const glm::vec3 expected(0.0f, static_cast<float>(-std::sin(deviation)),
                             static_cast<float>(-std::cos(deviation)));
    // A narrow lobe finds out where the light comes from; the other exits are elsewhere.
    const auto lobe = [expected](glm::vec3 d) {
        return glm::vec3(glm::dot(d, expected) > std::cos(1e-3f) ? 1.0f : 0.0f);
    };
    const double R = fresnel(std::cos(alpha), static_cast<float>(eta), 0.0);
    const View view = solidSphere(dielectricMaterial(static_cast<float>(eta)), lobe);
    EXPECT_NEAR(view(eye, kForward).x, (1.0 - R) * (1.0 - R), 1e-6);
}

TEST(SolidSphere, AbsorbsAlongTheChord) {
    const glm::vec3 sigmaA(0.1f, 1.0f, 3.0f);
    const View view = solidSphere(dielectricMaterial(1.0f, sigmaA), white);
    expectNear(view(kEye, kForward), glm::exp(-2.0 * dvec3(sigmaA)), 1e-7);
    // At impact parameter 0.6 the chord of a sphere with index 1 is 2 cos(asin 0.6) = 1.6.
    expectNear(view(dvec3(0.6, 0.0, 9.0), kForward), glm::exp(-1.6 * dvec3(sigmaA)), 1e-7);
}

TEST(SolidSphere, LosesMoreThanOneChordWhereItReflectsInside) {
    const View view = solidSphere(dielectricMaterial(1.5f, glm::vec3(0.7f)), white);
    // Normal incidence, R = 0.04, t = exp(-1.4): R + T^2 t / (1 - R t) by the geometric series.
    const double t = std::exp(-2.0 * static_cast<double>(0.7f));
    EXPECT_NEAR(view(kEye, kForward).x, 0.04 + 0.96 * 0.96 * t / (1.0 - 0.04 * t), 2e-6);
}

TEST(Picture, PutsTheWorldTheRightWayRound) {
    Camera camera;  // at (0, 0, 4), towards -Z
    const Image image = picture(camera, 8, 4, 4, background(directionAsRadiance));
    EXPECT_GT(image.at(7, 1).x, image.at(0, 1).x);  // +X to the right
    EXPECT_GT(image.at(3, 0).y, image.at(3, 3).y);  // +Y at the top
    EXPECT_LT(image.at(4, 2).z, 0.1f);              // -Z in the middle
    // Symmetric about the centre: samples are at the same places left and right.
    EXPECT_NEAR(image.at(0, 0).x + image.at(7, 0).x, 1.0f, 1e-6f);
}

TEST(Picture, CoversTheSphereAsPerspectiveSays) {
    // The outline of a unit sphere at distance 4 has tangent 1 / sqrt(15): its share of the
    // picture's area, in units of the half height tan(fov / 2).
    Camera camera;
    const auto one = [](dvec3 eye, dvec3 direction) {
        return reflectingSphere(mirrorMaterial(glm::vec3(1.0f)),
                                [](glm::vec3) { return glm::vec3(0.0f); })(eye, direction) +
               dvec3(glm::length(glm::cross(eye, direction)) > 1.0 ? 1.0 : 0.0);
    };
    const Image image = picture(camera, 90, 90, 4, one);
    double outside = 0.0;
    for (const glm::vec3& pixel : image.pixels()) outside += pixel.x;
    const double halfHeight = std::tan(0.5 * static_cast<double>(camera.verticalFov));
    const double disc = 3.14159265 / 15.0 / (4.0 * halfHeight * halfHeight);
    EXPECT_NEAR(1.0 - outside / (90.0 * 90.0), disc, 1e-3);
}

TEST(Equirect, HasItsCentreAtMinusZAndXToTheRight) {
    // 8 x 4 texels; the directions of texel centres come back exactly.
    Image panorama(8, 4);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) {
            panorama.at(column, row) =
                glm::vec3(static_cast<float>(column), static_cast<float>(row), 1.0f);
        }
    }
    const Environment environment = equirect(panorama);
    const double pi = 3.14159265358979;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) {
            const double longitude = (column + 0.5) / 8.0 * 2.0 * pi - pi;
            const double latitude = pi / 2.0 - (row + 0.5) / 4.0 * pi;
            const glm::vec3 d(dvec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                    -std::cos(latitude) * std::cos(longitude)));
            expectNear(dvec3(environment(d)), dvec3(column, row, 1.0), 1e-5);
        }
    }
    EXPECT_NEAR(environment(glm::vec3(0, 0, -1)).x, 3.5f, 1e-5f);  // the centre of the picture
    EXPECT_NEAR(environment(glm::vec3(1, 0, 0)).x, 5.5f, 1e-5f);   // to its right
    EXPECT_NEAR(environment(glm::vec3(0, 1, 0)).y, 0.0f, 1e-5f);   // the top row
    EXPECT_NEAR(environment(glm::vec3(0, 0, 1)).x, 3.5f, 1e-5f);   // the seam: mean of 7 and 0
}

TEST(Equirect, TakesBrokenTexelsAsBlack) {
    Image panorama(2, 1);
    panorama.at(0, 0) = glm::vec3(std::numeric_limits<float>::quiet_NaN(), -1.0f, 0.5f);
    panorama.at(1, 0) = glm::vec3(std::numeric_limits<float>::infinity(), 2.0f, 0.5f);
    const glm::vec3 seam = equirect(panorama)(glm::vec3(0, 0, 1));
    expectNear(dvec3(seam), dvec3(0.0, 1.0, 0.5), 1e-6);
}

}  // namespace
}  // namespace tukor::oracle
