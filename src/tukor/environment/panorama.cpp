#include "tukor/environment/panorama.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_axes.h"
#include "tukor/environment/cube_function.h"
#include "tukor/environment/cube_look_up.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/grid_point.h"
#include "tukor/environment/unblurred.h"
#include "tukor/environment/van_cittert.h"

namespace tukor {

namespace {

constexpr double kPi = std::numbers::pi;

/// Fills a picture with means of `across` x `across` values of radiance(u, v), u and v in [0, 1].
template <int across = 3, class Radiance>
Image pictureOf(int width, int height, const Radiance& radiance) {
    Image image(width, height);
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < width; ++column) {
                glm::vec3 sum(0.0f);
                for (int i = 0; i < across * across; ++i) {
                    const glm::vec2 at =
                        (glm::vec2(column, row) + gridPoint(i, across)) / glm::vec2(width, height);
                    sum += radiance(at.x, at.y);
                }
                image.at(column, row) = sum / static_cast<float>(across * across);
            }
    });
    return image;
}

glm::vec3 directionFromOctahedral(float u, float v) {
    glm::vec3 p(2.0f * u - 1.0f, 0.0f, 2.0f * v - 1.0f);
    p.y = 1.0f - std::abs(p.x) - std::abs(p.z);
    if (p.y < 0.0f) {
        const float x = p.x;
        p.x = (1.0f - std::abs(p.z)) * (x < 0.0f ? -1.0f : 1.0f);
        p.z = (1.0f - std::abs(x)) * (p.z < 0.0f ? -1.0f : 1.0f);
    }
    return p;
}

glm::vec2 octahedralFromDirection(glm::vec3 d) {
    d /= std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    if (d.y < 0.0f) {
        const float x = d.x;
        d.x = (1.0f - std::abs(d.z)) * (x < 0.0f ? -1.0f : 1.0f);
        d.z = (1.0f - std::abs(x)) * (d.z < 0.0f ? -1.0f : 1.0f);
    }
    return {0.5f * d.x + 0.5f, 0.5f * d.z + 0.5f};
}

/// Bilinear, clamped at the border.
glm::vec3 valueAt(const Image& image, glm::vec2 place) {
    const float x = std::clamp(place.x * static_cast<float>(image.width()) - 0.5f, 0.0f,
                               static_cast<float>(image.width() - 1));
    const float y = std::clamp(place.y * static_cast<float>(image.height()) - 0.5f, 0.0f,
                               static_cast<float>(image.height() - 1));
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const int nextColumn = std::min(column + 1, image.width() - 1);
    const int nextRow = std::min(row + 1, image.height() - 1);
    const float right = x - static_cast<float>(column), down = y - static_cast<float>(row);
    return glm::mix(glm::mix(image.at(column, row), image.at(nextColumn, row), right),
                    glm::mix(image.at(column, nextRow), image.at(nextColumn, nextRow), right),
                    down);
}

glm::vec2 ballFromDirection(glm::vec3 d, int width) {
    // The normal lies half way to the camera; where the ball hides the scene behind it, its rim.
    const glm::vec3 half = d + glm::vec3(0.0f, 0.0f, 1.0f);
    const float length = std::max(glm::length(half), 1e-4f);
    const float inside = 1.0f - 1.5f / static_cast<float>(width);
    glm::vec2 p = glm::vec2(half.x, half.y) / length;
    p *= std::min(1.0f, inside / std::max(glm::length(p), 1e-6f));
    return {0.5f + 0.5f * p.x, 0.5f - 0.5f * p.y};
}

std::optional<glm::vec3> directionFromBall(float u, float v) {
    const float x = 2.0f * u - 1.0f, y = 1.0f - 2.0f * v;
    const float z2 = 1.0f - x * x - y * y;
    if (z2 < 0.0f) return std::nullopt;
    const float z = std::sqrt(z2);
    return glm::vec3(2.0f * z * x, 2.0f * z * y, 2.0f * z * z - 1.0f);
}

