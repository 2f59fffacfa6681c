// Several pictures from one command: a model that turns, an animation that goes on.
#pragma once
#include <filesystem>
#include <optional>

#include "tukor/app/options.h"
#include "tukor/scene/camera.h"

namespace tukor {

struct SeriesOptions {
    std::optional<int> turntable{};  // pictures of one turn
    std::optional<float> fps{};      // pictures to the second of the animation

    friend bool operator==(const SeriesOptions&, const SeriesOptions&) = default;
};

template <OptionsOf<SeriesOptions> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("turntable", o.turntable, Measure<int>{"N", {2, 10000}},
          "N pictures of the model turning once around before a still camera in still light: OUT "
          "as turn-####.png, whose # become the number; without # turn.png is turn-0001.png and so "
          "on");
    field("fps", o.fps, Measure<float>{"F", {1e-3f, 1000.0f}, true},
          "F pictures to the second of a glTF model's animation, numbered likewise: from "
          "--time-seconds to its end, without the last moment, which in a loop is the first; with "
          "--turntable as many as that says, the animation beginning anew as often as it ends");
}

/// What is made of them.
class Series {
public:
    /// Throws Error where the model has no animation, or pictures would be too many.
    Series(const SeriesOptions& series, const SessionOptions& options);

    [[nodiscard]] bool several() const noexcept { return options_.turntable || options_.fps; }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] const SessionOptions& first() const noexcept { return first_; }
    /// The options of a picture, the first of which has number 0. `camera` and `ground` are those
    /// of the first.
    [[nodiscard]] SessionOptions optionsOf(int index, const Camera& camera,
                                           std::optional<float> ground) const;

private:
    SeriesOptions options_;
    SessionOptions first_;
    int count_ = 1;
    double seconds_ = 0.0;  // from the first picture's moment to the end of the animation
};

/// The options of picture `index` of `count`, the first being 0: the model stands turned,
/// counter-clockwise seen from above, about the vertical through the target of `camera`, which
/// stands still, as does the light.
///
/// The camera and the light are turned the other way; lamps of model files turn with the model.
[[nodiscard]] SessionOptions turntableOptions(const SessionOptions& options, const Camera& camera,
                                              int index, int count);

/// `turn-####.png` with a number in place of the last row of #, at least as many digits; without #
/// `turn.png` becomes `turn-0001.png`.
[[nodiscard]] std::filesystem::path numberedPath(const std::filesystem::path& path, int number);

}  // namespace tukor
