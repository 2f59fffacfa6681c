#include "tukor/app/option_text.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tukor {
namespace {

using testing::HasSubstr;

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

const Measure<float> kPlace{"X,Y,Z", {-1e6f, 1e6f}};
const Measure<int> kSize{"WxH", {1, 16384}};

TEST(OptionText, ReadsVectorsWithNegativeComponents) {
    EXPECT_EQ(valueFromText(ValueType<glm::vec3>{}, kPlace, "-1,0,4"), glm::vec3(-1, 0, 4));
    EXPECT_EQ(valueFromText(ValueType<glm::vec3>{}, kPlace, "-.5,1e2,+3"),
              glm::vec3(-0.5f, 100, 3));
}

TEST(OptionText, RefusesWhatIsNoVector) {
    for (const char* text : {"", "1", "1,2", "1,2,3,4", "1;2;3"}) {
        EXPECT_THAT(messageOf([&] { (void)valueFromText(ValueType<glm::vec3>{}, kPlace, text); }),
                    HasSubstr("is not a vector; X,Y,Z expected, as in 0,1.5,-4"))
            << text;
    }
    for (const char* text :
         {"nan,0,0", "inf,0,0", "0x1,0,0", "1,,2", " 1,2,3", "1,2,3 ", "1e999,0,0"}) {
        EXPECT_THAT(messageOf([&] { (void)valueFromText(ValueType<glm::vec3>{}, kPlace, text); }),
                    HasSubstr("is not a number"))
            << text;
    }
    EXPECT_EQ(messageOf([] { (void)valueFromText(ValueType<glm::vec3>{}, kPlace, "0,1e7,0"); }),
              "10000000 is out of range; -1000000 to 1000000 expected");
}

TEST(OptionText, ReadsSizesWithinBounds) {
    EXPECT_EQ(valueFromText(ValueType<PictureSize>{}, kSize, "640x360"), (PictureSize{640, 360}));
    for (const char* text : {"640", "640x", "x360", "640X360", "640x360x2", "ax2"}) {
        EXPECT_THAT(messageOf([&] { (void)valueFromText(ValueType<PictureSize>{}, kSize, text); }),
                    HasSubstr("is not a size; WxH expected, as in 1280x720"))
            << text;
    }
    EXPECT_EQ(messageOf([] { (void)valueFromText(ValueType<PictureSize>{}, kSize, "0x5"); }),
              "0 is out of range; 1 to 16384 expected");
    EXPECT_EQ(
        messageOf([] { (void)valueFromText(ValueType<PictureSize>{}, kSize, "16384x16384"); }),
        "16384 x 16384 is 268 million pixels; at most 100 million expected");
}

TEST(OptionText, ReadsWholeNumbers) {
    const Measure<int> samples{"N", {1, 65536}};
    EXPECT_EQ(valueFromText(ValueType<int>{}, samples, "64"), 64);
    EXPECT_EQ(messageOf([&] { (void)valueFromText(ValueType<int>{}, samples, "1.5"); }),
              "'1.5' is not a whole number");
    EXPECT_EQ(messageOf([&] { (void)valueFromText(ValueType<int>{}, samples, "-4"); }),
              "-4 is out of range; 1 to 65536 expected");
}

TEST(OptionText, NamesTheNearestSpelling) {
    const Spellings<Fidelity> spellings(kFidelitySpellings);
    EXPECT_EQ(valueFromText(ValueType<Fidelity>{}, spellings, "double"), Fidelity::two);
    EXPECT_EQ(messageOf([&] { (void)valueFromText(ValueType<Fidelity>{}, spellings, "exat"); }),
              "'exat' is unknown; did you mean exact? known are: single, double, exact");
    EXPECT_EQ(messageOf([&] { (void)valueFromText(ValueType<Fidelity>{}, spellings, "photon"); }),
              "'photon' is unknown; known are: single, double, exact");
}

TEST(OptionText, ReadsListsOfWords) {
    const Spellings<AovLayer> spellings(kAovSpellings);
    std::vector<AovLayer> layers;
    assignFromText(layers, spellings, "normal,depth,normal");
    EXPECT_EQ(layers, (std::vector{AovLayer::normal, AovLayer::depth}));
    EXPECT_EQ(textsFromOption(layers, spellings), std::vector<std::string>{"normal,depth"});
    EXPECT_THAT(messageOf([&] { assignFromText(layers, spellings, "depth,"); }),
                HasSubstr("'' is unknown; known are: depth, normal, material, bounces"));
}

TEST(OptionText, QuotesOnlyTheBeginningOfAHostileArgument) {
    const std::string text(100000, 'x');
    EXPECT_LT(messageOf([&] { (void)valueFromText(ValueType<float>{}, kPlace, text); }).size(),
              100);
}

TEST(OptionText, GivesBackWhatItWrote) {
    for (const float value : {0.1f, -1.0f / 3.0f, 1e-7f, 123456.789f, 0.0f}) {
        EXPECT_EQ(valueFromText(ValueType<float>{}, kPlace, textFromValue(value)), value);
    }
    EXPECT_EQ(textFromValue(glm::vec3(0.5f, -0.0f, -2)), "0.5,0,-2");
}

}  // namespace
}  // namespace tukor
