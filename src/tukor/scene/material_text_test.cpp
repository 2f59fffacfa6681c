#include "tukor/scene/material_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/optics/fresnel.h"
#include "tukor/scene/assign_materials.h"
#include "tukor/scene/finish.h"

namespace tukor {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

std::string messageOf(const std::string& text) {
    try {
        (void)materialFromText(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// The material without its finish.
Material inside(Material material) {
    material.finish = nullptr;
    return material;
}

TEST(MaterialFromText, IsTheSmoothMaterialWithoutRoughness) {
    for (const char* name :
         {"gold", "GOLD", "mirror:0.9,0.8,0.7", "metal:0.21,0.485,1.29/3.13,2.23,1.76", "ruby",
          "ior:1.5/0.1,0.2,0.9", "ior:+1.5", "ior:15e-1", "ior:1.5e+0", "mirror:+.5,+5e-1,5.E-1"}) {
        const Material smooth = parseMaterial(name);
        EXPECT_EQ(materialFromText(name), smooth) << name;
        for (const char* polished : {"+rough:0", "+rough:0.0", "+rough:-0", "+rough:0.05"})
            EXPECT_EQ(materialFromText(std::string(name) + polished), smooth) << name << polished;
        const Material rough = materialFromText(std::string(name) + "+rough:2e-1");
        EXPECT_EQ(inside(rough), smooth) << name;
        ASSERT_NE(rough.finish, nullptr) << name;
        EXPECT_EQ(rough.finish->roughness, 0.2f) << name;
        EXPECT_TRUE(rough.finish->ignoresColors) << name;
    }
}

TEST(MaterialFromText, GivesRoughMetalsTheirReflectanceAtNormalIncidence) {
    const Material gold = materialFromText("gold+rough:1");
    EXPECT_EQ(gold.finish->metallic, 1.0f);
    EXPECT_EQ(gold.finish->baseColor, optics::reflectanceAtNormal(gold.eta, gold.k));
}

TEST(MaterialFromText, GivesRoughGlassAnInside) {
    const Material ice = materialFromText("ice+rough:0.4");
    EXPECT_EQ(ice.kind, MaterialKind::dielectric);
    EXPECT_EQ(ice.priority, kIcePriority);
    EXPECT_EQ(ice.finish->metallic, 0.0f);
    EXPECT_EQ(ice.finish->transmission, 1.0f);
    EXPECT_TRUE(ice.finish->solid);
    EXPECT_EQ(ice.finish->ior, ice.eta.x);
}

TEST(MaterialFromText, GivesRoughMirrorsTheirTintAtAllAngles) {
    const Finish tinted = *materialFromText("mirror:0.9,0.6,0.3+rough:0.5").finish;
    EXPECT_EQ(tinted.metallic, 0.0f);
    EXPECT_EQ(tinted.baseColor, glm::vec3(0.0f));
    EXPECT_EQ(tinted.ior, 0.0f);
    for (int c = 0; c < 3; ++c)
        EXPECT_FLOAT_EQ(tinted.specular * tinted.specularColor[c],
                        0.9f - 0.3f * static_cast<float>(c));
    EXPECT_EQ(materialFromText("mirror:0+rough:0.5").finish->specular, 0.0f);
}

TEST(MaterialFromText, KnowsMattColours) {
    const Finish red = *materialFromText("matt:0.8,0.2,0.1").finish;
    EXPECT_EQ(red.baseColor, glm::vec3(0.8f, 0.2f, 0.1f));
    EXPECT_EQ(red.metallic, 0.0f);
    EXPECT_EQ(red.roughness, 1.0f);
    EXPECT_EQ(red.ior, 1.5f);
    EXPECT_EQ(materialFromText("matt:0.5").finish->baseColor, glm::vec3(0.5f));
}

TEST(MaterialFromText, SaysWhatWasFoundAndWhatWasExpected) {
    EXPECT_EQ(messageOf("gold+rough:2"), "material 'gold+rough:2': roughness 2; expected 0 to 1");
    EXPECT_THAT(messageOf("gold+rough:-0.1"), HasSubstr("roughness -0.1; expected 0 to 1"));
    EXPECT_THAT(messageOf("gold+rough:nan"), HasSubstr("roughness nan; expected 0 to 1"));
    for (const char* text : {"gold+rough:", "gold+rough:x", "gold+rough:0.2,0.3", "gold+rough: 0.2",
                             "gold+rough:0.2+rough:0.3", "ior:1.5+rough:0.2/3"})
        EXPECT_THAT(messageOf(text), AllOf(HasSubstr("is not a number; expected +rough:N with N")))
            << text;
    for (const char* text : {"gold+0.2", "gold+", "gold+ruogh:0.2", "gold+rough", "gold+Rough:0.2"})
        EXPECT_THAT(messageOf(text), HasSubstr("is unknown; expected +rough:N with N from 0 to 1"))
            << text;
    EXPECT_THAT(messageOf("gould+rough:0.2"), HasSubstr("'gould'; did you mean 'gold'?"));
    EXPECT_THAT(messageOf("+rough:0.2"), HasSubstr("unknown material ''"));
    EXPECT_THAT(messageOf("ior:0+rough:0.2"), HasSubstr("'ior:0': index 0; expected 0.001"));
    EXPECT_EQ(messageOf("matt:2"), "material 'matt:2': base colour 2; expected 0 to 1");
    EXPECT_THAT(messageOf("matt:0.5,0.5"), HasSubstr("has two numbers; expected one or three"));
    EXPECT_THAT(messageOf("matt:red"),
                AllOf(HasSubstr("'red' is not a number"), EndsWith("matt:R,G,B")));
    EXPECT_THAT(messageOf("matt"), EndsWith("matt:R,G,B"));
    EXPECT_THAT(messageOf("matt:0.5+rough:0.2"), HasSubstr("nothing is rougher than matt"));
}

TEST(MaterialFromText, IsWhatPartsAreAssigned) {
    Scene scene;
    scene.parts.push_back({"stone", "", {}, {}});
    scene.parts.push_back({"band", "", {}, {}});
    const std::string specifications[] = {"gold+rough:0.3", "stone=diamond+rough:0.2"};
    assignMaterials(scene, specifications);
    EXPECT_EQ(scene.parts[0].material.finish->roughness, 0.2f);
    EXPECT_EQ(scene.parts[1].material.finish->roughness, 0.3f);
    setDispersion(scene, 1.0f);
    EXPECT_FLOAT_EQ(scene.parts[0].material.dispersion, 20.0f / 55.3f);
}

}  // namespace
}  // namespace tukor
