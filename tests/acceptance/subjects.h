// What must show: the pictures whose closed form is known, and how near the renderers have to come.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "oracle/closed_form.h"
#include "tukor/environment/environment.h"
#include "tukor/scene/render_options.h"
#include "tukor/scene/scene.h"

namespace tukor::acceptance {

/// Which closed form a picture is measured against.
enum class Truth { background, reflecting, singleInterface, solid };

/// A sphere of some material, or nothing but the environment.
struct Subject {
    std::string material;  // empty: nothing
    Truth truth;
};

enum class Renderer { gl, trace };

/// One rendering of a subject and the largest RMSE it may have, in codes of 8-bit sRGB.
struct Trial {
    Subject subject;
    Renderer renderer;
    Fidelity fidelity;
    std::optional<int> samples;  // none: the renderer's default
    double limit;
};

/// All trials that this build's renderers can do; those of one subject follow each other.
[[nodiscard]] std::vector<Trial> trials();

[[nodiscard]] std::string describe(const Subject& subject);
[[nodiscard]] std::string describe(const Trial& trial);

/// The closed form, `samples` x `samples` per pixel.
[[nodiscard]] Image expected(const Subject& subject, const oracle::Environment& light,
                             const Camera& camera, int width, int height, int samples);

[[nodiscard]] Rendering rendered(const Trial& trial, const Environment& environment,
                                 const Camera& camera, int width, int height);

/// blender-data's eight panoramas that are installed, by path.
[[nodiscard]] std::vector<std::string> installedPanoramas();

}  // namespace tukor::acceptance
