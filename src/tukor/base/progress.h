// How long work tells its caller how far it is, and is told to stop.
#pragma once
#include <functional>

namespace tukor {

/// Called from time to time with the finished fraction in [0, 1]; returning false asks the work to
/// stop early.
///
/// Calls come from one thread at a time. An empty function is allowed everywhere: nobody is
/// watching.
using Progress = std::function<bool(float fraction)>;

/// The progress of a piece of the work, which takes it from one fraction to another. `whole` must
/// outlive it.
[[nodiscard]] inline Progress partOf(const Progress& whole, float from, float to) {
    if (!whole) return {};
    return [&whole, from, to](float fraction) { return whole(from + (to - from) * fraction); };
}

}  // namespace tukor
