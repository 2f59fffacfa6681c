// One picture by ray tracing on all cores: what `tukor render` calls.
#pragma once
#include "tukor/environment/environment.h"
#include "tukor/scene/render_options.h"
#include "tukor/scene/scene.h"

namespace tukor::trace {

/// The same picture for any number of threads, unless `timeSeconds` or `progress` ends it early:
/// then with the samples so far.
///
/// With neither `samples`, `error` nor `timeSeconds`, samples are added where they are worth most
/// until the expected RMSE is below 1 in 8-bit sRGB, at most 64 a pixel. Throws Error.
[[nodiscard]] Rendering render(const Scene& scene, const CubeMap& environment, const Camera& camera,
                               const RenderOptions& options = {},
                               const RenderProgress& progress = {});
/// Under an equirectangular panorama, without a cube map between.
[[nodiscard]] Rendering render(const Scene& scene, const Image& panorama, const Camera& camera,
                               const RenderOptions& options = {},
                               const RenderProgress& progress = {});
/// Under the environment's panorama if it has one, else its cube map.
[[nodiscard]] Rendering render(const Scene& scene, const Environment& environment,
                               const Camera& camera, const RenderOptions& options = {},
                               const RenderProgress& progress = {});

}  // namespace tukor::trace
