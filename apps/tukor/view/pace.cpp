#include "view/pace.h"

#include <algorithm>
#include <cmath>

namespace tukor {

RenderOptions Pace::whileMoving(const RenderOptions& rest) const {
    RenderOptions moving = rest;
    moving.width = std::max(1, static_cast<int>(std::lround(scale_ * float(rest.width))));
    moving.height = std::max(1, static_cast<int>(std::lround(scale_ * float(rest.height))));
    // 7 rays a pixel on average; what is lost of a glass knot no eye finds in motion
    moving.rayBudget = std::min(rest.rayBudget, 8);
    moving.weightCutoff = std::max(rest.weightCutoff, 1e-2f);
    return moving;
}

void Pace::took(double seconds) noexcept {
    constexpr double kTarget = 1.0 / 30.0;
    // time goes with the area; half of the way each time, or it would swing
    const double wanted = scale_ * std::sqrt(kTarget / std::max(seconds, 1e-4));
    scale_ = std::clamp(0.5f * (scale_ + static_cast<float>(wanted)), 0.2f, 1.0f);
    if (scale_ > 0.9f) scale_ = 1.0f;  // nearly sharp looks worse than sharp
}

}  // namespace tukor
