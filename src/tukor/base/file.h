// Whole files in and out: bounded reads, writes that are never half done.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tukor {

/// The largest file that any reader accepts, in bytes: four times an uncompressed 8192 x 4096 float
/// panorama.
inline constexpr std::uint64_t kMaxFileBytes = 1ull << 31;

/// The bytes of a regular file. Throws Error when it is missing, a folder, unreadable or above
/// `maxBytes`.
[[nodiscard]] std::vector<std::byte> readFile(const std::filesystem::path& path,
                                              std::uint64_t maxBytes = kMaxFileBytes);

/// Writes beside `path` and renames, so that a reader sees the old file or the whole new one.
///
/// Throws Error when the folder is missing or not writable; nothing is left behind then.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& path, std::string_view text);

/// The extension in lower case with its dot, `.exr`; empty when there is none.
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& path);

}  // namespace tukor
