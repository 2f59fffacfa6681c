// A first look at an OpenEXR file that allocates next to nothing: does it hold what it declares?
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace tukor {

/// `bytes` satisfy isExr. Throws Error when a part is larger than the limits of image_size.h, when
/// its pixels cannot be in a file of this size, or when the chunks of pixels are not all inside the
/// file.
void checkExr(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tukor
