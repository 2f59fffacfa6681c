#include "tukor/image/texel_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <Imath/half.h>

#include "tukor/base/error.h"
#include "tukor/image/display.h"

namespace tukor {

namespace {

// DXGI_FORMAT, VkFormat and OpenGL's internal format, format, type and size of a component.
constexpr TexelLayout kLayouts[] = {
    {TexelCode::float32, 4, 16, false, 2, 109, 0x8814, 0x1908, 0x1406, 4},
    {TexelCode::float32, 3, 12, false, 6, 106, 0x8815, 0x1907, 0x1406, 4},
    {TexelCode::float16, 4, 8, false, 10, 97, 0x881a, 0x1908, 0x140b, 2},
    {TexelCode::float16, 3, 6, false, 0, 90, 0x881b, 0x1907, 0x140b, 2},
    {TexelCode::rgb9e5, 1, 4, false, 67, 123, 0x8c3d, 0x1907, 0x8c3e, 4},
    {TexelCode::r11g11b10, 1, 4, false, 26, 122, 0x8c3a, 0x1907, 0x8c3b, 4},
    {TexelCode::srgb8, 4, 4, false, 29, 43, 0x8c43, 0x1908, 0x1401, 1},
    {TexelCode::unorm8, 4, 4, false, 28, 37, 0x8058, 0x1908, 0x1401, 1},
    {TexelCode::srgb8, 3, 3, false, 0, 29, 0x8c41, 0x1907, 0x1401, 1},
    {TexelCode::unorm8, 3, 3, false, 0, 23, 0x8051, 0x1907, 0x1401, 1},
    {TexelCode::srgb8, 4, 4, true, 91, 50, 0, 0, 0, 0},
    {TexelCode::unorm8, 4, 4, true, 87, 44, 0, 0, 0, 0},
    {TexelCode::srgb8, 4, 4, true, 93, 0, 0, 0, 0, 0},  // B8G8R8X8
    {TexelCode::unorm8, 4, 4, true, 88, 0, 0, 0, 0, 0},
    {TexelCode::bc6h, 1, 16, false, 95, 143, 0x8e8f, 0, 0, 1, 4},
    {TexelCode::bc6h, 1, 16, false, 94, 0, 0, 0, 0, 0, 4},  // typeless
    {TexelCode::signedBc6h, 1, 16, false, 96, 144, 0x8e8e, 0, 0, 1, 4},
};

template <class T>
T read(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

template <class T>
void append(std::vector<std::byte>& out, T value) {
    const std::size_t at = out.size();
    out.resize(at + sizeof value);
    std::memcpy(out.data() + at, &value, sizeof value);
}

/// An unsigned float with five bits of exponent, as half has, and fewer of mantissa.
float unpackSmallFloat(std::uint32_t code, int mantissaBits) {
    const std::uint32_t mantissa = code & ((1u << mantissaBits) - 1u);
    const auto exponent = static_cast<int>(code >> mantissaBits);
    const auto scaled = static_cast<float>(mantissa);
    if (exponent == 0) return std::ldexp(scaled, -14 - mantissaBits);
    if (exponent == 31) return mantissa == 0 ? INFINITY : NAN;
    return std::ldexp(scaled + static_cast<float>(1u << mantissaBits),
                      exponent - 15 - mantissaBits);
}

std::uint32_t packSmallFloat(float value, int mantissaBits) {
    const float most = std::ldexp(2.0f - std::ldexp(1.0f, -mantissaBits), 15);
    if (!(value > 0.0f)) return 0;
    value = std::min(value, most);
    if (value < std::ldexp(1.0f, -14))
        return static_cast<std::uint32_t>(std::lround(std::ldexp(value, 14 + mantissaBits)));
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    const int shift = 23 - mantissaBits;
    return ((bits + (1u << (shift - 1))) >> shift) - ((127u - 15u) << mantissaBits);
}

/// Three mantissas of nine bits below one exponent. [OpenGL ES 3.0, sec. 3.8.3.2]
glm::vec3 unpackRgb9e5(std::uint32_t code) {
    const float scale = std::ldexp(1.0f, static_cast<int>(code >> 27) - 15 - 9);
    return scale * glm::vec3(static_cast<float>(code & 511u), static_cast<float>(code >> 9 & 511u),
                             static_cast<float>(code >> 18 & 511u));
}

std::uint32_t packRgb9e5(glm::vec3 value) {
    for (int c = 0; c < 3; ++c) value[c] = value[c] > 0.0f ? std::min(value[c], 65408.0f) : 0.0f;
    const float most = std::max({value.x, value.y, value.z});
    int exponent = 0;  // most = fraction * 2^exponent, fraction in [0.5, 1)
    (void)std::frexp(most, &exponent);
    exponent = std::max(exponent, -15);
    if (most == 0.0f) exponent = -15;
    if (std::lround(std::ldexp(most, 9 - exponent)) == 512) ++exponent;
    const auto mantissa = [&](float v) {
        return static_cast<std::uint32_t>(std::lround(std::ldexp(v, 9 - exponent)));
    };
    return mantissa(value.x) | mantissa(value.y) << 9 | mantissa(value.z) << 18 |
           static_cast<std::uint32_t>(exponent + 15) << 27;
}

half halfOf(float value) {
    return value > HALF_MAX ? half(HALF_MAX) : value < -HALF_MAX ? half(-HALF_MAX) : half(value);
}

glm::vec3 unpack(const TexelLayout& layout, const std::byte* from) {
    switch (layout.code) {
        case TexelCode::float32:
            return {read<float>(from), read<float>(from + 4), read<float>(from + 8)};
        case TexelCode::float16:
            return {read<half>(from), read<half>(from + 2), read<half>(from + 4)};
        case TexelCode::rgb9e5:
            return unpackRgb9e5(read<std::uint32_t>(from));
        case TexelCode::r11g11b10: {
            const auto code = read<std::uint32_t>(from);
            return {unpackSmallFloat(code & 2047u, 6), unpackSmallFloat(code >> 11 & 2047u, 6),
                    unpackSmallFloat(code >> 22, 5)};
        }
        case TexelCode::unorm8:
        case TexelCode::srgb8:
        case TexelCode::bc6h:
        case TexelCode::signedBc6h:
            break;
    }
    glm::vec3 value;
    for (int c = 0; c < 3; ++c) {
        const auto code = static_cast<std::size_t>(from[layout.blueFirst ? 2 - c : c]);
        value[c] = layout.code == TexelCode::srgb8 ? linearFromSrgb8()[code]
                                                   : static_cast<float>(code) / 255.0f;
    }
    return value;
}

}  // namespace

std::span<const TexelLayout> texelLayouts() noexcept {
    return kLayouts;
}

const TexelLayout& layoutOf(TexelFormat format) noexcept {
    switch (format) {
        case TexelFormat::rgba32f:
            return kLayouts[0];
        case TexelFormat::rgba16f:
            return kLayouts[2];
        case TexelFormat::rgb9e5:
            return kLayouts[4];
        case TexelFormat::r11g11b10f:
            return kLayouts[5];
        case TexelFormat::rgba8:
            return kLayouts[6];
        case TexelFormat::bc6h:
            return kLayouts[14];
    }
    return kLayouts[0];
}

void unpackTexels(const TexelLayout& layout, const std::byte* from, std::span<glm::vec3> out) {
    TUKOR_ASSERT(layout.blockSize == 1);
    for (glm::vec3& value : out) {
        value = unpack(layout, from);
        from += layout.bytes;
    }
}

void packTexels(const TexelLayout& layout, std::span<const glm::vec3> from,
                std::vector<std::byte>& out) {
    TUKOR_ASSERT(layout.blockSize == 1);
    for (const glm::vec3& value : from) {
        switch (layout.code) {
            case TexelCode::float32:
                for (int c = 0; c < 3; ++c) append(out, value[c]);
                append(out, 1.0f);
                break;
            case TexelCode::float16:
                for (int c = 0; c < 3; ++c) append(out, halfOf(value[c]).bits());
                append(out, half(1.0f).bits());
                break;
            case TexelCode::rgb9e5:
                append(out, packRgb9e5(value));
                break;
            case TexelCode::r11g11b10:
                append(out, packSmallFloat(value.x, 6) | packSmallFloat(value.y, 6) << 11 |
                                packSmallFloat(value.z, 5) << 22);
                break;
            case TexelCode::unorm8:
            case TexelCode::srgb8:
                for (int c = 0; c < 3; ++c) append(out, srgb8(value[c]));
                append(out, std::uint8_t{255});
                break;
            case TexelCode::bc6h:
            case TexelCode::signedBc6h:
                break;
        }
    }
}

}  // namespace tukor
