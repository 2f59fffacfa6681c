// An OpenGL ES 3 context without a window or a display. The only part of this module that uses EGL.
#pragma once
#include <memory>

#include "tukor/gl/errors.h"

namespace tukor::gl {

/// A headless context, current on the thread that made it until destroyed; whatever was current
/// before is current again then.
///
/// Uses the surfaceless platform, or else the first EGL device: no X11, no Wayland.
class Context {
public:
    /// Throws Error when EGL, OpenGL ES 3 or float framebuffers are missing, and says which package
    /// gives them.
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    static void (*procAddress(const char* name))();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Throws Error unless the current context, whoever made it, can do what this module needs.
void requireFeatures();

}  // namespace tukor::gl
