#include "view/playback.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "tukor/base/error.h"
#include "tukor/scene/model_file.h"
#include "view/choice.h"

namespace tukor {

namespace {

/// What is framed at one moment stays as it is at the next.
void keepStill(const Session& session, CameraOptions& camera) {
    if (camera.camera.empty()) camera = optionsFromCamera(session.camera(), camera);
}

}  // namespace

void Playback::lookAt(const SubjectOptions& subject) {
    if (subject.models == models_ && subject.animation == animation_) return;
    if (subject.models != models_) playing_ = false;
    models_ = subject.models;
    animation_ = subject.animation;
    names_.clear();
    seconds_ = 0.0;
    try {
        for (const std::string& model : models_) {
            for (const std::string& name : choicesOf(model).animations)
                names_.push_back(name.empty() ? fmt::format("{}", names_.size()) : name);
            seconds_ = std::max(seconds_, animationSeconds(model, animation_));
        }
    } catch (const Error&) {  // gone since it was loaded: it stands as it is
        seconds_ = 0.0;
    }
}

void Playback::show(const Session& session, SessionOptions& wanted) {
    lookAt(session.options().subject);
    if (names_.size() > 1) {
        const std::string current =
            wanted.subject.animation.empty() ? names_.front() : wanted.subject.animation;
        if (const auto chosen = choose("animation", current, names_)) {
            keepStill(session, wanted.camera);
            wanted.subject.animation = *chosen;
            if (!wanted.subject.timeSeconds) wanted.subject.timeSeconds = 0.0f;
        }
    }
    if (!(seconds_ > 0.0)) return;
    auto moment = wanted.subject.timeSeconds.value_or(0.0f);
    if (ImGui::SliderFloat("time-seconds", &moment, 0.0f, static_cast<float>(seconds_), "%.2f",
                           ImGuiSliderFlags_AlwaysClamp)) {
        keepStill(session, wanted.camera);
        wanted.subject.timeSeconds = moment;
    }
    if (ImGui::SmallButton(playing_ ? "pause" : "play")) playing_ = !playing_;
    if (!wanted.subject.timeSeconds) return;
    ImGui::SameLine();
    if (ImGui::SmallButton("at rest")) {
        playing_ = false;
        wanted.subject.timeSeconds.reset();
    }
}

void Playback::goOn(double seconds, const Session& session, SessionOptions& wanted) {
    lookAt(session.options().subject);
    if (!playing_ || !(seconds_ > 0.0)) return;
    keepStill(session, wanted.camera);
    const double moment = wanted.subject.timeSeconds.value_or(0.0f) + seconds;
    wanted.subject.timeSeconds = static_cast<float>(std::fmod(moment, seconds_));
}

}  // namespace tukor
