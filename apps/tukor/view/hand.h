// Mouse and keys on the picture: which way the camera goes.
#pragma once
#include <optional>

#include "tukor/app/session.h"
#include "tukor/gl/renderer.h"

namespace tukor {

class Window;

/// What one frame's input asks for.
struct HandMovement {
    std::optional<Camera> camera;  // moved
    bool frameModel = false;       // show all of it
};

/// Holds what lasts longer than a frame: whether the divider of a comparison is being dragged.
class Hand {
public:
    /// Reads ImGui's input of this frame; what the panels use is left to them. Moves the divider of
    /// `comparison` itself.
    [[nodiscard]] HandMovement move(const Window& window, const Session& session,
                                    std::optional<gl::Comparison>& comparison);

private:
    bool draggingDivider_ = false;
};

}  // namespace tukor
