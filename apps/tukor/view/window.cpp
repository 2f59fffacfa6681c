#include "view/window.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include "tukor/base/error.h"
#include "tukor/gl/context.h"
#include "tukor/gl/errors.h"
#include "view/panel_renderer.h"

namespace tukor {
namespace {

/// What GLFW complained about last; its callback cannot throw through C frames.
std::string lastComplaint;

void storeComplaint(int, const char* message) {
    lastComplaint = message;
}

/// The key of a place that all layouts share; none of a letter.
int glfwKey(Key key) {
    switch (key) {
        case Key::f12:
            return GLFW_KEY_F12;
        case Key::left:
            return GLFW_KEY_LEFT;
        case Key::right:
            return GLFW_KEY_RIGHT;
        case Key::up:
            return GLFW_KEY_UP;
        case Key::down:
            return GLFW_KEY_DOWN;
        case Key::home:
            return GLFW_KEY_HOME;
        case Key::tab:
            return GLFW_KEY_TAB;
        case Key::copy:
        case Key::quit:
            break;
    }
    return GLFW_KEY_UNKNOWN;
}

/// What a key types by itself in the layout; 0 where that is no character of ASCII.
int characterOf(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return 0;
    return static_cast<unsigned char>(name[0]);
}

/// A face that reads better than ImGui's bitmap font, where the system has it.
constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

}  // namespace

struct Window::Glfw {
    Glfw() {
        glfwSetErrorCallback(storeComplaint);
        if (glfwInit() != GLFW_TRUE) {
            throw Error("no display (" + lastComplaint + "); `tukor render` needs none");
        }
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

struct Window::Panel {
    explicit Panel(GLFWwindow* window) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;  // leave no files behind
        ImGui::StyleColorsDark();
        ImGui_ImplGlfw_InitForOther(window, true);  // chains the callbacks set before
    }
    ~Panel() {
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
};

Window::Window(int width, int height, const std::string& title) : glfw_(std::make_unique<Glfw>()) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the scene is drawn elsewhere and copied here
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        throw Error("no window with OpenGL ES 3: " + lastComplaint +
                    "; `tukor render` needs no window");
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    gl::requireFeatures();
    gl::watchErrors(glfwGetProcAddress);
    glfwSetWindowUserPointer(window_, this);
    glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
        auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
        self.dropped_.insert(self.dropped_.end(), paths, paths + count);
    });
    // ImGui knows keys as down or up when a frame begins: it would miss those pressed and released
    // in a slow frame (see holdPressedKeys)
    glfwSetKeyCallback(
        window_, [](GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
            auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
            if (action != GLFW_RELEASE)
                self.presses_.push_back({key, modifiers, characterOf(key, scancode)});
        });
    glfwSetCharCallback(window_, [](GLFWwindow* handle, unsigned character) {
        static_cast<Window*>(glfwGetWindowUserPointer(handle))->typed_.push_back(character);
    });
    panel_ = std::make_unique<Panel>(window_);
    renderer_ = std::make_unique<PanelRenderer>();
}

Window::~Window() {
    renderer_.reset();
    panel_.reset();
    if (window_ != nullptr) glfwDestroyWindow(window_);
}

