#include "view/panel_renderer.h"

#include <cstddef>
#include <cstdint>

#include <imgui.h>

namespace tukor {
namespace {

constexpr const char* kVertexFile[] = {"apps/tukor/view/panel_renderer.cpp (vertex shader)"};
constexpr gl::ShaderSource kVertex{R"(#version 300 es
uniform vec4 scaleOffset;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec4 color;
out vec2 uv;
out vec4 tint;
void main() {
    uv = texCoord;
    tint = color;
    gl_Position = vec4(position * scaleOffset.xy + scaleOffset.zw, 0.0, 1.0);
}
)",
                                   kVertexFile};

constexpr const char* kFragmentFile[] = {"apps/tukor/view/panel_renderer.cpp (fragment shader)"};
constexpr gl::ShaderSource kFragment{R"(#version 300 es
precision mediump float;
uniform sampler2D fonts;
in vec2 uv;
in vec4 tint;
out vec4 fragmentColor;
void main() {
    fragmentColor = tint * texture(fonts, uv);
}
)",
                                     kFragmentFile};

const void* offsetPointer(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

PanelRenderer::PanelRenderer()
    : program_(kVertex, kFragment),
      vertexArray_(gl::VertexArray::make()),
      vertices_(gl::Buffer::make()),
      indices_(gl::Buffer::make()) {
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    for (const GLuint attribute : {0u, 1u, 2u}) glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert),
                          offsetPointer(offsetof(ImDrawVert, pos)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert),
                          offsetPointer(offsetof(ImDrawVert, uv)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert),
                          offsetPointer(offsetof(ImDrawVert, col)));
    glBindVertexArray(0);
}

void PanelRenderer::uploadFonts() {
    ImGuiIO& io = ImGui::GetIO();
    unsigned char* texels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&texels, &width, &height);
    fonts_ = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, fonts_.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(fonts_.id())));
    io.Fonts->ClearTexData();
}

void PanelRenderer::draw(const ImDrawData& data) const {
    const float width = data.DisplaySize.x * data.FramebufferScale.x;
    const float height = data.DisplaySize.y * data.FramebufferScale.y;
    if (width < 1.0f || height < 1.0f) return;
    glViewport(0, 0, static_cast<int>(width), static_cast<int>(height));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    // display coordinates run down from DisplayPos; clip coordinates run up
    const glm::vec2 scale(2.0f / data.DisplaySize.x, -2.0f / data.DisplaySize.y);
    program_.set("scaleOffset", glm::vec4(scale.x, scale.y, -1.0f - scale.x * data.DisplayPos.x,
                                          1.0f - scale.y * data.DisplayPos.y));
    program_.set("fonts", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                     GL_STREAM_DRAW);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                     GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback != nullptr) continue;  // the panels make none
            const float left = (command.ClipRect.x - data.DisplayPos.x) * data.FramebufferScale.x;
            const float top = (command.ClipRect.y - data.DisplayPos.y) * data.FramebufferScale.y;
            const float right = (command.ClipRect.z - data.DisplayPos.x) * data.FramebufferScale.x;
            const float bottom = (command.ClipRect.w - data.DisplayPos.y) * data.FramebufferScale.y;
            if (right <= left || bottom <= top) continue;
            glScissor(static_cast<int>(left), static_cast<int>(height - bottom),
                      static_cast<int>(right - left), static_cast<int>(bottom - top));
            glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(
                                             reinterpret_cast<std::uintptr_t>(command.GetTexID())));
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                           sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                           offsetPointer(command.IdxOffset * sizeof(ImDrawIdx)));
        }
    }
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
}

}  // namespace tukor
