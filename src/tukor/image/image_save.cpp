#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/base/parallel.h"
#include "tukor/image/image_file.h"
#include "tukor/image/jpeg_file.h"
#include "tukor/image/png_file.h"
#include "tukor/image/radiance_file.h"
#include "tukor/image/tonemap.h"

namespace tukor {

namespace {

float srgbEncoded(float linear) {
    return linear < 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// Colour over its own coverage, as PNG wants it: radiance carries the coverage as a factor.
glm::vec3 uncovered(glm::vec3 radiance, float alpha) {
    return alpha > 0.0f ? radiance / alpha : glm::vec3(0.0f);
}

std::uint32_t code(float value, float most) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * most));
}

std::vector<std::byte> exr(const Image& image, const SaveOptions& options,
                           const Progress& progress) {
    return encodeExr(image, options.exrPixels, options.metadata, progress);
}

std::vector<std::byte> hdr(const Image& image, const SaveOptions& options, const Progress&) {
    return encodeRadiance(image, options.metadata);
}

std::vector<std::byte> png(const Image& image, const SaveOptions& options, const Progress&) {
    const int channels = image.alpha.empty() ? 3 : 4;
    const int bytesPerChannel = options.pngDepth == PngDepth::bits16 ? 2 : 1;
    return encodePng(encodePixels(image, options, channels, bytesPerChannel), options.metadata);
}

std::vector<std::byte> jpeg(const Image& image, const SaveOptions& options, const Progress&) {
    return encodeJpeg(encodePixels(image, options, 3, 1), options.jpegQuality, options.metadata);
}

struct Format {
    std::string_view extension;
    std::vector<std::byte> (*encode)(const Image& image, const SaveOptions& options,
                                     const Progress& progress);
};

constexpr Format kFormats[] = {
    {".exr", exr}, {".hdr", hdr}, {".png", png}, {".jpg", jpeg}, {".jpeg", jpeg}};

const Format* findFormat(std::string_view extension) {
    for (const Format& format : kFormats)
        if (format.extension == extension) return &format;
    return nullptr;
}

std::string knownExtensions() {
    std::string list;
    for (const Format& format : kFormats)
        list += fmt::format("{}{}", list.empty() ? "" : " ", format.extension);
    return list;
}

}  // namespace

EncodedPixels encodePixels(const Image& image, const SaveOptions& options, int channels,
                           int bytesPerChannel) {
    TUKOR_ASSERT(channels == 3 || image.alpha.size() == image.pixels().size());
    EncodedPixels out{image.width(), image.height(), channels, bytesPerChannel, {}};
    const std::size_t step = static_cast<std::size_t>(channels * bytesPerChannel);
    out.bytes.resize(image.pixels().size() * step);
    const float exposure = tonemap::exposureFactor(options.exposureStops);
    const auto columns = static_cast<std::size_t>(image.width());
    parallelFor(0, image.height(), 32, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin) * columns;
             i < static_cast<std::size_t>(end) * columns; ++i) {
            glm::vec3 radiance = image.pixels()[i];
            if (channels == 4) radiance = uncovered(radiance, image.alpha[i]);
            const glm::vec3 colour = displayed(radiance, options.tonemap, exposure);
            std::uint8_t* to = out.bytes.data() + i * step;
            if (bytesPerChannel == 1) {
                for (int c = 0; c < 3; ++c) to[c] = srgb8(colour[c]);
                if (channels == 4) to[3] = static_cast<std::uint8_t>(code(image.alpha[i], 255.0f));
                continue;
            }
            for (int c = 0; c < channels; ++c) {
                const float value = c < 3 ? srgbEncoded(colour[c]) : image.alpha[i];
                const std::uint32_t wide = code(value, 65535.0f);
                to[2 * c] = static_cast<std::uint8_t>(wide >> 8);
                to[2 * c + 1] = static_cast<std::uint8_t>(wide & 255);
            }
        }
    });
    return out;
}

std::vector<std::byte> encodeImage(const Image& image, const std::string& extension,
                                   const SaveOptions& options, const Progress& progress) {
    TUKOR_ASSERT(!image.empty());
    const Format* format = findFormat(extension);
    if (!format)
        throw Error(fmt::format("no image format is called `{}`; known are {}", extension,
                                knownExtensions()));
    return format->encode(image, options, progress);
}

void checkSavable(const std::filesystem::path& path) {
    const std::string extension = lowerExtension(path);
    if (findFormat(extension)) return;
    throw Error(fmt::format("{}: {}; known are {}", path.string(),
                            extension.empty()
                                ? "no extension that says which image format to write"
                                : fmt::format("no image format is called `{}`", extension),
                            knownExtensions()));
}

void saveImage(const std::filesystem::path& path, const Image& image, const SaveOptions& options) {
    checkSavable(path);
    writeFile(path, encodeImage(image, lowerExtension(path), options));
}

void saveExrLayers(const std::filesystem::path& path, std::span<const ImageLayer> layers,
                   const SaveOptions& options) {
    if (lowerExtension(path) != ".exr")
        throw Error(fmt::format("{}: only .exr holds several layers", path.string()));
    writeFile(path, encodeExr(layers, options.exrPixels, options.metadata));
}

}  // namespace tukor
