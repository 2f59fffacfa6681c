#include "tukor/environment/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"

namespace tukor {
namespace {

std::string messageOf(const std::string& nameOrPath, const EnvironmentOptions& options = {}) {
    try {
        (void)loadEnvironment(nameOrPath, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(LoadEnvironment, MakesTheBuiltInsAtTheFaceSizeAsked) {
    for (const char* name : {"studio", "sky"}) {
        const Environment environment = loadEnvironment(name, {.faceSize = 32});
        EXPECT_EQ(environment.name, name);
        EXPECT_EQ(environment.radiance.faceSize(), 32);
        EXPECT_TRUE(environment.warnings.empty());
    }
    EXPECT_EQ(loadEnvironment("studio").radiance.faceSize(), 512);
}

TEST(LoadEnvironment, ListsTheBuiltInsForAnUnknownName) {
    EXPECT_EQ(messageOf("studoi"), "studoi: no such environment; built in are studio, sky");
}

}  // namespace
}  // namespace tukor
