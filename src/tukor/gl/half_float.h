// 32-bit floats to 16-bit ones, as textures hold them.
#pragma once
#include <cstdint>
#include <cstring>

#include <glm/glm.hpp>

namespace tukor::gl {

inline constexpr float kLargestHalf = 65504.0f;

/// Nearest half, ties to even, of a finite value of either sign and at most kLargestHalf.
[[nodiscard]] inline std::uint16_t halfFromFloat(float value) noexcept {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    const std::uint32_t sign = (bits >> 16) & 0x8000u;
    bits &= 0x7fffffffu;
    // Below 2^-14 halves are denormal: adding 0.5 lets the float unit round at their last place.
    float small = 0.0f;
    std::memcpy(&small, &bits, sizeof(small));
    small += 0.5f;
    std::uint32_t denormal = 0;
    std::memcpy(&denormal, &small, sizeof(denormal));
    denormal -= 0x3f000000u;
    // Exponent bias from 127 to 15, rounding 23 bits of mantissa to 10.
    const std::uint32_t normal = (bits - 0x38000000u + 0xfffu + ((bits >> 13) & 1u)) >> 13;
    return static_cast<std::uint16_t>(sign | (bits < 0x38800000u ? denormal : normal));
}

/// R, G, B and 1 in memory order.
[[nodiscard]] inline std::uint64_t halvesFromColour(glm::vec3 colour) noexcept {
    return static_cast<std::uint64_t>(halfFromFloat(colour.x)) |
           static_cast<std::uint64_t>(halfFromFloat(colour.y)) << 16 |
           static_cast<std::uint64_t>(halfFromFloat(colour.z)) << 32 | 0x3c00ull << 48;
}

}  // namespace tukor::gl
