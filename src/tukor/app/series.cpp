#include "tukor/app/series.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "tukor/app/session.h"
#include "tukor/base/error.h"
#include "tukor/scene/model_file.h"

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

constexpr double kMostPictures = 1e6;

double secondsOf(const SubjectOptions& subject) {
    double longest = 0.0;
    for (const std::string& model : subject.models)
        longest = std::max(longest, animationSeconds(model, subject.animation));
    return longest;
}

}  // namespace

Series::Series(const SeriesOptions& series, const SessionOptions& options)
    : options_(series), first_(options) {
    if (series.fps) {
        const double whole = secondsOf(options.subject);
        if (!(whole > 0.0) && options.subject.animation.empty())
            throw Error(fmt::format("fps {}: the model has no animation (those of glTF are shown)",
                                    *series.fps));
        const double start = options.subject.timeSeconds.value_or(0.0f);
        first_.subject.timeSeconds = static_cast<float>(start);
        seconds_ = std::max(whole - start, 0.0);
        const double pictures = std::round(seconds_ * static_cast<double>(*series.fps));
        if (!(pictures <= kMostPictures))
            throw Error(fmt::format("fps {}: {:.0f} pictures of {:.0f} s; at most {:.0f}",
                                    *series.fps, pictures, seconds_, kMostPictures));
        count_ = std::max(static_cast<int>(pictures), 1);
    }
    count_ = series.turntable.value_or(count_);
}

SessionOptions Series::optionsOf(int index, const Camera& camera,
                                 std::optional<float> ground) const {
    if (index == 0) return first_;
    SessionOptions next = first_;
    if (first_.camera.camera.empty())  // a camera of the file may move with it
        next.camera = optionsFromCamera(camera, first_.camera);
    if (options_.turntable) next = turntableOptions(first_, camera, index, *options_.turntable);
    if (options_.fps) {
        const double gone = index / static_cast<double>(*options_.fps);
        const double start = *first_.subject.timeSeconds;
        next.subject.timeSeconds =
            static_cast<float>(start + (seconds_ > 0.0 ? std::fmod(gone, seconds_) : 0.0));
        if (ground) next.light.ground = fmt::format("{}", *ground);  // `lowest` would rise and sink
    }
    return next;
}

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
