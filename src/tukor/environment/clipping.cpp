#include "tukor/environment/clipping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "tukor/environment/cube_texel.h"

namespace tukor {

float largestOf(TexelFormat format) noexcept {
    switch (format) {
        case TexelFormat::rgba16f:
        case TexelFormat::bc6h:
            return 65504.0f;
        case TexelFormat::rgb9e5:
            return 65408.0f;
        case TexelFormat::r11g11b10f:
            return 64512.0f;  // blue, of fewer bits; red and green hold 65024
        case TexelFormat::rgba32f:
        case TexelFormat::rgba8:
            break;
    }
    return std::numeric_limits<float>::infinity();
}

void addClipping(Clipping& clipping, const Image& image, PixelAreas areas) {
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column) {
            const glm::vec3 pixel = image.at(column, row);
            const glm::vec3 above = glm::max(pixel - clipping.most, glm::vec3(0.0f));
            double area = 1.0;
            if (areas == PixelAreas::equirect)
                area = std::sin(std::numbers::pi * (row + 0.5) / image.height());
            else if (areas == PixelAreas::face)
                area = texelSolidAngle(image.width(), column, row);
            clipping.pixels += std::max({above.x, above.y, above.z}) > 0.0f ? 1 : 0;
            clipping.lost += area * static_cast<double>(above.x + above.y + above.z);
            clipping.whole += area * static_cast<double>(pixel.x + pixel.y + pixel.z);
        }
}

std::string sentenceOf(const Clipping& clipping, std::string_view format) {
    const bool one = clipping.pixels == 1;
    return fmt::format(
        "{} {} above {:.0f}, the most that {} holds, {} clipped: {:.3g} % of the light",
        clipping.pixels, one ? "pixel" : "pixels", clipping.most, format, one ? "was" : "were",
        100.0 * clipping.lost / clipping.whole);
}

}  // namespace tukor
