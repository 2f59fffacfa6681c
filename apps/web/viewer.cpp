#include "viewer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <GLES3/gl3.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tukor/app/option_table.h"
#include "tukor/app/option_text.h"
#include "tukor/app/pick.h"
#include "tukor/base/error.h"
#include "tukor/environment/equirect.h"
#include "tukor/geometry/shapes.h"
#include "tukor/gl/context.h"
#include "tukor/image/display.h"
#include "tukor/scene/assign_materials.h"
#include "tukor/scene/model_file.h"

namespace tukor::web {

namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;
constexpr int kLargestFaceSize = 1024;  // 75 MB of texels, more than a phone's tab should be asked

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

// Calls action(value, default value, extra) for the option of that name.
template <class Action>
void withOption(SessionOptions& options, std::string_view name, const Action& action) {
    SessionOptions defaults;
    bool found = false;
    describeGroups(options, [&](std::string_view, auto& group) {
        describe(group, [&](std::string_view field, auto& value, const auto& extra, auto&&...) {
            if (field != name) return;
            found = true;
            action(value, extra);
        });
    });
    if (!found) throw Error(fmt::format("{}: no such option", name));
}

}  // namespace

Viewer::Viewer() {
    gl::requireFeatures();
}

void Viewer::setModel(const std::string& name) {
    const auto shapes = shapeNames();
    const bool file = name.find('.') != name.npos;
    if (!file && std::find(shapes.begin(), shapes.end(), name) == shapes.end())
        throw Error(fmt::format("{}: no such model; expected a file or one of {}", name,
                                fmt::join(shapes, ", ")));
    Scene scene = loadModel(name);
    renderer_.setScene(scene);
    scene_ = std::move(scene);
    ownMaterials_.clear();
    for (const Part& part : scene_.parts) ownMaterials_.push_back(part.material);
    options_.subject = {{name}, {}};
}

void Viewer::setMaterials(std::string_view specifications) {
    std::vector<std::string> list;
    while (!specifications.empty()) {
        const std::size_t end = std::min(specifications.find(';'), specifications.size());
        if (const std::string_view one = trimmed(specifications.substr(0, end)); !one.empty())
            list.emplace_back(one);
        specifications.remove_prefix(std::min(end + 1, specifications.size()));
    }
    Scene bare;  // names only: assignment does not look at meshes
    for (std::size_t i = 0; i < scene_.parts.size(); ++i)
        bare.parts.push_back(
            {scene_.parts[i].name, scene_.parts[i].materialName, ownMaterials_[i], {}});
    assignMaterials(bare, list);
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
        if (scene_.parts[i].material == bare.parts[i].material) continue;
        scene_.parts[i].material = bare.parts[i].material;
        renderer_.setMaterial(static_cast<int>(i), scene_.parts[i].material);
    }
    options_.subject.materials = std::move(list);
    restart();
}

void Viewer::setBuiltInEnvironment(std::string_view name) {
    std::optional<Environment> environment = builtInEnvironment(name);
    if (!environment)
        throw Error(fmt::format("{}: no such environment; built in are {}, anything else is a file",
                                name, fmt::join(builtInEnvironmentNames(), ", ")));
    useEnvironment(std::move(*environment));
}

void Viewer::setEnvironment(const std::string& name, Image picture) {
    EnvironmentOptions options;
    if (picture.width() == 2 * picture.height() &&
        faceSizeForEquirect(picture.width()) > kLargestFaceSize)
        options.faceSize = kLargestFaceSize;
    Environment environment = environmentFromPicture(name, std::move(picture), options);
    environment.panorama = nullptr;
    useEnvironment(std::move(environment));
}

void Viewer::useEnvironment(Environment environment) {
    renderer_.setEnvironment(environment);
    options_.light.environment = environment.name;
    environmentWarnings_ = std::move(environment.warnings);
}

void Viewer::setOption(std::string_view name, std::string_view text) {
    withOption(options_, name, [&](auto& value, const auto& extra) {
        try {
            auto changed = value;
            assignFromText(changed, extra, text);
            value = changed;
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", name, error.what()));
        }
    });
}

void Viewer::resetOption(std::string_view name) {
    SessionOptions defaults;
    std::vector<std::string> texts;
    withOption(defaults, name,
               [&](auto& value, const auto& extra) { texts = textsFromOption(value, extra); });
    for (const std::string& text : texts) setOption(name, text);
}

gl::FrameOptions Viewer::frameOptions(int width, int height) const noexcept {
    gl::FrameOptions frame;
    RenderOptions& picture = frame.picture;
    picture.width = width;
    picture.height = height;
    picture.fidelity = options_.quality.fidelity;
    picture.fresnel = options_.quality.fresnel;
    picture.background = options_.light.background;
    picture.environmentRotation = options_.light.rotationDegrees * kDegree;
    picture.environmentIntensity = options_.light.intensity;
    picture.rayBudget = options_.quality.rayBudget;
    picture.weightCutoff = options_.quality.weightCutoff;
    picture.maxDepth = options_.quality.maxDepth;
    return frame;
}

int Viewer::drawFrame(int width, int height) {
    options_.quality.size = {width, height};
    renderer_.drawFrame(camera_, frameOptions(width, height));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::DisplayOptions display;
    display.exposureStops = options_.develop.exposureStops;
    display.tonemap = options_.develop.tonemap;
    renderer_.present(display, {0, 0, width, height});
    return renderer_.accumulatedSamples();
}

void Viewer::drawStill(int width, int height) {
    renderer_.drawFrame(camera_, frameOptions(width, height));
}

std::span<const std::uint8_t> Viewer::stillPixels() {
    const Rendering rendering = renderer_.read();
    const Image& image = rendering.radiance;
    const float exposure = std::exp2(options_.develop.exposureStops);
    pixels_.resize(4 * image.pixels().size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const float alpha = image.alpha.empty() ? 1.0f : std::clamp(image.alpha[i], 0.0f, 1.0f);
        const glm::vec3 radiance = alpha > 0.0f ? image.pixels()[i] / alpha : glm::vec3(0.0f);
        const glm::vec3 shown = displayed(radiance, options_.develop.tonemap, exposure);
        for (int c = 0; c < 3; ++c) pixels_[4 * i + c] = srgb8(shown[c]);
        pixels_[4 * i + 3] = static_cast<std::uint8_t>(std::lround(255.0f * alpha));
    }
    return pixels_;
}

int Viewer::pick(float x, float y, float aspect) const {
    constexpr int height = 4096;  // fine enough: x and y are fractions of it
    const int width = std::max(1, static_cast<int>(std::lround(aspect * height)));
    const glm::vec3 direction =
        rayDirection(camera_, width, height, x * static_cast<float>(width), y * height);
    const std::optional<Pick> found = tukor::pick(scene_, camera_.eye, direction);
    return found ? static_cast<int>(found->part) + 1 : 0;
}

Camera Viewer::framing(float aspect) const noexcept {
    return framingCamera(scene_, aspect);
}

std::vector<std::string> Viewer::warnings() const {
    std::vector<std::string> all = scene_.warnings;
    all.insert(all.end(), environmentWarnings_.begin(), environmentWarnings_.end());
    for (std::string& warning : closednessWarnings(scene_)) all.push_back(std::move(warning));
    return all;
}

std::string Viewer::commandLine() const {
    SessionOptions options = options_;
    options.camera.eye = camera_.eye;
    options.camera.target = camera_.target;
    options.camera.fovDegrees = camera_.verticalFov / kDegree;
    return tukor::commandLine("tukor render", options);
}

}  // namespace tukor::web
