// A window with an OpenGL ES 3 context and Dear ImGui in it. The only file that talks to GLFW.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

struct GLFWwindow;

namespace tukor {

class PanelRenderer;

/// Keys that the viewer asks for; copy and quit are Ctrl+C and Ctrl+Q, by the letters of the
/// layout.
enum class Key { f12, left, right, up, down, home, tab, copy, quit };

class Window {
public:
    /// Opens at `width` x `height` in screen coordinates. Throws Error when there is no display or
    /// no OpenGL ES 3.
    Window(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] bool closing() const noexcept;
    void close() noexcept;

    /// Handles events: at once when `busy`, else sleeps until the next one, or `seconds` at most.
    void handleEvents(bool busy, double seconds);

    /// Pixels, which on high-density displays are more than screen coordinates.
    [[nodiscard]] glm::ivec2 framebufferSize() const noexcept;

    /// Pixels per screen coordinate of the mouse.
    [[nodiscard]] glm::vec2 framebufferScale() const noexcept;

    /// How much larger than usual text should be, in pixels.
    [[nodiscard]] float contentScale() const noexcept;

    /// Files dropped onto the window since the last call.
    [[nodiscard]] std::vector<std::string> takeDroppedFiles() noexcept;

    void setTitle(const std::string& title);
    void setClipboard(const std::string& text);

    [[nodiscard]] bool pressed(Key key) const;  // since the last frame, auto-repeat included
    [[nodiscard]] bool held(Key key) const;
    /// How often one of these characters of ASCII was typed since the last frame.
    [[nodiscard]] int typed(std::string_view characters) const;

    /// Between beginFrame and endFrame ImGui's widgets may be made; endFrame draws them over what
    /// the framebuffer holds and shows all.
    void beginFrame();
    void endFrame();

private:
    struct Glfw;   // initialised library
    struct Panel;  // ImGui context

    struct Press {
        int key;  // GLFW's, by place
        int modifiers;
        int character;  // of the key alone; 0 where that is none of ASCII
    };

    /// For one frame ImGui sees every key that was pressed since the last, released again or not.
    void holdPressedKeys();
    void releaseKeys();

    std::unique_ptr<Glfw> glfw_;
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<Panel> panel_;
    std::unique_ptr<PanelRenderer> renderer_;
    std::vector<std::string> dropped_;
    std::vector<Press> presses_;   // since the last frame
    std::vector<unsigned> typed_;  // characters, likewise
    float fontScale_ = 0.0f;
    double frameBegun_ = 0.0;  // GLFW's seconds
    double frameCost_ = 0.0;   // seconds of the last frame, without the wait before it
};

}  // namespace tukor
