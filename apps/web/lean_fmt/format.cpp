#include <fmt/format.h>

// Digits as JavaScript writes them: web/src/library.js.
extern "C" __attribute__((import_module("env"), import_name("tukorTextFromNumber"))) int
tukorTextFromNumber(double value, int single, int precision, int type, char* out);

namespace fmt {

namespace {

struct Specification {
    char fill = ' ';
    std::size_t width = 0;
    int precision = -1;
    char type = '\0';
    bool prefix = false;
};

Specification specificationOf(std::string_view text) {
    Specification spec;
    std::size_t i = 0;
    const auto number = [&] {
        int value = 0;
        while (i < text.size() && text[i] >= '0' && text[i] <= '9')
            value = 10 * value + (text[i++] - '0');
        return value;
    };
    if (i < text.size() && text[i] == '#') {
        spec.prefix = true;
        ++i;
    }
    if (i < text.size() && text[i] == '0') spec.fill = '0';
    spec.width = static_cast<std::size_t>(number());
    if (i < text.size() && text[i] == '.') {
        ++i;
        spec.precision = number();
    }
    if (i < text.size()) spec.type = text[i];
    return spec;
}

std::string wholeText(const Argument& argument, const Specification& spec) {
    const unsigned base = spec.type == 'x' ? 16 : 10;
    const bool negative = argument.kind == Argument::Kind::whole;
    auto rest = static_cast<std::uint64_t>(argument.whole);
    if (negative) rest = 0 - rest;
    std::string digits;
    do {
        digits.insert(digits.begin(), "0123456789abcdef"[rest % base]);
        rest /= base;
    } while (rest != 0);
    if (digits.size() < spec.width) digits.insert(0, spec.width - digits.size(), spec.fill);
    if (spec.prefix && base == 16) digits.insert(0, "0x");
    if (negative) digits.insert(0, "-");
    return digits;
}

std::string realText(const Argument& argument, const Specification& spec) {
    char digits[400];  // 309 before the point, at most 64 behind it
    const int size = tukorTextFromNumber(argument.real, argument.kind == Argument::Kind::single,
                                         spec.precision, spec.type, digits);
    return {digits, static_cast<std::size_t>(size)};
}

}  // namespace

std::string formatted(std::string_view pattern, std::span<const Argument> arguments) {
    std::string text;
    std::size_t next = 0;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char c = pattern[i];
        if (c == '}') ++i;  // doubled
        if (c != '{' || pattern[i + 1] == '{') {
            text += c;
            if (c == '{') ++i;
            continue;
        }
        const std::size_t end = pattern.find('}', i);
        const std::string_view inside = pattern.substr(i + 1, end - i - 1);
        const Specification spec = specificationOf(inside.empty() ? inside : inside.substr(1));
        const Argument& argument = arguments[next++];
        switch (argument.kind) {
            case Argument::Kind::text:
                text += argument.text;
                break;
            case Argument::Kind::whole:
            case Argument::Kind::positive:
                text += wholeText(argument, spec);
                break;
            case Argument::Kind::single:
            case Argument::Kind::real:
                text += realText(argument, spec);
                break;
        }
        i = end;
    }
    return text;
}

}  // namespace fmt