/// The panorama of which a square picture of the sphere comes near this one: `place` is where in
/// the picture a direction lies, `made` the picture of a cube map.
Image panoramaWithPicture(int steps, const Image& picture, int width, auto&& place, auto&& made,
                          const Progress& progress) {
    const int edge = picture.width(), height = std::max(1, width / 2);
    const auto means = [&](const Image& square) {
        return pictureOf(width, height, [&](float u, float v) {
            return valueAt(square, place(directionFromEquirect({u, v})));
        });
    };
    const auto missing = [&](const Image& panorama, const Progress& part) {
        if (part && !part(0.0f)) return Image();
        Image square = made(cubeFromEquirect(panorama, facesBeside(edge)), edge);
        for (std::size_t i = 0; i < square.pixels().size(); ++i)
            square.pixels()[i] = picture.pixels()[i] - square.pixels()[i];
        return sharpened(means(square));
    };
    return afterSteps(steps, unblurred(means(picture)), missing, progress);
}

}  // namespace

Image turnedPanorama(const Image& panorama, double radians) {
    // Longitude grows clockwise seen from above: what was at column c goes to c - shift.
    const int width = panorama.width();
    const double shift = radians / (2.0 * kPi) * width;
    double whole = std::floor(shift);
    auto part = static_cast<float>(shift - whole);
    if (part < 1e-4f) part = 0.0f;
    if (part > 1.0f - 1e-4f) {
        part = 0.0f;
        whole += 1.0;
    }
    const int offset = static_cast<int>(std::fmod(whole, width)) + width;
    Image turned(width, panorama.height());
    for (int row = 0; row < panorama.height(); ++row)
        for (int column = 0; column < width; ++column) {
            const glm::vec3 pixel = panorama.at((column + offset) % width, row);
            turned.at(column, row) =
                part == 0.0f
                    ? pixel
                    : glm::mix(pixel, panorama.at((column + offset + 1) % width, row), part);
        }
    return turned;
}

CubeMap turnedCube(const CubeMap& cube, double radians) {
    const double quarters = radians / (0.5 * kPi);
    if (std::abs(quarters - std::round(quarters)) < 1e-9) {
        CubeAxes axes = worldCubeAxes();
        for (int i = static_cast<int>(std::lround(quarters)) & 3; i > 0; --i)
            axes = mapped(axes, [](glm::ivec3 a) { return glm::ivec3(-a.z, a.y, a.x); });
        return storedCube(cube, axes);
    }
    const auto c = static_cast<float>(std::cos(radians)), s = static_cast<float>(std::sin(radians));
    const auto radiance = [&](glm::vec3 d) {
        return cube.radiance({c * d.x - s * d.z, d.y, s * d.x + c * d.z});
    };
    return cubeFromFunction(cube.faceSize(), [&](Cone) { return radiance; });
}

int facesBeside(int edge) noexcept {
    constexpr int kFine = 2048;
    return std::max(std::min(edge, kFine), std::max(1, edge / 2));
}

Image octahedralFromCube(const CubeMap& cube, int size) {
    const CubeLookUp radiance(cube);
    return pictureOf(size, size, [&](float u, float v) {
        return vec3FromFloat4(radiance(directionFromOctahedral(u, v)));
    });
}

Image ballFromCube(const CubeMap& cube, int size) {
    const CubeLookUp radiance(cube);
    return pictureOf(size, size, [&](float u, float v) {
        const std::optional<glm::vec3> d = directionFromBall(u, v);
        return d ? vec3FromFloat4(radiance(*d)) : glm::vec3(0.0f);
    });
}

CubeMap cubeFromOctahedral(const Image& picture, int faceSize) {
    const auto radiance = [&](glm::vec3 d) { return valueAt(picture, octahedralFromDirection(d)); };
    return cubeFromFunction(faceSize, [&](Cone) { return radiance; });
}

CubeMap cubeFromBall(const Image& picture, int faceSize) {
    const auto radiance = [&](glm::vec3 d) {
        return valueAt(picture, ballFromDirection(d, picture.width()));
    };
    return cubeFromFunction(faceSize, [&](Cone) { return radiance; });
}

Image panoramaFromOctahedral(const Image& picture, int width, const Progress& progress) {
    return panoramaWithPicture(8, picture, width, octahedralFromDirection, octahedralFromCube,
                               progress);
}

Image panoramaFromBall(const Image& picture, int width, const Progress& progress) {
    // Few: what lies behind the ball is a thin ring along its rim, and would be made up.
    return panoramaWithPicture(
        3, picture, width, [&](glm::vec3 d) { return ballFromDirection(d, picture.width()); },
        ballFromCube, progress);
}

}  // namespace tukor
