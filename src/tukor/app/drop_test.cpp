#include "tukor/app/drop.h"

#include <gtest/gtest.h>

#include "tukor/base/test_folder.h"

namespace tukor {
namespace {

using Names = std::vector<std::string>;

TEST(NamesEnvironment, IsTrueOfPicturesTexturesAndFolders) {
    for (const char* name : {"a.hdr", "a.EXR", "a.png", "a.jpeg", "a.dds", "a.ktx", "a.KTX2"})
        EXPECT_TRUE(namesEnvironment(name)) << name;
    for (const char* name : {"a.glb", "a.obj", "a.mtl", "a.bin", "hdr", "sphere"})
        EXPECT_FALSE(namesEnvironment(name)) << name;
    EXPECT_TRUE(namesEnvironment(TestFolder().path().parent_path()));
}

TEST(WithDropped, TakesModelsAndEnvironments) {
    SessionOptions options;
    options.subject.models = {"sphere"};
    options.subject.materials = {"gold"};
    const SessionOptions lit = withDropped(options, {"/a/sky.ktx2"});
    EXPECT_EQ(lit.light.environment, "/a/sky.ktx2");
    EXPECT_EQ(lit.subject, options.subject);
    const SessionOptions both = withDropped(options, {"a.glb", "sky.hdr", "b.FBX"});
    EXPECT_EQ(both.light.environment, "sky.hdr");
    EXPECT_EQ(both.subject.models, (Names{"a.glb", "b.FBX"}));
    EXPECT_TRUE(both.subject.materials.empty());
    EXPECT_EQ(withDropped(options, {"/a/model"}).subject.models, Names{"/a/model"});
}

TEST(WithDropped, IgnoresTheOtherFilesOfAModel) {
    for (const Names& files : {Names{"texture.png", "ball.gltf", "ball.bin"},
                               Names{"ball.bin", "ball.gltf", "a.ktx2"}}) {
        const SessionOptions dropped = withDropped({}, files);
        EXPECT_EQ(dropped.subject.models, Names{"ball.gltf"});
        EXPECT_EQ(dropped.light, LightOptions{});
    }
    EXPECT_EQ(withDropped({}, {"ball.mtl", "ball.obj"}).subject.models, Names{"ball.obj"});
}

}  // namespace
}  // namespace tukor