bool Window::closing() const noexcept {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() noexcept {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::handleEvents(bool busy, double seconds) {
    if (busy) {
        glfwPollEvents();
    } else {
        glfwWaitEventsTimeout(seconds);
    }
}

glm::ivec2 Window::framebufferSize() const noexcept {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::vec2 Window::framebufferScale() const noexcept {
    glm::ivec2 size(0);
    glfwGetWindowSize(window_, &size.x, &size.y);
    if (size.x < 1 || size.y < 1) return glm::vec2(1.0f);
    return glm::vec2(framebufferSize()) / glm::vec2(size);
}

float Window::contentScale() const noexcept {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return glm::clamp(y, 0.5f, 4.0f);
}

std::vector<std::string> Window::takeDroppedFiles() noexcept {
    return std::exchange(dropped_, {});
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::setClipboard(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}

bool Window::pressed(Key key) const {
    const auto any = [&](bool wantsControl, auto&& isIt) {
        return std::any_of(presses_.begin(), presses_.end(), [&](const Press& press) {
            return ((press.modifiers & GLFW_MOD_CONTROL) != 0) == wantsControl && isIt(press);
        });
    };
    // Layouts without Latin letters have Ctrl+C where that of the US has it.
    const auto withControl = [&](char letter, int place) {
        return any(true, [&](const Press& press) {
            return press.character == letter || (press.character == 0 && press.key == place);
        });
    };
    switch (key) {
        case Key::copy:
            return withControl('c', GLFW_KEY_C);
        case Key::quit:
            return withControl('q', GLFW_KEY_Q);
        default:
            return any(false, [&](const Press& press) { return press.key == glfwKey(key); });
    }
}

bool Window::held(Key key) const {
    return ImGui::IsKeyDown(glfwKey(key));
}

int Window::typed(std::string_view characters) const {
    return static_cast<int>(std::count_if(typed_.begin(), typed_.end(), [&](unsigned character) {
        return character < 128 && characters.find(static_cast<char>(character)) != characters.npos;
    }));
}

void Window::holdPressedKeys() {
    ImGuiIO& io = ImGui::GetIO();
    for (const Press& press : presses_) {
        if (press.key >= 0) io.KeysDown[press.key] = true;
        if ((press.modifiers & GLFW_MOD_CONTROL) != 0) io.KeyCtrl = true;
        if ((press.modifiers & GLFW_MOD_SHIFT) != 0) io.KeyShift = true;
    }
}

void Window::releaseKeys() {
    ImGuiIO& io = ImGui::GetIO();
    const auto down = [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; };
    for (const Press& press : presses_) {
        if (press.key >= 0) io.KeysDown[press.key] = down(press.key);
    }
    if (presses_.empty()) return;
    io.KeyCtrl = down(GLFW_KEY_LEFT_CONTROL) || down(GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = down(GLFW_KEY_LEFT_SHIFT) || down(GLFW_KEY_RIGHT_SHIFT);
}

void Window::beginFrame() {
    frameBegun_ = glfwGetTime();
    // ImGui sees one press or release a frame: where frames are slow a double click takes longer.
    ImGui::GetIO().MouseDoubleClickTime =
        std::clamp(4.0f * static_cast<float>(frameCost_), 0.5f, 2.0f);
    // the widgets are laid out in screen coordinates: text grows by what those do not account for
    const float textScale = contentScale() / framebufferScale().y;
    const float pixelScale = contentScale();
    if (pixelScale != fontScale_) {
        fontScale_ = pixelScale;
        ImGuiIO& io = ImGui::GetIO();
        io.Fonts->Clear();
        std::error_code ignored;
        if (std::filesystem::exists(kFontFile, ignored)) {
            io.Fonts->AddFontFromFileTTF(kFontFile, 14.0f * pixelScale);
        } else {
            ImFontConfig config;
            config.SizePixels = 13.0f * pixelScale;
            io.Fonts->AddFontDefault(&config);
        }
        io.FontGlobalScale = textScale / pixelScale;
        ImGui::GetStyle() = ImGuiStyle();
        ImGui::StyleColorsDark();
        ImGui::GetStyle().WindowRounding = 4.0f;
        ImGui::GetStyle().ScaleAllSizes(textScale);
        renderer_->uploadFonts();
    }
    ImGui_ImplGlfw_NewFrame();
    holdPressedKeys();
    ImGui::NewFrame();
}

void Window::endFrame() {
    ImGui::Render();
    renderer_->draw(*ImGui::GetDrawData());
    gl::throwPendingErrors("drawing the panel");
    glfwSwapBuffers(window_);
    releaseKeys();
    presses_.clear();
    typed_.clear();
    frameCost_ = glfwGetTime() - frameBegun_;
}

}  // namespace tukor
