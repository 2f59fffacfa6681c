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

}  // namespace tukor
