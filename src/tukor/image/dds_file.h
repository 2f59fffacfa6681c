// DirectDraw surfaces (.dds), with the DX10 header and without.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "tukor/base/progress.h"
#include "tukor/image/texture_file.h"

namespace tukor {

[[nodiscard]] bool isDds(std::span<const std::byte> bytes) noexcept;

/// 8-bit files without the DX10 header are taken for sRGB, as everybody writes them. Throws Error.
[[nodiscard]] TextureFile decodeDds(std::span<const std::byte> bytes, std::string_view name);

/// With the DX10 header. None where `progress` asked to stop.
[[nodiscard]] std::vector<std::byte> encodeDds(const TextureFile& texture, TexelFormat texels,
                                               const Progress& progress = {});

}  // namespace tukor
