// The 14 modes of a BC6H block: its endpoints, their precision, and where their bits lie.
//
// [ARB_texture_compression_bptc, tables MF, F, P2 and A2]
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace tukor {

inline constexpr int kBc6hBytes = 16;  // of a block of 4 x 4 texels

/// One mode. Endpoints are counted 0 and 1 for the first subset of texels, 2 and 3 for the second.
struct Bc6hMode {
    std::uint32_t number;  // in the lowest modeBits
    int modeBits;
    int subsets;
    bool transformed;  // endpoints 1 to 3 are differences from endpoint 0
    int endpointBits;
    std::array<int, 3> deltaBits;  // of endpoints 1 to 3; red, green, blue
};

/// In the order of tables MF and F.
inline constexpr std::array<Bc6hMode, 14> kBc6hModes{{
    {0, 2, 2, true, 10, {5, 5, 5}},
    {1, 2, 2, true, 7, {6, 6, 6}},
    {2, 5, 2, true, 11, {5, 4, 4}},
    {6, 5, 2, true, 11, {4, 5, 4}},
    {10, 5, 2, true, 11, {4, 4, 5}},
    {14, 5, 2, true, 9, {5, 5, 5}},
    {18, 5, 2, true, 8, {6, 5, 5}},
    {22, 5, 2, true, 8, {5, 6, 5}},
    {26, 5, 2, true, 8, {5, 5, 6}},
    {30, 5, 2, false, 6, {6, 6, 6}},
    {3, 5, 1, false, 10, {10, 10, 10}},
    {7, 5, 1, true, 11, {9, 9, 9}},
    {11, 5, 1, true, 12, {8, 8, 8}},
    {15, 5, 1, true, 16, {4, 4, 4}},
}};

/// Where the bits above the mode go, lowest first: `g2[3:0]` are bits 0 to 3 of endpoint 2's green,
/// `r0[10:15]` bits 15 down to 10 of endpoint 0's red.
inline constexpr std::array<std::string_view, 14> kBc6hLayouts{{
    "g2[4],b2[4],b3[4],r0[9:0],g0[9:0],b0[9:0],r1[4:0],g3[4],g2[3:0],g1[4:0],b3[0],g3[3:0],"
    "b1[4:0],b3[1],b2[3:0],r2[4:0],b3[2],r3[4:0],b3[3]",
    "g2[5],g3[4],g3[5],r0[6:0],b3[0],b3[1],b2[4],g0[6:0],b2[5],b3[2],g2[4],b0[6:0],b3[3],b3[5],"
    "b3[4],r1[5:0],g2[3:0],g1[5:0],g3[3:0],b1[5:0],b2[3:0],r2[5:0],r3[5:0]",
    "r0[9:0],g0[9:0],b0[9:0],r1[4:0],r0[10],g2[3:0],g1[3:0],g0[10],b3[0],g3[3:0],b1[3:0],b0[10],"
    "b3[1],b2[3:0],r2[4:0],b3[2],r3[4:0],b3[3]",
    "r0[9:0],g0[9:0],b0[9:0],r1[3:0],r0[10],g3[4],g2[3:0],g1[4:0],g0[10],g3[3:0],b1[3:0],b0[10],"
    "b3[1],b2[3:0],r2[3:0],b3[0],b3[2],r3[3:0],g2[4],b3[3]",
    "r0[9:0],g0[9:0],b0[9:0],r1[3:0],r0[10],b2[4],g2[3:0],g1[3:0],g0[10],b3[0],g3[3:0],b1[4:0],"
    "b0[10],b2[3:0],r2[3:0],b3[1],b3[2],r3[3:0],b3[4],b3[3]",
    "r0[8:0],b2[4],g0[8:0],g2[4],b0[8:0],b3[4],r1[4:0],g3[4],g2[3:0],g1[4:0],b3[0],g3[3:0],"
    "b1[4:0],b3[1],b2[3:0],r2[4:0],b3[2],r3[4:0],b3[3]",
    "r0[7:0],g3[4],b2[4],g0[7:0],b3[2],g2[4],b0[7:0],b3[3],b3[4],r1[5:0],g2[3:0],g1[4:0],b3[0],"
    "g3[3:0],b1[4:0],b3[1],b2[3:0],r2[5:0],r3[5:0]",
    "r0[7:0],b3[0],b2[4],g0[7:0],g2[5],g2[4],b0[7:0],g3[5],b3[4],r1[4:0],g3[4],g2[3:0],g1[5:0],"
    "g3[3:0],b1[4:0],b3[1],b2[3:0],r2[4:0],b3[2],r3[4:0],b3[3]",
    "r0[7:0],b3[1],b2[4],g0[7:0],b2[5],g2[4],b0[7:0],b3[5],b3[4],r1[4:0],g3[4],g2[3:0],g1[4:0],"
    "b3[0],g3[3:0],b1[5:0],b2[3:0],r2[4:0],b3[2],r3[4:0],b3[3]",
    "r0[5:0],g3[4],b3[0],b3[1],b2[4],g0[5:0],g2[5],b2[5],b3[2],g2[4],b0[5:0],g3[5],b3[3],b3[5],"
    "b3[4],r1[5:0],g2[3:0],g1[5:0],g3[3:0],b1[5:0],b2[3:0],r2[5:0],r3[5:0]",
    "r0[9:0],g0[9:0],b0[9:0],r1[9:0],g1[9:0],b1[9:0]",
    "r0[9:0],g0[9:0],b0[9:0],r1[8:0],r0[10],g1[8:0],g0[10],b1[8:0],b0[10]",
    "r0[9:0],g0[9:0],b0[9:0],r1[7:0],r0[10:11],g1[7:0],g0[10:11],b1[7:0],b0[10:11]",
    "r0[9:0],g0[9:0],b0[9:0],r1[3:0],r0[10:15],g1[3:0],g0[10:15],b1[3:0],b0[10:15]",
}};

/// One bit of an endpoint.
struct Bc6hBit {
    std::uint8_t endpoint;
    std::uint8_t channel;
    std::uint8_t bit;
};

/// Where the bits above a mode's own go, in the block's order; the partition and indices follow.
struct Bc6hBits {
    std::array<Bc6hBit, 75> at{};
    int count = 0;
};

[[nodiscard]] constexpr Bc6hBits bc6hBits(std::string_view layout) {
    Bc6hBits bits;
    std::size_t at = 0;
    const auto number = [&] {
        int value = 0;
        while (layout[at] >= '0' && layout[at] <= '9') value = 10 * value + (layout[at++] - '0');
        return value;
    };
    while (at < layout.size()) {
        const char name = layout[at++];
        const int channel = name == 'r' ? 0 : name == 'g' ? 1 : 2;
        const int endpoint = number();
        ++at;  // [
        const int last = number();
        int first = last;
        if (layout[at] == ':') {
            ++at;
            first = number();
        }
        at += 2;  // ] and the comma
        // v[a:b] is lowest bit first where a >= b, and highest first otherwise.
        const int step = first <= last ? 1 : -1;
        for (int bit = first;; bit += step) {
            bits.at[static_cast<std::size_t>(bits.count++)] = {static_cast<std::uint8_t>(endpoint),
                                                               static_cast<std::uint8_t>(channel),
                                                               static_cast<std::uint8_t>(bit)};
            if (bit == last) break;
        }
    }
    return bits;
}

inline constexpr std::array<Bc6hBits, 14> kBc6hBits = [] {
    std::array<Bc6hBits, 14> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = bc6hBits(kBc6hLayouts[i]);
    return all;
}();

/// How a block of two subsets is parted: bit 4 row + column is set for texels of the second. Their
/// anchor is the texel whose index lacks its highest bit; the first subset's is texel 0.
struct Bc6hPartition {
    std::uint16_t second;
    std::uint8_t anchor;
};

inline constexpr std::array<Bc6hPartition, 32> kBc6hPartitions{{
    {0xcccc, 15}, {0x8888, 15}, {0xeeee, 15}, {0xecc8, 15}, {0xc880, 15}, {0xfeec, 15},
    {0xfec8, 15}, {0xec80, 15}, {0xc800, 15}, {0xffec, 15}, {0xfe80, 15}, {0xe800, 15},
    {0xffe8, 15}, {0xff00, 15}, {0xfff0, 15}, {0xf000, 15}, {0xf710, 15}, {0x008e, 2},
    {0x7100, 8},  {0x08ce, 2},  {0x008c, 2},  {0x7310, 8},  {0x3100, 8},  {0x8cce, 15},
    {0x088c, 2},  {0x3110, 8},  {0x6666, 2},  {0x366c, 2},  {0x17e8, 8},  {0x0ff0, 8},
    {0x718e, 2},  {0x399c, 2},
}};

/// Weights of a subset's second endpoint, in 64ths.
inline constexpr std::array<int, 8> kBc6hWeights3{0, 9, 18, 27, 37, 46, 55, 64};
inline constexpr std::array<int, 16> kBc6hWeights4{0,  4,  9,  13, 17, 21, 26, 30,
                                                   34, 38, 43, 47, 51, 55, 60, 64};

/// An endpoint of `bits` bits between 0 and 65535, of which a half is 31 / 64; unsigned.
[[nodiscard]] constexpr int unquantizedBc6h(int value, int bits) noexcept {
    if (bits >= 15 || value == 0) return value;
    if (value == (1 << bits) - 1) return 0xffff;
    return ((value << 15) + 0x4000) >> (bits - 1);
}

}  // namespace tukor
