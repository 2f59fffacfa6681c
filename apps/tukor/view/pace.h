// How fine a picture may be while it changes: coarse enough to follow the hand.
#pragma once
#include <glm/glm.hpp>

#include "tukor/scene/render_options.h"

namespace tukor {

/// Holds the time of a frame near 1/30 s by its resolution, and limits the light paths meanwhile.
class Pace {
public:
    /// What to draw while the picture changes, instead of `rest`; the same when there is no need.
    [[nodiscard]] RenderOptions whileMoving(const RenderOptions& rest) const;

    /// How long a frame of whileMoving() took, in seconds.
    void took(double seconds) noexcept;

private:
    float scale_ = 1.0f;  // of width and height
};

}  // namespace tukor
