#include "tukor/image/bc6h.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <Imath/half.h>
#include <gtest/gtest.h>

#include "tukor/base/parallel.h"

namespace tukor {
namespace {

constexpr std::uint16_t kMost = 0x7bff;  // 65504

Bc6hTexels thereAndBack(const Bc6hTexels& texels) {
    return decodeBc6hBlock(encodeBc6hBlock(texels), Bc6hSign::none);
}

Image thereAndBack(const Image& image) {
    std::vector<std::byte> blocks;
    EXPECT_TRUE(encodeBc6h(image, blocks));
    EXPECT_EQ(blocks.size(), bc6hBlocks(image.width(), image.height()) * kBc6hBytes);
    Image back(image.width(), image.height());
    decodeBc6h(blocks, Bc6hSign::none, back);
    return back;
}

float largestRelativeError(const Image& is, const Image& was) {
    float most = 0.0f;
    for (std::size_t i = 0; i < was.pixels().size(); ++i)
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(is.pixels()[i][c] / was.pixels()[i][c] - 1.0f));
    return most;
}

TEST(Bc6hModes, PlaceEveryBitOnce) {
    for (std::size_t i = 0; i < kBc6hModes.size(); ++i) {
        const Bc6hMode& mode = kBc6hModes[i];
        std::set<std::array<int, 3>> seen;
        for (int k = 0; k < kBc6hBits[i].count; ++k) {
            const Bc6hBit bit = kBc6hBits[i].at[static_cast<std::size_t>(k)];
            const int bits = bit.endpoint == 0 ? mode.endpointBits : mode.deltaBits[bit.channel];
            EXPECT_LT(bit.bit, bits);
            EXPECT_LT(bit.endpoint, 2 * mode.subsets);
            seen.insert({bit.endpoint, bit.channel, bit.bit});
        }
        EXPECT_EQ(static_cast<int>(seen.size()), kBc6hBits[i].count) << mode.number;
        const int indices = mode.subsets == 2 ? 16 * 3 - 2 + 5 : 16 * 4 - 1;
        EXPECT_EQ(mode.modeBits + kBc6hBits[i].count + indices, 128) << mode.number;
    }
}

TEST(Bc6h, ReservedModesAreBlack) {
    for (int low : {19, 23, 27, 31}) {
        std::array<std::byte, kBc6hBytes> block;
        block.fill(std::byte{0xff});
        block[0] = static_cast<std::byte>(0xe0 | low);
        for (const Bc6hSign sign : {Bc6hSign::none, Bc6hSign::one})
            EXPECT_EQ(decodeBc6hBlock(block, sign), Bc6hTexels{});
    }
}

TEST(Bc6h, AConstantBlockComesBackBitForBit) {
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        std::array<std::uint16_t, 3> texel;
        for (std::uint16_t& half : texel) half = static_cast<std::uint16_t>(random() % (kMost + 1));
        if (i == 0) texel = {0, 0, 0};
        if (i == 1) texel = {kMost, kMost, kMost};
        if (i == 2) texel = {kMost, 0, 1};
        Bc6hTexels texels;
        texels.fill(texel);
        ASSERT_EQ(thereAndBack(texels), texels) << texel[0] << " " << texel[1] << " " << texel[2];
    }
}

TEST(Bc6h, NothingBecomesInfinite) {
    std::mt19937 random(6);
    for (int i = 0; i < 20000; ++i) {
        Bc6hTexels texels;
        // Of anything, or of the largest only.
        const std::uint32_t span = i % 2 == 0 ? kMost + 1u : 300u;
        for (auto& texel : texels)
            for (std::uint16_t& half : texel)
                half = static_cast<std::uint16_t>(kMost - random() % span);
        for (const auto& texel : thereAndBack(texels))
            for (const std::uint16_t half : texel) ASSERT_LE(half, kMost);
    }
}

