// The command line: help texts, usage errors, and which command is to run.
#pragma once
#include "command.h"

namespace tukor {

/// Parses all arguments, so that every usage error is met before any work is done, then runs the
/// command they name; without one, prints the help. Returns the exit status.
[[nodiscard]] int runCommandLine(const Command& program, int argc, const char* const* argv);

}  // namespace tukor
