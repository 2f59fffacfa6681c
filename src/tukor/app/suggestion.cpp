#include "tukor/app/suggestion.h"

#include <fmt/format.h>

#include "tukor/base/spelling.h"

namespace tukor {

std::string unknownName(std::string_view name, std::span<const std::string_view> known) {
    const std::string_view nearest = nearestName(name, known);
    return fmt::format("'{}' is unknown; {}known are: {}", name.substr(0, 60),
                       nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest),
                       fmt::join(known, ", "));
}

std::string unknownInModel(std::string_view kind, std::string_view name,
                           std::span<const std::string_view> known) {
    if (known.empty())
        return fmt::format("{} '{}': the model has no {}s", kind, name.substr(0, 60), kind);
    return fmt::format("{} {}", kind, unknownName(name, known));
}

}  // namespace tukor
