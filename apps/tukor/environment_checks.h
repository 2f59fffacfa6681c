// Which options of `tukor environment` say nothing about what is written.
#pragma once
#include <optional>
#include <set>
#include <string>

#include "environment_actions.h"

namespace tukor {

/// Throws Error for one of the options `given` that belongs to something else than OUT, or than the
/// kind of filter; without one, OUT is converted.
void checkGiven(const std::set<std::string>& given, const std::string& out,
                std::optional<FilterKind> kind);

}  // namespace tukor
