#include "tukor/scene/json_item.h"

#include <cmath>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {

std::string JsonItem::where() const {
    std::string path;
    for (std::size_t i = 0; i < depth_; ++i) {
        if (path_[i].name == nullptr) {
            path += fmt::format("[{}]", path_[i].index);
        } else {
            if (i > 0) path += '.';
            path += printable(path_[i].name);
        }
    }
    return path.empty() ? *document_ : fmt::format("{}: {}", *document_, path);
}

JsonItem JsonItem::child(std::size_t value, const char* name, std::size_t index) const noexcept {
    JsonItem item = *this;
    item.value_ = value;
    if (depth_ < kSteps) item.path_[item.depth_++] = {name, index};
    return item;
}

void JsonItem::refuse(std::string_view expected) const {
    constexpr std::string_view kKinds[] = {"null",   "boolean", "number",
                                           "string", "array",   "object"};
    fail(fmt::format("found {}; expected {}", kKinds[static_cast<int>(json_->kind(value_))],
                     expected));
}

void JsonItem::fail(std::string_view message) const {
    throw Error(fmt::format("{}: {}", where(), message));
}

void JsonItem::require(JsonKind kind, std::string_view expected) const {
    if (json_->kind(value_) != kind) refuse(expected);
}

std::optional<JsonItem> JsonItem::find(const char* name) const {
    require(JsonKind::object, "an object");
    const std::optional<std::size_t> member = json_->find(value_, name);
    if (!member) return std::nullopt;
    return child(*member, json_->name(*member), 0);
}

JsonItem JsonItem::at(const char* name) const {
    const std::optional<JsonItem> found = find(name);
    if (!found) fail(fmt::format("'{}' is missing", name));
    return *found;
}

std::vector<std::string> JsonItem::memberNames() const {
    require(JsonKind::object, "an object");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < json_->size(value_); ++i)
        names.emplace_back(json_->name(json_->child(value_, i)));
    return names;
}

std::size_t JsonItem::size() const {
    require(JsonKind::array, "an array");
    return json_->size(value_);
}

JsonItem JsonItem::operator[](std::size_t index) const {
    if (index >= size()) fail(fmt::format("element {} of {}", index, size()));
    return child(json_->child(value_, index), nullptr, index);
}

std::size_t JsonItem::countAt(std::size_t index) const {
    if (index < size()) {
        const std::size_t element = json_->child(value_, index);
        const double number = json_->number(element);
        if (json_->kind(element) == JsonKind::number && number >= 0.0 && number < 0x1p53 &&
            number == std::floor(number))
            return static_cast<std::size_t>(number);
    }
    return (*this)[index].count();  // or what is wrong with it
}

JsonList JsonItem::list(const char* name) const {
    return JsonList(find(name));
}

double JsonItem::number() const {
    require(JsonKind::number, "a number");
    return json_->number(value_);
}

std::size_t JsonItem::count() const {
    constexpr double kLargest = 9007199254740992.0;  // 2^53, beyond which doubles have gaps
    const double value = number();
    if (!(value >= 0.0 && value <= kLargest && value == std::floor(value)))
        fail(fmt::format("found {}; expected a whole number from 0 up", value));
    return static_cast<std::size_t>(value);
}

std::string_view JsonItem::text() const {
    require(JsonKind::string, "a string");
    return json_->text(value_);
}

bool JsonItem::truth() const {
    require(JsonKind::boolean, "true or false");
    return json_->truth(value_);
}

double JsonItem::numberOr(const char* name, double absent) const {
    const std::optional<JsonItem> item = find(name);
    return item ? item->number() : absent;
}

std::size_t JsonItem::countOr(const char* name, std::size_t absent) const {
    const std::optional<JsonItem> item = find(name);
    return item ? item->count() : absent;
}

std::string JsonItem::textOr(const char* name, std::string_view absent) const {
    const std::optional<JsonItem> item = find(name);
    return std::string(item ? item->text() : absent);
}

bool JsonItem::truthOr(const char* name, bool absent) const {
    const std::optional<JsonItem> item = find(name);
    return item ? item->truth() : absent;
}

bool JsonItem::numbersInto(const char* name, std::span<double> values) const {
    const std::optional<JsonItem> item = find(name);
    if (!item) return false;
    if (item->size() != values.size())
        item->fail(fmt::format("{} numbers; expected {}", item->size(), values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = (*item)[i].number();
    return true;
}

}  // namespace tukor
