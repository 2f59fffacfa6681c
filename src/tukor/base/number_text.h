// Decimal numbers in text: what options, materials and file headers are written in.
#pragma once
#include <optional>
#include <string_view>

namespace tukor {

/// The number that fills the whole text: decimal with an optional exponent, `nan` or `inf`. No
/// hexadecimal, no white space. Rounded correctly; beyond the largest double it is infinite.
[[nodiscard]] std::optional<double> numberFromText(std::string_view text);

}  // namespace tukor
