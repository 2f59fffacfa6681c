// Textures made quick to look up: a mip chain over the texels of a model.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "tukor/scene/finish.h"

namespace tukor::trace {

/// Trilinear look-ups in 8-bit texels; linear values come out. Refers to the texels of level 0.
class TexturePyramid {
public:
    enum class Encoding { srgb, linear };

    TexturePyramid(std::shared_ptr<const Texels> texels, Encoding encoding);

    /// `width` is that of the footprint in units of the picture's larger edge. Three channels have
    /// an alpha of 1.
    [[nodiscard]] glm::vec4 at(glm::vec2 place, float width, const TextureMap& map) const noexcept;

private:
    struct Level {
        int width;
        int height;
        const std::uint8_t* texels;
    };
    [[nodiscard]] glm::vec4 texel(const Level& level, int column, int row) const noexcept;
    [[nodiscard]] glm::vec4 bilinear(const Level& level, glm::vec2 place,
                                     const TextureMap& map) const noexcept;
    void addLevel();

    std::shared_ptr<const Texels> texels_;
    const float* linear_;  // of each code
    int channels_;
    std::vector<Level> levels_;
    std::vector<std::vector<std::uint8_t>> made_;  // those above 0
};

/// The pyramids of a scene: one for each picture in each encoding.
class TextureStore {
public:
    /// Null where the map has no picture. The store must outlive what it gives.
    const TexturePyramid* pyramidOf(const TextureMap& map, TextureRole role);

private:
    std::map<std::pair<const Texels*, bool>, std::unique_ptr<TexturePyramid>> pyramids_;
};

}  // namespace tukor::trace
