#include "view/viewer.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "tukor/app/drop.h"
#include "tukor/app/option_table.h"
#include "tukor/app/pace.h"
#include "tukor/app/picture.h"
#include "tukor/app/session.h"
#include "tukor/base/error.h"
#include "tukor/gl/renderer.h"
#include "view/hand.h"
#include "view/notices.h"
#include "view/panel.h"
#include "view/window.h"

namespace tukor {
namespace {

constexpr int kSamplesAtRest = 64;   // then the picture is finished and the window sleeps
constexpr int kPictureSamples = 16;  // a saved picture has at least as many
constexpr int kSettlingFrames = 3;   // ImGui shows the effect of an event one frame later

class Viewer {
    using Clock = std::chrono::steady_clock;
    static constexpr auto kRest = std::chrono::milliseconds(150);  // without a change

public:
    explicit Viewer(const SessionOptions& options)
        : session_(windowOptions(options)),
          wanted_(session_.options()),
          window_(options.quality.size.width, options.quality.size.height, "tukor") {
        for (const std::string& unused : unusedInWindow(options)) {
            notices_.add(Notices::Kind::news, unused);
        }
        sayWarnings();
    }

    int run() {
        while (!window_.closing()) {
            const bool refining = (!finished() && !moving()) || playback_.playing();
            const double toRest = moving() ? 0.02 : 3600.0;
            window_.handleEvents(settling_ > 0 || refining,
                                 std::min(toRest, notices_.secondsToNextChange()));
            settling_ = finished() && settling_ > 0 ? settling_ - 1 : kSettlingFrames;
            frame();
        }
        return 0;
    }

private:
    [[nodiscard]] int samplesWanted() const {
        return session_.options().quality.samples.value_or(kSamplesAtRest);
    }

    [[nodiscard]] bool finished() const {
        return atRest_ && renderer_.accumulatedSamples() >= samplesWanted();
    }

    [[nodiscard]] bool moving() const { return Clock::now() - changed_ < kRest; }

    void frame() {
        const glm::ivec2 size = window_.framebufferSize();
        window_.beginFrame();
        takeDrops();
        readInput();
        wanted_.quality.size = {std::max(1, size.x), std::max(1, size.y)};
        const PanelRequests requests = showPanels();
        carryOut();
        if (size.x > 0 && size.y > 0) draw(size);  // not while minimised
        serve(requests);
        window_.endFrame();
    }

    void readInput() {
        const HandMovement movement = hand_.move(window_, session_, comparison_);
        if (movement.camera) {
            wanted_.camera = optionsFromCamera(*movement.camera, wanted_.camera);
        }
        if (movement.frameModel) frameModel();
        playback_.goOn(ImGui::GetIO().DeltaTime, session_, wanted_);
    }

    void frameModel() {
        CameraOptions lens;
        lens.fovDegrees = wanted_.camera.fovDegrees;
        lens.aperture = wanted_.camera.aperture;
        wanted_.camera = lens;
    }

    PanelRequests showPanels() {
        PanelRequests requests;
        const ImGuiIO& io = ImGui::GetIO();
        if (!io.WantTextInput && window_.pressed(Key::tab)) panelShown_ = !panelShown_;
        if (panelShown_) {
            requests = panel_.show(session_, wanted_, comparison_, playback_,
                                   {renderer_.accumulatedSamples(), samplesWanted(), frameTime_});
        }
        if (comparison_) showDivider();
        notices_.show();
        requests.screenshot = requests.screenshot || window_.pressed(Key::f12);
        requests.copyCommand =
            requests.copyCommand || (!io.WantTextInput && window_.pressed(Key::copy));
        if (requests.frameModel) frameModel();
        if (!io.WantTextInput && window_.pressed(Key::quit)) window_.close();
        return requests;
    }

    void showDivider() const {
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        const ImVec2 area = ImGui::GetIO().DisplaySize;
        const float x = comparison_->splitX * area.x;
        list.AddLine({x, 0.0f}, {x, area.y}, IM_COL32(255, 255, 255, 200), 1.5f);
        const auto label = [](Fidelity fidelity, FresnelForm fresnel) {
            std::string text;
            for (const auto& [value, spelling] : kFidelitySpellings) {
                if (value == fidelity) text += spelling;
            }
            return text + (fresnel == FresnelForm::exact ? ", Fresnel's equations"
                                                         : ", Schlick's approximation");
        };
        const QualityOptions& quality = session_.options().quality;
        const float unit = ImGui::GetFontSize();
        const auto write = [&](float left, const std::string& text) {
            const ImVec2 size = ImGui::CalcTextSize(text.c_str());
            const float y = area.y - 2.0f * unit;
            list.AddRectFilled({left - 0.3f * unit, y - 0.2f * unit},
                               {left + size.x + 0.3f * unit, y + size.y + 0.2f * unit},
                               IM_COL32(0, 0, 0, 150), 3.0f);
            list.AddText({left, y}, IM_COL32_WHITE, text.c_str());
        };
        const std::string here = label(quality.fidelity, quality.fresnel);
        write(x - unit - ImGui::CalcTextSize(here.c_str()).x, here);
        write(x + unit, label(comparison_->fidelity, comparison_->fresnel));
    }

    void takeDrops() {
        const std::vector<std::string> files = window_.takeDroppedFiles();
        if (!files.empty()) wanted_ = withDropped(std::move(wanted_), files);
    }

