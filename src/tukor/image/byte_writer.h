// Little-endian numbers, text and bytes, one after the other.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tukor {

class ByteWriter {
public:
    void u32(std::uint32_t value);
    void u64(std::uint64_t value);
    void bytes(std::span<const std::byte> data);
    void text(std::string_view characters);
    /// Zeros up to the next multiple of `step`.
    void align(std::size_t step);

    [[nodiscard]] std::size_t size() const noexcept { return out_.size(); }
    [[nodiscard]] std::vector<std::byte>& data() noexcept { return out_; }

private:
    std::vector<std::byte> out_;
};

}  // namespace tukor
