// JSON values that know where they stand, so that every wrong type has a message that says where.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/scene/json_document.h"

namespace tukor {

class JsonList;

/// A value and the path to it, such as `a.gltf: meshes[2].primitives[0]`. Refers to the document
/// and its name.
///
/// Every member function throws Error when the value is not of the type asked for.
class JsonItem {
public:
    /// The root of a document.
    JsonItem(const JsonDocument& json, const std::string& document)
        : json_(&json), document_(&document) {}

    [[nodiscard]] std::string where() const;

    /// A member of an object; none where it is absent.
    [[nodiscard]] std::optional<JsonItem> find(const char* name) const;
    /// A member that must be there.
    [[nodiscard]] JsonItem at(const char* name) const;
    [[nodiscard]] std::vector<std::string> memberNames() const;

    /// Of an array.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] JsonItem operator[](std::size_t index) const;
    /// (*this)[index].count(), of millions.
    [[nodiscard]] std::size_t countAt(std::size_t index) const;
    /// The elements of an array member; none where it is absent.
    [[nodiscard]] JsonList list(const char* name) const;

    [[nodiscard]] double number() const;      // finite
    [[nodiscard]] std::size_t count() const;  // a whole number from 0 to 2^53
    [[nodiscard]] std::string_view text() const;
    [[nodiscard]] bool truth() const;

    /// Members with a default for absence.
    [[nodiscard]] double numberOr(const char* name, double absent) const;
    [[nodiscard]] std::size_t countOr(const char* name, std::size_t absent) const;
    [[nodiscard]] std::string textOr(const char* name, std::string_view absent) const;
    [[nodiscard]] bool truthOr(const char* name, bool absent) const;

    /// An array of exactly N numbers.
    template <std::size_t N>
    [[nodiscard]] std::optional<std::array<double, N>> numbers(const char* name) const {
        std::array<double, N> values;
        if (!numbersInto(name, values)) return std::nullopt;
        return values;
    }

    /// `where: found TYPE; expected THING`, as an Error.
    [[noreturn]] void refuse(std::string_view expected) const;
    /// `where: message`, as an Error.
    [[noreturn]] void fail(std::string_view message) const;

private:
    bool numbersInto(const char* name, std::span<double> values) const;
    void require(JsonKind kind, std::string_view expected) const;
    [[nodiscard]] JsonItem child(std::size_t value, const char* name,
                                 std::size_t index) const noexcept;

    struct Step {
        const char* name = nullptr;  // of a member; null: an element
        std::size_t index = 0;
    };
    static constexpr std::size_t kSteps = 10;  // deeper ones are not told

    // Paths are put into words only for messages: a file can have millions of items.
    const JsonDocument* json_;
    const std::string* document_;
    std::size_t value_ = 0;
    std::array<Step, kSteps> path_{};
    std::size_t depth_ = 0;
};

/// The elements of an array, made one by one as they are walked over.
class JsonList {
public:
    explicit JsonList(const std::optional<JsonItem>& array)
        : array_(array), size_(array_ ? array_->size() : 0) {}

    class Iterator {
    public:
        Iterator(const JsonList* list, std::size_t index) : list_(list), index_(index) {}
        JsonItem operator*() const { return (*list_)[index_]; }
        Iterator& operator++() {
            ++index_;
            return *this;
        }
        bool operator==(const Iterator& other) const { return index_ == other.index_; }

    private:
        const JsonList* list_;
        std::size_t index_;
    };

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] JsonItem operator[](std::size_t index) const { return (*array_)[index]; }
    [[nodiscard]] std::size_t countAt(std::size_t index) const { return array_->countAt(index); }
    [[nodiscard]] Iterator begin() const { return {this, 0}; }
    [[nodiscard]] Iterator end() const { return {this, size_}; }

private:
    std::optional<JsonItem> array_;
    std::size_t size_;
};

}  // namespace tukor
