// The texels of texture files: their names in each format, and their bits.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/image/texture_file.h"

namespace tukor {

enum class TexelCode { float32, float16, rgb9e5, r11g11b10, unorm8, srgb8, bc6h, signedBc6h };

/// One kind of texels. A code of 0: the format has none for it.
struct TexelLayout {
    TexelCode code;
    int channels;              // stored, 3 or 4; packed ones count as 1
    int bytes;                 // of a texel, or of a block
    bool blueFirst;            // B, G, R, (A)
    std::uint32_t dxgi;        // DDS
    std::uint32_t vulkan;      // KTX2
    std::uint32_t glInternal;  // KTX
    std::uint32_t glFormat;
    std::uint32_t glType;
    std::uint32_t glTypeSize;
    int blockSize = 1;  // texels along a block's edge
};

[[nodiscard]] std::span<const TexelLayout> texelLayouts() noexcept;
[[nodiscard]] const TexelLayout& layoutOf(TexelFormat format) noexcept;

/// Linear values of `out.size()` texels. `from` holds as many. Not for blocks: see texture_shape.h.
void unpackTexels(const TexelLayout& layout, const std::byte* from, std::span<glm::vec3> out);

/// Appends texels in one of the layouts that layoutOf returns. Not for blocks.
void packTexels(const TexelLayout& layout, std::span<const glm::vec3> from,
                std::vector<std::byte>& out);

}  // namespace tukor
