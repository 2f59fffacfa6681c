// Pictures as textures keep them: 8-bit samples, whose meaning is their user's business.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tukor {

/// Rows from the top, `channels` (3 or 4) samples a texel. A quarter of what an Image takes.
struct Texels {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<std::uint8_t> bytes;
};

struct TexelsSize {
    std::uint32_t width;
    std::uint32_t height;
};

/// What decodeTexels would give, by the file's first bytes. Throws Error.
[[nodiscard]] TexelsSize sizeOfTexels(std::span<const std::byte> bytes, std::string_view name);

/// A PNG or JPEG; colour profiles and gamma are not applied, alpha multiplies nothing. At most
/// 16384 x 16384. Throws Error.
[[nodiscard]] Texels decodeTexels(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tukor
