// What the texture formats share: checked sizes, and pictures out of packed rows.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "tukor/base/progress.h"
#include "tukor/image/texel_format.h"
#include "tukor/image/texture_file.h"

namespace tukor {

/// As a file's header declares it.
struct TextureShape {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t depth = 0;   // 0 or 1 for pictures
    std::uint32_t layers = 0;  // 0 or 1 unless an array
    std::uint32_t faces = 1;
    std::uint32_t levels = 1;
};

/// Throws Error for volumes, arrays, part cubes, faces that are not square and more levels than
/// there are halvings, and for more pixels than image_size.h allows.
void checkTextureShape(std::string_view name, const TextureShape& shape);

[[nodiscard]] std::uint32_t levelSize(std::uint32_t size, std::uint32_t level) noexcept;

/// Bytes of one face of a level whose rows, of texels or of blocks, are padded to `rowAlignment`.
[[nodiscard]] std::uint64_t faceBytes(const TextureShape& shape, const TexelLayout& layout,
                                      std::uint32_t level, std::uint32_t rowAlignment) noexcept;

/// One face of a level; `bytes` are as many as faceBytes says.
[[nodiscard]] Image unpackFace(const TextureShape& shape, const TexelLayout& layout,
                               std::uint32_t level, std::uint32_t rowAlignment,
                               std::span<const std::byte> bytes);

/// Packs the faces of a texture, and tells how far it is by their texels.
class FacePacker {
public:
    /// All three must outlive it.
    FacePacker(const TextureFile& texture, const TexelLayout& layout, const Progress& progress);

    /// Appends one face of a level, as unpackFace reads it where rows are not padded. False where
    /// `progress` asked to stop.
    [[nodiscard]] bool pack(int level, int face, std::vector<std::byte>& out);

private:
    const TextureFile& texture_;
    const TexelLayout& layout_;
    const Progress& progress_;
    std::size_t texels_ = 0;  // of all faces
    std::size_t packed_ = 0;
};

/// A texture of the shape with room for its pictures, which are empty.
[[nodiscard]] TextureFile emptyTexture(const TextureShape& shape);

}  // namespace tukor
