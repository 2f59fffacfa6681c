// Dear ImGui's draw lists in OpenGL ES 3.
//
// ImGui's own OpenGL backend, as Debian builds it, is for desktop OpenGL and loads libGL.
#pragma once
#include "tukor/gl/handles.h"
#include "tukor/gl/program.h"

struct ImDrawData;

namespace tukor {

/// Draws panels into the framebuffer that is bound. Belongs to the context it was made in.
class PanelRenderer {
public:
    PanelRenderer();

    /// Uploads the atlas of ImGui's fonts; again whenever fonts were added or scaled.
    void uploadFonts();

    /// Leaves blending and scissoring off, and the viewport at the size of the framebuffer.
    void draw(const ImDrawData& data) const;

private:
    gl::Program program_;
    gl::Texture fonts_;
    gl::VertexArray vertexArray_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
};

}  // namespace tukor
