#include "tukor/scene/texel_channels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/glm.hpp>

namespace tukor {

namespace {

/// The channels of the texel in the same place of a picture of that size.
const std::uint8_t* texelAt(const Texels& picture, int x, int y, int width, int height) {
    const auto column = static_cast<std::size_t>(std::int64_t{x} * picture.width / width);
    const auto row = static_cast<std::size_t>(std::int64_t{y} * picture.height / height);
    return &picture.bytes[(row * static_cast<std::size_t>(picture.width) + column) *
                          static_cast<std::size_t>(picture.channels)];
}

/// Of the size of the larger; texel(x, y, out) writes `channels` samples.
template <class Texel>
Texels mixed(const Texels& a, const Texels& b, int channels, Texel&& texel) {
    Texels out{std::max(a.width, b.width), std::max(a.height, b.height), channels, {}};
    out.bytes.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) *
                     static_cast<std::size_t>(channels));
    std::uint8_t* to = out.bytes.data();
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x, to += channels) texel(x, y, out, to);
    return out;
}

bool isGrey(const Texels& picture) {
    std::size_t coloured = 0;
    const auto step = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i + 2 < picture.bytes.size(); i += step) {
        const auto [least, most] =
            std::minmax({picture.bytes[i], picture.bytes[i + 1], picture.bytes[i + 2]});
        coloured += most - least > 16;  // more than JPEG adds to a grey
    }
    return 8 * coloured < picture.bytes.size() / step;
}

}  // namespace

Texels withOpacity(const Texels& colours, const Texels& opacity) {
    if (opacity.width == 0) return colours;
    const int channel = opacity.channels == 4 ? 3 : 0;
    return mixed(colours, opacity, 4, [&](int x, int y, const Texels& out, std::uint8_t* to) {
        std::fill_n(to, 3, std::uint8_t{255});
        if (colours.width > 0) std::copy_n(texelAt(colours, x, y, out.width, out.height), 3, to);
        to[3] = texelAt(opacity, x, y, out.width, out.height)[channel];
    });
}

Texels metallicRoughnessOf(const Texels& metallic, const Texels& roughness) {
    return mixed(metallic, roughness, 3, [&](int x, int y, const Texels& out, std::uint8_t* to) {
        const auto grey = [&](const Texels& picture) {
            return picture.width > 0 ? *texelAt(picture, x, y, out.width, out.height)
                                     : std::uint8_t{255};
        };
        to[0] = 255;
        to[1] = grey(roughness);
        to[2] = grey(metallic);
    });
}

Texels normalsOf(const Texels& relief, float strength) {
    if (relief.width == 0 || !isGrey(relief)) return relief;
    return mixed(relief, {}, 3, [&](int x, int y, const Texels& out, std::uint8_t* to) {
        const auto height = [&](int column, int row) {  // pictures are repeated
            column = (column + out.width) % out.width;
            row = (row + out.height) % out.height;
            return static_cast<float>(*texelAt(relief, column, row, out.width, out.height)) /
                   255.0f;
        };
        const glm::vec3 normal = glm::normalize(
            glm::vec3(0.5f * strength * (height(x - 1, y) - height(x + 1, y)),
                      0.5f * strength * (height(x, y + 1) - height(x, y - 1)), 1.0f));
        for (int c = 0; c < 3; ++c)
            to[c] = static_cast<std::uint8_t>(std::lround(127.5f + 127.5f * normal[c]));
    });
}

}  // namespace tukor
