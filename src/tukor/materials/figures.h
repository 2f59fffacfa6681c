// What readers of `--material` share: figures from text, and messages about them.
#pragma once
#include <string>
#include <string_view>

#include <glm/glm.hpp>

namespace tukor {

/// As messages quote it, not without end.
[[nodiscard]] std::string shown(std::string_view text);

/// One number for all channels, or three. `whole` opens the message of the Error.
[[nodiscard]] glm::vec3 parseColour(std::string_view text, std::string_view whole);

/// Throws Error unless all are from `least` to `most`: "material 'NAME': FIGURE 2; expected 0 to
/// 1".
void checkRange(std::string_view name, std::string_view figure, glm::vec3 values, float least,
                float most);

}  // namespace tukor
