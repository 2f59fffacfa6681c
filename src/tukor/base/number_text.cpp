#include "tukor/base/number_text.h"

#include <limits>

#ifdef __EMSCRIPTEN__
// The C library's reader would bring arithmetic of 128 bits along; the browser has one.
extern "C" __attribute__((import_module("env"), import_name("tukorNumberFromText"))) double
tukorNumberFromText(const char* text, int size);
#else
#include <algorithm>
#include <charconv>
#include <system_error>
#endif

namespace tukor {
#ifndef __EMSCRIPTEN__
namespace {

/// What a decimal number rounds to that lies beyond the largest or the smallest double.
double roundedBeyond(std::string_view text) {
    const std::size_t end = std::min(text.find_first_of("eE"), text.size());
    const std::string_view mantissa = text.substr(0, end);
    std::string_view exponent = text.substr(std::min(end + 1, text.size()));
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    int power = 0;
    const auto read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (read.ec == std::errc::result_out_of_range)  // more than any mantissa makes up for
        power = exponent.starts_with('-') ? -1'000'000 : 1'000'000;
    const auto point = static_cast<int>(std::min(mantissa.find('.'), mantissa.size()));
    const auto first = static_cast<int>(mantissa.find_first_of("123456789"));
    return point - first + power > 0 ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace
#endif

std::optional<double> numberFromText(std::string_view text) {
    constexpr std::size_t kLongest = 1000;
    const bool sign = text.starts_with('-') || text.starts_with('+');
    const std::string_view word = text.substr(sign ? 1 : 0);
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (word == "inf") {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return text.front() == '-' ? -infinity : infinity;
    }
    if (text.empty() || text.size() > kLongest) return std::nullopt;
    if (text.find_first_not_of("0123456789+-.eE") != std::string_view::npos) return std::nullopt;
#ifdef __EMSCRIPTEN__
    const double value = tukorNumberFromText(text.data(), static_cast<int>(text.size()));
    if (value != value) return std::nullopt;
    return value;
#else
    // Whatever the locale is, unlike strtod. A sign is read here: from_chars takes no plus.
    if (sign && (word.starts_with('-') || word.starts_with('+'))) return std::nullopt;
    const char* const end = word.data() + word.size();
    double value = 0.0;
    const auto read = std::from_chars(word.data(), end, value);
    if (read.ptr != end || read.ec == std::errc::invalid_argument) return std::nullopt;
    if (read.ec == std::errc::result_out_of_range) value = roundedBeyond(word);
    return text.front() == '-' ? -value : value;
#endif
}

}  // namespace tukor
