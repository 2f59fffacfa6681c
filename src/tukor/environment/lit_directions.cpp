#include "tukor/environment/lit_directions.h"

#include <cmath>
#include <numbers>

#include "tukor/environment/cube_texel.h"
#include "tukor/environment/equirect.h"

namespace tukor {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

double brightness(glm::vec3 v) noexcept {
    return static_cast<double>(v.x) + v.y + v.z;
}

std::size_t reversedBits(std::size_t index, std::size_t count) noexcept {
    std::size_t reversed = 0;
    for (std::size_t bit = 1; bit < count; bit <<= 1, index >>= 1)
        reversed = 2 * reversed + (index & 1);
    return reversed;
}

/// `forAll` calls a function with the irradiance by every direction above the horizon, in an order
/// of neighbours, and a function for the direction.
template <class ForAll>
std::vector<LitDirection> chosen(const ForAll& forAll, std::span<const LitDirection> lamps,
                                 std::size_t count) {
    const auto visitAll = [&](const auto& visit) {
        for (const LitDirection& lamp : lamps)
            visit(lamp.irradiance, [&] { return lamp.direction; });
        forAll(visit);
    };
    glm::dvec3 sum(0.0);
    visitAll([&](glm::vec3 irradiance, const auto&) { sum += glm::dvec3(irradiance); });
    const double each = (sum.x + sum.y + sum.z) / static_cast<double>(count);
    if (!(each > 0.0)) return {};
    std::vector<LitDirection> all(count);
    glm::dvec3 found(0.0);
    double before = 0.0;
    std::size_t next = 0;
    visitAll([&](glm::vec3 irradiance, const auto& direction) {
        const double bright = brightness(irradiance);
        before += bright;
        for (; next < count && (static_cast<double>(next) + 0.5) * each < before; ++next) {
            LitDirection& one = all[reversedBits(next, count)];
            one = {direction(), irradiance * static_cast<float>(each / bright)};
            found += glm::dvec3(one.irradiance);
        }
    });
    // Their colours, too, are those of all together.
    const glm::vec3 factor(sum / glm::max(found, glm::dvec3(1e-300)));
    for (LitDirection& one : all) one.irradiance *= factor;
    return all;
}

}  // namespace

std::vector<LitDirection> litDirections(const Image& panorama, std::span<const LitDirection> lamps,
                                        std::size_t count) {
    const int width = panorama.width(), height = panorama.height();
    const auto forAll = [&](const auto& visit) {
        for (int row = 0; row < (height + 1) / 2; ++row) {
            const float top = kPi * static_cast<float>(row) / static_cast<float>(height);
            const float bottom = std::min(top + kPi / static_cast<float>(height), 0.5f * kPi);
            // Of cos over the solid angle of a pixel.
            const float weight =
                kPi / static_cast<float>(width) *
                (std::sin(bottom) * std::sin(bottom) - std::sin(top) * std::sin(top));
            for (int column = 0; column < width; ++column)
                visit(weight * panorama.at(column, row), [&] {
                    return directionFromEquirect((glm::vec2(column, row) + 0.5f) /
                                                 glm::vec2(width, height));
                });
        }
    };
    return chosen(forAll, lamps, count);
}

std::vector<LitDirection> litDirections(const CubeMap& cube, std::span<const LitDirection> lamps,
                                        std::size_t count) {
    const int size = cube.faceSize();
    const std::vector<float> solidAngles = faceSolidAngles(size);
    const auto forAll = [&](const auto& visit) {
        for (const CubeFace face : kCubeFaces)
            for (int row = 0; row < size; ++row)
                for (int column = 0; column < size; ++column) {
                    const glm::vec3 d =
                        glm::normalize(directionFromTexel({face, column, row}, size));
                    const auto texel =
                        static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                        static_cast<std::size_t>(column);
                    if (d.y > 0.0f)
                        visit(solidAngles[texel] * d.y * cube.texels(face)[texel],
                              [&] { return d; });
                }
    };
    return chosen(forAll, lamps, count);
}

}  // namespace tukor
