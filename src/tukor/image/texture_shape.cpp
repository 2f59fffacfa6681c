#include "tukor/image/texture_shape.h"

#include <algorithm>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/image/bc6h.h"
#include "tukor/image/image_size.h"

namespace tukor {

namespace {

/// Texels, where blocks are single ones; blocks at the edge count whole.
std::uint64_t blocksAlong(std::uint32_t size, const TexelLayout& layout) {
    const auto block = static_cast<std::uint64_t>(layout.blockSize);
    return (size + block - 1) / block;
}

std::uint64_t rowBytes(const TextureShape& shape, const TexelLayout& layout, std::uint32_t level,
                       std::uint32_t alignment) {
    const std::uint64_t bytes = blocksAlong(levelSize(shape.width, level), layout) *
                                static_cast<std::uint64_t>(layout.bytes);
    return (bytes + alignment - 1) / alignment * alignment;
}

}  // namespace

std::uint32_t levelSize(std::uint32_t size, std::uint32_t level) noexcept {
    return std::max(size >> level, 1u);
}

void checkTextureShape(std::string_view name, const TextureShape& shape) {
    if (shape.depth > 1)
        throw Error(fmt::format("{}: a volume of depth {}; expected a picture or a cube map", name,
                                shape.depth));
    if (shape.layers > 1)
        throw Error(fmt::format("{}: an array of {} textures; expected one", name, shape.layers));
    if (shape.faces != 1 && shape.faces != 6)
        throw Error(fmt::format("{}: {} faces; a cube map has six", name, shape.faces));
    checkImageSize(name, shape.width, std::uint64_t{shape.height} * shape.faces);
    if (shape.faces == 6 && shape.width != shape.height)
        throw Error(fmt::format("{}: cube faces of {} x {} pixels; expected squares", name,
                                shape.width, shape.height));
    std::uint32_t most = 1;
    while (most < 32 && std::max(shape.width, shape.height) >> most > 0) ++most;
    if (shape.levels < 1 || shape.levels > most)
        throw Error(fmt::format("{}: {} levels; {} x {} pixels can have 1 to {}", name,
                                shape.levels, shape.width, shape.height, most));
}

std::uint64_t faceBytes(const TextureShape& shape, const TexelLayout& layout, std::uint32_t level,
                        std::uint32_t rowAlignment) noexcept {
    return rowBytes(shape, layout, level, rowAlignment) *
           blocksAlong(levelSize(shape.height, level), layout);
}

Image unpackFace(const TextureShape& shape, const TexelLayout& layout, std::uint32_t level,
                 std::uint32_t rowAlignment, std::span<const std::byte> bytes) {
    TUKOR_ASSERT(bytes.size() == faceBytes(shape, layout, level, rowAlignment));
    const std::uint64_t stride = rowBytes(shape, layout, level, rowAlignment);
    Image image(static_cast<int>(levelSize(shape.width, level)),
                static_cast<int>(levelSize(shape.height, level)));
    if (layout.blockSize > 1) {  // whose 16 bytes need no padding
        decodeBc6h(bytes, layout.code == TexelCode::bc6h ? Bc6hSign::none : Bc6hSign::one, image);
        return image;
    }
    const auto width = static_cast<std::size_t>(image.width());
    parallelFor(0, image.height(), 64, [&](int begin, int end) {
        for (auto row = static_cast<std::size_t>(begin); row < static_cast<std::size_t>(end); ++row)
            unpackTexels(layout, bytes.data() + row * stride,
                         image.pixels().subspan(row * width, width));
    });
    return image;
}

FacePacker::FacePacker(const TextureFile& texture, const TexelLayout& layout,
                       const Progress& progress)
    : texture_(texture), layout_(layout), progress_(progress) {
    for (const Image& image : texture.images) texels_ += image.pixels().size();
}

bool FacePacker::pack(int level, int face, std::vector<std::byte>& out) {
    const Image& image = texture_.image(level, face);
    const float from = static_cast<float>(packed_) / static_cast<float>(texels_);
    packed_ += image.pixels().size();
    const float to = static_cast<float>(packed_) / static_cast<float>(texels_);
    if (layout_.blockSize > 1) return encodeBc6h(image, out, partOf(progress_, from, to));
    packTexels(layout_, image.pixels(), out);
    return !progress_ || progress_(to);
}

TextureFile emptyTexture(const TextureShape& shape) {
    TextureFile texture;
    texture.width = static_cast<int>(shape.width);
    texture.height = static_cast<int>(shape.height);
    texture.faces = static_cast<int>(shape.faces);
    texture.levels = static_cast<int>(shape.levels);
    texture.images.resize(std::size_t{shape.levels} * shape.faces);
    return texture;
}

}  // namespace tukor
