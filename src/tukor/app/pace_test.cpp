#include "tukor/app/pace.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace tukor {
namespace {

/// A machine that traces so many rays a second, on paths that end after 20 rays at the latest.
double secondsFor(const RenderOptions& options, double raysPerSecond) {
    return options.width * options.height * std::min(options.rayBudget, 20) / raysPerSecond;
}

RenderOptions settled(Pace& pace, double raysPerSecond) {
    const RenderOptions rest;
    for (int frame = 0; frame < 30; ++frame)
        pace.took(secondsFor(pace.whileMoving(rest), raysPerSecond));
    return pace.whileMoving(rest);
}

TEST(Pace, HoldsTheFrameTimeOnFastAndSlowMachines) {
    for (const double raysPerSecond : {1e7, 3e7, 1e8, 3e8, 5e8}) {
        Pace pace;
        const double seconds = secondsFor(settled(pace, raysPerSecond), raysPerSecond);
        EXPECT_GT(seconds, 0.02) << raysPerSecond;
        EXPECT_LT(seconds, 0.05) << raysPerSecond;
    }
}

TEST(Pace, GivesFastMachinesTheWholePicture) {
    Pace pace;
    const RenderOptions moving = settled(pace, 1e10);
    EXPECT_EQ(moving.width, RenderOptions{}.width);
    EXPECT_EQ(moving.rayBudget, RenderOptions{}.rayBudget);
    EXPECT_EQ(moving.weightCutoff, RenderOptions{}.weightCutoff);
}

TEST(Pace, KeepsAPictureOnTheSlowest) {
    Pace pace;
    const RenderOptions moving = settled(pace, 1e5);
    EXPECT_EQ(moving.width, 256);
    EXPECT_EQ(moving.rayBudget, 3);
}

TEST(Pace, RecoversWithinAFewFramesWhenTheSubjectChanges) {
    Pace pace;
    (void)settled(pace, 1e10);
    const RenderOptions rest;
    for (int frame = 0; frame < 6; ++frame) pace.took(secondsFor(pace.whileMoving(rest), 1e8));
    EXPECT_LT(secondsFor(pace.whileMoving(rest), 1e8), 0.05);
}

}  // namespace
}  // namespace tukor
