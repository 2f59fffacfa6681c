// BC6H, BPTC's form for radiance: 4 x 4 texels of three halves in 16 bytes.
//
// [ARB_texture_compression_bptc]
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tukor/base/progress.h"
#include "tukor/image/bc6h_modes.h"
#include "tukor/image/image.h"

namespace tukor {

enum class Bc6hSign { none, one };  // unsigned halves, signed halves

/// The bits of 16 texels' halves, row by row: red, green, blue.
using Bc6hTexels = std::array<std::array<std::uint16_t, 3>, 16>;

/// Every block decodes: reserved modes to zeros, and nothing to an infinity but a signed block that
/// asks for the negative one.
[[nodiscard]] Bc6hTexels decodeBc6hBlock(std::span<const std::byte, kBc6hBytes> block,
                                         Bc6hSign sign) noexcept;

/// The unsigned block nearest to finite halves without a sign: of the modes and partitions tried
/// the one of the least squared difference of the halves' bits, which is about that of logarithms.
///
/// A constant block comes back bit for bit.
[[nodiscard]] std::array<std::byte, kBc6hBytes> encodeBc6hBlock(const Bc6hTexels& texels) noexcept;

/// Blocks of an image, row by row: ceil(width / 4) * ceil(height / 4).
[[nodiscard]] std::size_t bc6hBlocks(int width, int height) noexcept;

/// Fills `image` from as many blocks as bc6hBlocks says. On all cores.
void decodeBc6h(std::span<const std::byte> blocks, Bc6hSign sign, Image& image);

/// Appends the blocks of an image, unsigned: what is negative or no number becomes 0, what is above
/// 65504 that. On all cores, and the same bytes whatever their number. False where `progress` asked
/// to stop: some of what was appended is none.
[[nodiscard]] bool encodeBc6h(const Image& image, std::vector<std::byte>& out,
                              const Progress& progress = {});

}  // namespace tukor
