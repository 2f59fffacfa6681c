#include "tukor/app/version.h"

namespace tukor {

std::string versionText() {
    const std::string commit = TUKOR_COMMIT;
    return commit.empty() ? TUKOR_VERSION : std::string(TUKOR_VERSION) + " (" + commit + ")";
}

}  // namespace tukor
