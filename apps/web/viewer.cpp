#include "viewer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <GLES3/gl3.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

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

constexpr int kLargestFaceSize = 1024;  // 75 MB of texels, more than a phone's tab should be asked

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

// A value by its spelling or within its bounds; `name` opens the message where it is neither.
template <class T, class Extra>
void assign(T& value, const Extra& extra, std::string_view name, std::string_view text) {
    try {
        value = valueFromText(ValueType<T>{}, extra, text);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", name, error.what()));
    }
}

}  // namespace

Viewer::Viewer() {
    gl::requireFeatures();
    display_.tonemap = Tonemap::neutral;  // as in `tukor render`
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
    environmentWarnings_ = std::move(environment.warnings);
}

void Viewer::setOption(std::string_view name, std::string_view text) {
    if (name == "fidelity")
        assign(options_.fidelity, Spellings<Fidelity>(kFidelitySpellings), name, text);
    else if (name == "fresnel")
        assign(options_.fresnel, Spellings<FresnelForm>(kFresnelSpellings), name, text);
    else if (name == "background")
        assign(options_.background, Spellings<Background>(kBackgroundSpellings), name, text);
    else if (name == "tone-map")
        assign(display_.tonemap, Spellings<Tonemap>(kTonemapSpellings), name, text);
    else
        throw Error(fmt::format("{}: no such option", name));
    restart();
}

void Viewer::setLight(float rotation, float intensity) noexcept {
    options_.environmentRotation = rotation;
    options_.environmentIntensity = intensity;
}

gl::FrameOptions Viewer::frameOptions(int width, int height) const noexcept {
    gl::FrameOptions frame;
    frame.picture = options_;
    frame.picture.width = width;
    frame.picture.height = height;
    return frame;
}

int Viewer::drawFrame(int width, int height) {
    renderer_.drawFrame(camera_, frameOptions(width, height));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    renderer_.present(display_, {0, 0, width, height});
    return renderer_.accumulatedSamples();
}

void Viewer::drawStill(int width, int height) {
    renderer_.drawFrame(camera_, frameOptions(width, height));
}

std::span<const std::uint8_t> Viewer::stillPixels() {
    const Rendering rendering = renderer_.read();
    const Image& image = rendering.radiance;
    const float exposure = std::exp2(display_.exposureStops);
    pixels_.resize(4 * image.pixels().size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const float alpha = image.alpha.empty() ? 1.0f : std::clamp(image.alpha[i], 0.0f, 1.0f);
        const glm::vec3 radiance = alpha > 0.0f ? image.pixels()[i] / alpha : glm::vec3(0.0f);
        const glm::vec3 shown = displayed(radiance, display_.tonemap, exposure);
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

}  // namespace tukor::web
