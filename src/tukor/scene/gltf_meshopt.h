// Buffer views compressed by EXT_meshopt_compression.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "tukor/scene/json_item.h"

namespace tukor {

/// The bytes that a view stands for. `extension` is its EXT_meshopt_compression, `compressed` the
/// bytes of the buffer that it names.
///
/// Throws Error where they do not decode to the count and stride that it says. These are bounded by
/// the size of `compressed` before anything is allocated: no stream expands more than 64 times.
[[nodiscard]] std::vector<std::byte> meshoptDecoded(const JsonItem& extension,
                                                    std::span<const std::byte> compressed);

}  // namespace tukor
