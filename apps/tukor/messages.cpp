#include "messages.h"

#include <cstdio>
#include <set>
#include <string>

#include <fmt/format.h>

namespace tukor {

void warn(std::string_view message) {
    static std::set<std::string, std::less<>> said;
    if (said.emplace(message).second) fmt::print(stderr, "tukor: warning: {}\n", message);
}

}  // namespace tukor
