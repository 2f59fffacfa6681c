// Option tables as ImGui widgets: the panel's sliders and lists come from describe().
#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "tukor/app/options.h"

namespace tukor {

/// A visitor for describe(): one widget per option that has a natural one; the others (names,
/// vectors, unset options) are left to the caller. Labels are the flags without their dashes.
class OptionWidgets {
public:
    /// Which of a table's rows become widgets.
    enum class Rows { all, choices, numbers };

    explicit OptionWidgets(Rows rows = Rows::all) : rows_(rows) {}

    void operator()(std::string_view name, float& value, const Measure<float>& measure,
                    std::string_view help) const {
        if (rows_ == Rows::choices) return;
        const std::string label = labelOf(name);
        const auto [least, most] = measure.range;
        if (measure.byRatio) {
            ImGui::SliderFloat(label.c_str(), &value, least, most, "%.4f",
                               ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
        } else if (most - least <= 1000.0f) {  // a slider over more than that cannot be aimed
            ImGui::SliderFloat(label.c_str(), &value, least, most, "%.2f",
                               ImGuiSliderFlags_AlwaysClamp);
        } else {
            ImGui::DragFloat(label.c_str(), &value, 0.01f * std::max(0.1f, value), least, most,
                             "%.3f", ImGuiSliderFlags_AlwaysClamp);
        }
        tip(help);
    }

    void operator()(std::string_view name, int& value, const Measure<int>& measure,
                    std::string_view help) const {
        if (rows_ == Rows::choices) return;
        const std::string label = labelOf(name);
        ImGui::SliderInt(label.c_str(), &value, measure.range.least, measure.range.most, "%d",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
        tip(help);
    }

    template <class Enum>
    void operator()(std::string_view name, Enum& value, const Spellings<Enum>& spellings,
                    std::string_view help) const {
        if (rows_ == Rows::numbers) return;
        const std::string label = labelOf(name);
        std::string current;
        for (const auto& [candidate, spelling] : spellings) {
            if (candidate == value) current = spelling;
        }
        const bool open = ImGui::BeginCombo(label.c_str(), current.c_str());
        if (!open) tip(help);
        if (!open) return;
        for (const auto& [candidate, spelling] : spellings) {
            const std::string text(spelling);
            if (ImGui::Selectable(text.c_str(), candidate == value)) value = candidate;
        }
        ImGui::EndCombo();
    }

    template <class T, class Extra>
    void operator()(std::string_view, std::optional<T>&, const Extra&, std::string_view) const {}
    template <class Extra>
    void operator()(std::string_view, std::string&, const Extra&, std::string_view) const {}
    template <class T, class Extra>
    void operator()(std::string_view, std::vector<T>&, const Extra&, std::string_view) const {}
    void operator()(std::string_view, PictureSize&, const Measure<int>&, std::string_view) const {}

private:
    /// Under the heading "Light", `environment-rotation` needs no more than `rotation`.
    static std::string labelOf(std::string_view name) {
        constexpr std::string_view kOpening = "environment-";
        const bool shorter =
            name.size() > kOpening.size() && name.substr(0, kOpening.size()) == kOpening;
        return std::string(shorter ? name.substr(kOpening.size()) : name) + "##" +
               std::string(name);
    }

    static void tip(std::string_view help) {
        if (!ImGui::IsItemHovered()) return;
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(22.0f * ImGui::GetFontSize());
        ImGui::TextUnformatted(help.data(), help.data() + help.size());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }

    Rows rows_;
};

}  // namespace tukor
