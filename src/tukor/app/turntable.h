// Pictures of a model that turns once around: what differs from one to the next.
#pragma once
#include <filesystem>

#include "tukor/app/options.h"
#include "tukor/scene/camera.h"

namespace tukor {

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
