// Streams of zlib, as pictures hold them, written by libdeflate.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tukor {

/// Quick rather than small: what is left of a picture by then hardly shrinks any more. Throws Error
/// when the memory fails.
[[nodiscard]] std::vector<std::byte> zlibStream(std::span<const std::uint8_t> data);

}  // namespace tukor
