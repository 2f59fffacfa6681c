#include "tukor/image/texture_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/image/dds_file.h"
#include "tukor/image/ktx_file.h"

namespace tukor {

namespace {

/// The caller's promise: every picture is there and has its level's size.
[[maybe_unused]] bool isWhole(const TextureFile& texture) {
    if (texture.images.size() != static_cast<std::size_t>(texture.levels * texture.faces))
        return false;
    for (int level = 0; level < texture.levels; ++level)
        for (int face = 0; face < texture.faces; ++face)
            if (texture.image(level, face).width() != std::max(texture.width >> level, 1) ||
                texture.image(level, face).height() != std::max(texture.height >> level, 1))
                return false;
    return true;
}

std::vector<std::byte> dds(const TextureFile& texture, const TextureOptions& options,
                           const Progress& progress) {
    return encodeDds(texture, options.texels, progress);
}

std::vector<std::byte> ktx1(const TextureFile& texture, const TextureOptions& options,
                            const Progress& progress) {
    return encodeKtx1(texture, options.texels, progress);
}

std::vector<std::byte> ktx2(const TextureFile& texture, const TextureOptions& options,
                            const Progress& progress) {
    return encodeKtx2(texture, options.texels, options.supercompression, progress);
}

struct Format {
    std::string_view extension;
    std::vector<std::byte> (*encode)(const TextureFile& texture, const TextureOptions& options,
                                     const Progress& progress);
};

constexpr Format kFormats[] = {{".dds", dds}, {".ktx", ktx1}, {".ktx2", ktx2}};

}  // namespace

bool isTexture(std::span<const std::byte> bytes) noexcept {
    return isDds(bytes) || isKtx1(bytes) || isKtx2(bytes);
}

TextureFile decodeTexture(std::span<const std::byte> bytes, std::string_view name) {
    if (isDds(bytes)) return decodeDds(bytes, name);
    if (isKtx1(bytes)) return decodeKtx1(bytes, name);
    if (isKtx2(bytes)) return decodeKtx2(bytes, name);
    throw Error(fmt::format("{}: {}; expected a .dds, .ktx or .ktx2 texture", name,
                            bytes.empty() ? "is empty" : "not a texture file"));
}

TextureFile loadTexture(const std::filesystem::path& path) {
    const MappedFile file(path);
    return decodeTexture(file.bytes(), path.string());
}

std::vector<std::byte> encodeTexture(const TextureFile& texture, const std::string& extension,
                                     const TextureOptions& options, const Progress& progress) {
    TUKOR_ASSERT(isWhole(texture));
    for (const Format& format : kFormats)
        if (format.extension == extension) return format.encode(texture, options, progress);
    throw Error(
        fmt::format("no texture format is called `{}`; known are .dds .ktx .ktx2", extension));
}

bool saveTexture(const std::filesystem::path& path, const TextureFile& texture,
                 const TextureOptions& options, const Progress& progress) {
    const auto bytes = encodeTexture(texture, lowerExtension(path), options, progress);
    if (bytes.empty()) return false;
    writeFile(path, bytes);
    return true;
}

}  // namespace tukor
