#include "tukor/base/parallel.h"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

#include "tukor/base/error.h"

namespace tukor {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceInPiecesNoLongerThanTheGrain) {
    std::vector<std::atomic<int>> visits(1000);
    std::atomic<int> longest = 0;
    parallelFor(0, 1000, 7, [&](int begin, int end) {
        for (int length = end - begin, seen = longest;
             length > seen && !longest.compare_exchange_weak(seen, length);) {
        }
        for (int i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
    });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
    EXPECT_LE(longest, 7);
}

TEST(ParallelFor, DoesNothingOnAnEmptyRange) {
    parallelFor(3, 3, 1, [](int, int) { FAIL(); });
    parallelFor(3, 1, 1, [](int, int) { FAIL(); });
}

TEST(ParallelFor, RethrowsTheErrorOfABody) {
    EXPECT_THROW(parallelFor(0, 100, 1,
                             [](int begin, int) {
                                 if (begin == 50) throw Error("half way");
                             }),
                 Error);
}

TEST(ParallelFor, TellsHowFarItIsAndStopsWhenAsked) {
    std::vector<std::atomic<int>> visits(100);
    const auto visit = [&](int begin, int end) {
        for (int i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
    };
    float last = 0.0f;
    EXPECT_TRUE(parallelFor(0, 100, 7, Progress([&](float fraction) {
                                EXPECT_GT(fraction, last);
                                last = fraction;
                                return true;
                            }),
                            visit));
    EXPECT_EQ(last, 1.0f);
    for (const auto& count : visits) EXPECT_EQ(count, 1);
    EXPECT_FALSE(
        parallelFor(0, 100, 7, Progress([](float fraction) { return fraction < 0.5f; }), visit));
    EXPECT_EQ(visits[10], 2);
    EXPECT_EQ(visits[90], 1);
    EXPECT_TRUE(parallelFor(0, 100, 7, Progress(), visit));
    EXPECT_EQ(visits[90], 2);
}

TEST(ParallelFor, RunsLoopsInsideLoopsWhileTheThreadCountChanges) {
    for (const int threads : {4, 1, 2, 4}) {
        setThreadCount(threads);
        std::atomic<int> visits = 0;
        parallelFor(0, 10, 1, [&](int, int) {
            parallelFor(0, 100, 3, [&](int begin, int end) { visits += end - begin; });
        });
        EXPECT_EQ(visits, 1000);
    }
    setThreadCount(0);
}

TEST(ParallelFor, TakesTheThreadCountItIsTold) {
    setThreadCount(1);
    EXPECT_EQ(threadCount(), 1);
    setThreadCount(0);
    EXPECT_GE(threadCount(), 1);
}

}  // namespace
}  // namespace tukor
