// Help for mistyped names: the known name nearest to what was written.
#pragma once
#include <span>
#include <string_view>

namespace tukor {

/// The least number of letters to insert, delete, replace or swap with their neighbour that turns
/// `a` into `b`; case does not count.
[[nodiscard]] int editDistance(std::string_view a, std::string_view b);

/// The nearest of `names`; empty when none is near enough to be meant (a third of its letters).
[[nodiscard]] std::string_view nearestName(std::string_view word,
                                           std::span<const std::string_view> names);

}  // namespace tukor
