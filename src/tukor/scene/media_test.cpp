#include "tukor/scene/media.h"

#include <gmock/gmock.h>

#include "tukor/base/error.h"

namespace tukor {
namespace {

Part solid(float x, float eta, int priority) {
    Part part;
    part.material.kind = MaterialKind::dielectric;
    part.material.eta = glm::vec3(eta);
    part.material.priority = priority;
    part.mesh.positions = {{x, 0, 0}, {x + 0.5f, 0, 0}, {x, 1, 1}};
    return part;
}

TEST(Media, AreOrderedByPriorityAndTheFirstOfEqualsWins) {
    Scene scene;
    scene.parts = {solid(0, 1.5f, 2), solid(0, 1.33f, 1), Part{}, solid(0, 1.6f, 2)};
    const MediaTable table = mediaOf(scene);
    EXPECT_THAT(table.mediumOfPart, testing::ElementsAre(2, 0, -1, 1));
    EXPECT_EQ(table.media[2].eta, 1.5f);
}

TEST(Media, AreSharedOnlyWhenThereAreTooMany) {
    Scene scene;
    for (int i = 0; i < 32; ++i) scene.parts.push_back(solid(static_cast<float>(i), 2.4f, 0));
    EXPECT_EQ(mediaOf(scene).media.size(), 32u);
    scene.parts.push_back(solid(100.0f, 2.4f, 0));
    EXPECT_EQ(mediaOf(scene).media.size(), 1u) << "33 separate stones of one kind";
    scene.parts.push_back(solid(100.2f, 2.4f, 0));
    EXPECT_EQ(mediaOf(scene).media.size(), 2u) << "two of them overlap";
}

TEST(Media, AreAsDeeplyColouredInAnySize) {
    Scene scene;
    scene.parts = {solid(0, 1.5f, 0), solid(3, 1.5f, 0)};
    for (Part& part : scene.parts) {
        part.material.sigmaA = glm::vec3(1, 2, 3);
        part.material.colourSize = 2.0f;
    }
    for (glm::vec3& p : scene.parts[1].mesh.positions) p *= 0.005f;
    const MediaTable table = mediaOf(scene);
    const auto mediumOf = [&](std::size_t part) {
        return table.media[static_cast<std::size_t>(table.mediumOfPart[part])];
    };
    EXPECT_EQ(mediumOf(0).sigmaA, 2.0f * glm::vec3(1, 2, 3)) << "1 m across";
    EXPECT_LT(glm::distance(mediumOf(1).sigmaA, 400.0f * glm::vec3(1, 2, 3)), 0.1f) << "5 mm";
    scene.parts[1].material.colourSize = 0.0f;
    EXPECT_EQ(mediaOf(scene).media[0].sigmaA, glm::vec3(1, 2, 3)) << "as it is";
}

TEST(Media, SayWhenTheyCannotBeToldApart) {
    Scene scene;
    for (int i = 0; i < 33; ++i) scene.parts.push_back(solid(0, 1.1f + 0.01f * float(i), 0));
    try {
        (void)mediaOf(scene);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "33 different dielectrics; at most 32 can be told apart along a ray");
    }
}

}  // namespace
}  // namespace tukor
