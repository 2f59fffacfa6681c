// A panorama with detail down to single pixels and a small sun, for offline.py: what an HDRI of
// 4096 x 2048 asks of a renderer's look-ups.
//
// usage: detailed_map OUT.exr [WIDTH]
//
// Blocks of random brightness at every scale from an eighth of the height to one pixel, brighter
// above the horizon; a disc of half a degree and radiance 20,000 in it.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>

#include "tukor/image/image_file.h"

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSunRadius = 0.25 * kPi / 180.0;
constexpr float kSunRadiance = 20000.0f;

/// In [0, 1), of a block by its level and place.
float blockValue(std::uint32_t level, std::uint32_t column, std::uint32_t row) {
    std::uint32_t x = level * 0x9e3779b9u + column * 0x85ebca6bu + row * 0xc2b2ae35u;
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return static_cast<float>(x >> 8) / 16777216.0f;
}

glm::vec3 detail(int column, int row, int height) {
    glm::vec3 radiance =
        row < height / 2 ? glm::vec3(0.7f, 0.9f, 1.2f) : glm::vec3(0.3f, 0.25f, 0.2f);
    std::uint32_t level = 0;
    for (int size = height / 8; size >= 1; size /= 2, ++level) {
        const auto c = static_cast<std::uint32_t>(column / size);
        const auto r = static_cast<std::uint32_t>(row / size);
        // Contrast falls towards small scales as in photographs, about as their size^0.5.
        const float contrast = 1.2f * std::pow(0.75f, static_cast<float>(level));
        for (int i = 0; i < 3; ++i) {
            const float v =
                0.7f * blockValue(level, c, r) +
                0.3f * blockValue(level + 64u * static_cast<std::uint32_t>(i + 1), c, r);
            radiance[i] *= std::exp(contrast * (2.0f * v - 1.0f));
        }
    }
    return radiance;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 2 || argc > 3) {
            std::fprintf(stderr, "usage: detailed_map OUT.exr [WIDTH]\n");
            return 2;
        }
        const int width = argc > 2 ? std::atoi(argv[2]) : 4096, height = width / 2;
        tukor::Image image(width, height);
        // Ahead, to the right of the middle and 35 degrees above the horizon.
        const double sunLongitude = 0.9, sunLatitude = 35.0 * kPi / 180.0;
        for (int row = 0; row < height; ++row) {
            const double latitude = kPi * (0.5 - (row + 0.5) / height);
            for (int column = 0; column < width; ++column) {
                const double longitude = 2.0 * kPi * ((column + 0.5) / width - 0.5);
                const double cosine =
                    std::sin(latitude) * std::sin(sunLatitude) +
                    std::cos(latitude) * std::cos(sunLatitude) * std::cos(longitude - sunLongitude);
                image.at(column, row) = cosine > std::cos(kSunRadius) ? glm::vec3(kSunRadiance)
                                                                      : detail(column, row, height);
            }
        }
        tukor::saveImage(argv[1], image);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "detailed_map: %s\n", error.what());
        return 1;
    }
}
