#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tukor/environment/cube_function.h"
#include "tukor/environment/cube_texel.h"
#include "tukor/environment/grid_point.h"
#include "tukor/environment/procedural.h"

namespace tukor {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kUnit = 25.0f;  // kcd/m^2 that become radiance 1

/// The Perez distribution of one quantity, relative to its value at the zenith.
struct Perez {
    float a, b, c, d, e;

    /// `cosTheta` from the zenith, `gamma` from the sun in radians.
    [[nodiscard]] float operator()(float cosTheta, float gamma, float cosGamma) const {
        return (1.0f + a * std::exp(b / cosTheta)) *
               (1.0f + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
    }
};

/// Sky luminance and chromaticity after Preetham, Shirley and Smits. [Preetham et al. 1999,
/// appendix A.2]
class PreethamSky {
public:
    PreethamSky(glm::vec3 sun, float turbidity) : sun_(sun) {
        const float t = turbidity;
        luminance_ = {0.1787f * t - 1.4630f, -0.3554f * t + 0.4275f, -0.0227f * t + 5.3251f,
                      0.1206f * t - 2.5771f, -0.0670f * t + 0.3703f};
        x_ = {-0.0193f * t - 0.2592f, -0.0665f * t + 0.0008f, -0.0004f * t + 0.2125f,
              -0.0641f * t - 0.8989f, -0.0033f * t + 0.0452f};
        y_ = {-0.0167f * t - 0.2608f, -0.0950f * t + 0.0092f, -0.0079f * t + 0.2102f,
              -0.0441f * t - 1.6537f, -0.0109f * t + 0.0529f};
        const float thetaSun = std::acos(std::clamp(sun.y, 0.0f, 1.0f));
        const float chi = (4.0f / 9.0f - t / 120.0f) * (kPi - 2.0f * thetaSun);
        const float zenithLuminance =
            (4.0453f * t - 4.9710f) * std::tan(chi) - 0.2155f * t + 2.4192f;
        const auto cubic = [&](float a, float b, float c, float d) {
            return ((a * thetaSun + b) * thetaSun + c) * thetaSun + d;
        };
        const float zenithX = t * t * cubic(0.00166f, -0.00375f, 0.00209f, 0.0f) +
                              t * cubic(-0.02903f, 0.06377f, -0.03202f, 0.00394f) +
                              cubic(0.11693f, -0.21196f, 0.06052f, 0.25886f);
        const float zenithY = t * t * cubic(0.00275f, -0.00610f, 0.00317f, 0.0f) +
                              t * cubic(-0.04214f, 0.08970f, -0.04153f, 0.00516f) +
                              cubic(0.15346f, -0.26756f, 0.06670f, 0.26688f);
        zenith_ = {std::max(zenithLuminance, 0.0f) / luminance_(1.0f, thetaSun, sun.y),
                   zenithX / x_(1.0f, thetaSun, sun.y), zenithY / y_(1.0f, thetaSun, sun.y)};
    }