// A block spans six steps of 0.03 octaves, 184 of a half's bits. One subset has ends of 12 bits,
// off by up to 8 of 65536, which are 4 of a half's bits; 16 indices, off by up to 184 / 30 = 6, and
// by as much as channels' ends are off differently, 4; weights, rounded to 64ths, by 1; the decoder
// drops
// 1. Of 1024 to 2048 bits from one octave to the next 16 are 1 / 64.
TEST(Bc6h, GradientsComeBackWithinASixtyFourth) {
    Image image(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            image.at(x, y) =
                std::exp2(0.03f * static_cast<float>(x + y) + 0.005f) * glm::vec3(0.2f, 0.5f, 1.0f);
    EXPECT_LT(largestRelativeError(thereAndBack(image), image), 1.0f / 64.0f);
}

// The ends of one subset that spans everything have 10 bits: off by up to 32 of 65536 steps, which
// are 16 of a half's bits, and 1.6 %.
TEST(Bc6h, ALampBesideDarknessLeavesBothAsTheyAre) {
    for (int lamp = 1; lamp < 16; ++lamp)
        for (const float dark : {0.001f, 0.1f, 3.0f}) {
            Image image(4, 4);
            for (glm::vec3& pixel : image.pixels()) pixel = dark * glm::vec3(0.6f, 0.8f, 1.0f);
            for (int i = 0; i < lamp; ++i)
                image.pixels()[static_cast<std::size_t>(5 * i % 16)] = {60000, 50000, 40000};
            EXPECT_LT(largestRelativeError(thereAndBack(image), image), 0.02f) << lamp << dark;
        }
}

TEST(Bc6h, TwoColoursOfEveryPartitionComeBack) {
    for (const Bc6hPartition& partition : kBc6hPartitions) {
        Image image(4, 4);
        for (std::size_t i = 0; i < 16; ++i) {
            const float shade = 1.0f + 0.02f * static_cast<float>(i % 3);
            image.pixels()[i] = (partition.second >> i & 1) != 0
                                    ? shade * glm::vec3(1.0f, 0.75f, 0.5f)
                                    : glm::vec3(0.5f, 0.75f * shade, 1.0f);
        }
        // Two lines in space: no single one holds them. A difference of an octave needs modes of
        // 8 bits: ends off by 62 of a half's bits, 6 %.
        EXPECT_LT(largestRelativeError(thereAndBack(image), image), 0.06f) << partition.second;
    }
}

// Independent values in three channels lie along no line. What the bits can do was measured: 0.53
// of the deviation is left. A constant block would leave all of it.
TEST(Bc6h, NoiseLosesLessThanItsDeviation) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> noise(-512, 512);
    double error = 0.0, deviation = 0.0;
    for (int i = 0; i < 2000; ++i) {
        Bc6hTexels texels;
        for (auto& texel : texels)
            for (std::uint16_t& half : texel)
                half = static_cast<std::uint16_t>(0x3c00 + noise(random));
        const Bc6hTexels back = thereAndBack(texels);
        for (std::size_t k = 0; k < 16; ++k)
            for (std::size_t c = 0; c < 3; ++c) {
                error += std::pow(back[k][c] - texels[k][c], 2);
                deviation += std::pow(texels[k][c] - 0x3c00, 2);
            }
    }
    EXPECT_LT(std::sqrt(error / deviation), 0.6);
}

TEST(Bc6h, EveryModeIsUsed) {
    std::mt19937 random(8);
    std::set<int> modes;
    for (int i = 0; i < 40000; ++i) {
        const int spread = 1 << (2 + i % 12);
        std::uniform_int_distribution<int> noise(-spread, spread);
        const int favourite = i / 12 % 4;  // a channel that changes more
        Bc6hTexels texels;
        const std::uint16_t second = kBc6hPartitions[random() % 32].second;
        std::array<std::array<int, 3>, 2> colours;
        for (auto& colour : colours)
            for (std::size_t c = 0; c < 3; ++c)
                colour[c] = 0x3c00 + noise(random) / (static_cast<int>(c) == favourite ? 1 : 2);
        for (std::size_t k = 0; k < 16; ++k)
            for (std::size_t c = 0; c < 3; ++c)
                texels[k][c] = static_cast<std::uint16_t>(std::clamp(
                    colours[second >> k & 1][c] + noise(random) / 16, 0, static_cast<int>(kMost)));
        const int low = std::to_integer<int>(encodeBc6hBlock(texels)[0]) & 31;
        modes.insert((low & 3) < 2 ? low & 3 : low);
    }
    EXPECT_EQ(modes.size(), kBc6hModes.size());
}

TEST(Bc6h, ClipsToWhatTheFormatHolds) {
    const float inf = std::numeric_limits<float>::infinity();
    Image image(3, 1);
    image.at(0, 0) = {-1.0f, std::nanf(""), -inf};
    image.at(1, 0) = {0.0f, 1.0f, 65504.0f};
    image.at(2, 0) = {inf, 1e9f, 65519.0f};
    for (int i = 0; i < 3; ++i) {
        Image one(1, 1);
        one.at(0, 0) = image.at(i, 0);
        const glm::vec3 back = thereAndBack(one).at(0, 0);
        EXPECT_EQ(back, (std::array{glm::vec3(0), glm::vec3(0, 1, 65504),
                                    glm::vec3(65504)})[static_cast<std::size_t>(i)]);
    }
}

TEST(Bc6h, SizesThatAreNoMultipleOfFourKeepTheirEdges) {
    for (int width : {1, 2, 3, 5, 9})
        for (int height : {1, 2, 6, 7}) {
            Image image(width, height);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    image.at(x, y) = glm::vec3(1.0f + 0.02f * static_cast<float>(x),
                                               2.0f + 0.02f * static_cast<float>(y), 3.0f);
            EXPECT_LT(largestRelativeError(thereAndBack(image), image), 0.02f) << width << height;
        }
}

TEST(Bc6h, AnyNumberOfThreadsGivesTheSameBytes) {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> uniform(0.0f, 10.0f);
    Image image(200, 120);
    for (glm::vec3& pixel : image.pixels())
        pixel = {uniform(random), uniform(random), uniform(random)};
    std::vector<std::byte> one, all;
    setThreadCount(1);
    EXPECT_TRUE(encodeBc6h(image, one));
    setThreadCount(0);
    EXPECT_TRUE(encodeBc6h(image, all));
    EXPECT_EQ(one, all);
}

}  // namespace
}  // namespace tukor
