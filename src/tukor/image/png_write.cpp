#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <libdeflate.h>

#include "tukor/base/error.h"
#include "tukor/image/png_file.h"
#include "tukor/image/zlib_stream.h"

namespace tukor {

namespace {

void appendNumber(std::vector<std::byte>& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<std::byte>(value >> shift));
}

void appendChunk(std::vector<std::byte>& out, const char* type, std::span<const std::byte> data) {
    appendNumber(out, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = out.size();
    const auto name = std::as_bytes(std::span(type, 4));
    out.insert(out.end(), name.begin(), name.end());
    out.insert(out.end(), data.begin(), data.end());
    appendNumber(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

/// Each row as its difference from the pixel to the left or from the row above, whichever is
/// smaller in sum, behind a byte that says which.
std::vector<std::uint8_t> filtered(const EncodedPixels& pixels) {
    const auto step = static_cast<std::size_t>(pixels.channels * pixels.bytesPerChannel);
    const std::size_t stride = step * static_cast<std::size_t>(pixels.width);
    std::vector<std::uint8_t> out((stride + 1) * static_cast<std::size_t>(pixels.height));
    std::vector<std::uint8_t> left(stride);
    std::vector<std::uint8_t> up(stride);
    const std::vector<std::uint8_t> black(stride);
    for (int row = 0; row < pixels.height; ++row) {
        const std::uint8_t* now = pixels.bytes.data() + stride * static_cast<std::size_t>(row);
        const std::uint8_t* above = row == 0 ? black.data() : now - stride;
        std::uint32_t leftSum = 0;
        std::uint32_t upSum = 0;
        const auto size = [](std::uint8_t difference) {
            return static_cast<std::uint32_t>(std::abs(static_cast<std::int8_t>(difference)));
        };
        for (std::size_t i = 0; i < stride; ++i) {
            up[i] = static_cast<std::uint8_t>(now[i] - above[i]);
            upSum += size(up[i]);
        }
        std::copy_n(now, std::min(step, stride), left.data());
        for (std::size_t i = step; i < stride; ++i) {
            left[i] = static_cast<std::uint8_t>(now[i] - now[i - step]);
            leftSum += size(left[i]);
        }
        std::uint8_t* to = out.data() + (stride + 1) * static_cast<std::size_t>(row);
        *to = leftSum < upSum ? 1 : 2;
        std::memcpy(to + 1, leftSum < upSum ? left.data() : up.data(), stride);
    }
    return out;
}

}  // namespace

std::vector<std::byte> encodePng(const EncodedPixels& pixels,
                                 std::span<const std::pair<std::string, std::string>> metadata) {
    TUKOR_ASSERT(pixels.channels == 3 || pixels.channels == 4);
    std::vector<std::byte> out;
    const auto signature = std::as_bytes(std::span("\x89PNG\r\n\x1a\n", 8));
    out.assign(signature.begin(), signature.end());
    std::vector<std::byte> header;
    appendNumber(header, static_cast<std::uint32_t>(pixels.width));
    appendNumber(header, static_cast<std::uint32_t>(pixels.height));
    const int colourType = pixels.channels == 4 ? 6 : 2;
    for (int value : {8 * pixels.bytesPerChannel, colourType, 0, 0, 0})
        header.push_back(static_cast<std::byte>(value));
    appendChunk(out, "IHDR", header);
    const std::byte intent{0};  // perceptual
    appendChunk(out, "sRGB", std::span(&intent, 1));
    for (const auto& [key, value] : metadata) {
        // Keyword, no compression, no language, no translation; at most 79 bytes of keyword.
        std::string text = key.substr(0, 79);
        text.append(5, '\0');
        text += value;
        appendChunk(out, "iTXt", std::as_bytes(std::span(text)));
    }
    appendChunk(out, "IDAT", zlibStream(filtered(pixels)));
    appendChunk(out, "IEND", {});
    return out;
}

}  // namespace tukor
