#include "tukor/environment/sun.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "tukor/environment/equirect.h"

namespace tukor {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostRadius = 0.052;  // 3 degrees: beyond that it is a window or a lamp nearby
constexpr double kSkyRadius = 0.12;    // 7 degrees: where the sky around it is measured

float luminanceOf(glm::vec3 radiance) {
    return glm::dot(radiance, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

glm::vec3 directionOf(const Image& image, int column, int row) {
    return directionFromEquirect(
        {(static_cast<float>(column) + 0.5f) / static_cast<float>(image.width()),
         (static_cast<float>(row) + 0.5f) / static_cast<float>(image.height())});
}

double solidAngleOf(const Image& image, int row) {
    return 2.0 * kPi / image.width() *
           (std::cos(kPi * row / image.height()) - std::cos(kPi * (row + 1) / image.height()));
}

/// Calls visit(column, row, angle) for the pixels within an angle of a direction.
template <class Visit>
void visitAround(const Image& image, glm::vec3 direction, double radius, const Visit& visit) {
    const double theta = std::acos(std::clamp(static_cast<double>(direction.y), -1.0, 1.0));
    const int first = std::max(0, static_cast<int>((theta - radius) / kPi * image.height()) - 1);
    const int last =
        std::min(image.height() - 1, static_cast<int>((theta + radius) / kPi * image.height()) + 1);
    for (int row = first; row <= last; ++row)
        for (int column = 0; column < image.width(); ++column) {
            // By the chord: the cosine of a small angle has no digits left in a float.
            const float chord = glm::length(directionOf(image, column, row) - direction);
            const double angle = 2.0 * std::asin(std::min(0.5 * static_cast<double>(chord), 1.0));
            if (angle <= radius) visit(column, row, angle);
        }
}

/// Whether nothing outside the sky around it is more than half as bright: of several lamps none is
/// the sun.
bool isAlone(const Image& image, glm::vec3 direction, float luminance) {
    const auto leastCosine = static_cast<float>(std::cos(kSkyRadius));
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column)
            if (luminanceOf(image.at(column, row)) > 0.5f * luminance &&
                glm::dot(directionOf(image, column, row), direction) < leastCosine)
                return false;
    return true;
}

glm::vec3 skyAround(const Image& image, glm::vec3 direction) {
    std::vector<glm::vec3> ring;
    visitAround(image, direction, kSkyRadius, [&](int column, int row, double angle) {
        if (angle > kMostRadius) ring.push_back(image.at(column, row));
    });
    if (ring.empty()) return glm::vec3(0.0f);
    const auto middle = ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2);
    std::nth_element(ring.begin(), middle, ring.end(),
                     [](glm::vec3 a, glm::vec3 b) { return luminanceOf(a) < luminanceOf(b); });
    return *middle;
}

}  // namespace

std::optional<Sun> findSun(const Image& panorama) {
    int brightestColumn = 0, brightestRow = 0;
    float most = -1.0f;
    double mean = 0.0;
    for (int row = 0; row < panorama.height(); ++row)
        for (int column = 0; column < panorama.width(); ++column) {
            const float luminance = luminanceOf(panorama.at(column, row));
            mean += static_cast<double>(luminance) * solidAngleOf(panorama, row) / (4.0 * kPi);
            if (luminance <= most) continue;
            most = luminance;
            brightestColumn = column;
            brightestRow = row;
        }
    const glm::vec3 peak = directionOf(panorama, brightestColumn, brightestRow);
    const glm::vec3 sky = skyAround(panorama, peak);
    const float skyLuminance = luminanceOf(sky);
    const auto meanLuminance = static_cast<float>(mean);
    if (!(most > 0.0f) || most < 10.0f * skyLuminance || most < 10.0f * meanLuminance ||
        !isAlone(panorama, peak, most))
        return std::nullopt;

    // What stands out of the sky by a twentieth of the peak belongs to the sun; a wide light has as
    // much just outside the largest sun as inside.
    const float threshold = skyLuminance + 0.05f * (most - skyLuminance);
    double outside = 0.0, inside = 0.0, spread = 0.0;
    glm::dvec3 irradiance(0.0), direction(0.0);
    const auto excessAt = [&](int column, int row) {
        return glm::max(panorama.at(column, row) - sky, glm::vec3(0.0f));
    };
    visitAround(panorama, peak, kSkyRadius, [&](int column, int row, double angle) {
        if (luminanceOf(panorama.at(column, row)) < threshold) return;
        const double weight = solidAngleOf(panorama, row);
        const glm::vec3 excess = excessAt(column, row);
        const double flux = weight * static_cast<double>(luminanceOf(excess));
        (angle <= kMostRadius ? inside : outside) += flux;
        if (angle > kMostRadius) return;
        irradiance += weight * glm::dvec3(excess);
        direction += flux * glm::dvec3(directionOf(panorama, column, row));
    });
    if (outside > 0.1 * inside) return std::nullopt;
    const glm::vec3 middle(glm::normalize(direction));
    visitAround(panorama, middle, kMostRadius, [&](int column, int row, double angle) {
        if (luminanceOf(panorama.at(column, row)) < threshold) return;
        spread += solidAngleOf(panorama, row) *
                  static_cast<double>(luminanceOf(excessAt(column, row))) * angle * angle;
    });
    // A uniform disc of radius r has a mean square distance of r^2 / 2 from its middle; pixels add
    // their own.
    const double pixel = kPi / panorama.height();
    const double radius = std::sqrt(2.0 * spread / inside + pixel * pixel / (3.0 * kPi));
    return Sun{middle, static_cast<float>(radius), glm::vec3(irradiance), sky,
               most / std::max(skyLuminance, 1e-30f)};
}

Image withoutSun(Image panorama, const Sun& sun) {
    const float limit = 2.0f * luminanceOf(sun.skyRadiance);
    // Lens and resampling spread a sun over a pixel or two around it.
    const double radius = std::min(
        kMostRadius, 1.5 * static_cast<double>(sun.angularRadius) + 2.0 * kPi / panorama.height());
    visitAround(panorama, sun.direction, radius, [&](int column, int row, double) {
        if (luminanceOf(panorama.at(column, row)) > limit)
            panorama.at(column, row) = sun.skyRadiance;
    });
    return panorama;
}

std::string jsonOf(const Sun& sun) {
    const auto list = [](glm::vec3 v) {
        return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x, v.y, v.z);
    };
    return fmt::format(
        "{{\n  \"direction\": {},\n  \"angularRadiusDegrees\": {:.4g},\n  \"irradiance\": {},\n"
        "  \"skyRadiance\": {}\n}}\n",
        list(sun.direction), static_cast<double>(sun.angularRadius) * 180.0 / kPi,
        list(sun.irradiance), list(sun.skyRadiance));
}

}  // namespace tukor
