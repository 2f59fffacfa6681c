// What every renderer is asked: size, samples, fidelity, background. And what it gives back.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tukor/base/options.h"
#include "tukor/image/exr_file.h"
#include "tukor/image/image.h"

namespace tukor {

/// The ladder. `two` is spelt "double" wherever a person reads it: C++ has taken the word.
enum class Fidelity {
    single,  // the lecture: one look-up along the reflected, one along the refracted direction of
             // the first surface
    two,     // a second interface, refracted out of the solid
    exact,   // the whole tree of reflections and refractions, inside and between objects
};

/// How the environment is drawn behind the model. Quad, box and dome give the same picture.
enum class Background { quad, box, dome, none };

/// Exact Fresnel equations, or the lecture's R0 + (1 - R0)(1 - cos)^5.
enum class FresnelForm { exact, schlick };

/// What else there is to know of each pixel's centre; a layer of the file beside the radiance.
enum class AovLayer {
    depth,     // metres from the eye to the first surface; 0 where there is none
    normal,    // its shading normal in world space, facing the eye
    material,  // 1 + the index of its part in the scene; 0 for the background
    bounces,   // events along the longest branch of the light path
};

struct RenderOptions {
    int width = 1280;
    int height = 720;
    std::optional<int> samples;  // per pixel; none: the renderer's own choice
    std::optional<float> error;  // go on until the picture's expected RMSE in 8-bit sRGB is below;
                                 // `samples` is then the most that a pixel gets (trace only)
    std::optional<float> timeSeconds;  // stop then, with the picture so far (trace only)
    std::uint32_t seed = 0;            // another one gives other noise of the same size
    Fidelity fidelity = Fidelity::exact;
    FresnelForm fresnel = FresnelForm::exact;
    Background background = Background::quad;
    float backgroundBlur = 0.0f;        // as a surface of this perceptual roughness shows it, to 1
    float environmentRotation = 0.0f;   // radians about +Y, counter-clockwise seen from above
    float environmentIntensity = 1.0f;  // factor on radiance
    int rayBudget = 128;                // rays a camera ray may spend at `exact`
    // Branches lighter than this become one look-up; where trace chooses by chance, 1e-5 at
    // most.
    float weightCutoff = 1e-4f;
    int maxDepth = 64;  // events along one branch
    // Where following both children of a branch gains less than this, as transport/path_tree.h
    // reckons it, one is, by chance; 0: always both (trace only).
    float splitGain = 0.01f;
    std::optional<float> ground;  // height in m of a plane that shows the environment behind it,
                                  // but for shadows on it and light that things throw
    // Whether a camera sample that grazes a curved surface is taken again as 16 finer ones: a pixel
    // at the rim of a glass ball shows a wide strip of the environment. trace: where `samples`
    // alone is given; gl: from 64 samples on.
    bool splitGrazing = true;
    // Whether a camera sample whose path lost track of its media, by rounding, is taken again a
    // little aside, where that is rare: where it is not, the model is at fault (trace only).
    bool retakeFaulty = true;
    // Whether the picture will be asked what is brighter than white, as radiance, darkened or tone
    // mapped: where not, no samples are spent on it (trace only).
    bool beyondWhite = true;
    std::vector<AovLayer> layers;  // trace only

    friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// Half the width of the ground, in radii of the scene.
inline constexpr float kGroundSize = 50.0f;

/// Whether the environment is seen blurred beside the scene.
[[nodiscard]] inline bool blursBackground(const RenderOptions& options) noexcept {
    return options.backgroundBlur > 0.0f && options.background != Background::none;
}

/// As Progress, with the rays so far beside the finished fraction; 0 where they are not counted.
using RenderProgress = std::function<bool(float fraction, std::uint64_t rays)>;

/// A finished picture and what the renderer counted on the way.
struct Rendering {
    Image radiance;
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;  // rays that left a closed solid without crossing its surface
    std::uint64_t inconsistencies = 0;  // surfaces met from a side that the path says it is not on
    std::uint64_t truncated =
        0;  // branches that ended in a look-up because of budget, depth or cutoff
    double samplesPerPixel = 0.0;    // mean over the picture
    std::optional<double> error;     // expected RMSE in 8-bit sRGB, where the renderer knows it
    std::optional<double> noise;     // the part of it that more samples take off
    std::vector<ImageLayer> layers;  // those asked for by RenderOptions::layers, same order
};

}  // namespace tukor
