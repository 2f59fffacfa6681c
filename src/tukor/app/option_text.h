// Option values from text and back: what the command line, JSON and the panel have in common.
//
// valueFromText(extra, text) throws Error without the option's name: `'abc' is not a number`; the
// caller knows the name. textFromValue is its inverse, shortest text that gives the value back.
#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "tukor/app/options.h"
#include "tukor/app/suggestion.h"
#include "tukor/base/error.h"

namespace tukor {

/// Tells valueFromText which type is wanted.
template <class T>
struct ValueType {};

[[nodiscard]] int valueFromText(ValueType<int>, const Measure<int>& measure, std::string_view text);
[[nodiscard]] float valueFromText(ValueType<float>, const Measure<float>& measure,
                                  std::string_view text);
[[nodiscard]] glm::vec3 valueFromText(ValueType<glm::vec3>, const Measure<float>& measure,
                                      std::string_view text);
[[nodiscard]] PictureSize valueFromText(ValueType<PictureSize>, const Measure<int>& measure,
                                        std::string_view text);
[[nodiscard]] std::string valueFromText(ValueType<std::string>, const Placeholder& placeholder,
                                        std::string_view text);

template <class Enum>
[[nodiscard]] Enum valueFromText(ValueType<Enum>, const Spellings<Enum>& spellings,
                                 std::string_view text) {
    std::vector<std::string_view> known;
    for (const auto& [value, spelling] : spellings) {
        if (spelling == text) return value;
        known.push_back(spelling);
    }
    throw Error(unknownName(text, known));
}

/// Reads into the option: an optional becomes engaged, a list grows by one.
template <class T, class Extra>
void assignFromText(T& value, const Extra& extra, std::string_view text) {
    value = valueFromText(ValueType<T>{}, extra, text);
}
template <class T, class Extra>
void assignFromText(std::optional<T>& value, const Extra& extra, std::string_view text) {
    value = valueFromText(ValueType<T>{}, extra, text);
}
template <class Extra>
void assignFromText(std::vector<std::string>& value, const Extra& extra, std::string_view text) {
    value.push_back(valueFromText(ValueType<std::string>{}, extra, text));
}

/// A list of words separated by commas; those that are there already are not repeated.
template <class Enum>
void assignFromText(std::vector<Enum>& value, const Spellings<Enum>& spellings,
                    std::string_view text) {
    while (true) {
        const auto comma = text.find(',');
        const Enum one = valueFromText(ValueType<Enum>{}, spellings, text.substr(0, comma));
        if (std::find(value.begin(), value.end(), one) == value.end()) value.push_back(one);
        if (comma == text.npos) return;
        text.remove_prefix(comma + 1);
    }
}

[[nodiscard]] std::string textFromValue(int value);
[[nodiscard]] std::string textFromValue(float value);
[[nodiscard]] std::string textFromValue(glm::vec3 value);
[[nodiscard]] std::string textFromValue(PictureSize value);

/// The texts that give an option its value: none for an empty optional or list.
template <class T, class Extra>
[[nodiscard]] std::vector<std::string> textsFromOption(const T& value, const Extra&) {
    return {textFromValue(value)};
}
template <class Enum>
[[nodiscard]] std::vector<std::string> textsFromOption(const Enum& value,
                                                       const Spellings<Enum>& spellings) {
    for (const auto& [known, spelling] : spellings) {
        if (known == value) return {std::string(spelling)};
    }
    return {};
}
template <class Extra>
[[nodiscard]] std::vector<std::string> textsFromOption(const std::string& value, const Extra&) {
    if (value.empty()) return {};
    return {value};
}
template <class Extra>
[[nodiscard]] std::vector<std::string> textsFromOption(const std::vector<std::string>& value,
                                                       const Extra&) {
    return value;
}
template <class Enum>
[[nodiscard]] std::vector<std::string> textsFromOption(const std::vector<Enum>& value,
                                                       const Spellings<Enum>& spellings) {
    std::string text;
    for (const Enum one : value) {
        text += (text.empty() ? "" : ",") + textsFromOption(one, spellings).front();
    }
    if (text.empty()) return {};
    return {text};
}
template <class T, class Extra>
[[nodiscard]] std::vector<std::string> textsFromOption(const std::optional<T>& value,
                                                       const Extra& extra) {
    if (!value) return {};
    return textsFromOption(*value, extra);
}

/// What stands for the value in a usage line: `DEG`, `quad|box|dome|none`.
[[nodiscard]] std::string usageOf(const Placeholder& placeholder);
template <class T>
[[nodiscard]] std::string usageOf(const Measure<T>& measure) {
    return std::string(measure.unit);
}
template <class Enum>
[[nodiscard]] std::string usageOf(const Spellings<Enum>& spellings) {
    std::string usage;
    for (const auto& [value, spelling] : spellings) {
        if (!usage.empty()) usage += '|';
        usage += spelling;
    }
    return usage;
}

/// The bounds as people read them, `1 to 175`; empty for what has none.
template <class Extra>
[[nodiscard]] std::string boundsOf(const Extra&) {
    return {};
}
template <class T>
[[nodiscard]] std::string boundsOf(const Measure<T>& measure) {
    return fmt::format("{} to {}", textFromValue(measure.range.least),
                       textFromValue(measure.range.most));
}

}  // namespace tukor
