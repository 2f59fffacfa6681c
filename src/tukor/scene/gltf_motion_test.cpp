// What moves and changes in glTF: animations, skins, morph targets, variants; and its lamps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/scene/finish.h"
#include "tukor/scene/gltf_file.h"
#include "tukor/scene/gltf_test_file.h"

namespace tukor {
namespace {

using test::Bytes;
using test::messageOf;
using testing::HasSubstr;

/// A triangle in accessor 0, whatever `bytes` hold behind it in view 1, and `rest`.
Scene sceneOf(const Bytes& more, const std::string& accessors, const std::string& rest,
              const ModelOptions& options = {}) {
    Bytes triangle;
    triangle.add({glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)});
    const std::string text =
        R"({"asset": {"version": "2.0"}, "buffers": [)" + buffer(triangle) + ", " + buffer(more) +
        R"(], "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 1, "byteLength": )" +
        std::to_string(more.text().size()) +
        R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}, )" +
        accessors + "], " + rest + "}";
    return loadGltf("a.gltf", std::as_bytes(std::span(text)), options);
}

std::string accessor(const char* type, int count, int offset, int component = 5126) {
    return R"({"bufferView": 1, "componentType": )" + std::to_string(component) + R"(, "type": ")" +
           type + R"(", "count": )" + std::to_string(count) + R"(, "byteOffset": )" +
           std::to_string(offset) + "}";
}

const std::string kTriangle = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])";

void expectFirstAt(const Scene& scene, glm::vec3 place) {
    const glm::vec3 p = scene.parts.at(0).mesh.positions.at(0);
    EXPECT_LT(glm::distance(p, place), 1e-5f) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(GltfAnimation, IsChosenByNameOrNumber) {
    Bytes bytes;
    bytes.add({0.0f, 1.0f}).add({glm::vec3(4, 0, 0), glm::vec3(4, 0, 0)});
    bytes.add({glm::vec3(0, 5, 0), glm::vec3(0, 5, 0)});
    const auto animation = [](const std::string& name, int output) {
        return R"({"name": ")" + name + R"(", "samplers": [{"input": 1, "output": )" +
               std::to_string(output) + R"(}], "channels": [{"sampler": 0, "target":
               {"node": 0, "path": "translation"}}]})";
    };
    const auto at = [&](const std::string& which) {
        return sceneOf(bytes,
                       accessor("SCALAR", 2, 0) + ", " + accessor("VEC3", 2, 8) + ", " +
                           accessor("VEC3", 2, 32),
                       kTriangle + R"(, "nodes": [{"mesh": 0}], "animations": [)" +
                           animation("walk", 2) + ", " + animation("jump", 3) + "]",
                       {.timeSeconds = 0.5, .animation = which});
    };
    expectFirstAt(at(""), {4, 0, 0});
    expectFirstAt(at("walk"), {4, 0, 0});
    expectFirstAt(at("jump"), {0, 5, 0});
    expectFirstAt(at("1"), {0, 5, 0});
    EXPECT_THAT(messageOf([&] { (void)at("run"); }),
                HasSubstr("no animation 'run'; there are walk, jump"));
    EXPECT_THAT(messageOf([&] { (void)at("2"); }), HasSubstr("no animation '2'"));
    EXPECT_THAT(at("").warnings, testing::Contains(HasSubstr("the first is shown")));
    EXPECT_THAT(at("jump").warnings, testing::Not(testing::Contains(HasSubstr("first"))));
}

TEST(GltfAnimation, MovesNodesBetweenTheirMoments) {
    Bytes bytes;
    bytes.add({1.0f, 3.0f}).add({glm::vec3(0), glm::vec3(4, 0, 0)});
    const auto at = [&](double seconds, const std::string& how) {
        return sceneOf(bytes, accessor("SCALAR", 2, 0) + ", " + accessor("VEC3", 2, 8),
                       kTriangle + R"(, "nodes": [{"mesh": 0}], "animations": [{"samplers":
                           [{"input": 1, "output": 2, "interpolation": ")" +
                           how + R"("}], "channels": [{"sampler": 0, "target":
                           {"node": 0, "path": "translation"}}]}])",
                       {.timeSeconds = seconds});
    };
    expectFirstAt(at(0.0, "LINEAR"), {0, 0, 0});
    expectFirstAt(at(1.5, "LINEAR"), {1, 0, 0});
    expectFirstAt(at(9.0, "LINEAR"), {4, 0, 0});
    expectFirstAt(at(2.9, "STEP"), {0, 0, 0});
    EXPECT_THAT(messageOf([&] { (void)at(1.0, "WARP"); }), HasSubstr("interpolation 'WARP'"));
    EXPECT_THAT(messageOf([&] { (void)at(1.0, "CUBICSPLINE"); }),
                HasSubstr("2 values for 2 moments"));
}

