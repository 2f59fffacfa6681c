#include "tukor/image/exr_check.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/exr_context.h"
#include "tukor/image/image_size.h"

namespace tukor {

namespace {

// A black DWAB image takes one bit for each block of 64 half floats and channel, in runs.
constexpr std::uint64_t kMostPixelsPerByte = 1 << 14;
// One chunk, all channels: 256 scanlines of 16384 float RGBA pixels, DWAB's largest.
constexpr std::uint64_t kLargestChunk = 1 << 26;

/// Steps over the attributes of all headers: the library allocates what they declare before it
/// looks how much there is.
class HeaderWalk {
public:
    HeaderWalk(std::span<const std::byte> bytes, std::string_view name)
        : bytes_(bytes), name_(name) {}

    void walk() {
        constexpr std::uint32_t kMultiPart = 0x1000;
        at_ = 4;  // behind the magic number
        const std::uint32_t flags = number();
        while (walkHeader() && (flags & kMultiPart) != 0) {
        }
    }

private:
    [[noreturn]] void fail() const {
        throw Error(fmt::format("{}: damaged OpenEXR file: its header does not end", name_));
    }

    std::uint32_t number() {
        if (bytes_.size() - at_ < 4) fail();
        std::uint32_t value = 0;
        std::memcpy(&value, bytes_.data() + at_, 4);  // little-endian, as everything that we run on
        at_ += 4;
        return value;
    }

    /// Returns its length.
    std::size_t skipString() {
        const auto rest = bytes_.subspan(at_, std::min<std::size_t>(bytes_.size() - at_, 256));
        const auto end = std::find(rest.begin(), rest.end(), std::byte{0});
        if (end == rest.end()) fail();
        const auto length = static_cast<std::size_t>(end - rest.begin());
        at_ += length + 1;
        return length;
    }

    /// False for an empty header, which ends the list of parts.
    bool walkHeader() {
        bool any = false;
        while (skipString() > 0) {
            any = true;
            skipString();  // the type
            const std::uint32_t size = number();
            if (size > bytes_.size() - at_)
                throw Error(
                    fmt::format("{}: damaged OpenEXR file: an attribute of {} bytes", name_, size));
            at_ += size;
        }
        return any;
    }

    std::span<const std::byte> bytes_;
    std::string_view name_;
    std::size_t at_ = 0;
};

/// Walks the parts of one open file.
class Checker {
public:
    Checker(exr_context_t context, std::uint64_t fileBytes, std::string_view name)
        : context_(context), fileBytes_(fileBytes), name_(name) {}

    void check() const {
        int parts = 0;
        require(exr_get_count(context_, &parts));
        for (int part = 0; part < parts; ++part) checkPart(part);
    }

private:
    void require(exr_result_t result) const { requireExr(result, name_); }

    void checkWindow(const exr_attr_box2i_t& window) const {
        const auto extent = [](std::int64_t least, std::int64_t most) {
            return static_cast<std::uint64_t>(std::max<std::int64_t>(most - least + 1, 0));
        };
        const std::uint64_t width = extent(window.min.x, window.max.x);
        const std::uint64_t height = extent(window.min.y, window.max.y);
        checkImageSize(name_, width, height);
        checkImageFits(name_, width, height, fileBytes_, kMostPixelsPerByte);
    }

    void checkPart(int part) const {
        exr_storage_t storage{};
        require(exr_get_storage(context_, part, &storage));
        if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED) return;  // deep
        exr_attr_box2i_t data{};
        exr_attr_box2i_t display{};
        require(exr_get_data_window(context_, part, &data));
        require(exr_get_display_window(context_, part, &display));
        checkWindow(data);
        checkWindow(display);
        std::uint64_t chunkBytes = 0;
        require(exr_get_chunk_unpacked_size(context_, part, &chunkBytes));
        if (chunkBytes > kLargestChunk * 4)
            throw Error(
                fmt::format("{}: damaged OpenEXR file: chunks of {} bytes", name_, chunkBytes));
        exr_chunk_info_t chunk{};
        if (storage == EXR_STORAGE_SCANLINE) {
            std::int32_t step = 1;
            require(exr_get_scanlines_per_chunk(context_, part, &step));
            for (std::int64_t y = data.min.y; y <= data.max.y; y += std::max(step, 1))
                require(exr_read_scanline_chunk_info(context_, part, static_cast<int>(y), &chunk));
            return;
        }
        std::int32_t tileWidth = 0;
        std::int32_t tileHeight = 0;
        require(exr_get_tile_sizes(context_, part, 0, 0, &tileWidth, &tileHeight));
        const std::int64_t columns = std::int64_t{data.max.x} - data.min.x + 1;
        const std::int64_t rows = std::int64_t{data.max.y} - data.min.y + 1;
        for (std::int64_t ty = 0; ty * tileHeight < rows; ++ty)
            for (std::int64_t tx = 0; tx * tileWidth < columns; ++tx)
                require(exr_read_tile_chunk_info(context_, part, static_cast<int>(tx),
                                                 static_cast<int>(ty), 0, 0, &chunk));
    }

    exr_context_t context_;
    std::uint64_t fileBytes_;
    std::string_view name_;
};

}  // namespace

void checkExr(std::span<const std::byte> bytes, std::string_view name) {
    HeaderWalk(bytes, name).walk();
    const ExrContext context = openExr(bytes, name);
    Checker(context.get(), bytes.size(), name).check();
}

}  // namespace tukor
