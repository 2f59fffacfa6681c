// The library writes the file, its chunks are compressed here: its own zlib takes several times as
// long, 0.3 CPU-seconds of a picture of 1280 x 720.
#include <algorithm>
#include <cstring>
#include <memory>
#include <type_traits>

#include <Imath/half.h>
#include <OpenEXR/openexr.h>
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/image/exr_file.h"
#include "tukor/image/exr_zip.h"
#include "tukor/image/zlib_stream.h"

namespace tukor {

namespace {

constexpr int kChunkRows = 16;  // of ZIP

/// A channel of the file.
struct Channel {
    std::string name;
    const Image* image;
    int index;  // 0, 1, 2, or 3: alpha

    [[nodiscard]] float at(std::size_t pixel) const {
        return index == 3 ? image->alpha[pixel] : image->pixels()[pixel][index];
    }
};

/// In the file's order.
std::vector<Channel> channelsOf(std::span<const ImageLayer> layers) {
    std::vector<Channel> channels;
    for (const ImageLayer& layer : layers) {
        const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
        for (int index = 0; index < (layer.image.alpha.empty() ? 3 : 4); ++index)
            channels.push_back({prefix + "RGBA"[index], &layer.image, index});
    }
    std::ranges::sort(channels, {}, &Channel::name);
    return channels;
}

half halfOf(float value) {  // NaN stays NaN, too large does not
    constexpr float kMost = HALF_MAX;
    return half(value > kMost ? kMost : value < -kMost ? -kMost : value);
}

/// Rows [begin, end), each channel by channel.
std::vector<std::uint8_t> rowsOf(std::span<const Channel> channels, ExrPixels pixels, int width,
                                 int begin, int end) {
    const std::size_t size = pixels == ExrPixels::half ? sizeof(half) : sizeof(float);
    std::vector<std::uint8_t> bytes(size * channels.size() * static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(end - begin));
    std::uint8_t* to = bytes.data();
    for (int row = begin; row < end; ++row) {
        const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
        for (const Channel& channel : channels) {
            for (std::size_t i = first; i < first + static_cast<std::size_t>(width); ++i) {
                const float value = channel.at(i);
                const half rounded = pixels == ExrPixels::half ? halfOf(value) : half();
                std::memcpy(to,
                            pixels == ExrPixels::half ? static_cast<const void*>(&rounded) : &value,
                            size);
                to += size;
            }
        }
    }
    return bytes;
}

/// What is no smaller for it stays uncompressed, which readers tell by its size.
std::vector<std::byte> chunkOf(std::span<const std::uint8_t> rows) {
    std::vector<std::byte> stream = zlibStream(predictedForZip(rows));
    if (stream.size() < rows.size()) return stream;
    const auto raw = std::as_bytes(rows);
    return {raw.begin(), raw.end()};
}

void check(exr_result_t result) {
    if (result != EXR_ERR_SUCCESS)
        throw Error(fmt::format("cannot write OpenEXR: {}", exr_get_error_code_as_string(result)));
}

/// A file in memory that is being written.
class File {
public:
    File(int width, int height, std::span<const Channel> channels, ExrPixels pixels,
         std::span<const std::pair<std::string, std::string>> metadata) {
        exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
        init.user_data = &bytes_;
        init.write_fn = write;
        init.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
        exr_context_t context = nullptr;
        check(exr_start_write(&context, "memory", EXR_WRITE_FILE_DIRECTLY, &init));
        context_.reset(context);
        int part = 0;
        check(exr_add_part(context, nullptr, EXR_STORAGE_SCANLINE, &part));
        const exr_attr_box2i_t window = {{0, 0}, {width - 1, height - 1}};
        const exr_attr_v2f_t middle = {0.0f, 0.0f};
        check(exr_initialize_required_attr(context, part, &window, &window, 1.0f, &middle, 1.0f,
                                           EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_ZIP));
        const exr_pixel_type_t type = pixels == ExrPixels::half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
        for (const Channel& channel : channels)
            check(exr_add_channel(context, part, channel.name.c_str(), type,
                                  EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
        for (const auto& [key, value] : metadata)
            check(exr_attr_set_string(context, part, key.c_str(), value.c_str()));
        check(exr_write_header(context));
    }

    /// Those that begin at that row.
    void add(int row, std::span<const std::byte> chunk) {
        check(exr_write_scanline_chunk(context_.get(), 0, row, chunk.data(), chunk.size()));
    }

    std::vector<std::byte> take() {
        exr_context_t context = context_.release();
        check(exr_finish(&context));
        return std::move(bytes_);
    }

private:
    struct Finish {
        void operator()(exr_context_t context) const noexcept { exr_finish(&context); }
    };

    static std::int64_t write(exr_const_context_t, void* userData, const void* from,
                              std::uint64_t size, std::uint64_t position,
                              exr_stream_error_func_ptr_t) {
        auto& bytes = *static_cast<std::vector<std::byte>*>(userData);
        if (position + size > bytes.size()) bytes.resize(position + size);
        std::memcpy(bytes.data() + position, from, size);
        return static_cast<std::int64_t>(size);
    }

    std::vector<std::byte> bytes_;
    std::unique_ptr<std::remove_pointer_t<exr_context_t>, Finish> context_;
};

}  // namespace

std::vector<std::byte> encodeExr(std::span<const ImageLayer> layers, ExrPixels pixels,
                                 std::span<const std::pair<std::string, std::string>> metadata,
                                 const Progress& progress) {
    TUKOR_ASSERT(!layers.empty() && !layers[0].image.empty());
    const int width = layers[0].image.width();
    const int height = layers[0].image.height();
    for (const ImageLayer& layer : layers)
        TUKOR_ASSERT(layer.image.width() == width && layer.image.height() == height);
    const std::vector<Channel> channels = channelsOf(layers);
    File file(width, height, channels, pixels, metadata);
    constexpr int kAtOnce =
        32;  // chunks in memory: 134 MB of 16384 floats across and four channels
    std::vector<std::vector<std::byte>> chunks(kAtOnce);
    for (int first = 0; first < height; first += kAtOnce * kChunkRows) {
        if (progress && !progress(static_cast<float>(first) / static_cast<float>(height)))
            return {};
        const int count = std::min(kAtOnce, (height - first + kChunkRows - 1) / kChunkRows);
        parallelFor(0, count, 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const int row = first + i * kChunkRows;
                chunks[static_cast<std::size_t>(i)] = chunkOf(
                    rowsOf(channels, pixels, width, row, std::min(row + kChunkRows, height)));
            }
        });
        for (int i = 0; i < count; ++i)
            file.add(first + i * kChunkRows, chunks[static_cast<std::size_t>(i)]);
    }
    return file.take();
}

std::vector<std::byte> encodeExr(const Image& image, ExrPixels pixels,
                                 std::span<const std::pair<std::string, std::string>> metadata,
                                 const Progress& progress) {
    const ImageLayer layer{"", image};
    return encodeExr(std::span(&layer, 1), pixels, metadata, progress);
}

}  // namespace tukor
