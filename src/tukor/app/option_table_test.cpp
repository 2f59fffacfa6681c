#include "tukor/app/option_table.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tukor {
namespace {

SessionOptions unusualOptions() {
    SessionOptions options;
    options.subject.models = {"my model.glb", "sphere"};
    options.subject.materials = {"glass", "lens*=ior:1.2"};
    options.light.environment = "it's.hdr";
    options.light.rotationDegrees = -30.0f;
    options.camera.eye = glm::vec3(-1, 0, 4);
    options.quality.renderer = Renderer::gl;
    options.quality.size = {640, 360};
    return options;
}

TEST(OptionTable, NamesEveryOptionOnce) {
    std::set<std::string> names;
    for (const OptionRow& row : optionRows({})) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.help.empty()) << row.name;
        EXPECT_TRUE(row.isDefault) << row.name;
    }
}

TEST(CommandLine, SaysOnlyWhatDiffersFromTheDefaults) {
    SessionOptions options;
    options.subject.models = {"sphere"};
    EXPECT_EQ(commandLine("tukor render", options), "tukor render sphere");
    EXPECT_EQ(commandLine("tukor render", unusualOptions()),
              "tukor render 'my model.glb' sphere --material glass --material 'lens*=ior:1.2' "
              "--environment 'it'\\''s.hdr' --environment-rotation -30 --eye -1,0,4 --size 640x360 "
              "--renderer gl");
}

TEST(CommandLine, ShieldsNamesThatLookLikeOptions) {
    SessionOptions options;
    options.subject.models = {"-o"};
    options.light.environment = "--help";
    EXPECT_EQ(commandLine("", options), "./-o --environment=--help");
}

TEST(ShellQuoted, LeavesPlainWordsAlone) {
    EXPECT_EQ(shellQuoted("a/b-c_1.exr"), "a/b-c_1.exr");
    EXPECT_EQ(shellQuoted(""), "''");
    EXPECT_EQ(shellQuoted("$(rm)"), "'$(rm)'");
    EXPECT_EQ(shellQuoted("~"), "'~'");
}

TEST(JsonFromOptions, HoldsEveryOptionInItsOwnType) {
    const auto json = nlohmann::json::parse(jsonFromOptions(unusualOptions()));
    EXPECT_EQ(json["model"], (std::vector<std::string>{"my model.glb", "sphere"}));
    EXPECT_EQ(json["eye"], (std::vector<double>{-1, 0, 4}));
    EXPECT_EQ(json["renderer"], "gl");
    EXPECT_EQ(json["size"], "640x360");
    EXPECT_EQ(json["weight-cutoff"], 0.0001);
    EXPECT_TRUE(json["samples"].is_null());
    for (const OptionRow& row : optionRows({})) EXPECT_TRUE(json.contains(row.name)) << row.name;
}

TEST(JsonFromOptions, SurvivesNamesThatAreNotUtf8) {
    SessionOptions options;
    options.subject.models = {"\xff\xfe.obj"};
    EXPECT_TRUE(nlohmann::json::accept(jsonFromOptions(options)));
}

}  // namespace
}  // namespace tukor