    /// Linear Rec. 709, for a unit direction above the horizon; below it, the horizon's.
    [[nodiscard]] glm::vec3 operator()(glm::vec3 direction) const {
        const float cosTheta = std::max(direction.y, 0.01f);  // b / cosTheta has its pole at 0
        const float cosGamma = std::clamp(glm::dot(direction, sun_), -1.0f, 1.0f);
        const float gamma = std::acos(cosGamma);
        const float luminance = zenith_.x * luminance_(cosTheta, gamma, cosGamma) / kUnit;
        const float x = zenith_.y * x_(cosTheta, gamma, cosGamma);
        const float y = zenith_.z * y_(cosTheta, gamma, cosGamma);
        const float X = luminance * x / y, Z = luminance * (1.0f - x - y) / y;
        return glm::max(glm::vec3(3.2404542f * X - 1.5371385f * luminance - 0.4985314f * Z,
                                  -0.9692660f * X + 1.8760108f * luminance + 0.0415560f * Z,
                                  0.0556434f * X - 0.2040259f * luminance + 1.0572252f * Z),
                        glm::vec3(0.0f));
    }

private:
    glm::vec3 sun_;
    Perez luminance_{}, x_{}, y_{};
    glm::vec3 zenith_{};  // factors of luminance in kcd/m^2, x and y
};

/// Irradiance of the sun on a plane facing it, after Rayleigh scattering and haze.
/// [Preetham et al. 1999, appendix A.1]
glm::vec3 sunIrradiance(const SkyOptions& options) {
    const float zenithDegrees = 90.0f - options.sunElevation * 180.0f / kPi;
    const float airMass = 1.0f / (std::sin(options.sunElevation) +
                                  0.15f * std::pow(93.885f - zenithDegrees, -1.253f));
    const float beta = 0.04608f * options.turbidity - 0.04586f;
    const std::array<float, 3> wavelengths = {0.61f, 0.55f, 0.465f};  // micrometres: the primaries
    glm::vec3 transmittance;
    for (int i = 0; i < 3; ++i) {
        const float wavelength = wavelengths[static_cast<std::size_t>(i)];
        transmittance[i] = std::exp(-airMass * (0.008735f * std::pow(wavelength, -4.08f) +
                                                beta * std::pow(wavelength, -1.3f)));
    }
    return 128.0f / kUnit * transmittance;  // 128 klx reach the top of the atmosphere
}

}  // namespace

glm::vec3 sunDirection(const SkyOptions& options) noexcept {
    const float across = std::cos(options.sunElevation);
    return {across * std::sin(options.sunAzimuth), std::sin(options.sunElevation),
            across * std::cos(options.sunAzimuth)};
}

void addDisc(CubeMap& cube, glm::vec3 direction, float angularRadius, glm::vec3 radiance) {
    const glm::vec3 centre = glm::normalize(direction);
    const int size = cube.faceSize();
    const float step = 2.0f / static_cast<float>(size);
    const float edge = std::cos(angularRadius);
    const float reach =
        std::cos(std::min(angularRadius + 1.5f * step, kPi));  // disc and half a texel
    constexpr int kSamples = 32;  // squared: a texel on the rim is right to 1 %
    struct Part {
        CubeTexel texel;
        float cover;
    };
    std::vector<Part> parts;
    double solidAngle = 0.0;
    for (const CubeFace face : kCubeFaces)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const CubeTexel texel{face, column, row};
                const glm::vec3 middle = directionFromTexel(texel, size);
                if (glm::dot(middle, centre) < reach * glm::length(middle)) continue;
                double inside = 0.0, all = 0.0;
                for (int i = 0; i < kSamples * kSamples; ++i) {
                    const glm::vec2 at =
                        (glm::vec2(column, row) + gridPoint(i, kSamples)) * step - 1.0f;
                    const glm::vec3 sample = directionFromCube({face, at.x, at.y});
                    const double length = glm::length(sample);
                    const double weight = 1.0 / (length * length * length);
                    all += weight;
                    // By the chord, not the cosine: 1 - 1e-5 has no digits left in a float.
                    if (glm::length(sample / static_cast<float>(length) - centre) <
                        2.0f * std::sin(0.5f * angularRadius))
                        inside += weight;
                }
                if (inside <= 0.0) continue;
                parts.push_back({texel, static_cast<float>(inside / all)});
                solidAngle += inside / all * texelSolidAngle(size, column, row);
            }
    if (parts.empty()) {  // smaller than the distance of two samples
        const CubePoint point = cubeFromDirection(centre);
        const auto place = [&](float x) {
            return std::clamp(static_cast<int>((x + 1.0f) / step), 0, size - 1);
        };
        const CubeTexel texel{point.face, place(point.s), place(point.t)};
        parts.push_back({texel, 1.0f});
        solidAngle = texelSolidAngle(size, texel.column, texel.row);
    }
    const double wanted = 2.0 * std::numbers::pi * (1.0 - static_cast<double>(edge));
    const double exact = angularRadius < 0.1f
                             ? std::numbers::pi * 4.0 * std::pow(std::sin(0.5 * angularRadius), 2)
                             : wanted;
    const auto scale = static_cast<float>(exact / solidAngle);
    for (const Part& part : parts)
        cube.texels(
            part.texel.face)[static_cast<std::size_t>(part.texel.row * size + part.texel.column)] +=
            part.cover * scale * radiance;
}

CubeMap skyCube(int faceSize, const SkyOptions& options) {
    const glm::vec3 sun = sunDirection(options);
    const PreethamSky sky(sun, options.turbidity);
    const glm::vec3 sunlight = sunIrradiance(options);

    // Irradiance of the sky on the ground: 32 x 16 directions uniform in the projected disc.
    glm::vec3 skylight(0.0f);
    for (int i = 0; i < 512; ++i) {
        const float azimuth = 2.0f * kPi * (static_cast<float>(i % 32) + 0.5f) / 32.0f;
        const int ring = i / 32;
        const float radius2 = (static_cast<float>(ring) + 0.5f) / 16.0f;
        const float radius = std::sqrt(radius2);
        skylight += kPi / 512.0f *
                    sky({radius * std::sin(azimuth), std::sqrt(1.0f - radius2),
                         radius * std::cos(azimuth)});
    }
    const glm::vec3 earth = options.groundAlbedo * glm::vec3(1.0f, 0.93f, 0.82f);
    const glm::vec3 ground = earth / kPi * (sun.y * sunlight + skylight);

    const auto radiance = [&](glm::vec3 direction) {
        if (direction.y >= 0.0f) return sky(direction);
        if (direction.y < -0.5f) return ground;  // exp(-12.5): less than a half float's last digit
        // The farther the ground, the more air before it: the horizon is a haze, not an edge.
        const glm::vec3 horizon = sky(glm::vec3(direction.x, 0.0f, direction.z));
        return glm::mix(ground, 0.8f * horizon, std::exp(direction.y / 0.04f));
    };
    CubeMap cube = cubeFromFunction(faceSize, [&](Cone) { return radiance; });
    const float radius = std::min(kSunRadius * options.sunSize, 0.5f * kPi);
    const float solidAngle = 4.0f * kPi * std::pow(std::sin(0.5f * radius), 2.0f);
    addDisc(cube, sun, radius, sunlight / solidAngle);
    return cube;
}

}  // namespace tukor
