#include "tukor/materials/materials.h"

#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/optics/fresnel.h"

namespace tukor {
namespace {

using testing::HasSubstr;

std::string messageOf(const std::string& text) {
    try {
        (void)parseMaterial(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Materials, KeepTheFiguresOfTheLecture) {
    const Material gold = parseMaterial("gold");
    EXPECT_EQ(gold.kind, MaterialKind::metal);
    EXPECT_EQ(gold.eta, glm::vec3(0.21f, 0.485f, 1.29f));
    EXPECT_EQ(gold.k, glm::vec3(3.13f, 2.23f, 1.76f));
    const Material silver = parseMaterial("silver");
    EXPECT_EQ(silver.eta, glm::vec3(0.15f, 0.14f, 0.13f));
    EXPECT_EQ(silver.k, glm::vec3(3.7f, 3.11f, 2.47f));
    EXPECT_EQ(parseMaterial("glass"), dielectricMaterial(1.46f));
    EXPECT_EQ(parseMaterial("water"), dielectricMaterial(1.333f, glm::vec3(0.0f), kLiquidPriority));
    EXPECT_EQ(parseMaterial("mirror"), mirrorMaterial(glm::vec3(1.0f)));
}

TEST(Materials, HaveDistinctNamesSourcesAndFiguresInRange) {
    std::set<std::string_view> names;
    for (const NamedMaterial& named : namedMaterials()) {
        EXPECT_TRUE(names.insert(named.name).second) << named.name;
        EXPECT_FALSE(named.source.empty()) << named.name;
        EXPECT_FALSE(named.description.empty()) << named.name;
        const Material material = named.material();
        EXPECT_NO_THROW(checkMaterial(material, named.name));
        EXPECT_EQ(named.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string::npos)
            << named.name;
        if (material.kind == MaterialKind::dielectric) {
            EXPECT_EQ(material.eta, glm::vec3(material.eta.x)) << named.name;
            EXPECT_GT(material.priority, 0) << named.name;
        }
    }
    ASSERT_EQ(materialNames().size(), namedMaterials().size());
    EXPECT_GE(names.size(), 30u);
}

TEST(Materials, NameOnlySourcesThatTheReferencesList) {
    const auto bytes = readFile(std::string(TUKOR_SOURCE_DIR) + "/docs/references.md");
    const std::string references(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const NamedMaterial& named : namedMaterials()) {
        const std::size_t open = named.source.find('[');
        if (open == std::string_view::npos) continue;
        const std::size_t close = named.source.find(']', open);
        EXPECT_THAT(references, HasSubstr(std::string(named.source.substr(open, close - open + 1))))
            << named.name;
    }
}

TEST(Materials, ReflectAsPublishedAtNormalIncidence) {
    // Linear R, G, B of whole-spectrum reflectances [Akenine-Moller et al. 2018, table 9.2]. Three
    // wavelengths instead of the spectrum, and other measurements of the same metal, leave 0.06;
    // gold's R is clipped there from 1.022.
    struct Published {
        const char* name;
        glm::vec3 R0;
    };
    const Published published[] = {
        {"titanium", {0.542f, 0.497f, 0.449f}},  {"chromium", {0.549f, 0.556f, 0.554f}},
        {"iron", {0.562f, 0.565f, 0.578f}},      {"nickel", {0.660f, 0.609f, 0.526f}},
        {"platinum", {0.673f, 0.637f, 0.585f}},  {"copper", {0.955f, 0.638f, 0.538f}},
        {"palladium", {0.733f, 0.697f, 0.652f}}, {"gold", {1.000f, 0.782f, 0.344f}},
        {"brass", {0.910f, 0.778f, 0.423f}},     {"aluminium", {0.913f, 0.922f, 0.924f}},
        {"silver", {0.972f, 0.960f, 0.915f}},
    };
    for (const Published& one : published) {
        const Material metal = parseMaterial(one.name);
        const glm::vec3 R0 = optics::reflectanceAtNormal(metal.eta, metal.k);
        const float tolerance = std::string(one.name) == "titanium" ? 0.1f : 0.085f;
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(R0[channel], one.R0[channel], tolerance) << one.name << ' ' << channel;
        }
    }
}

TEST(Materials, ReflectAsPublishedAtNormalIncidenceWhenClear) {
    // [Akenine-Moller et al. 2018, table 9.1]
    const std::pair<const char*, float> published[] = {
        {"water", 0.02f}, {"glass", 0.035f}, {"crown-glass", 0.043f}, {"diamond", 0.172f}};
    for (const auto& [name, R0] : published) {
        EXPECT_NEAR(optics::fresnelDielectric(1.0f, parseMaterial(name).eta.x), R0, 1.5e-3f)
            << name;
    }
}

TEST(Materials, SolidsDisplaceLiquids) {
    EXPECT_GT(parseMaterial("glass").priority, parseMaterial("water").priority);
    EXPECT_GT(parseMaterial("ice").priority, parseMaterial("water").priority);
    EXPECT_GT(parseMaterial("glass").priority, parseMaterial("ice").priority);
    EXPECT_GT(parseMaterial("air").priority, parseMaterial("glass").priority);
    EXPECT_EQ(parseMaterial("ior:1.5").priority, kSolidPriority);
}

TEST(ParseMaterial, TakesNamesInAnyCaseAndFigures) {
    EXPECT_EQ(parseMaterial("GOLD"), parseMaterial("gold"));
    EXPECT_EQ(parseMaterial("ior:1.2"), dielectricMaterial(1.2f));
    EXPECT_EQ(parseMaterial("ior:1.5/0.1,0.2,0.9"),
              dielectricMaterial(1.5f, glm::vec3(0.1f, 0.2f, 0.9f)));
    EXPECT_EQ(parseMaterial("ior:1.5/2"), dielectricMaterial(1.5f, glm::vec3(2.0f)));
    EXPECT_EQ(parseMaterial("metal:0.21,0.485,1.29/3.13,2.23,1.76"), parseMaterial("gold"));
    EXPECT_EQ(parseMaterial("mirror:0.9,0.8,0.7"), mirrorMaterial(glm::vec3(0.9f, 0.8f, 0.7f)));
    EXPECT_EQ(parseMaterial("mirror:0.5"), mirrorMaterial(glm::vec3(0.5f)));
}

TEST(ParseMaterial, SaysWhichNamesThereAreAndWhichWasMeant) {
    const std::string message = messageOf("glod");
    EXPECT_THAT(message, HasSubstr("unknown material 'glod'; did you mean 'gold'?"));
    EXPECT_THAT(message, HasSubstr("known are mirror, gold, silver, glass, water, copper"));
    EXPECT_THAT(message, HasSubstr("ior:N"));
    EXPECT_THAT(messageOf("unobtainium"), HasSubstr("unknown material 'unobtainium'; known are"));
    EXPECT_THAT(messageOf(""), HasSubstr("unknown material ''"));
    EXPECT_THAT(messageOf("plastic:1"), HasSubstr("unknown material 'plastic:1'"));
}

TEST(ParseMaterial, SaysWhatIsWrongWithFigures) {
    EXPECT_THAT(messageOf("ior:"), HasSubstr("material 'ior:': '' is not a number; expected"));
    EXPECT_THAT(messageOf("ior:abc"), HasSubstr("'abc' is not a number"));
    EXPECT_THAT(messageOf("ior:1.5x"), HasSubstr("'1.5x' is not a number"));
    EXPECT_THAT(messageOf("ior:0"), HasSubstr("material 'ior:0': index 0; expected 0.001 to 1000"));
    EXPECT_THAT(messageOf("ior:-1.5"), HasSubstr("index -1.5"));
    EXPECT_THAT(messageOf("ior:nan"), HasSubstr("index nan"));
    EXPECT_THAT(messageOf("ior:inf"), HasSubstr("index inf"));
    EXPECT_THAT(messageOf("ior:1.5/-1"), HasSubstr("absorption -1"));
    EXPECT_THAT(messageOf("metal:1,2,3"), HasSubstr("a metal needs eta and k"));
    EXPECT_THAT(messageOf("metal:1,2/3"),
                HasSubstr("'1,2' has two numbers; expected one or three"));
    EXPECT_THAT(messageOf("metal:1,2,3,4/3"), HasSubstr("more than three numbers"));
    EXPECT_THAT(messageOf("metal:0,1,1/1"), HasSubstr("eta 0"));
    EXPECT_THAT(messageOf("metal:1/1,1,-1"), HasSubstr("k -1"));
    EXPECT_THAT(messageOf("mirror:1.5"), HasSubstr("reflectance 1.5; expected 0 to 1"));
    EXPECT_THAT(messageOf("mirror:0.9/0.1"), HasSubstr("'0.9/0.1' is not a number"));
    EXPECT_THAT(messageOf("mirror:,,"), HasSubstr("'' is not a number"));
    EXPECT_LT(messageOf("ior:" + std::string(1'000'000, '9') + "x").size(), 500u);
    EXPECT_LT(messageOf(std::string(1'000'000, 'g')).size(), 2000u);
}

TEST(MetalFromReflectance, HasThatReflectanceAtNormalIncidence) {
    for (int i = 0; i <= 100; ++i) {
        const float r = std::min(static_cast<float>(i) / 100.0f, 0.998f);
        for (const float edgeTint : {-1.0f, 0.0f, 0.3f, 0.9f, 1.0f}) {
            const Material metal = edgeTint < 0.0f
                                       ? metalFromReflectance(glm::vec3(r))
                                       : metalFromReflectance(glm::vec3(r), glm::vec3(edgeTint));
            // Float cancels in (eta - 1)^2 + k^2 where eta is near 1: 1e-6 of (eta + 1)^2.
            EXPECT_NEAR(optics::reflectanceAtNormal(metal.eta, metal.k).x, r, 2e-5f)
                << "r " << r << " edge tint " << edgeTint;
            EXPECT_NO_THROW(checkMaterial(metal, "metal"));
        }
    }
}

TEST(MetalFromReflectance, IsNearestToTheApproximationThatBaseColoursMean) {
    for (const float r : {0.01f, 0.04f, 0.2f, 0.5f, 0.8f, 0.95f, 0.99f}) {
        const auto error = [r](const Material& metal) {
            float worst = 0.0f;
            for (int i = 1; i <= 500; ++i) {
                const float cosThetaI = static_cast<float>(i) / 500.0f;
                worst = std::max(
                    worst, std::abs(optics::fresnelConductor(cosThetaI, metal.eta, metal.k).x -
                                    optics::fresnelSchlick(cosThetaI, glm::vec3(r)).x));
            }
            return worst;
        };
        const float chosen = error(metalFromReflectance(glm::vec3(r)));
        for (int i = 0; i <= 50; ++i) {
            const glm::vec3 edgeTint(static_cast<float>(i) / 50.0f);
            EXPECT_LE(chosen, error(metalFromReflectance(glm::vec3(r), edgeTint)) + 2e-3f)
                << "r " << r << " edge tint " << edgeTint.x;
        }
        EXPECT_LT(chosen, 0.045f) << r;
    }
}

TEST(MetalFromReflectance, TakesAnyColour) {
    for (const float r : {-1.0f, 0.0f, 1.0f, 2.0f, NAN}) {
        const Material metal = metalFromReflectance(glm::vec3(r));
        EXPECT_NO_THROW(checkMaterial(metal, "metal")) << r;
    }
    // Channels are independent.
    const Material metal = metalFromReflectance(glm::vec3(0.9f, 0.5f, 0.1f));
    const glm::vec3 R0 = optics::reflectanceAtNormal(metal.eta, metal.k);
    EXPECT_NEAR(R0.x, 0.9f, 1e-5f);
    EXPECT_NEAR(R0.y, 0.5f, 1e-5f);
    EXPECT_NEAR(R0.z, 0.1f, 1e-5f);
}

}  // namespace
}  // namespace tukor
