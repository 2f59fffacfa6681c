#include "viewer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include "tukor/app/option_text.h"
#include "tukor/app/pick.h"
#include "tukor/base/error.h"
#include "tukor/environment/repair.h"
#include "tukor/image/display.h"
#include "tukor/scene/assign_materials.h"

namespace tukor::web {

namespace {

constexpr int kLargestPanorama =
    4096;  // 64 MB of texels: more a phone's tab should not be asked for

Image halved(const Image& picture) {
    const int width = picture.width() / 2;
    Image half(width, picture.height() / 2);
    for (int row = 0; row < half.height(); ++row)
        for (int column = 0; column < width; ++column)
            half.at(column, row) =
                0.25f *
                (picture.at(2 * column, 2 * row) + picture.at(2 * column + 1, 2 * row) +
                 picture.at(2 * column, 2 * row + 1) + picture.at(2 * column + 1, 2 * row + 1));
    return half;
}

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
    display_.tonemap = Tonemap::neutral;  // as in `tukor render`
}

void Viewer::setScene(Scene scene) {
    renderer_.setScene(scene);
    scene_ = std::move(scene);
    lowest_ = boundsOf(scene_).least.y;
    ownLights_ = scene_.lights.size();
    ownMaterials_.clear();
    for (const Part& part : scene_.parts) ownMaterials_.push_back(part.material);
}

bool Viewer::setPose(Scene scene) {
    const auto same = [](const Part& a, const Part& b) {
        return a.name == b.name && a.materialName == b.materialName;
    };
    if (!std::equal(scene.parts.begin(), scene.parts.end(), scene_.parts.begin(),
                    scene_.parts.end(), same) ||
        scene.lights.size() != ownLights_)
        return false;
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        scene_.parts[i].mesh = std::move(scene.parts[i].mesh);
    std::move(scene.lights.begin(), scene.lights.end(), scene_.lights.begin());
    renderer_.setPose(scene_);
    lowest_ = boundsOf(scene_).least.y;
    return true;
}

void Viewer::setSuns(std::span<const float> figures) {
    while (scene_.lights.size() > ownLights_) scene_.lights.pop_back();
    for (std::size_t i = 0; i < figures.size(); i += 6) {
        const float* sun = &figures[i];
        Light light;
        light.direction = -glm::normalize(glm::vec3(sun[0], sun[1], sun[2]));
        light.intensity = std::numbers::pi_v<float> * glm::vec3(sun[3], sun[4], sun[5]);
        scene_.lights.push_back(std::move(light));
    }
    renderer_.setLights(scene_.lights);
}

void Viewer::setMaterials(std::string_view specifications, float dispersion) {
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
    if (dispersion >= 0.0f) setDispersion(bare, dispersion);
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
        if (scene_.parts[i].material == bare.parts[i].material) continue;
        scene_.parts[i].material = bare.parts[i].material;
        renderer_.setMaterial(static_cast<int>(i), scene_.parts[i].material);
    }
    restart();
}

bool Viewer::setPanorama(Image picture) {
    if (picture.width() != 2 * picture.height()) return false;
    std::vector<std::string> warnings = describeRepairs(repairRadiance(picture));
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    while (picture.width() > std::min(largest, kLargestPanorama)) picture = halved(picture);
    // Looked up as it is: no cube map is made that nobody would look at.
    useEnvironment(
        {"", CubeMap(1), std::move(warnings), std::make_shared<const Image>(std::move(picture))});
    return true;
}

void Viewer::setCube(const float* texels, int faceSize) {
    CubeMap cube(faceSize);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : cube.texels(face)) {
            texel = glm::vec3(texels[0], texels[1], texels[2]);
            texels += 3;
        }
    useEnvironment({"", std::move(cube), {}});
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
    if (ground_ < std::numeric_limits<float>::infinity())
        frame.picture.ground = std::isinf(ground_) ? lowest_ : ground_;
    return frame;
}

int Viewer::drawFrame(int width, int height) {
    renderer_.drawFrame(camera_, frameOptions(width, height));
    return present(width, height);
}

int Viewer::drawMoving(int width, int height) {
    gl::FrameOptions frame = frameOptions(width, height);
    frame.picture = pace_.whileMoving(frame.picture);
    restart();
    renderer_.drawFrame(camera_, frame);
    return present(width, height);
}

int Viewer::present(int width, int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    renderer_.present(display_, {0, 0, width, height});
    return renderer_.accumulatedSamples();
}

int Viewer::drawStill(int width, int height, int samples) {
    gl::FrameOptions frame = frameOptions(width, height);
    frame.picture.samples = samples;
    renderer_.drawFrame(camera_, frame);
    return renderer_.accumulatedSamples();
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

std::string Viewer::lightWanted() const {
    if (!renderer_.preparesLight(frameOptions(1, 1).picture)) return "null";
    const gl::LightSource& source = renderer_.lightChain().source();
    const int width = source.panorama ? source.panorama->width() : source.cube->faceSize();
    const glm::vec3* const texels = source.panorama ? source.panorama->pixels().data()
                                                    : source.cube->texels(CubeFace::posX).data();
    return fmt::format(R"({{"at":{},"width":{},"height":{},"scale":{}}})",
                       reinterpret_cast<std::uintptr_t>(texels), width,
                       source.panorama ? width / 2 : 6 * width, renderer_.lightChain().scale());
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
