// What a message says about a name that nobody knows.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace tukor {

/// `'glas' is unknown; did you mean glass? known are: gold, glass`
[[nodiscard]] std::string unknownName(std::string_view name,
                                      std::span<const std::string_view> known);

}  // namespace tukor
