// Khronos textures: .ktx of version 1 and .ktx2 of version 2.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "tukor/base/progress.h"
#include "tukor/image/texture_file.h"

namespace tukor {

[[nodiscard]] bool isKtx1(std::span<const std::byte> bytes) noexcept;
[[nodiscard]] bool isKtx2(std::span<const std::byte> bytes) noexcept;

/// Pictures stored bottom row first, as KTXorientation may say, are turned over. Throws Error.
[[nodiscard]] TextureFile decodeKtx1(std::span<const std::byte> bytes, std::string_view name);
[[nodiscard]] TextureFile decodeKtx2(std::span<const std::byte> bytes, std::string_view name);

/// None where `progress` asked to stop.
[[nodiscard]] std::vector<std::byte> encodeKtx1(const TextureFile& texture, TexelFormat texels,
                                                const Progress& progress = {});
[[nodiscard]] std::vector<std::byte> encodeKtx2(const TextureFile& texture, TexelFormat texels,
                                                Supercompression supercompression,
                                                const Progress& progress = {});

}  // namespace tukor
