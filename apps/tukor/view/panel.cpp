#include "view/panel.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "tukor/geometry/shapes.h"
#include "tukor/materials/materials.h"
#include "view/choice.h"
#include "view/option_widgets.h"

namespace tukor {
namespace {

/// A line of text that counts when Enter is pressed.
bool entered(const char* label, const char* hint, std::string& text) {
    return ImGui::InputTextWithHint(label, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue) &&
           !text.empty();
}

/// The material that a specification list gives to a pattern, as spelt there.
std::optional<std::string> specified(const std::vector<std::string>& specifications,
                                     const std::string& pattern) {
    const std::string opening = pattern.empty() ? "" : pattern + "=";
    for (auto it = specifications.rbegin(); it != specifications.rend(); ++it) {
        if (pattern.empty() ? it->find('=') == it->npos : it->starts_with(opening)) {
            return it->substr(opening.size());
        }
    }
    return std::nullopt;
}

/// In the bar of the panel, which stays in sight while the rest is scrolled.
PanelRequests showButtons() {
    PanelRequests requests;
    if (!ImGui::BeginMenuBar()) return requests;
    const auto button = [](const char* label, const char* key) {
        const bool clicked = ImGui::SmallButton(label);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", key);
        return clicked;
    };
    requests.screenshot = button("save picture", "F12");
    requests.copyCommand = button("copy command", "Ctrl+C");
    requests.frameModel = button("show all", "Home");
    ImGui::EndMenuBar();
    return requests;
}

}  // namespace

std::string patternFor(const std::string& name) {
    std::string pattern = name;
    for (char& c : pattern) {
        if (c == '*' || c == '=' || c == ':') c = '?';
    }
    return pattern;
}

void specify(std::vector<std::string>& specifications, const std::string& pattern,
             const std::optional<std::string>& material) {
    std::erase_if(specifications, [&](const std::string& specification) {
        return pattern.empty() || specification.starts_with(pattern + "=");
    });
    if (material) {
        specifications.push_back(pattern.empty() ? *material : pattern + "=" + *material);
    }
}

void Panel::showMaterials(const Session& session, SubjectOptions& subject) {
    std::vector<std::string>& specifications = subject.materials;
    constexpr std::size_t kListed = 40;  // more rows than that are no help
    const auto everything = specified(specifications, "");
    if (auto chosen =
            choose("everything", everything.value_or("as in the model"), materialNames())) {
        specify(specifications, "", chosen);
    }
    if (entered("figures", "ior:1.2, gold+rough:0.2", materialText_))
        specify(specifications, "", materialText_);
    std::set<std::string> seen;
    for (const Part& part : session.scene().parts) {
        const std::string& name = part.materialName.empty() ? part.name : part.materialName;
        if (name.empty() || !seen.insert(name).second || seen.size() > kListed) continue;
        const std::string pattern = patternFor(name);
        const auto own = specified(specifications, pattern);
        ImGui::PushID(name.c_str());
        if (auto chosen = choose(name.c_str(), own.value_or(everything.value_or("as in the model")),
                                 materialNames())) {
            specify(specifications, pattern, chosen);
        }
        ImGui::PopID();
    }
    const auto& parts = session.scene().parts;
    const bool clear = std::any_of(parts.begin(), parts.end(), [](const Part& part) {
        return part.material.kind == MaterialKind::dielectric;
    });
    float dispersion = subject.dispersion.value_or(0.0f);
    if (clear && ImGui::SliderFloat("dispersion", &dispersion, 0.0f, 4.0f, "%.1f"))
        subject.dispersion = std::clamp(dispersion, 0.0f, 100.0f);
    if ((!specifications.empty() || subject.dispersion) && ImGui::SmallButton("as in the model")) {
        specifications.clear();
        subject.dispersion.reset();
    }
}

void Panel::showSubject(const Session& session, SessionOptions& wanted, Playback& playback) {
    std::string current;
    for (const std::string& model : wanted.subject.models) {
        current += (current.empty() ? "" : ", ") + model;
    }
    std::optional<std::string> model = choose("model", current, shapeNames());
    if (entered("model file", "or drop one here", modelText_)) model = modelText_;
    if (model) wanted = withModels(std::move(wanted), {*model});
    playback.show(session, wanted);
    std::vector<std::string> cameras;
    for (const NamedCamera& camera : session.scene().cameras) cameras.push_back(camera.name);
    if (!cameras.empty()) {
        if (auto chosen = choose("camera", wanted.camera.camera, cameras)) {
            wanted.camera = {};
            wanted.camera.camera = *chosen;
        }
    }
    float fov = glm::degrees(session.camera().verticalFov);
    if (ImGui::SliderFloat("fov", &fov, 5.0f, 120.0f, "%.1f", ImGuiSliderFlags_AlwaysClamp)) {
        wanted.camera.fovDegrees = fov;
    }
}

void Panel::showLight(LightOptions& light) {
    if (auto chosen = choose("environment", light.environment, builtInEnvironmentNames())) {
        light.environment = *chosen;
    }
    if (entered("environment file", "or drop one here", environmentText_)) {
        light.environment = environmentText_;
    }
    describe(light, OptionWidgets());
    bool stands = !light.ground.empty();
    if (ImGui::Checkbox("ground", &stands)) light.ground = stands ? "lowest" : "";
}

PanelRequests Panel::show(const Session& session, SessionOptions& wanted,
                          std::optional<gl::Comparison>& comparison, Playback& playback,
                          const PanelStatus& status) {
    const float unit = ImGui::GetFontSize();
    const ImVec2 area = ImGui::GetMainViewport()->WorkSize;
    ImGui::SetNextWindowPos({0.7f * unit, 0.7f * unit}, ImGuiCond_Once);
    ImGui::SetNextWindowSizeConstraints(
        {17.0f * unit, 4.0f * unit},
        {std::max(17.0f * unit, 0.6f * area.x), std::max(4.0f * unit, area.y - 1.4f * unit)});
    ImGui::SetNextWindowSize({22.0f * unit, 0.0f}, ImGuiCond_Once);
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("tukor  (Tab hides)", nullptr,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_MenuBar);
    const PanelRequests requests = showButtons();
    ImGui::TextDisabled("%s", fmt::format("{} of {} samples, {:.0f} ms a frame", status.samples,
                                          status.samplesWanted, 1000.0 * status.secondsPerFrame)
                                  .c_str());
    ImGui::PushItemWidth(0.55f * ImGui::GetContentRegionAvail().x);
    if (ImGui::CollapsingHeader("Model", ImGuiTreeNodeFlags_DefaultOpen)) {
        showSubject(session, wanted, playback);
    }
    if (ImGui::CollapsingHeader("Materials", ImGuiTreeNodeFlags_DefaultOpen)) {
        showMaterials(session, wanted.subject);
    }
    if (ImGui::CollapsingHeader("Light", ImGuiTreeNodeFlags_DefaultOpen)) showLight(wanted.light);
    if (ImGui::CollapsingHeader("Quality", ImGuiTreeNodeFlags_DefaultOpen)) {
        describe(wanted.quality, OptionWidgets(OptionWidgets::Rows::choices));
        if (ImGui::TreeNode("limits of the light paths")) {
            describe(wanted.quality, OptionWidgets(OptionWidgets::Rows::numbers));
            ImGui::TreePop();
        }
        bool compared = comparison.has_value();
        if (ImGui::Checkbox("compare with", &compared)) {
            comparison.reset();
            // what a student asks first: what does the approximation do?
            if (compared) {
                comparison.emplace();
                comparison->fidelity = wanted.quality.fidelity;
                comparison->fresnel = FresnelForm::schlick;
            }
        }
        if (comparison) {
            ImGui::PushID("comparison");
            const OptionWidgets widget;
            widget("fidelity", comparison->fidelity, Spellings<Fidelity>(kFidelitySpellings),
                   "right of the divider");
            widget("fresnel", comparison->fresnel, Spellings<FresnelForm>(kFresnelSpellings),
                   "right of the divider");
            ImGui::PopID();
        }
    }
    if (ImGui::CollapsingHeader("Development", ImGuiTreeNodeFlags_DefaultOpen)) {
        describe(wanted.develop, OptionWidgets());
    }
    ImGui::PopItemWidth();
    ImGui::End();
    return requests;
}

}  // namespace tukor
