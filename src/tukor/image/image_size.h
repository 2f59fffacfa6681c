// The size limits that every reader of images applies before it allocates.
#pragma once
#include <cstdint>
#include <string_view>

namespace tukor {

/// The most pixels an image may have: 16384 x 16384, 3 GB of radiance.
inline constexpr std::uint64_t kMaxPixels = 1ull << 28;

/// Images up to this size are read on trust, 4096 x 2048; a larger one must come in a file large
/// enough to hold it.
inline constexpr std::uint64_t kTrustedPixels = 1ull << 23;

/// Throws Error unless both sizes are at least 1 and the product is at most kMaxPixels.
void checkImageSize(std::string_view name, std::uint64_t width, std::uint64_t height);

/// Throws Error when an image above kTrustedPixels has more than `pixelsPerByte` pixels for each of
/// `fileBytes`.
void checkImageFits(std::string_view name, std::uint64_t width, std::uint64_t height,
                    std::uint64_t fileBytes, std::uint64_t pixelsPerByte);

}  // namespace tukor