    /// Makes the session what is wanted; what cannot be had is said, and nothing is lost.
    void carryOut() {
        if (wanted_ == session_.options()) return;
        try {
            session_.apply(wanted_);
        } catch (const Error& error) {
            notices_.add(Notices::Kind::trouble, error.what());
            const PictureSize size = wanted_.quality.size;
            wanted_ = session_.options();
            wanted_.quality.size = size;
        }
    }

    void draw(glm::ivec2 size) {
        if (sceneSeen_ != session_.sceneRevision()) {
            const bool another = sceneSeen_ != 0;
            renderer_.setScene(session_.scene());
            sceneSeen_ = session_.sceneRevision();
            window_.setTitle("tukor: " + session_.options().subject.models.front());
            if (another) sayWarnings();
            materialsSeen_.clear();
        }
        if (environmentSeen_ != session_.environmentRevision()) {
            renderer_.setEnvironment(session_.environment());
            environmentSeen_ = session_.environmentRevision();
            stale_ = true;
        }
        updateMaterials();

        gl::FrameOptions frame;
        frame.picture = session_.renderOptions();
        frame.picture.width = size.x;
        frame.picture.height = size.y;
        frame.picture.samples = samplesWanted();
        frame.comparison = comparison_;
        drawPicture(frame);
        gl::DisplayOptions display;
        display.exposureStops = session_.options().develop.exposureStops;
        display.tonemap = session_.options().develop.tonemap;
        renderer_.present(display, {0, 0, size.x, size.y});
    }

    /// Coarse while the picture changes, full size and one frame more each time when it rests.
    void drawPicture(gl::FrameOptions frame) {
        const bool changed = !restSeen_ || *restSeen_ != frame || !cameraSeen_ ||
                             *cameraSeen_ != session_.camera() || stale_;
        const auto start = Clock::now();
        if (changed && restSeen_) changed_ = start;  // the first picture is nobody's movement
        restSeen_ = frame;
        cameraSeen_ = session_.camera();
        stale_ = false;
        if (changed && moving()) {
            frame.picture = pace_.whileMoving(frame.picture);
            renderer_.drawFrame(session_.camera(), frame);
            glFinish();  // the clock is about the drawing, not about the asking
            const std::chrono::duration<double> gone = Clock::now() - start;
            pace_.took(gone.count());
            frameTime_ = gone.count();
            atRest_ = false;
        } else if (!moving() && !finished()) {
            renderer_.drawFrame(session_.camera(), frame);
            renderer_.gatherGroundLight(session_.camera(), frame);
            const std::chrono::duration<double> gone = Clock::now() - start;
            frameTime_ = gone.count();
            atRest_ = true;
        }
    }

    void updateMaterials() {
        const auto& parts = session_.scene().parts;
        const bool all = materialsSeen_.size() != parts.size();
        if (all) materialsSeen_.resize(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (!all && materialsSeen_[i] == parts[i].material) continue;
            materialsSeen_[i] = parts[i].material;
            renderer_.setMaterial(static_cast<int>(i), parts[i].material);
            stale_ = true;
        }
    }

    void sayWarnings() {
        const std::vector<std::string> warnings = session_.warnings();
        if (warnings == warningsSaid_) return;  // of the same model a moment later
        for (const std::string& warning : warnings) notices_.add(Notices::Kind::news, warning);
        warningsSaid_ = warnings;
    }

    /// Those of a picture of so many samples a pixel: gl's own choice for files is another one.
    [[nodiscard]] SessionOptions optionsOf(int samples) const {
        SessionOptions options = session_.options();
        options.quality.samples = samples;
        return options;
    }

    void serve(const PanelRequests& requests) {
        if (requests.copyCommand) {
            window_.setClipboard(commandLine("tukor render", optionsOf(samplesWanted())) +
                                 " -o picture.png");
            notices_.add(Notices::Kind::news, "the command is in the clipboard");
        }
        screenshotWanted_ = screenshotWanted_ || requests.screenshot;
        if (!screenshotWanted_ || !atRest_ ||
            renderer_.accumulatedSamples() < std::min(kPictureSamples, samplesWanted())) {
            return;
        }
        screenshotWanted_ = false;
        try {
            const std::filesystem::path path = freshPicturePath(std::filesystem::current_path());
            savePicture(path, renderer_.read(), optionsOf(renderer_.accumulatedSamples()));
            notices_.add(Notices::Kind::news, "saved " + path.string());
        } catch (const Error& error) {
            notices_.add(Notices::Kind::trouble, error.what());
        }
    }

    Session session_;        // what is shown
    SessionOptions wanted_;  // what the widgets and the hand ask for
    Window window_;
    gl::Renderer renderer_;  // after the window: its objects live in the window's context
    Panel panel_;
    Playback playback_;
    Hand hand_;
    Notices notices_;
    std::optional<gl::Comparison> comparison_;
    std::vector<Material> materialsSeen_;
    std::vector<std::string> warningsSaid_;
    Pace pace_;
    std::optional<gl::FrameOptions> restSeen_;  // as it would be at rest
    std::optional<Camera> cameraSeen_;
    std::uint64_t sceneSeen_ = 0;
    std::uint64_t environmentSeen_ = 0;
    Clock::time_point changed_{};
    bool stale_ = true;    // light or material is another one
    bool atRest_ = false;  // the picture is at full size
    bool screenshotWanted_ = false;
    double frameTime_ = 0.0;
    int settling_ = kSettlingFrames;
    bool panelShown_ = true;
};

}  // namespace

int runViewer(const SessionOptions& options) {
    return Viewer(options).run();
}

}  // namespace tukor
