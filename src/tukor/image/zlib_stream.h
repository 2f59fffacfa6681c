// Streams of zlib, as pictures hold them, written and read by libdeflate.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tukor {

/// Quick rather than small: what is left of a picture by then hardly shrinks any more. Throws Error
/// when the memory fails.
[[nodiscard]] std::vector<std::byte> zlibStream(std::span<const std::uint8_t> data);

/// Fills `out` with what the stream holds; false where that is not exactly as much, or damaged.
[[nodiscard]] bool readZlibStream(std::span<const std::byte> stream, std::span<std::uint8_t> out);

}  // namespace tukor
