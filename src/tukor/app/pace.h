// How fine a picture may be while it changes: coarse enough to follow the hand.
#pragma once
#include "tukor/scene/render_options.h"

namespace tukor {

/// Holds the time of a frame near 1/30 s: by the rays that a pixel may spend and by resolution.
///
/// A fast machine gives whole light paths at full size; a slower one first shortens the paths, then
/// halves the size, then cuts the paths to the first few rays, then shrinks what is left.
class Pace {
public:
    /// What to draw while the picture changes, instead of `rest`: one sample a pixel.
    [[nodiscard]] RenderOptions whileMoving(const RenderOptions& rest) const noexcept;

    /// How long a frame of whileMoving() took, in seconds.
    void took(double seconds) noexcept;

private:
    double effort_ = 1.0;  // about in proportion to the time; 1: full size and 8 rays a pixel
};

}  // namespace tukor
