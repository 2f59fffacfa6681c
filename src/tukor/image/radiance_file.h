// Radiance pictures (.hdr, .pic): RGBE or XYZE pixels, flat or run-length coded, in any axis order.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tukor/image/image.h"

namespace tukor {

/// True when the bytes start as Radiance pictures do.
[[nodiscard]] bool isRadiance(std::span<const std::byte> bytes) noexcept;

/// Radiance as the header's EXPOSURE and COLORCORR lines leave it: pixel values divided by them.
///
/// A mantissa m stands for m / 256, without Radiance's own half step, so that a picture of ones is
/// exactly ones; this is also what OpenImageIO, Blender and three.js read. XYZE becomes linear
/// Rec. 709 on the same scale. `name` is for messages. Throws Error.
[[nodiscard]] Image decodeRadiance(std::span<const std::byte> bytes, std::string_view name);

/// Run-length coded RGBE, top row first. `metadata` becomes header lines. Negative and non-finite
/// values become 0, those too large for the format its maximum.
[[nodiscard]] std::vector<std::byte> encodeRadiance(
    const Image& image, std::span<const std::pair<std::string, std::string>> metadata);

}  // namespace tukor