TEST(GltfAnimation, FollowsSplinesAndTurnsTheShortWay) {
    Bytes bytes;
    bytes.add({0.0f, 2.0f});
    // In-tangent, value, out-tangent of both moments: up one side of a bump.
    bytes.add({glm::vec3(0), glm::vec3(0), glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0),
               glm::vec3(0)});
    bytes.add({glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 1, 0)});
    const Scene scene = sceneOf(
        bytes,
        accessor("SCALAR", 2, 0) + ", " + accessor("VEC3", 6, 8) + ", " + accessor("VEC4", 2, 80),
        kTriangle + R"(, "nodes": [{"mesh": 0}], "animations": [{"samplers":
            [{"input": 1, "output": 2, "interpolation": "CUBICSPLINE"}, {"input": 1, "output": 3}],
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}},
                         {"sampler": 1, "target": {"node": 0, "path": "rotation"}}]}])",
        {.timeSeconds = 1.0});
    // Halfway: (t3 - 2 t2 + t) 2 1 - (t3 - t2) 2 (-1) = 0.25 + 0.25; turned by 90 degrees.
    expectFirstAt(scene, {0, 0.5f, 0});
    EXPECT_LT(glm::distance(scene.parts[0].mesh.positions[1], glm::vec3(0, 1.5f, 0)), 1e-5f);
}

TEST(GltfDeformation, MorphTargetsAddTheirShare) {
    Bytes bytes;
    bytes.add({glm::vec3(0, 0, 2), glm::vec3(0), glm::vec3(0)});
    const std::string mesh = R"("meshes": [{"weights": [0.5], "primitives": [{"attributes":
        {"POSITION": 0}, "targets": [{"POSITION": 1}]}]}], "nodes": [{"mesh": 0)";
    const auto scene = [&](const std::string& weights) {
        return sceneOf(bytes, accessor("VEC3", 3, 0), mesh + weights + "}]");
    };
    expectFirstAt(scene(""), {0, 0, 1});
    expectFirstAt(scene(R"(, "weights": [1])"), {0, 0, 2});
    expectFirstAt(scene(R"(, "weights": [0])"), {0, 0, 0});
}

TEST(GltfDeformation, SkinsHangOnTheirJoints) {
    Bytes bytes;
    bytes.add<std::uint8_t>({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    bytes.add({glm::vec4(0.5f, 0.5f, 0, 0), glm::vec4(1, 0, 0, 0), glm::vec4(1, 0, 0, 0)});
    const std::string skinned = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0,
        "JOINTS_0": 1, "WEIGHTS_0": 2}}]}], "skins": [{"joints": [1, 2]}],
        "nodes": [{"mesh": 0, "skin": 0, "translation": [100, 0, 0]}, {"translation": [2, 0, 0]},
                  {"translation": [0, 4, 0]}])";
    const std::string both = accessor("VEC4", 3, 0, 5121) + ", " + accessor("VEC4", 3, 12);
    const Scene scene = sceneOf(bytes, both, skinned);
    expectFirstAt(scene, {1, 2, 0});
    EXPECT_LT(glm::distance(scene.parts[0].mesh.positions[1], glm::vec3(1, 4, 0)), 1e-5f);
    EXPECT_THAT(messageOf([&] {
                    std::string fewer = skinned;
                    fewer.replace(fewer.find("[1, 2]"), 6, "[1]");
                    (void)sceneOf(bytes, both, fewer);
                }),
                HasSubstr("hangs on joint 1 of 1"));
}

TEST(GltfVariants, ChangeMaterialsByName) {
    const std::string rest = R"("materials": [{"name": "red"}, {"name": "blue"}],
        "extensions": {"KHR_materials_variants": {"variants": [{"name": "day"}, {"name": "night"}]}},
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0, "extensions":
            {"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [1]}]}}}]}],
        "nodes": [{"mesh": 0}])";
    const auto name = [&](const std::string& variant) {
        return sceneOf(Bytes().add(0.0f), accessor("SCALAR", 1, 0), rest, {.variant = variant})
            .parts[0]
            .materialName;
    };
    EXPECT_EQ(name(""), "red");
    EXPECT_EQ(name("day"), "red");
    EXPECT_EQ(name("night"), "blue");
    EXPECT_THAT(messageOf([&] { (void)name("noon"); }),
                HasSubstr("no variant 'noon'; there are day, night"));
}

TEST(GltfLights, ShineWhereTheirNodesPoint) {
    const Scene scene =
        sceneOf(Bytes().add(0.0f), accessor("SCALAR", 1, 0),
                kTriangle + R"(, "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot",
            "color": [1, 0.5, 0], "intensity": 8, "range": 10,
            "spot": {"outerConeAngle": 0.5}}]}},
            "nodes": [{"mesh": 0}, {"translation": [0, 2, 0], "rotation":
                [-0.7071067811865476, 0, 0, 0.7071067811865476],
                "extensions": {"KHR_lights_punctual": {"light": 0}}}])");
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_TRUE(scene.warnings.empty());
    const LightAt below = lightAt(scene.lights[0], glm::vec3(0));
    EXPECT_LT(glm::distance(below.wi, glm::vec3(0, 1, 0)), 1e-5f);
    // Two metres: a quarter of it, less what the range of ten takes away.
    EXPECT_NEAR(below.E.x, 2.0f * (1.0f - 0.0016f), 1e-4f);
    EXPECT_NEAR(below.E.y, 0.5f * below.E.x, 1e-5f);
    EXPECT_EQ(lightAt(scene.lights[0], glm::vec3(5, 0, 0)).E.x, 0.0f) << "outside of the cone";
    EXPECT_EQ(lightAt(scene.lights[0], glm::vec3(0, -9, 0)).E.x, 0.0f) << "out of range";
}

}  // namespace
}  // namespace tukor
