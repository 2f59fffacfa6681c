#include <cctype>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <spng.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/image/display.h"
#include "tukor/image/image_size.h"
#include "tukor/image/png_file.h"

namespace tukor {

namespace {

constexpr unsigned char kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

// Deflate expands 1032 times at most, and a byte holds eight one-bit pixels.
constexpr std::uint64_t kMostPixelsPerByte = 8 * 1032;
// Profiles and texts are held in memory, inflated.
constexpr std::size_t kLargestChunk = 16u << 20;

struct FreeContext {
    void operator()(spng_ctx* context) const noexcept { spng_ctx_free(context); }
};

/// Walks the chunks to the last one, so that a file cut off is refused before its pixels cost
/// memory.
void checkChunks(std::span<const std::byte> bytes, std::string_view name) {
    std::size_t at = sizeof kSignature;
    while (bytes.size() - at >= 12) {
        const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(bytes[at + i]); };
        const std::size_t length = byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
        for (std::size_t i = 4; i < 8; ++i)
            if (!std::isalpha(static_cast<int>(byte(i))))
                throw Error(fmt::format("{}: damaged PNG file: no chunk at byte {}", name, at));
        if (length > bytes.size() - at - 12) break;
        if (std::memcmp(bytes.data() + at + 4, "IEND", 4) == 0) return;
        at += length + 12;
    }
    throw Error(fmt::format("{}: cut off: the PNG file ends after {} bytes, without its end chunk",
                            name, bytes.size()));
}

/// The exponent that makes samples linear when the file gives one; none: sRGB.
std::optional<double> decodingGamma(spng_ctx* context) {
    std::uint8_t intent = 0;
    spng_iccp profile{};
    std::uint32_t gamma = 0;
    if (spng_get_srgb(context, &intent) == 0 || spng_get_iccp(context, &profile) == 0 ||
        spng_get_gama_int(context, &gamma) != 0)
        return std::nullopt;
    // 45455 is 1 / 2.2, which writers mean for sRGB; 0 means nothing.
    if (gamma == 0 || (gamma > 45000 && gamma < 46000)) return std::nullopt;
    return 100000.0 / gamma;
}

double linearFromEncoded(double c, std::optional<double> gamma) {
    if (gamma) return std::pow(c, *gamma);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

template <class Sample>
Image linearImage(const std::vector<Sample>& samples, int width, int height, int channels,
                  std::optional<double> gamma) {
    constexpr std::size_t kLevels = std::size_t{1} << (8 * sizeof(Sample));
    std::vector<float> linear(kLevels);
    for (std::size_t i = 0; i < kLevels; ++i)
        linear[i] = static_cast<float>(
            linearFromEncoded(static_cast<double>(i) / static_cast<double>(kLevels - 1), gamma));
    Image image(width, height);
    if (channels == 4) image.alpha.resize(image.pixels().size());
    parallelFor(0, height, 64, [&](int begin, int end) {
        const auto columns = static_cast<std::size_t>(width);
        for (auto i = static_cast<std::size_t>(begin) * columns;
             i < static_cast<std::size_t>(end) * columns; ++i) {
            const Sample* s = samples.data() + i * static_cast<std::size_t>(channels);
            glm::vec3 value(linear[s[0]], linear[s[1]], linear[s[2]]);
            if (channels == 4) {
                const float alpha = static_cast<float>(s[3]) / static_cast<float>(kLevels - 1);
                image.alpha[i] = alpha;
                value *= alpha;
            }
            image.pixels()[i] = value;
        }
    });
    return image;
}

/// A PNG whose sizes and chunks have been checked.
struct CheckedPng {
    std::unique_ptr<spng_ctx, FreeContext> context;
    spng_ihdr header{};
    bool alpha = false;
};

void require(int result, std::string_view name) {
    if (result != 0)
        throw Error(fmt::format("{}: damaged PNG file: {}", name, spng_strerror(result)));
}

CheckedPng checkedPng(std::span<const std::byte> bytes, std::string_view name) {
    CheckedPng png;
    png.context.reset(spng_ctx_new(0));
    if (!png.context) throw Error(fmt::format("{}: out of memory", name));
    require(spng_set_chunk_limits(png.context.get(), kLargestChunk, kLargestChunk), name);
    require(spng_set_png_buffer(png.context.get(), bytes.data(), bytes.size()), name);
    require(spng_get_ihdr(png.context.get(), &png.header), name);
    checkImageSize(name, png.header.width, png.header.height);
    checkImageFits(name, png.header.width, png.header.height, bytes.size(), kMostPixelsPerByte);
    checkChunks(bytes, name);
    spng_trns transparency{};
    png.alpha = png.header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
                png.header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA ||
                spng_get_trns(png.context.get(), &transparency) == 0;
    return png;
}

template <class Sample>
std::vector<Sample> samplesOf(const CheckedPng& png, int format, std::string_view name) {
    std::size_t size = 0;
    require(spng_decoded_image_size(png.context.get(), format, &size), name);
    std::vector<Sample> samples(size / sizeof(Sample));
    require(spng_decode_image(png.context.get(), samples.data(), size, format, SPNG_DECODE_TRNS),
            name);
    return samples;
}

}  // namespace

bool isPng(std::span<const std::byte> bytes) noexcept {
    return bytes.size() >= sizeof kSignature &&
           std::memcmp(bytes.data(), kSignature, sizeof kSignature) == 0;
}

Image decodePng(std::span<const std::byte> bytes, std::string_view name) {
    const CheckedPng png = checkedPng(bytes, name);
    const std::optional<double> gamma = decodingGamma(png.context.get());
    const int width = static_cast<int>(png.header.width);
    const int height = static_cast<int>(png.header.height);
    if (png.header.bit_depth == 16) {
        Image image = linearImage(samplesOf<std::uint16_t>(png, SPNG_FMT_RGBA16, name), width,
                                  height, 4, gamma);
        if (!png.alpha) image.alpha.clear();
        return image;
    }
    const int format = png.alpha ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8;
    return linearImage(samplesOf<std::uint8_t>(png, format, name), width, height, png.alpha ? 4 : 3,
                       gamma);
}

EncodedPixels decodePngPixels(std::span<const std::byte> bytes, std::string_view name) {
    const CheckedPng png = checkedPng(bytes, name);
    EncodedPixels pixels;
    pixels.width = static_cast<int>(png.header.width);
    pixels.height = static_cast<int>(png.header.height);
    // Of 16-bit files spng gives the four channels alone.
    pixels.channels = png.alpha || png.header.bit_depth == 16 ? 4 : 3;
    pixels.bytes =
        samplesOf<std::uint8_t>(png, pixels.channels == 4 ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8, name);
    return pixels;
}

}  // namespace tukor
