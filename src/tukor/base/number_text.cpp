#include "tukor/base/number_text.h"

#include <cstdlib>
#include <limits>
#include <string>

#ifdef __EMSCRIPTEN__
// The C library's reader would bring arithmetic of 128 bits along; the browser has one.
extern "C" __attribute__((import_module("env"), import_name("tukorNumberFromText"))) double
tukorNumberFromText(const char* text, int size);
#endif

namespace tukor {

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
    const std::string copy(text);  // strtod wants a terminator
    char* end = nullptr;
    const double value = std::strtod(copy.c_str(), &end);
    if (end != copy.c_str() + copy.size()) return std::nullopt;
    return value;
#endif
}

}  // namespace tukor
