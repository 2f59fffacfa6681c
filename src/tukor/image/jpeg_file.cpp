#include "tukor/image/jpeg_file.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <turbojpeg.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/image/display.h"
#include "tukor/image/image_size.h"

namespace tukor {

namespace {

// One bit for a block of 64 grey pixels is the least, but for arithmetic coding.
constexpr std::uint64_t kMostPixelsPerByte = 1024;
// A comment's length is two bytes, which count themselves.
constexpr std::size_t kLongestComment = 65533;

struct Destroy {
    void operator()(void* codec) const noexcept { tjDestroy(codec); }
};
using Codec = std::unique_ptr<void, Destroy>;

struct FreeBuffer {
    void operator()(unsigned char* buffer) const noexcept { tjFree(buffer); }
};

/// The end marker may be followed by anything, but it must be there.
bool hasEnd(std::span<const std::byte> bytes) {
    for (std::size_t i = bytes.size(); i-- > 1;)
        if (bytes[i] == std::byte{0xd9} && bytes[i - 1] == std::byte{0xff}) return true;
    return false;
}

/// Without what other programs append: pixels take 16 bytes at the very most, and 64 MB are left
/// for profiles and thumbnails.
std::span<const std::byte> withoutTail(std::span<const std::byte> bytes, std::uint64_t pixels) {
    return bytes.first(std::min<std::uint64_t>(bytes.size(), (64ull << 20) + 16 * pixels));
}

}  // namespace

bool isJpeg(std::span<const std::byte> bytes) noexcept {
    return bytes.size() >= 3 && bytes[0] == std::byte{0xff} && bytes[1] == std::byte{0xd8} &&
           bytes[2] == std::byte{0xff};
}

EncodedPixels decodeJpegPixels(std::span<const std::byte> bytes, std::string_view name) {
    const Codec codec(tjInitDecompress());
    if (!codec) throw Error(fmt::format("{}: out of memory", name));
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const auto fail = [&] {
        throw Error(fmt::format("{}: damaged JPEG file: {}", name, tjGetErrorStr2(codec.get())));
    };
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colours = 0;
    if (tjDecompressHeader3(codec.get(), data, bytes.size(), &width, &height, &subsampling,
                            &colours) != 0)
        fail();
    if (colours == TJCS_CMYK || colours == TJCS_YCCK)
        throw Error(fmt::format("{}: CMYK JPEG; expected grey or RGB: convert it to RGB", name));
    if (width < 1 || height < 1)
        throw Error(fmt::format("{}: damaged JPEG file: no image in it", name));
    const auto columns = static_cast<std::uint64_t>(width);
    const auto rows = static_cast<std::uint64_t>(height);
    checkImageSize(name, columns, rows);
    checkImageFits(name, columns, rows, bytes.size(), kMostPixelsPerByte);
    if (!hasEnd(withoutTail(bytes, columns * rows)))
        throw Error(
            fmt::format("{}: cut off: the JPEG file ends after {} bytes, without its end "
                        "marker",
                        name, bytes.size()));
    EncodedPixels pixels;
    pixels.width = width;
    pixels.height = height;
    pixels.bytes.resize(3 * columns * rows);
    // More scans than any camera writes take for ever; a warning means that pixels are made up.
    if (tjDecompress2(codec.get(), data, bytes.size(), pixels.bytes.data(), width, 0, height,
                      TJPF_RGB, TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS | TJFLAG_STOPONWARNING) != 0)
        fail();
    return pixels;
}

Image decodeJpeg(std::span<const std::byte> bytes, std::string_view name) {
    const EncodedPixels pixels = decodeJpegPixels(bytes, name);
    const std::vector<std::uint8_t>& samples = pixels.bytes;
    Image image(pixels.width, pixels.height);
    const auto& linear = linearFromSrgb8();
    const auto columns = static_cast<std::size_t>(pixels.width);
    parallelFor(0, pixels.height, 64, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin) * columns;
             i < static_cast<std::size_t>(end) * columns; ++i)
            image.pixels()[i] = glm::vec3(linear[samples[3 * i]], linear[samples[3 * i + 1]],
                                          linear[samples[3 * i + 2]]);
    });
    return image;
}

std::vector<std::byte> encodeJpeg(const EncodedPixels& pixels, int quality,
                                  std::span<const std::pair<std::string, std::string>> metadata) {
    TUKOR_ASSERT(pixels.channels == 3 && pixels.bytesPerChannel == 1);
    const Codec codec(tjInitCompress());
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    const int result =
        codec ? tjCompress2(codec.get(), pixels.bytes.data(), pixels.width, 0, pixels.height,
                            TJPF_RGB, &memory, &size, quality >= 90 ? TJSAMP_444 : TJSAMP_420,
                            quality, TJFLAG_ACCURATEDCT)
              : -1;
    const std::unique_ptr<unsigned char, FreeBuffer> owner(memory);
    if (result != 0)
        throw Error(fmt::format("{} x {} pixels cannot be written as JPEG: {}", pixels.width,
                                pixels.height, codec ? tjGetErrorStr2(codec.get()) : "no memory"));
    const auto coded = std::as_bytes(std::span(memory, size));
    std::vector<std::byte> out(coded.begin(), coded.begin() + 2);  // the start marker
    for (const auto& [key, value] : metadata) {
        const std::string text = fmt::format("{}: {}", key, value).substr(0, kLongestComment);
        const std::size_t length = text.size() + 2;
        for (std::size_t byte : {std::size_t{0xff}, std::size_t{0xfe}, length >> 8, length & 255})
            out.push_back(static_cast<std::byte>(byte));
        const auto letters = std::as_bytes(std::span(text));
        out.insert(out.end(), letters.begin(), letters.end());
    }
    out.insert(out.end(), coded.begin() + 2, coded.end());
    return out;
}

}  // namespace tukor
