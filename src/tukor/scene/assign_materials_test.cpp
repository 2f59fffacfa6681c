#include "tukor/scene/assign_materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/geometry/sphere.h"
#include "tukor/materials/materials.h"

namespace tukor {
namespace {

using testing::HasSubstr;

std::string messageOf(const auto& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

Scene ring() {
    Scene scene;
    for (const auto& [name, material] :
         {std::pair{"band", "yellow metal"}, {"Stone 1", "clear"}, {"Stone 2", "clear"}})
        scene.parts.push_back({name, material, mirrorMaterial(glm::vec3(1.0f)), makeSphere(2)});
    return scene;
}

void assign(Scene& scene, std::vector<std::string> specifications) {
    assignMaterials(scene, specifications);
}

TEST(MatchesPattern, KnowsStarsAndQuestionMarks) {
    EXPECT_TRUE(matchesPattern("stone", "stone"));
    EXPECT_TRUE(matchesPattern("Stone 12", "stone*"));
    EXPECT_TRUE(matchesPattern("stone", "*"));
    EXPECT_TRUE(matchesPattern("", "*"));
    EXPECT_TRUE(matchesPattern("a stone b", "*st?ne*"));
    EXPECT_TRUE(matchesPattern("abab", "*ab"));
    EXPECT_FALSE(matchesPattern("stone", "ston"));
    EXPECT_FALSE(matchesPattern("stone", "stone?"));
    EXPECT_FALSE(matchesPattern("", "?"));
    EXPECT_FALSE(matchesPattern("stone", ""));
}

TEST(MatchesPattern, TakesNoExponentialTime) {
    std::string pattern;
    for (int i = 0; i < 1000; ++i) pattern += "*a";
    EXPECT_FALSE(matchesPattern(std::string(5000, 'a').append("b"), pattern));
}

TEST(AssignMaterials, AssignsToAllOrByPartOrMaterialNameAndTheLaterWins) {
    Scene scene = ring();
    assign(scene, {"silver", "clear=diamond", "stone 2=ior:1.5"});
    EXPECT_EQ(scene.parts[0].material, parseMaterial("silver"));
    EXPECT_EQ(scene.parts[1].material, parseMaterial("diamond"));
    EXPECT_EQ(scene.parts[2].material, parseMaterial("ior:1.5"));
    assign(scene, {"clear=diamond", "gold"});
    for (const Part& part : scene.parts) EXPECT_EQ(part.material, parseMaterial("gold"));
}

TEST(AssignMaterials, TakesPatternsWithAnEqualsSign) {
    Scene scene = ring();
    scene.parts[0].name = "a=b";
    assign(scene, {"a=b=silver"});
    EXPECT_EQ(scene.parts[0].material, parseMaterial("silver"));
}

TEST(AssignMaterials, SaysWhatThereIsWhenAPatternMatchesNothing) {
    Scene scene = ring();
    EXPECT_EQ(messageOf([&] { assign(scene, {"gem=diamond"}); }),
              "material 'gem=diamond': no part or material of the model matches 'gem'; there are "
              "Stone 1, Stone 2, band, clear, yellow metal");
    EXPECT_THAT(messageOf([&] { assign(scene, {"band=gould"}); }), HasSubstr("gold"));
    Scene nameless;
    EXPECT_THAT(messageOf([&] { assign(nameless, {"a=gold"}); }), HasSubstr("have no names"));
}

TEST(Append, PutsSecondSceneBehindTheFirst) {
    Scene scene = ring();
    Scene second = ring();
    second.cameras.emplace_back();
    second.warnings.emplace_back("a warning");
    append(scene, std::move(second));
    EXPECT_EQ(scene.parts.size(), 6u);
    EXPECT_EQ(scene.parts[3].name, "band");
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(ClosednessWarnings, ConcernOpenDielectricsOnly) {
    Scene scene = ring();
    scene.parts[0].mesh.triangles.pop_back();
    EXPECT_TRUE(closednessWarnings(scene).empty());
    assign(scene, {"glass"});
    const std::vector<std::string> warnings = closednessWarnings(scene);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], HasSubstr("yellow metal: not closed: 3 open edges"));
}

TEST(ClosednessWarnings, TakePartsOfOneMaterialTogether) {
    Scene scene = ring();
    scene.parts.erase(scene.parts.begin());
    std::vector<glm::uvec3>& all = scene.parts[0].mesh.triangles;
    scene.parts[1].mesh.triangles.assign(all.begin() + 7, all.end());
    all.resize(7);
    assign(scene, {"water"});
    EXPECT_TRUE(closednessWarnings(scene).empty());
}

}  // namespace
}  // namespace tukor
