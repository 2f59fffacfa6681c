// Little-endian numbers out of bytes that may end early.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "tukor/base/error.h"

namespace tukor {

/// Reads from the front; throws Error when there is no more.
class ByteReader {
public:
    ByteReader(std::span<const std::byte> bytes, std::string_view name)
        : bytes_(bytes), name_(name) {}

    [[nodiscard]] std::uint32_t u32() { return number<std::uint32_t>(); }
    [[nodiscard]] std::uint64_t u64() { return number<std::uint64_t>(); }
    void skip(std::size_t count) { (void)take(count); }

    /// The next `count` bytes.
    [[nodiscard]] std::span<const std::byte> take(std::uint64_t count) {
        const auto piece = slice(at_, count);
        at_ += count;
        return piece;
    }

    /// `count` bytes from `offset`, wherever reading is.
    [[nodiscard]] std::span<const std::byte> slice(std::uint64_t offset,
                                                   std::uint64_t count) const {
        if (offset > bytes_.size() || count > bytes_.size() - offset)
            throw Error(std::string(name_) + ": cut off: the file ends after " +
                        std::to_string(bytes_.size()) + " bytes");
        return bytes_.subspan(offset, count);
    }

    [[nodiscard]] std::uint64_t position() const noexcept { return at_; }

private:
    template <class T>
    T number() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }

    std::span<const std::byte> bytes_;
    std::string_view name_;
    std::uint64_t at_ = 0;
};

}  // namespace tukor
