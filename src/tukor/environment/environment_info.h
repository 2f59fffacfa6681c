// What is in an environment: figures for a terminal, and a picture of it.
#pragma once
#include <string>

#include "tukor/environment/environment_work.h"

namespace tukor {

/// Lines of text: layout, size, range, mean, repairs, sun, harmonics.
[[nodiscard]] std::string describeWork(WorkSource source);

/// Three exposures, two stops apart around the mean, and the six faces.
[[nodiscard]] Image contactSheet(WorkSource source);

}  // namespace tukor
