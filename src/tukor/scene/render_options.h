// What every renderer is asked: size, samples, fidelity, background. And what it gives back.
#pragma once
#include <cstdint>
#include <optional>

#include "tukor/base/options.h"
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

struct RenderOptions {
    int width = 1280;
    int height = 720;
    std::optional<int> samples;  // per pixel; none: the renderer's own choice
    Fidelity fidelity = Fidelity::exact;
    FresnelForm fresnel = FresnelForm::exact;
    Background background = Background::quad;
    float environmentRotation = 0.0f;   // radians about +Y, counter-clockwise seen from above
    float environmentIntensity = 1.0f;  // factor on radiance
    int rayBudget = 128;                // rays a camera ray may spend at `exact`
    float weightCutoff = 1e-3f;         // branches lighter than this become one look-up
    int maxDepth = 64;                  // events along one branch

    friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// A finished picture and what the renderer counted on the way.
struct Rendering {
    Image radiance;
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;  // rays that left a closed solid without crossing its surface
    std::uint64_t inconsistencies = 0;  // surfaces met from a side that the path says it is not on
    std::uint64_t truncated =
        0;  // branches that ended in a look-up because of budget, depth or cutoff
};

}  // namespace tukor
