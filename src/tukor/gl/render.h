// One picture by OpenGL, without a window: what `tukor render --renderer gl` calls.
#pragma once
#include "tukor/environment/environment.h"
#include "tukor/scene/render_options.h"
#include "tukor/scene/scene.h"

namespace tukor::gl {

/// Renders in a headless context of its own; whatever context was current is current again after.
///
/// Samples are rounded up to a multiple of four at `single`; 8 when none are asked for. Told to
/// stop by `progress`, it returns the picture with the samples so far. Throws Error.
[[nodiscard]] Rendering render(const Scene& scene, const Environment& environment,
                               const Camera& camera, const RenderOptions& options,
                               const RenderProgress& progress = {});

}  // namespace tukor::gl
