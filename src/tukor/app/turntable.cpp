#include "tukor/app/turntable.h"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "tukor/app/session.h"

namespace tukor {
namespace {

/// About +Y, counter-clockwise seen from above.
struct Turn {
    double sine, cosine;

    explicit Turn(double radians) : sine(std::sin(radians)), cosine(std::cos(radians)) {}
    glm::vec3 operator()(glm::vec3 v) const noexcept {
        const glm::dvec3 d(v);
        return {cosine * d.x + sine * d.z, d.y, cosine * d.z - sine * d.x};
    }
};

std::string turnedLight(const std::string& text, const Turn& turn) {
    const glm::vec3 from = turn(-lightFromText(text).direction);
    const auto slash = text.find('/');
    return fmt::format("{},{},{}{}", from.x, from.y, from.z,
                       slash == text.npos ? std::string() : text.substr(slash));
}

}  // namespace

SessionOptions turntableOptions(const SessionOptions& options, const Camera& camera, int index,
                                int count) {
    if (index == 0) return options;
    const double degrees = -360.0 * index / count;
    const Turn turn(degrees * std::numbers::pi / 180.0);
    Camera turned = camera;
    turned.eye = camera.target + turn(camera.eye - camera.target);
    turned.up = turn(camera.up);
    SessionOptions next = options;
    next.camera = optionsFromCamera(turned, options.camera);
    next.light.rotationDegrees = static_cast<float>(
        std::remainder(static_cast<double>(options.light.rotationDegrees) + degrees, 360.0));
    for (std::string& light : next.light.lights) light = turnedLight(light, turn);
    return next;
}

std::filesystem::path numberedPath(const std::filesystem::path& path, int number) {
    std::string name = path.filename().string();
    const auto last = name.rfind('#');
    if (last == name.npos)
        return path.parent_path() /
               fmt::format("{}-{:04}{}", path.stem().string(), number, path.extension().string());
    auto first = last;
    while (first > 0 && name[first - 1] == '#') --first;
    name.replace(first, last - first + 1, fmt::format("{:0{}}", number, last - first + 1));
    return path.parent_path() / name;
}

}  // namespace tukor
