#include "tukor/base/file.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "tukor/base/error.h"

namespace tukor {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace

std::vector<std::byte> readFile(const fs::path& path, std::uint64_t maxBytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        throw Error(fmt::format("{}: no such file", path.string()));
    if (fs::is_directory(status))
        throw Error(fmt::format("{}: is a folder; expected a file", path.string()));
    if (!fs::is_regular_file(status))
        throw Error(fmt::format("{}: not a regular file", path.string()));
    File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        throw Error(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
    const std::uint64_t size = fs::file_size(path, error);
    if (error) throw Error(fmt::format("{}: cannot be read: {}", path.string(), error.message()));
    if (size > maxBytes)
        throw Error(fmt::format("{}: {} bytes; the largest file accepted is {} bytes",
                                path.string(), size, maxBytes));
    std::vector<std::byte> bytes(size);
    if (std::fread(bytes.data(), 1, size, file.get()) != size)
        throw Error(fmt::format("{}: cannot be read to its end", path.string()));
    return bytes;
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes) {
    static std::atomic<unsigned> serial = 0;  // two threads may write side by side
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw Error(fmt::format("{}: cannot be written: there is no folder {}", path.string(),
                                folder.string()));
    if (fs::is_directory(path, error))
        throw Error(fmt::format("{}: cannot be written: it is a folder", path.string()));
    const fs::path partial =
        folder / fmt::format(".{}.{}.{}.partial", path.filename().string(), ::getpid(), serial++);
    const auto fail = [&](int code) {
        std::error_code ignored;
        fs::remove(partial, ignored);
        throw Error(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(code)));
    };
    {
        File file(std::fopen(partial.c_str(), "wb"));
        if (!file) fail(errno);
        if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
            std::fflush(file.get()) != 0)
            fail(errno);
    }
    fs::rename(partial, path, error);
    if (error) fail(error.value());
}

void writeFile(const fs::path& path, std::string_view text) {
    writeFile(path, std::as_bytes(std::span(text)));
}

std::string lowerExtension(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace tukor
