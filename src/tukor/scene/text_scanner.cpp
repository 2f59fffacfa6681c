#include "tukor/scene/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tukor {

namespace {

bool isBlank(char c) noexcept {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == '\0';
}

bool isDigit(char c) noexcept {
    return c >= '0' && c <= '9';
}

// Exact in double up to 22, all that the largest mantissas of files need.
constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                              1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                              1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

double scaled(double mantissa, int exponent) noexcept {
    if (exponent >= 0 && exponent <= 22) return mantissa * kPowers[exponent];
    if (exponent < 0 && exponent >= -22) return mantissa / kPowers[-exponent];
    return mantissa * std::pow(10.0, exponent);
}

}  // namespace

void TextScanner::skipBlanks() noexcept {
    while (at_ != end_) {
        if (isBlank(*at_)) {
            ++at_;
        } else if (*at_ == '\\' && end_ - at_ >= 2 && at_[1] == '\n') {
            at_ += 2;
            ++line_;
        } else if (*at_ == '\\' && end_ - at_ >= 3 && at_[1] == '\r' && at_[2] == '\n') {
            at_ += 3;
            ++line_;
        } else {
            return;
        }
    }
}

void TextScanner::skipLine() noexcept {
    at_ = std::find(at_, end_, '\n');
    if (at_ != end_) ++at_;
    ++line_;
}

std::string_view TextScanner::word() noexcept {
    skipBlanks();
    const char* const start = at_;
    while (at_ != end_ && !isBlank(*at_) && *at_ != '\n') ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
}

std::string_view TextScanner::restOfLine() noexcept {
    skipBlanks();
    const char* const start = at_;
    at_ = std::find(at_, end_, '\n');
    const char* last = at_;
    while (last != start && isBlank(last[-1])) --last;
    return {start, static_cast<std::size_t>(last - start)};
}

std::string_view TextScanner::wordOnAnyLine() noexcept {
    std::string_view found = word();
    while (found.empty() && !atEnd()) {
        skipLine();
        found = word();
    }
    return found;
}

std::optional<float> floatOf(std::string_view word) noexcept {
    const char* at = word.data();
    const char* const end = at + word.size();
    const bool negative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;
    if (at == end) return std::nullopt;
    const std::string_view rest(at, static_cast<std::size_t>(end - at));
    const float sign = negative ? -1.0f : 1.0f;
    if (rest == "nan" || rest == "NaN") return std::numeric_limits<float>::quiet_NaN();
    if (rest == "inf" || rest == "Inf" || rest == "infinity")
        return sign * std::numeric_limits<float>::infinity();

    std::uint64_t mantissa = 0;
    int exponent = 0, digits = 0;
    bool fraction = false;
    for (; at != end; ++at) {
        if (*at == '.' && !fraction) {
            fraction = true;
        } else if (isDigit(*at)) {
            ++digits;
            if (mantissa < 100'000'000'000'000'000u) {  // 17 digits and one more fit into 64 bits
                mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
                exponent -= fraction ? 1 : 0;
            } else if (!fraction && exponent < 10'000) {
                ++exponent;
            }
        } else {
            break;
        }
    }
    if (digits == 0) return std::nullopt;
    if (at != end) {
        if (*at != 'e' && *at != 'E') return std::nullopt;
        ++at;
        const bool down = at != end && *at == '-';
        if (at != end && (*at == '-' || *at == '+')) ++at;
        if (at == end) return std::nullopt;
        int power = 0;
        for (; at != end; ++at) {
            if (!isDigit(*at)) return std::nullopt;
            power = std::min(power * 10 + (*at - '0'), 10'000);
        }
        exponent += down ? -power : power;
    }
    return sign * static_cast<float>(scaled(static_cast<double>(mantissa), exponent));
}

std::optional<std::int64_t> integerOf(std::string_view word) noexcept {
    const bool negative = word.starts_with('-');
    if (negative || word.starts_with('+')) word.remove_prefix(1);
    if (word.empty() || word.size() > 18) return std::nullopt;
    std::int64_t value = 0;
    for (const char c : word) {
        if (!isDigit(c)) return std::nullopt;
        value = value * 10 + (c - '0');
    }
    return negative ? -value : value;
}

}  // namespace tukor
