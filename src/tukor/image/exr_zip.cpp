#include "tukor/image/exr_zip.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <numeric>
#include <optional>

#include <Imath/half.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/image/exr_context.h"
#include "tukor/image/zlib_stream.h"

namespace tukor {

namespace {

constexpr std::uint64_t kLargestChunk = 1 << 26;

/// A channel as it lies in a row of the file.
struct Channel {
    std::size_t offset;  // in bytes, of a row of one pixel
    bool isHalf;
    const ExrSlice* slice;
};

struct Part {
    exr_attr_box2i_t window;
    std::int32_t rowsPerChunk;
    std::size_t pixelBytes;
    std::vector<Channel> channels;  // those that are asked for

    [[nodiscard]] std::size_t width() const {
        return static_cast<std::size_t>(std::int64_t{window.max.x} - window.min.x + 1);
    }
};

std::optional<Part> partOf(exr_const_context_t context, int number,
                           std::span<const ExrSlice> slices) {
    exr_storage_t storage{};
    exr_compression_t compression{};
    const exr_attr_chlist_t* channels = nullptr;
    Part part{};
    if (exr_get_storage(context, number, &storage) != EXR_ERR_SUCCESS ||
        exr_get_compression(context, number, &compression) != EXR_ERR_SUCCESS ||
        exr_get_data_window(context, number, &part.window) != EXR_ERR_SUCCESS ||
        exr_get_scanlines_per_chunk(context, number, &part.rowsPerChunk) != EXR_ERR_SUCCESS ||
        exr_get_channels(context, number, &channels) != EXR_ERR_SUCCESS)
        return std::nullopt;
    if (storage != EXR_STORAGE_SCANLINE ||
        (compression != EXR_COMPRESSION_ZIP && compression != EXR_COMPRESSION_ZIPS))
        return std::nullopt;
    for (int i = 0; i < channels->num_channels; ++i) {
        const exr_attr_chlist_entry_t& entry = channels->entries[i];
        const bool isHalf = entry.pixel_type == EXR_PIXEL_HALF;
        if (entry.x_sampling != 1 || entry.y_sampling != 1 ||
            (!isHalf && entry.pixel_type != EXR_PIXEL_FLOAT))
            return std::nullopt;
        const auto slice = std::ranges::find(slices, entry.name.str, &ExrSlice::channel);
        if (slice != slices.end()) part.channels.push_back({part.pixelBytes, isHalf, &*slice});
        part.pixelBytes += isHalf ? sizeof(half) : sizeof(float);
    }
    if (part.channels.size() != slices.size()) return std::nullopt;
    return part;
}

template <class Stored>
void convert(const std::uint8_t* from, std::size_t count, float* to, std::size_t step) {
    for (std::size_t i = 0; i < count; ++i) {
        Stored value;
        std::memcpy(&value, from + i * sizeof(Stored), sizeof(Stored));
        to[i * step] = float(value);
    }
}

/// The rows of a chunk, to their places.
bool readChunk(std::span<const std::byte> bytes, const Part& part, const exr_chunk_info_t& chunk) {
    const std::size_t width = part.width(), rowBytes = width * part.pixelBytes;
    const auto rows = static_cast<std::size_t>(chunk.height);
    if (chunk.unpacked_size != rowBytes * rows || chunk.unpacked_size > kLargestChunk ||
        chunk.data_offset > bytes.size() || chunk.packed_size > bytes.size() - chunk.data_offset)
        return false;
    const std::span<const std::byte> packed = bytes.subspan(chunk.data_offset, chunk.packed_size);
    std::vector<std::uint8_t> unpacked(chunk.unpacked_size);
    if (packed.size() == unpacked.size()) {  // it would have been no smaller
        std::memcpy(unpacked.data(), packed.data(), packed.size());
    } else {
        std::vector<std::uint8_t> predicted(unpacked.size());
        if (!readZlibStream(packed, predicted)) return false;
        unpredictedFromZip(predicted, unpacked);
    }
    for (std::size_t row = 0; row < rows; ++row) {
        const auto y = static_cast<std::size_t>(std::int64_t{chunk.start_y} - part.window.min.y);
        for (const Channel& channel : part.channels) {
            const std::uint8_t* from = &unpacked[row * rowBytes + channel.offset * width];
            const std::size_t step = channel.slice->step;
            float* to = channel.slice->first + (y + row) * width * step;
            channel.isHalf ? convert<half>(from, width, to, step)
                           : convert<float>(from, width, to, step);
        }
    }
    return true;
}

}  // namespace

bool readZipScanlines(const std::span<const std::byte>& bytes, int number,
                      std::span<const ExrSlice> slices) {
    const ExrContext context = openExr(bytes, "memory");
    const std::optional<Part> part = partOf(context.get(), number, slices);
    if (!part) return false;
    std::vector<exr_chunk_info_t> chunks;
    for (std::int64_t y = part->window.min.y; y <= part->window.max.y; y += part->rowsPerChunk) {
        exr_chunk_info_t& chunk = chunks.emplace_back();
        if (exr_read_scanline_chunk_info(context.get(), number, static_cast<int>(y), &chunk) !=
                EXR_ERR_SUCCESS ||
            chunk.start_y != y ||
            chunk.height != std::min<std::int64_t>(part->rowsPerChunk, part->window.max.y - y + 1))
            return false;
    }
    std::atomic<bool> sound = true;
    parallelFor(0, static_cast<int>(chunks.size()), 1, [&](int begin, int end) {
        for (int i = begin; i < end && sound; ++i)
            if (!readChunk(bytes, *part, chunks[static_cast<std::size_t>(i)])) sound = false;
    });
    return sound;
}

std::vector<std::uint8_t> predictedForZip(std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> out(bytes.size());
    const std::size_t evens = (bytes.size() + 1) / 2;
    for (std::size_t i = 0; i < evens; ++i) out[i] = bytes[2 * i];
    for (std::size_t i = evens; i < bytes.size(); ++i) out[i] = bytes[2 * (i - evens) + 1];
    for (std::size_t i = out.size() - 1; i > 0; --i)
        out[i] = static_cast<std::uint8_t>(out[i] - out[i - 1] + 128);
    return out;
}

void unpredictedFromZip(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> out) {
    TUKOR_ASSERT(out.size() == bytes.size());
    // Each difference carries 128 more but the first. Where the odd places begin shows in the sum
    // of all before, so that both can go on side by side.
    const std::size_t evens = (bytes.size() + 1) / 2, odds = bytes.size() / 2;
    const auto sum = [](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(a + b);
    };
    const auto bias = static_cast<std::uint8_t>(128);
    std::uint8_t even = bias;
    std::uint8_t odd = std::accumulate(bytes.begin(), bytes.begin() + evens,
                                       static_cast<std::uint8_t>(bias + evens % 2 * 128), sum);
    for (std::size_t i = 0; i < odds; ++i) {
        even = sum(even, sum(bytes[i], bias));
        odd = sum(odd, sum(bytes[evens + i], bias));
        out[2 * i] = even;
        out[2 * i + 1] = odd;
    }
    if (evens > odds) out[2 * odds] = sum(even, sum(bytes[odds], bias));
}

}  // namespace tukor
