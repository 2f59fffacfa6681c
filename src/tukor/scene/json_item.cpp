#include "tukor/scene/json_item.h"

#include <cmath>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

constexpr int kDeepest = 64;                // extras and extensions nest; ten levels are many
constexpr std::size_t kMostMegabytes = 64;  // taken by values, beside the text of strings

// What the parser allocates for each kind of value: an array grows by doubling, a member is a node
// of a tree.
constexpr std::size_t kElementBytes = 32, kStringBytes = 48, kArrayBytes = 48, kObjectBytes = 64,
                      kMemberBytes = 48;  // and the string of its key

// Bounds what the parser will allocate, before it does.
void checkSize(std::string_view name, std::string_view text) {
    int depth = 0;
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
            case '"':
                bytes += kStringBytes;
                for (++i; i < text.size() && text[i] != '"'; ++i)
                    if (text[i] == '\\') ++i;
                break;
            case '[':
            case '{':
                bytes += text[i] == '[' ? kArrayBytes : kObjectBytes;
                if (++depth > kDeepest)
                    throw Error(
                        fmt::format("{}: JSON nested deeper than {} levels", name, kDeepest));
                break;
            case ']':
            case '}':
                --depth;
                break;
            case ',':
                bytes += kElementBytes;
                break;
            case ':':
                bytes += kMemberBytes;
                break;
            default:
                break;
        }
        if (bytes > kMostMegabytes << 20)
            throw Error(
                fmt::format("{}: JSON of values that take more than {} MB", name, kMostMegabytes));
    }
}

}  // namespace

nlohmann::json parseJson(std::string_view name, std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    checkSize(name, text);
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        throw Error(
            fmt::format("{}: not JSON: wrong at byte {} of {}", name, error.byte, bytes.size()));
    } catch (const nlohmann::json::exception&) {
        throw Error(fmt::format("{}: not JSON: a number is beyond all bounds", name));
    }
}

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

JsonItem JsonItem::child(const nlohmann::json& value, const char* name,
                         std::size_t index) const noexcept {
    JsonItem item = *this;
    item.value_ = &value;
    if (depth_ < kSteps) item.path_[item.depth_++] = {name, index};
    return item;
}

void JsonItem::refuse(std::string_view expected) const {
    fail(fmt::format("found {}; expected {}", value_->type_name(), expected));
}

void JsonItem::fail(std::string_view message) const {
    throw Error(fmt::format("{}: {}", where(), message));
}

void JsonItem::requireObject() const {
    if (!value_->is_object()) refuse("an object");
}

std::optional<JsonItem> JsonItem::find(const char* name) const {
    requireObject();
    const auto found = value_->find(name);
    if (found == value_->end()) return std::nullopt;
    return child(*found, found.key().c_str(), 0);
}

JsonItem JsonItem::at(const char* name) const {
    std::optional<JsonItem> found = find(name);
    if (!found) fail(fmt::format("'{}' is missing", name));
    return *std::move(found);
}

std::vector<std::string> JsonItem::memberNames() const {
    requireObject();
    std::vector<std::string> names;
    for (const auto& member : value_->items()) names.push_back(member.key());
    return names;
}

std::size_t JsonItem::size() const {
    if (!value_->is_array()) refuse("an array");
    return value_->size();
}

JsonItem JsonItem::operator[](std::size_t index) const {
    if (index >= size()) fail(fmt::format("element {} of {}", index, size()));
    return child((*value_)[index], nullptr, index);
}

std::size_t JsonItem::countAt(std::size_t index) const {
    if (index < size())
        if (const auto* number =
                (*value_)[index].get_ptr<const nlohmann::json::number_unsigned_t*>();
            number != nullptr && *number < std::size_t{1} << 53)
            return *number;
    return (*this)[index].count();  // or what is wrong with it
}

JsonList JsonItem::list(const char* name) const {
    return JsonList(find(name));
}

double JsonItem::number() const {
    if (!value_->is_number()) refuse("a number");
    const double value = value_->get<double>();
    if (!std::isfinite(value)) fail("a number that is not finite");
    return value;
}

std::size_t JsonItem::count() const {
    constexpr double kLargest = 9007199254740992.0;  // 2^53, beyond which doubles have gaps
    const double value = number();
    if (!(value >= 0.0 && value <= kLargest && value == std::floor(value)))
        fail(fmt::format("found {}; expected a whole number from 0 up", value));
    return static_cast<std::size_t>(value);
}

const std::string& JsonItem::text() const {
    if (!value_->is_string()) refuse("a string");
    return value_->get_ref<const std::string&>();
}

bool JsonItem::truth() const {
    if (!value_->is_boolean()) refuse("true or false");
    return value_->get<bool>();
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
    return item ? item->text() : std::string(absent);
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
