#include "tukor/base/file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "tukor/base/error.h"

namespace tukor {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// The size of a regular file of at most `maxBytes`; Error for everything else.
std::uint64_t checkedSize(const fs::path& path, std::uint64_t maxBytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        throw Error(fmt::format("{}: no such file", path.string()));
    if (fs::is_directory(status))
        throw Error(fmt::format("{}: is a folder; expected a file", path.string()));
    if (!fs::is_regular_file(status))
        throw Error(fmt::format("{}: not a regular file", path.string()));
    const std::uint64_t size = fs::file_size(path, error);
    if (error) throw Error(fmt::format("{}: cannot be read: {}", path.string(), error.message()));
    if (size > maxBytes)
        throw Error(fmt::format("{}: {} bytes; the largest file accepted is {} bytes",
                                path.string(), size, maxBytes));
    return size;
}

}  // namespace

std::vector<std::byte> readFile(const fs::path& path, std::uint64_t maxBytes) {
    const std::uint64_t size = checkedSize(path, maxBytes);
    File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        throw Error(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
    std::vector<std::byte> bytes(size);
    if (std::fread(bytes.data(), 1, size, file.get()) != size)
        throw Error(fmt::format("{}: cannot be read to its end", path.string()));
    return bytes;
}

MappedFile::MappedFile(const fs::path& path, std::uint64_t maxBytes) {
    const std::uint64_t size = checkedSize(path, maxBytes);
    File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        throw Error(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
    if (size == 0) return;  // an empty mapping is an error to mmap
    void* memory = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, ::fileno(file.get()), 0);
    if (memory == MAP_FAILED)
        throw Error(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
    bytes_ = {static_cast<const std::byte*>(memory), size};
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes) {
    static std::atomic<unsigned> serial = 0;  // two threads may write side by side
    std::error_code error;
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        throw Error(fmt::format("{}: cannot be written: there is no folder {}", path.string(),
                                folder.string()));
    if (fs::is_directory(target, error))
        throw Error(fmt::format("{}: cannot be written: it is a folder", path.string()));
    // To rename over /dev/null would replace the device.
    const bool inPlace = fs::exists(target, error) && !fs::is_regular_file(target, error);
    const fs::path partial =
        inPlace ? target
                : folder / fmt::format(".{}.{}.{}.partial", target.filename().string(), ::getpid(),
                                       serial++);
    const auto fail = [&](int code) {
        std::error_code ignored;
        if (!inPlace) fs::remove(partial, ignored);
        throw Error(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(code)));
    };
    {
        File file(std::fopen(partial.c_str(), "wb"));
        if (!file) fail(errno);
        if (!bytes.empty() &&
            std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
            fail(errno);
        if (std::fflush(file.get()) != 0) fail(errno);
    }
    if (inPlace) return;
    fs::rename(partial, target, error);
    if (error) fail(error.value());
}

void requireWritable(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw Error(fmt::format("{}: is a folder; a file name expected", path.string()));
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return;  // a device
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored))
        throw Error(fmt::format("{}: there is no folder {}", path.string(), folder.string()));
    // Permissions alone do not tell: make a file there and remove it.
    std::string probe = (folder / ".tukor-XXXXXX").string();
    const int file = ::mkstemp(probe.data());
    if (file < 0) {
        const int reason = errno;
        throw Error(fmt::format("{}: cannot write into {}: {}", path.string(), folder.string(),
                                std::strerror(reason)));
    }
    ::close(file);
    ::unlink(probe.c_str());
}

void writeFile(const fs::path& path, std::string_view text) {
    writeFile(path, std::as_bytes(std::span(text)));
}

}  // namespace tukor
