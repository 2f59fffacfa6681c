// What the library uses of fmt, made small: pages fetch the module, and {fmt} itself would be a
// third of it.
//
// `{}` and `{:SPEC}` with the specifications that messages use: [0][width]x for whole numbers,
// [.precision]f, g or e for others. Patterns are checked by {fmt} in every native build.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace fmt {

/// One value of a message.
class Argument {
public:
    enum class Kind { whole, positive, single, real, text };

    Argument(std::string_view text) : kind(Kind::text), text(text) {}
    Argument(const std::string& text) : Argument(std::string_view(text)) {}
    Argument(const char* text) : Argument(std::string_view(text)) {}
    Argument(bool value) : Argument(value ? "true" : "false") {}
    Argument(const char& value) : Argument(std::string_view(&value, 1)) {}
    Argument(float value) : kind(Kind::single), real(value) {}
    Argument(double value) : kind(Kind::real), real(value) {}
    template <class T>
    requires std::is_integral_v<T> Argument(T value)
        : kind(std::is_signed_v<T> && value < T(0) ? Kind::whole : Kind::positive),
          whole(static_cast<std::int64_t>(value)) {}

    Kind kind;
    std::string_view text{};
    std::int64_t whole = 0;
    double real = 0.0;
};

std::string formatted(std::string_view pattern, std::span<const Argument> arguments);

template <class... Values>
std::string format(std::string_view pattern, const Values&... values) {
    if constexpr (sizeof...(values) == 0) {
        return formatted(pattern, {});
    } else {
        const Argument arguments[] = {Argument(values)...};
        return formatted(pattern, arguments);
    }
}

template <class Range>
std::string join(const Range& range, std::string_view separator) {
    std::string joined;
    bool first = true;
    for (const auto& one : range) {
        if (!first) joined += separator;
        joined += std::string_view(one);
        first = false;
    }
    return joined;
}

}  // namespace fmt
