// Pictures of which something else is given: Van Cittert's steps, with momentum.
#pragma once
#include <functional>

#include "tukor/base/progress.h"
#include "tukor/image/image.h"

namespace tukor {

/// What has to be added to a picture for what is made of it to be what is given, as far as that
/// can be said at once; negative where there is too much. Empty where `progress` asked to stop.
using Missing = std::function<Image(const Image& picture, const Progress& progress)>;

/// The picture after so many times that what was missing has been added [Van Cittert 1931], each
/// time to where the last two point [Biggs & Andrews 1997]. At once no pixel falls below a quarter
/// of itself: nothing becomes negative that was not [Jansson 1970], and what was too dark can rise.
[[nodiscard]] Image afterSteps(int steps, Image picture, const Missing& missing,
                               const Progress& progress);

}  // namespace tukor
