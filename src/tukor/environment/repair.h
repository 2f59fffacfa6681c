// Makes captured radiance finite and non-negative.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/image/image.h"

namespace tukor {

/// How many pixels had a component that was wrong in this way.
struct RepairCount {
    int notFinite = 0;
    int negative = 0;
};

/// Replaces, component by component, what is not radiance.
///
/// Negative values, which are colours outside Rec. 709 or ringing of a resampling, become 0. Values
/// above 1e30, whose sums overflow, count as not finite. A value that is not finite takes the
/// largest of the finite ones among the eight neighbours where it is +infinity, an overflow of
/// something bright; their mean where it is no number; 0 where there is no such neighbour. Zero
/// alone would make holes, and a hole in the sun a black dot in every reflection.
RepairCount repairRadiance(Image& image);

/// One sentence for each kind of repair that was made, none when all was well.
[[nodiscard]] std::vector<std::string> describeRepairs(const RepairCount& count);

/// Repairs the pictures of the file `name` and says what was done, as describeRepairs. Throws Error
/// where more than half of their pixels are not finite: nothing is left to repair them from.
[[nodiscard]] std::vector<std::string> repairPictures(std::string_view name,
                                                      std::span<Image> pictures);

}  // namespace tukor
