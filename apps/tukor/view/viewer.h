// The window's program: turns input into options, options into frames.
#pragma once
#include "tukor/app/options.h"

namespace tukor {

/// Opens a window and returns when it is closed: the exit status. Throws Error for what is wrong
/// with the options, or when there is no display.
[[nodiscard]] int runViewer(const SessionOptions& options);

}  // namespace tukor
