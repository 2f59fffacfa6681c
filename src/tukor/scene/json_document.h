// A JSON text as values in memory: small, in document order, and nothing but what JSON has.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tukor {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

/// Values refer to each other by index; 0 is the root. Texts and names end with a zero byte.
class JsonDocument {
public:
    JsonDocument() : values_(1) {}

    [[nodiscard]] JsonKind kind(std::size_t value) const noexcept { return values_[value].kind; }
    [[nodiscard]] bool truth(std::size_t value) const noexcept { return values_[value].size != 0; }
    [[nodiscard]] double number(std::size_t value) const noexcept { return values_[value].number; }
    [[nodiscard]] std::string_view text(std::size_t value) const noexcept {
        return {texts_.data() + values_[value].first, values_[value].size};
    }

    /// Of an array or an object; members are in the order of their names.
    [[nodiscard]] std::size_t size(std::size_t value) const noexcept { return values_[value].size; }
    [[nodiscard]] std::size_t child(std::size_t value, std::size_t index) const noexcept {
        return children_[values_[value].first + index];
    }
    /// The member of an object; of several of one name the last.
    [[nodiscard]] std::optional<std::size_t> find(std::size_t value,
                                                  const char* name) const noexcept;
    /// Of a member of an object.
    [[nodiscard]] const char* name(std::size_t value) const noexcept {
        return texts_.data() + values_[value].name;
    }

private:
    friend class JsonParser;

    struct Value {
        double number = 0.0;
        std::uint32_t first = 0;  // of its children, or of its text
        std::uint32_t size = 0;   // how many; true is one
        std::uint32_t name = 0;
        JsonKind kind = JsonKind::null;
    };
    std::vector<Value> values_;
    std::vector<std::uint32_t> children_;  // side by side for each array and object
    std::string texts_;
};

/// Parses a whole document. Throws Error, opened by `name`, where it is not JSON, nests deeper than
/// 64 levels, or holds more than two million values.
[[nodiscard]] JsonDocument parseJson(std::string_view name, std::span<const std::byte> text);

}  // namespace tukor
