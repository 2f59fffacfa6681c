// OpenGL's errors as exceptions of C++ frames: the driver's callback stores, the next check throws.
#pragma once
#include <string_view>

namespace tukor::gl {

/// Finds an extension's function by name, as eglGetProcAddress and glfwGetProcAddress do.
using ProcAddress = void (*(*)(const char* name))();

/// Asks the current context to report errors through KHR_debug, where it has that; without it
/// throwPendingErrors still sees what glGetError does.
void watchErrors(ProcAddress procAddress);

/// Throws Error for what went wrong in OpenGL since the last call; `doing` says what was tried:
/// "drawing the model".
void throwPendingErrors(std::string_view doing);

}  // namespace tukor::gl
