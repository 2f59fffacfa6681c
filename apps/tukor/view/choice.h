// A list of names as a widget.
#pragma once
#include <optional>
#include <string>
#include <utility>

#include <imgui.h>

namespace tukor {

/// Returns the name that was chosen. `current` may be none of them.
template <class Names>
[[nodiscard]] std::optional<std::string> choose(const char* label, const std::string& current,
                                                const Names& names) {
    std::optional<std::string> chosen;
    if (!ImGui::BeginCombo(label, current.c_str())) return chosen;
    for (const auto& candidate : names) {
        std::string name(candidate);
        if (ImGui::Selectable(name.c_str(), name == current)) chosen = std::move(name);
    }
    ImGui::EndCombo();
    return chosen;
}

}  // namespace tukor
