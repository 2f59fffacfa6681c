// The panel: what of the picture can be changed, and the buttons.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tukor/app/session.h"
#include "tukor/gl/renderer.h"
#include "view/playback.h"

namespace tukor {

/// What the buttons ask for; read and reset by the viewer after each frame.
struct PanelRequests {
    bool screenshot = false;
    bool copyCommand = false;
    bool frameModel = false;
};

/// What the panel says about the picture.
struct PanelStatus {
    int samples = 0;
    int samplesWanted = 0;
    double secondsPerFrame = 0.0;
};

class Panel {
public:
    /// Shows the widgets; changes land in `wanted` and `comparison`, which the caller carries out.
    PanelRequests show(const Session& session, SessionOptions& wanted,
                       std::optional<gl::Comparison>& comparison, Playback& playback,
                       const PanelStatus& status);

private:
    void showSubject(const Session& session, SessionOptions& wanted, Playback& playback);
    void showMaterials(const Session& session, SubjectOptions& subject);
    void showLight(LightOptions& light);

    std::string modelText_;
    std::string materialText_;
    std::string environmentText_;
};

/// `PATTERN=` that matches just this part or material name: characters with a meaning become `?`.
[[nodiscard]] std::string patternFor(const std::string& name);

/// Sets what is said about one pattern (empty: about everything) in a list of specifications; what
/// was said before about it is dropped. None takes it out.
void specify(std::vector<std::string>& specifications, const std::string& pattern,
             const std::optional<std::string>& material);

}  // namespace tukor
