#include "view/hand.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "tukor/app/pick.h"
#include "tukor/scene/orbit.h"
#include "view/window.h"

namespace tukor {
namespace {

constexpr float kRadiansPerHeight =
    3.5f;  // a drag over the window's height turns a little over half
constexpr float kZoomPerNotch = 0.88f;
constexpr float kRadiansPerSecond = 1.5f;  // of a held arrow key

/// Nearer or farther, but never through the target or out of sight.
Camera zoomed(const Camera& camera, float factor, const Scene& scene) {
    const float radius = std::max(boundsOf(scene).radius(), 1e-4f);
    const float distance = glm::length(camera.eye - camera.target);
    const float wanted = std::clamp(distance * factor, 0.02f * radius, 200.0f * radius);
    return dolly(camera, wanted / distance);
}

std::optional<Pick> pickAt(ImVec2 mouse, ImVec2 size, const Session& session) {
    const Camera& camera = session.camera();
    const int width = std::max(1, static_cast<int>(size.x));
    const int height = std::max(1, static_cast<int>(size.y));
    return pick(session.scene(), camera.eye, rayDirection(camera, width, height, mouse.x, mouse.y));
}

}  // namespace

HandMovement Hand::move(const Window& window, const Session& session,
                        std::optional<gl::Comparison>& comparison) {
    HandMovement movement;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 size = io.DisplaySize;
    if (size.x < 1.0f || size.y < 1.0f) return movement;
    Camera camera = session.camera();
    const Camera before = camera;

    if (!io.WantCaptureMouse) {
        const float divider = comparison ? comparison->splitX * size.x : -1e6f;
        const bool overDivider = std::abs(io.MousePos.x - divider) < 0.5f * ImGui::GetFontSize();
        if (overDivider || draggingDivider_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) draggingDivider_ = overDivider;
        if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) draggingDivider_ = false;
        const glm::vec2 drag = glm::vec2(io.MouseDelta.x, io.MouseDelta.y) / size.y;
        const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
        const bool aside = ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                           ImGui::IsMouseDown(ImGuiMouseButton_Right) || (left && io.KeyShift);
        if (draggingDivider_) {
            if (comparison) {
                comparison->splitX = std::clamp(io.MousePos.x / size.x, 0.0f, 1.0f);
            }
        } else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            if (const auto hit = pickAt(io.MousePos, size, session)) {
                camera = focus(camera, hit->position);
            } else {
                movement.frameModel = true;
            }
        } else if (drag != glm::vec2(0.0f) && aside) {
            camera = pan(camera, drag.x, -drag.y);
        } else if (drag != glm::vec2(0.0f) && left) {
            // the model follows the hand: the eye goes the other way
            camera = orbit(camera, -kRadiansPerHeight * drag.x, kRadiansPerHeight * drag.y);
        }
        if (io.MouseWheel != 0.0f) {
            camera = zoomed(camera, std::pow(kZoomPerNotch, io.MouseWheel), session.scene());
        }
    } else {
        draggingDivider_ = false;
    }
    if (!io.WantCaptureKeyboard) {
        const float turn = kRadiansPerSecond * std::min(io.DeltaTime, 0.1f);
        const auto held = [&](Key key) { return window.held(key) ? 1.0f : 0.0f; };
        const float yaw = held(Key::right) - held(Key::left);
        const float pitch = held(Key::up) - held(Key::down);
        if (yaw != 0.0f || pitch != 0.0f) camera = orbit(camera, turn * yaw, turn * pitch);
        // one key of many layouts has the plus with Shift, and the equals sign without
        const int notches = window.typed("+=") - window.typed("-");
        if (notches != 0) {
            const float factor = std::pow(kZoomPerNotch, static_cast<float>(notches));
            camera = zoomed(camera, factor, session.scene());
        }
        if (window.pressed(Key::home)) movement.frameModel = true;
    }
    if (camera.eye != before.eye || camera.target != before.target) movement.camera = camera;
    return movement;
}

}  // namespace tukor
