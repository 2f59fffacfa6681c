#include "tukor/image/byte_writer.h"

namespace tukor {

void ByteWriter::u32(std::uint32_t value) {
    bytes(std::as_bytes(std::span(&value, 1)));
}

void ByteWriter::u64(std::uint64_t value) {
    bytes(std::as_bytes(std::span(&value, 1)));
}

void ByteWriter::bytes(std::span<const std::byte> data) {
    out_.insert(out_.end(), data.begin(), data.end());
}

void ByteWriter::text(std::string_view characters) {
    bytes(std::as_bytes(std::span(characters)));
}

void ByteWriter::align(std::size_t step) {
    out_.resize((out_.size() + step - 1) / step * step);
}

}  // namespace tukor
