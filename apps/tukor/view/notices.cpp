#include "view/notices.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

namespace tukor {

void Notices::add(Kind kind, std::string text) {
    constexpr std::size_t kMost = 6;
    if (kind == Kind::trouble) fmt::print(stderr, "tukor: {}\n", text);
    // trouble takes longer to read
    const auto time = std::chrono::seconds(kind == Kind::trouble ? 15 : 6);
    notices_.push_back({kind, std::move(text), Clock::now() + time});
    if (notices_.size() > kMost) notices_.pop_front();
}

void Notices::show() {
    const auto now = Clock::now();
    std::erase_if(notices_, [&](const Notice& notice) { return notice.end <= now; });
    if (notices_.empty()) return;
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float margin = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(
        {viewport.WorkPos.x + margin, viewport.WorkPos.y + viewport.WorkSize.y - margin},
        ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("notices", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(std::max(10.0f * margin, viewport.WorkSize.x - 4.0f * margin));
    for (const Notice& notice : notices_) {
        const ImVec4 color = notice.kind == Kind::trouble ? ImVec4(1.0f, 0.65f, 0.5f, 1.0f)
                                                          : ImVec4(0.9f, 0.95f, 1.0f, 1.0f);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(notice.text.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::End();
}

double Notices::secondsToNextChange() const {
    double least = 3600.0;
    for (const Notice& notice : notices_) {
        const std::chrono::duration<double> left = notice.end - Clock::now();
        least = std::min(least, std::max(0.0, left.count()));
    }
    return least;
}

}  // namespace tukor
