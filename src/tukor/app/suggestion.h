// What a message says about a name that nobody knows.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace tukor {

/// `'glas' is unknown; did you mean glass? known are: gold, glass`
[[nodiscard]] std::string unknownName(std::string_view name,
                                      std::span<const std::string_view> known);

/// The same about a name that models give: `camera 'frnt' is unknown; did you mean front? ...`, or
/// `camera 'front': the model has no cameras`.
[[nodiscard]] std::string unknownInModel(std::string_view kind, std::string_view name,
                                         std::span<const std::string_view> known);

}  // namespace tukor
