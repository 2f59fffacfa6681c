// Levels of a KTX2 file as zstd compresses them.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace tukor {

/// Fills the beginning of `bytes` with what `frame` holds and returns how much that is. Throws
/// Error, also where it is more than there is room for.
[[nodiscard]] std::size_t expandZstd(std::span<const std::byte> frame, std::span<std::byte> bytes,
                                     std::string_view name);

}  // namespace tukor
