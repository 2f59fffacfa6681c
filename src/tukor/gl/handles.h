// Owners of OpenGL objects: made empty, moved, deleted with their scope.
//
// All calls need the context current that the object was made in.
#pragma once
#include <utility>

#include <GLES3/gl3.h>

namespace tukor::gl {

/// Owns one object name. `Kind` has static make() and destroy(GLuint).
template <class Kind>
class Handle {
public:
    /// Owns nothing; id() is 0.
    Handle() = default;
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0u)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (id_ != 0) Kind::destroy(id_);
    }

    /// A new object of the current context.
    [[nodiscard]] static Handle make() {
        Handle handle;
        handle.id_ = Kind::make();
        return handle;
    }

    [[nodiscard]] GLuint id() const noexcept { return id_; }

private:
    GLuint id_ = 0;
};

template <auto generate, auto remove>
struct GeneratedKind {
    static GLuint make() {
        GLuint id = 0;
        generate(1, &id);
        return id;
    }
    static void destroy(GLuint id) { remove(1, &id); }
};

using Buffer = Handle<GeneratedKind<glGenBuffers, glDeleteBuffers>>;
using Texture = Handle<GeneratedKind<glGenTextures, glDeleteTextures>>;
using Renderbuffer = Handle<GeneratedKind<glGenRenderbuffers, glDeleteRenderbuffers>>;
using Framebuffer = Handle<GeneratedKind<glGenFramebuffers, glDeleteFramebuffers>>;
using VertexArray = Handle<GeneratedKind<glGenVertexArrays, glDeleteVertexArrays>>;

struct ProgramKind {
    static GLuint make() { return glCreateProgram(); }
    static void destroy(GLuint id) { glDeleteProgram(id); }
};

}  // namespace tukor::gl
