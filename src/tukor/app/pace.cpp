#include "tukor/app/pace.h"

#include <algorithm>
#include <cmath>

namespace tukor {

namespace {

constexpr double kFrameTime = 1.0 / 30.0;
constexpr double kRays = 8.0;  // what is lost beyond, in a glass knot, few eyes find in motion
constexpr double kFewestRays = 3.0;  // in, on to the far side, and out of a glass ball
constexpr double kHalfSize = 0.5;
constexpr double kLeastSize = 0.2;  // of width and height: still a picture

// Where the next of the four measures has to be taken.
constexpr double kHalved = kHalfSize * kHalfSize;
constexpr double kShortened = kHalved * kFewestRays / kRays;
constexpr double kLeastEffort = kShortened * (kLeastSize / kHalfSize) * (kLeastSize / kHalfSize);
constexpr double kMostEffort = 16.0;  // 128 rays, the budget at rest

}  // namespace

RenderOptions Pace::whileMoving(const RenderOptions& rest) const noexcept {
    double size = 1.0;
    double rays = kRays * std::max(effort_, 1.0);
    if (effort_ < kShortened) {
        size = kHalfSize * std::sqrt(effort_ / kShortened);
        rays = kFewestRays;
    } else if (effort_ < kHalved) {
        size = kHalfSize;
        rays = kRays * effort_ / kHalved;
    } else if (effort_ < 1.0) {
        size = std::sqrt(effort_);
        if (size > 0.9) size = 1.0;  // nearly sharp looks worse than sharp
    }
    RenderOptions moving = rest;
    moving.samples = 1;
    moving.width = std::max(1, static_cast<int>(std::lround(size * rest.width)));
    moving.height = std::max(1, static_cast<int>(std::lround(size * rest.height)));
    moving.rayBudget = std::min(rest.rayBudget, static_cast<int>(std::lround(rays)));
    // 1e-2 with 8 rays, 1e-3 with 80: lighter branches are not worth what they take from others.
    if (moving.rayBudget < rest.rayBudget)
        moving.weightCutoff = std::max(rest.weightCutoff, 0.08f / static_cast<float>(rays));
    return moving;
}

void Pace::took(double seconds) noexcept {
    // Half of the way each time, as ratios go, or it would swing.
    const double wanted = effort_ * std::sqrt(kFrameTime / std::max(seconds, 1e-4));
    effort_ = std::clamp(wanted, kLeastEffort, kMostEffort);
}

}  // namespace tukor
