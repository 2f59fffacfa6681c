#include "tukor/app/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tukor {
namespace {

TEST(WindowOptions, LeaveOutWhatOnlyTraceCanDo) {
    SessionOptions options;
    options.quality.renderer = Renderer::trace;
    options.quality.error = 1.0f;
    options.quality.seconds = 2.0f;
    options.quality.layers = {AovLayer::depth};
    EXPECT_THAT(
        unusedInWindow(options),
        testing::ElementsAre(testing::HasSubstr("--renderer trace"), testing::HasSubstr("--error"),
                             testing::HasSubstr("--time"), testing::HasSubstr("--aov")));
    const SessionOptions shown = windowOptions(options);
    EXPECT_EQ(shown.quality.renderer, Renderer::gl);
    EXPECT_TRUE(unusedInWindow(shown).empty());
    EXPECT_TRUE(unusedInWindow({}).empty());
}

Session sessionOf(const std::string& material, const QualityOptions& quality = {}) {
    SessionOptions options;
    options.subject.models = {"brilliant"};
    options.subject.materials = {material};
    options.light.faceSize = 8;
    options.quality = quality;
    return Session(options);
}

TEST(WarningsOf, CountsTheRaysThatFoundAHole) {
    const Session glass = sessionOf("glass");
    Rendering rendering;
    rendering.rays = 1000;
    EXPECT_TRUE(warningsOf(rendering, glass).empty());
    rendering.leaks = 2;
    rendering.inconsistencies = 1;
    EXPECT_THAT(warningsOf(rendering, glass),
                testing::ElementsAre(testing::StartsWith("3 of 1000 rays left a solid")));
    EXPECT_TRUE(warningsOf(rendering, sessionOf("gold")).empty());
}

TEST(WarningsOf, DoesNotBlameAModelForOneRayInTenMillion) {
    const Session glass = sessionOf("glass");
    Rendering rendering;
    rendering.rays = 30'000'000;
    rendering.inconsistencies = 2;
    EXPECT_TRUE(warningsOf(rendering, glass).empty());
    rendering.inconsistencies = 3;
    EXPECT_FALSE(warningsOf(rendering, glass).empty());
}

TEST(WarningsOf, SayWhereAPictureIsFarFromWhatWasAsked) {
    Rendering rendering;
    rendering.samplesPerPixel = 64.0;
    rendering.error = 1.4;
    EXPECT_TRUE(warningsOf(rendering, sessionOf("gold")).empty());
    rendering.error = 5.8;
    EXPECT_THAT(warningsOf(rendering, sessionOf("gold")),
                testing::ElementsAre(
                    "expected RMSE 5.8 after 64 samples a pixel, 1 is usual: --error 1 goes on, "
                    "--samples N says how far"));
    QualityOptions quality;
    quality.error = 4.0f;
    EXPECT_TRUE(warningsOf(rendering, sessionOf("gold", quality)).empty());
    quality.error = 2.0f;
    quality.samples = 64;
    EXPECT_THAT(warningsOf(rendering, sessionOf("gold", quality)),
                testing::ElementsAre(testing::EndsWith("2 was asked: a larger --samples goes on")));
    quality.error.reset();  // the samples are what was asked
    EXPECT_TRUE(warningsOf(rendering, sessionOf("gold", quality)).empty());
    quality.samples.reset();
    quality.seconds = 1.0f;
    EXPECT_TRUE(warningsOf(rendering, sessionOf("gold", quality)).empty());
}

TEST(UnusedInFile, NamesWhatTheFormatDoesNotHold) {
    SessionOptions options;
    for (const char* out : {"a.png", "a.jpg", "a.exr", "a.hdr"})
        EXPECT_TRUE(unusedInFile(out, options).empty()) << out;
    options.light.background = Background::none;
    options.develop = {1.0f, Tonemap::aces, PngDepth::bits16, 80, ExrPixels::half};
    const auto said = [&](const char* out) {
        std::string all;
        for (const std::string& one : unusedInFile(out, options)) {
            const auto from = one.find("--") + 2;
            all += one.substr(from, one.find(' ', from) - from) + " ";
        }
        return all;
    };
    EXPECT_EQ(said("a.png"), "jpeg-quality exr-pixels ");
    EXPECT_EQ(said("a.JPG"), "background png-depth exr-pixels ");
    EXPECT_EQ(said("a.exr"), "exposure tonemap png-depth jpeg-quality ");
    EXPECT_EQ(said("a.hdr"), "background exposure tonemap png-depth jpeg-quality exr-pixels ");
}

TEST(ShowsBeyondWhite, WhereTheFileHoldsOrBendsOrDarkensIt) {
    SessionOptions options;
    EXPECT_FALSE(showsBeyondWhite("a.png", options)) << "neutral keeps 14 codes for it";
    EXPECT_TRUE(showsBeyondWhite("a.exr", options));
    EXPECT_TRUE(showsBeyondWhite("a.HDR", options));
    options.develop.exposureStops = -1.0f;
    EXPECT_TRUE(showsBeyondWhite("a.jpg", options));
    options.develop.exposureStops = 1.0f;
    EXPECT_FALSE(showsBeyondWhite("a.jpg", options));
    options.develop.tonemap = Tonemap::agx;
    EXPECT_TRUE(showsBeyondWhite("a.jpg", options));
}

TEST(ClippedInFile, CountsThePixelsThatHalfCutsOff) {
    SessionOptions options;
    options.develop.exrPixels = ExrPixels::half;
    Rendering rendering;
    rendering.radiance = Image(3, 1);
    rendering.radiance.at(0, 0) = glm::vec3(65504.0f);
    EXPECT_EQ(clippedInFile("a.exr", rendering, options), "");
    rendering.radiance.at(1, 0) = {4.0f * 65504.0f, 0.0f, 0.0f};
    EXPECT_EQ(clippedInFile("a.EXR", rendering, options),
              "1 pixel above 65504, the most that half holds, was clipped: 42.9 % of the light; "
              "--exr-pixels full keeps it");
    rendering.radiance.at(2, 0) = glm::vec3(65505.0f);
    EXPECT_THAT(clippedInFile("a.exr", rendering, options), testing::StartsWith("2 pixels above"));
    EXPECT_EQ(clippedInFile("a.hdr", rendering, options), "");
    options.develop.exrPixels = ExrPixels::full;
    EXPECT_EQ(clippedInFile("a.exr", rendering, options), "");
}

TEST(SummaryOf, SaysWhatMoreSamplesDoNotTakeOff) {
    Rendering rendering;
    rendering.error = 0.81;
    rendering.noise = 0.80;
    EXPECT_THAT(summaryOf(rendering, 2.0), testing::EndsWith("expected RMSE 0.81"));
    rendering.noise = 0.35;
    EXPECT_THAT(
        summaryOf(rendering, 2.0),
        testing::EndsWith(
            "expected RMSE 0.81 (noise 0.35, the rest suns and lamps that glint in glass)"));
}

}  // namespace
}  // namespace tukor
