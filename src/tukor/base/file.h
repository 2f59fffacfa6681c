// Whole files in and out: bounded reads, writes that are never half done.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tukor {

/// The largest file that any reader accepts, in bytes: four times an uncompressed 8192 x 4096 float
/// panorama.
inline constexpr std::uint64_t kMaxFileBytes = 1ull << 31;

/// The bytes of a regular file. Throws Error when it is missing, a folder, unreadable or above
/// `maxBytes`.
[[nodiscard]] std::vector<std::byte> readFile(const std::filesystem::path& path,
                                              std::uint64_t maxBytes = kMaxFileBytes);

/// A regular file seen as memory: pages are read when they are touched, so that a reader which
/// refuses a huge file has not paid for it.
///
/// Owns the mapping; a moved-from file is empty. Throws Error like readFile.
class MappedFile {
public:
    explicit MappedFile(const std::filesystem::path& path, std::uint64_t maxBytes = kMaxFileBytes);
    MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
    MappedFile& operator=(MappedFile&& other) noexcept {
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    ~MappedFile();

    [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

private:
    std::span<const std::byte> bytes_;
};

/// Writes beside `path` and renames, so that a reader sees the old file or the whole new one.
///
/// Symbolic links are followed; devices and pipes are written in place. Throws Error when the
/// folder is missing or not writable; nothing is left behind then.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& path, std::string_view text);

/// Before time is spent on what is to be written there. Throws Error when `path` is a folder, or
/// the folder that it names is missing or not writable; a file there is left as it is.
void requireWritable(const std::filesystem::path& path);

/// The extension in lower case with its dot, `.exr`; empty when there is none.
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& path);

}  // namespace tukor
