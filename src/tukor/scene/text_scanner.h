// Words and numbers of line-based model files, read in place.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tukor {

/// Walks over text without copying it. Blanks are spaces, tabs, carriage returns, and line ends
/// after a backslash.
class TextScanner {
public:
    explicit TextScanner(std::span<const std::byte> bytes)
        : at_(reinterpret_cast<const char*>(bytes.data())), end_(at_ + bytes.size()) {}

    [[nodiscard]] bool atEnd() const noexcept { return at_ == end_; }
    [[nodiscard]] std::size_t line() const noexcept { return line_; }  // from 1

    /// Goes to the beginning of the next line.
    void skipLine() noexcept;
    /// The next word on this line; empty at its end.
    [[nodiscard]] std::string_view word() noexcept;
    /// The rest of the line without blanks around it.
    [[nodiscard]] std::string_view restOfLine() noexcept;
    /// Like word(), on whatever line it comes.
    [[nodiscard]] std::string_view wordOnAnyLine() noexcept;

private:
    void skipBlanks() noexcept;

    const char* at_;
    const char* end_;
    std::size_t line_ = 1;
};

/// The whole word as a number, to the last bit or the one before; none where it is not one. `nan`
/// and `inf` are numbers.
[[nodiscard]] std::optional<float> floatOf(std::string_view word) noexcept;

/// The whole word as an integer of at most 18 digits.
[[nodiscard]] std::optional<std::int64_t> integerOf(std::string_view word) noexcept;

}  // namespace tukor
