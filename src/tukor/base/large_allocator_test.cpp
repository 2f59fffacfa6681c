#include "tukor/base/large_allocator.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace tukor {
namespace {

TEST(LargeAllocator, HoldsWhatIsPutIntoSmallAndLargeVectors) {
    for (const std::size_t size : {std::size_t{3}, std::size_t{3} << 20}) {
        std::vector<int, LargeAllocator<int>> numbers(size, 7);
        numbers.push_back(8);
        EXPECT_EQ(numbers.front(), 7);
        EXPECT_EQ(numbers.back(), 8);
        if (size > 3) {
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % (2u << 20), 0u);
        }
    }
}

TEST(LargeAllocator, RefusesMoreThanThereIs) {
    EXPECT_THROW((void)LargeAllocator<double>().allocate(static_cast<std::size_t>(-1) / 4),
                 std::bad_alloc);
}

}  // namespace
}  // namespace tukor
