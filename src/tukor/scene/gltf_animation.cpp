#include "tukor/scene/gltf_animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tukor/base/error.h"
#include "tukor/scene/gltf_accessor.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

constexpr std::size_t kMostWeights = 1024;

/// The interval of `times` around a moment and the place within it.
struct Moment {
    std::size_t before;
    std::size_t after;
    double share;
    double length;  // seconds
};

Moment momentIn(const GltfAccessor& times, double seconds) {
    const std::size_t count = times.count();
    std::size_t low = 0, high = count;  // the first time beyond the moment lies in [low, high]
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (static_cast<double>(times.vec4(middle).x) > seconds)
            high = middle;
        else
            low = middle + 1;
    }
    if (low == 0) return {0, 0, 0.0, 0.0};
    if (low == count) return {count - 1, count - 1, 0.0, 0.0};
    const auto from = static_cast<double>(times.vec4(low - 1).x);
    const auto to = static_cast<double>(times.vec4(low).x);
    return {low - 1, low, to > from ? (seconds - from) / (to - from) : 0.0, to - from};
}

enum class Interpolation { step, linear, cubic };

Interpolation interpolationOf(const JsonItem& sampler) {
    const std::string name = sampler.textOr("interpolation", "LINEAR");
    if (name == "STEP") return Interpolation::step;
    if (name == "LINEAR") return Interpolation::linear;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    sampler.fail(
        fmt::format("interpolation '{}'; expected STEP, LINEAR or CUBICSPLINE", printable(name)));
}

glm::dquat quatOf(glm::dvec4 v) noexcept {
    const glm::dquat q(v.w, v.x, v.y, v.z);
    const double length = glm::length(q);
    return length > 0.0 ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

class Sampler {
public:
    Sampler(const GltfDocument& document, const JsonItem& sampler, double seconds)
        : item_(sampler),
          interpolation_(interpolationOf(sampler)),
          values_(document, sampler.at("output").count(), sampler) {
        const GltfAccessor times(document, sampler.at("input").count(), sampler);
        times.requireComponents(1, 1);
        if (times.count() == 0) sampler.fail("no moments");
        count_ = times.count();
        moment_ = momentIn(times, seconds);
    }

    /// Values of one moment that belong together: 1, or the number of weights.
    [[nodiscard]] std::size_t width() const {
        const std::size_t parts = interpolation_ == Interpolation::cubic ? 3 : 1;
        if (values_.count() % (count_ * parts) != 0)
            item_.fail(fmt::format("{} values for {} moments", values_.count(), count_));
        return values_.count() / (count_ * parts);
    }

    [[nodiscard]] glm::dvec4 value(std::size_t index, std::size_t width, bool turns) const {
        const auto at = [&](std::size_t moment, std::size_t part) {
            const std::size_t parts = interpolation_ == Interpolation::cubic ? 3 : 1;
            return glm::dvec4(values_.vec4((moment * parts + part) * width + index));
        };
        const double t = moment_.share;
        if (interpolation_ == Interpolation::cubic) {
            const glm::dvec4 a = at(moment_.before, 1), b = at(moment_.after, 1);
            const glm::dvec4 out = at(moment_.before, 2) * moment_.length;
            const glm::dvec4 in = at(moment_.after, 0) * moment_.length;
            const double t2 = t * t, t3 = t2 * t;
            return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * out + (3 * t2 - 2 * t3) * b +
                   (t3 - t2) * in;
        }
        const glm::dvec4 a = at(moment_.before, 0);
        if (interpolation_ == Interpolation::step || t == 0.0) return a;
        const glm::dvec4 b = at(moment_.after, 0);
        if (!turns) return glm::mix(a, b, t);
        const glm::dquat q = glm::slerp(quatOf(a), quatOf(b), t);
        return {q.x, q.y, q.z, q.w};
    }

    void requireComponents(int count) const { values_.requireComponents(count, count); }

private:
    JsonItem item_;
    Interpolation interpolation_;
    GltfAccessor values_;
    std::size_t count_ = 0;
    Moment moment_{};
};

void apply(const Sampler& sampler, const JsonItem& target, GltfNodePose& pose) {
    const std::string path(target.at("path").text());
    const std::size_t width = sampler.width();
    if (path == "weights") {
        sampler.requireComponents(1);
        if (width > kMostWeights)
            target.fail(fmt::format("{} weights; at most {} are read", width, kMostWeights));
        pose.weights.resize(width);
        for (std::size_t i = 0; i < width; ++i) pose.weights[i] = sampler.value(i, width, false).x;
        return;
    }
    if (width != 1) target.fail("several values at one moment");
    sampler.requireComponents(path == "rotation" ? 4 : 3);
    const glm::dvec4 value = sampler.value(0, 1, path == "rotation");
    if (path == "translation")
        pose.translation = glm::dvec3(value);
    else if (path == "rotation")
        pose.rotation = quatOf(value);
    else if (path == "scale")
        pose.scale = glm::dvec3(value);
}

JsonItem chosen(const GltfDocument& document, const JsonList& animations, std::string_view which) {
    if (which.empty()) return animations[0];
    std::vector<std::string> known;
    for (const JsonItem animation : animations) {
        if (animation.textOr("name", "") == which) return animation;
        known.push_back(printable(animation.textOr("name", "")));
    }
    for (std::size_t i = 0; i < animations.size(); ++i)
        if (fmt::format("{}", i) == which) return animations[i];
    throw Error(fmt::format("{}: no animation '{}'; there are {}", document.name(),
                            printable(which), fmt::join(known, ", ")));
}

}  // namespace

GltfPose poseAt(const GltfDocument& document, std::string_view which, double seconds) {
    GltfPose pose;
    const JsonList animations = document.root().list("animations");
    if (animations.empty()) return pose;
    const JsonItem animation = chosen(document, animations, which);
    const JsonList samplers = animation.list("samplers");
    for (const JsonItem channel : animation.list("channels")) {
        const JsonItem target = channel.at("target");
        const std::optional<JsonItem> node = target.find("node");
        if (!node) continue;  // of an extension
        const std::size_t sampler = channel.at("sampler").count();
        if (sampler >= samplers.size())
            channel.fail(
                fmt::format("refers to samplers[{}]; there are {}", sampler, samplers.size()));
        apply(Sampler(document, samplers[sampler], seconds), target, pose[node->count()]);
    }
    return pose;
}

double secondsOf(const GltfDocument& document, std::string_view which) {
    const JsonList animations = document.root().list("animations");
    bool known = which.empty() && !animations.empty();
    for (std::size_t i = 0; i < animations.size(); ++i)
        known = known || animations[i].textOr("name", "") == which || fmt::format("{}", i) == which;
    if (!known) return 0.0;
    double seconds = 0.0;
    for (const JsonItem sampler : chosen(document, animations, which).list("samplers")) {
        const GltfAccessor times(document, sampler.at("input").count(), sampler);
        if (times.count() == 0) continue;
        seconds = std::max(seconds, static_cast<double>(times.vec4(times.count() - 1).x));
    }
    return seconds;
}

}  // namespace tukor
