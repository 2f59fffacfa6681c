#include <algorithm>
#include <cstring>

#include <Imath/half.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/image/bc6h.h"

namespace tukor {

namespace {

/// Index of a mode by the lowest five bits of a block, of which it may use two; -1 where reserved.
constexpr std::array<int, 32> kModeOf = [] {
    std::array<int, 32> modes{};
    for (std::uint32_t low = 0; low < 32; ++low) {
        modes[low] = -1;
        for (std::size_t i = 0; i < kBc6hModes.size(); ++i)
            if ((low & ((1u << kBc6hModes[i].modeBits) - 1u)) == kBc6hModes[i].number)
                modes[low] = static_cast<int>(i);
    }
    return modes;
}();

/// The 128 bits of a block, lowest first.
class BitReader {
public:
    explicit BitReader(std::span<const std::byte, kBc6hBytes> block) noexcept {
        std::memcpy(words_, block.data(), sizeof words_);
    }

    std::uint32_t take(int count) noexcept {
        const std::uint64_t word =
            words_[at_ / 64] >> (at_ % 64) | (at_ > 0 && at_ < 64 ? words_[1] << (64 - at_) : 0);
        at_ += count;
        return static_cast<std::uint32_t>(word) & ((1u << count) - 1u);
    }

private:
    std::uint64_t words_[2];
    int at_ = 0;
};

int signExtended(int value, int bits) noexcept {
    return (value & 1 << (bits - 1)) != 0 ? value - (1 << bits) : value;
}

int unquantized(int value, int bits, Bc6hSign sign) noexcept {
    if (sign == Bc6hSign::none) return unquantizedBc6h(value, bits);
    if (bits >= 16) return value;
    const int size = std::abs(value);
    const int most = (1 << (bits - 1)) - 1;
    const int out = size == 0 ? 0 : size >= most ? 0x7fff : ((size << 15) + 0x4000) >> (bits - 1);
    return value < 0 ? -out : out;
}

/// The bits of a half from an interpolated value of 16 bits.
std::uint16_t halfBits(int value, Bc6hSign sign) noexcept {
    if (sign == Bc6hSign::none) return static_cast<std::uint16_t>(value * 31 >> 6);
    return static_cast<std::uint16_t>(value < 0 ? 0x8000 | -value * 31 >> 5 : value * 31 >> 5);
}

float floatFromHalf(std::uint16_t bits) noexcept {
    half value;
    value.setBits(bits);
    return value;
}

}  // namespace

Bc6hTexels decodeBc6hBlock(std::span<const std::byte, kBc6hBytes> block, Bc6hSign sign) noexcept {
    Bc6hTexels texels{};
    const int index = kModeOf[std::to_integer<std::size_t>(block[0]) & 31];
    if (index < 0) return texels;
    const auto modeIndex = static_cast<std::size_t>(index);
    const Bc6hMode& mode = kBc6hModes[modeIndex];
    BitReader reader(block);
    (void)reader.take(mode.modeBits);

    int ends[4][3] = {};
    for (int i = 0; i < kBc6hBits[modeIndex].count; ++i) {
        const Bc6hBit bit = kBc6hBits[modeIndex].at[static_cast<std::size_t>(i)];
        ends[bit.endpoint][bit.channel] |= static_cast<int>(reader.take(1)) << bit.bit;
    }
    for (int c = 0; c < 3; ++c) {
        if (sign == Bc6hSign::one) ends[0][c] = signExtended(ends[0][c], mode.endpointBits);
        for (int e = 1; e < 2 * mode.subsets; ++e) {
            int& end = ends[e][c];
            const int bits = mode.deltaBits[static_cast<std::size_t>(c)];
            if (sign == Bc6hSign::one || mode.transformed) end = signExtended(end, bits);
            if (!mode.transformed) continue;
            end = (end + ends[0][c]) & ((1 << mode.endpointBits) - 1);
            if (sign == Bc6hSign::one) end = signExtended(end, mode.endpointBits);
        }
        for (int e = 0; e < 2 * mode.subsets; ++e)
            ends[e][c] = unquantized(ends[e][c], mode.endpointBits, sign);
    }

    Bc6hPartition partition{0, 0};
    if (mode.subsets == 2) partition = kBc6hPartitions[reader.take(5)];
    const int indexBits = mode.subsets == 2 ? 3 : 4;
    for (int i = 0; i < 16; ++i) {
        const bool anchor = i == 0 || (mode.subsets == 2 && i == partition.anchor);
        const std::size_t step = reader.take(anchor ? indexBits - 1 : indexBits);
        const int weight = mode.subsets == 2 ? kBc6hWeights3[step] : kBc6hWeights4[step];
        const int first = (partition.second >> i & 1) * 2;
        for (int c = 0; c < 3; ++c) {
            const int value =
                (ends[first][c] * (64 - weight) + ends[first + 1][c] * weight + 32) >> 6;
            texels[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)] =
                halfBits(value, sign);
        }
    }
    return texels;
}

std::size_t bc6hBlocks(int width, int height) noexcept {
    return static_cast<std::size_t>((width + 3) / 4) * static_cast<std::size_t>((height + 3) / 4);
}

void decodeBc6h(std::span<const std::byte> blocks, Bc6hSign sign, Image& image) {
    TUKOR_ASSERT(blocks.size() == bc6hBlocks(image.width(), image.height()) * kBc6hBytes);
    const int across = (image.width() + 3) / 4;
    parallelFor(0, (image.height() + 3) / 4, 16, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < across; ++x) {
                const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(across);
                const std::size_t at = (row + static_cast<std::size_t>(x)) * kBc6hBytes;
                const Bc6hTexels texels =
                    decodeBc6hBlock(blocks.subspan(at).first<kBc6hBytes>(), sign);
                for (std::size_t i = 0; i < 16; ++i) {
                    const int column = 4 * x + static_cast<int>(i % 4);
                    const int line = 4 * y + static_cast<int>(i / 4);
                    if (column < image.width() && line < image.height())
                        image.at(column, line) = {floatFromHalf(texels[i][0]),
                                                  floatFromHalf(texels[i][1]),
                                                  floatFromHalf(texels[i][2])};
                }
            }
    });
}

}  // namespace tukor
