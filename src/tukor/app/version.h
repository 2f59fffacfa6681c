// Which build this is: what --version prints and every picture's metadata carries.
#pragma once
#include <string>

namespace tukor {

/// `0.1.0 (1a2af65)`: the release, and the commit it was configured from if that is known.
[[nodiscard]] std::string versionText();

}  // namespace tukor
