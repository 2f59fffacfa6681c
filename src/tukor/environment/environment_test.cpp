#include "tukor/environment/environment.h"

#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/test_folder.h"
#include "tukor/environment/equirect.h"
#include "tukor/image/image_file.h"

namespace tukor {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class LoadEnvironment : public testing::Test {
protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

    void save(const std::string& name, int width, int height, glm::vec3 colour) const {
        Image image(width, height);
        for (glm::vec3& pixel : image.pixels()) pixel = colour;
        saveImage(path(name), image);
    }

    static std::string messageOf(const std::string& nameOrPath,
                                 const EnvironmentOptions& options = {}) {
        try {
            (void)loadEnvironment(nameOrPath, options);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

private:
    TestFolder folder_;
};

TEST_F(LoadEnvironment, MakesTheBuiltInsAtTheFaceSizeAsked) {
    for (const char* name : {"studio", "sky"}) {
        const Environment environment = loadEnvironment(name, {.faceSize = 32});
        EXPECT_EQ(environment.name, name);
        EXPECT_EQ(environment.radiance.faceSize(), 32);
        EXPECT_TRUE(environment.warnings.empty());
    }
    EXPECT_EQ(loadEnvironment("studio").radiance.faceSize(), 512);
}

TEST_F(LoadEnvironment, ReadsAPanorama) {
    save("a.exr", 128, 64, {0.25f, 0.5f, 2.0f});
    const Environment environment = loadEnvironment(path("a.exr"));
    EXPECT_EQ(environment.radiance.faceSize(), 64);
    EXPECT_NEAR(environment.radiance.radiance({1, 2, 3}).z, 2.0f, 1e-5f);
    ASSERT_NE(environment.panorama, nullptr);
    EXPECT_NEAR(equirectRadiance(*environment.panorama, {1, 2, 3}).y, 0.5f, 1e-5f);
    EXPECT_EQ(loadEnvironment(path("a.exr"), {.faceSize = 16}).radiance.faceSize(), 16);
}

TEST_F(LoadEnvironment, ReadsACrossAndAStrip) {
    save("cross.hdr", 32, 24, glm::vec3(0.5f));
    save("strip.exr", 8, 48, glm::vec3(0.5f));
    for (const char* name : {"cross.hdr", "strip.exr"}) {
        const Environment environment = loadEnvironment(path(name));
        EXPECT_EQ(environment.radiance.faceSize(), 8);
        EXPECT_EQ(environment.panorama, nullptr);
    }
    EXPECT_EQ(loadEnvironment(path("cross.hdr"), {.faceSize = 20}).radiance.faceSize(), 20);
    EXPECT_EQ(loadEnvironment(path("cross.hdr"), {.faceSize = 3}).radiance.faceSize(), 3);
}

TEST_F(LoadEnvironment, ReadsSixFilesByPatternOrFolder) {
    const char* names[] = {"px", "nx", "py", "ny", "pz", "nz"};
    for (int i = 0; i < 6; ++i)
        save(fmt::format("sky_{}.exr", names[i]), 4, 4, glm::vec3(static_cast<float>(i)));
    for (const std::string& from : {path("sky_{}.exr"), path("")}) {
        const Environment environment = loadEnvironment(from);
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_EQ(environment.radiance.texels(kCubeFaces[i])[0],
                      glm::vec3(static_cast<float>(i)));
    }
}

TEST_F(LoadEnvironment, RepairsAndSaysSo) {
    Image image(8, 4);
    image.at(3, 2).x = std::numeric_limits<float>::quiet_NaN();
    image.at(4, 2).y = -1.0f;
    saveImage(path("bad.exr"), image);
    EXPECT_THAT(loadEnvironment(path("bad.exr")).warnings,
                ElementsAre("1 pixel not finite, replaced by the neighbours",
                            "1 pixel with negative radiance, set to 0"));
}

TEST_F(LoadEnvironment, ListsTheBuiltInsForAnUnknownName) {
    EXPECT_EQ(messageOf("studoi"),
              "studoi: no such environment; built in are studio, sky, anything else is a file");
}

TEST_F(LoadEnvironment, SaysWhatIsWrongWithAFile) {
    EXPECT_THAT(messageOf(path("none.exr")), EndsWith("none.exr: no such file"));
    save("odd.exr", 47, 24, glm::vec3(1.0f));
    EXPECT_THAT(
        messageOf(path("odd.exr")),
        EndsWith("odd.exr: 47 x 24 pixels; an equirectangular panorama must be exactly twice as "
                 "wide as high, a cube map a cross of 4 x 3 or 3 x 4 squares or a strip of six"));
    EXPECT_EQ(messageOf("studio", {.faceSize = 0}),
              "studio: a face size of 0 texels; expected 1 to 8192");
}

TEST_F(LoadEnvironment, SaysWhatIsWrongWithSixFiles) {
    EXPECT_THAT(messageOf(path("sky_{}.exr")),
                HasSubstr("no such files; {} stands for px, nx, py"));
    EXPECT_THAT(messageOf(path("")),
                HasSubstr("a folder without the six faces; expected files called px, nx"));
    for (const char* name : {"px", "nx", "py", "ny", "pz"})
        save(fmt::format("sky_{}.exr", name), 4, 4, {});
    EXPECT_THAT(messageOf(path("sky_{}.exr")), HasSubstr("5 of six faces found; "));
    EXPECT_THAT(messageOf(path("sky_{}.exr")), EndsWith("sky_nz.exr is missing"));
    save("sky_nz.exr", 4, 8, {});
    EXPECT_THAT(messageOf(path("sky_{}.exr")),
                EndsWith("sky_nz.exr: 4 x 8 pixels; a face of a cube map must be square"));
    save("sky_nz.exr", 8, 8, {});
    EXPECT_THAT(messageOf(path("sky_{}.exr")),
                HasSubstr("8 x 8 pixels; all faces must have the 4 x 4 of "));
    save("sky_nz.exr", 4, 4, {});
    save("sea_nz.exr", 4, 4, {});
    EXPECT_THAT(messageOf(path("")),
                HasSubstr("2 files are called nz; say which by a pattern, as sky_{}.png"));
}

}  // namespace
}  // namespace tukor
