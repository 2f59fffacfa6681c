#include "tukor/app/option_text.h"

#include <cmath>

#include "tukor/base/number_text.h"

namespace tukor {
namespace {

/// What a message quotes: a hostile argument must not fill the terminal.
std::string quoted(std::string_view text) {
    constexpr std::size_t kShown = 60;
    if (text.size() <= kShown) return fmt::format("'{}'", text);
    return fmt::format("'{}...'", text.substr(0, kShown));
}

/// A plain decimal number that fills the whole text; no nan, inf, hexadecimal or white space.
std::optional<double> decimal(std::string_view text) {
    const std::optional<double> value = numberFromText(text);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    return value;
}

template <class T>
void checkRange(double value, const Measure<T>& measure) {
    if (value >= double(measure.range.least) && value <= double(measure.range.most)) return;
    throw Error(fmt::format("{} is out of range; {} expected", value, boundsOf(measure)));
}

float component(const Measure<float>& measure, std::string_view text) {
    const auto value = decimal(text);
    if (!value) throw Error(fmt::format("{} is not a number", quoted(text)));
    checkRange(*value, measure);
    return static_cast<float>(*value);
}

int wholeNumber(const Measure<int>& measure, std::string_view text) {
    const auto value = decimal(text);
    if (!value || *value != std::floor(*value)) {
        throw Error(fmt::format("{} is not a whole number", quoted(text)));
    }
    checkRange(*value, measure);
    return static_cast<int>(*value);
}

}  // namespace

int valueFromText(ValueType<int>, const Measure<int>& measure, std::string_view text) {
    return wholeNumber(measure, text);
}

float valueFromText(ValueType<float>, const Measure<float>& measure, std::string_view text) {
    return component(measure, text);
}

glm::vec3 valueFromText(ValueType<glm::vec3>, const Measure<float>& measure,
                        std::string_view text) {
    const auto first = text.find(',');
    const auto second = first == text.npos ? text.npos : text.find(',', first + 1);
    if (second == text.npos || text.find(',', second + 1) != text.npos) {
        throw Error(
            fmt::format("{} is not a vector; X,Y,Z expected, as in 0,1.5,-4", quoted(text)));
    }
    return {component(measure, text.substr(0, first)),
            component(measure, text.substr(first + 1, second - first - 1)),
            component(measure, text.substr(second + 1))};
}

PictureSize valueFromText(ValueType<PictureSize>, const Measure<int>& measure,
                          std::string_view text) {
    const auto cross = text.find('x');
    if (cross == text.npos || !decimal(text.substr(0, cross)) || !decimal(text.substr(cross + 1))) {
        throw Error(fmt::format("{} is not a size; WxH expected, as in 1280x720", quoted(text)));
    }
    const PictureSize size{wholeNumber(measure, text.substr(0, cross)),
                           wholeNumber(measure, text.substr(cross + 1))};
    if (long(size.width) * long(size.height) > kMostPicturePixels) {
        throw Error(fmt::format(
            "{} x {} is {} million pixels; at most {} million expected", size.width, size.height,
            long(size.width) * long(size.height) / 1'000'000, kMostPicturePixels / 1'000'000));
    }
    return size;
}

std::string valueFromText(ValueType<std::string>, const Placeholder& placeholder,
                          std::string_view text) {
    if (text.empty()) throw Error(fmt::format("is empty; {} expected", placeholder.text));
    return std::string(text);
}

std::string textFromValue(int value) {
    return fmt::format("{}", value);
}

std::string textFromValue(float value) {
    return fmt::format("{}", value == 0.0f ? 0.0f : value);  // -0 reads as a mistake
}

std::string textFromValue(glm::vec3 value) {
    return fmt::format("{},{},{}", textFromValue(value.x), textFromValue(value.y),
                       textFromValue(value.z));
}

std::string textFromValue(PictureSize value) {
    return fmt::format("{}x{}", value.width, value.height);
}

std::string usageOf(const Placeholder& placeholder) {
    return std::string(placeholder.text);
}

}  // namespace tukor
