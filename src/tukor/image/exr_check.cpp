#include "tukor/image/exr_check.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include <OpenEXR/openexr.h>
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/image_size.h"

namespace tukor {

namespace {

// A black DWAB image takes one bit for each block of 64 half floats and channel, in runs.
constexpr std::uint64_t kMostPixelsPerByte = 1 << 14;
// One chunk, all channels: 256 scanlines of 16384 float RGBA pixels, DWAB's largest.
constexpr std::uint64_t kLargestChunk = 1 << 26;

/// The library's last complaint; it prefers a callback to a return value.
thread_local std::string complaint;

void keepComplaint(exr_const_context_t, exr_result_t, const char* message) {
    complaint = message ? message : "";
}

std::int64_t readBytes(exr_const_context_t, void* user, void* buffer, std::uint64_t size,
                       std::uint64_t offset, exr_stream_error_func_ptr_t) {
    const auto& bytes = *static_cast<const std::span<const std::byte>*>(user);
    if (offset >= bytes.size()) return 0;
    const std::uint64_t count = std::min<std::uint64_t>(size, bytes.size() - offset);
    std::memcpy(buffer, bytes.data() + offset, count);
    return static_cast<std::int64_t>(count);
}

std::int64_t sizeOfBytes(exr_const_context_t, void* user) {
    return static_cast<std::int64_t>(static_cast<const std::span<const std::byte>*>(user)->size());
}

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

struct Finish {
    void operator()(exr_context_t context) const noexcept { exr_finish(&context); }
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
    void require(exr_result_t result) const {
        if (result == EXR_ERR_SUCCESS) return;
        throw Error(fmt::format(
            "{}: damaged OpenEXR file: {}", name_,
            complaint.empty() ? exr_get_default_error_message(result) : complaint.c_str()));
    }

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
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.error_handler_fn = keepComplaint;
    setup.user_data = &bytes;
    setup.read_fn = readBytes;
    setup.size_fn = sizeOfBytes;
    complaint.clear();
    exr_context_t context = nullptr;
    const exr_result_t result = exr_start_read(&context, std::string(name).c_str(), &setup);
    const std::unique_ptr<_priv_exr_context_t, Finish> owner(context);
    if (result != EXR_ERR_SUCCESS)
        throw Error(fmt::format(
            "{}: damaged OpenEXR file: {}", name,
            complaint.empty() ? exr_get_default_error_message(result) : complaint.c_str()));
    Checker(context, bytes.size(), name).check();
}

}  // namespace tukor
