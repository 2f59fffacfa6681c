// The module's functions, called by web/src/engine.js. Results below zero are errors: tukor_error()
// has the sentence.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <emscripten/emscripten.h>
#include <fmt/format.h>

#include "answers.h"
#include "given_finish.h"
#include "scene_bytes.h"
#include "tukor/base/error.h"
#include "tukor/base/memory_file.h"
#include "tukor/image/display.h"
#include "tukor/image/radiance_file.h"
#include "tukor/scene/gltf_file.h"
#include "tukor/scene/gltf_textures.h"
#include "viewer.h"

namespace {

using tukor::Error;
using tukor::Image;
using tukor::web::Viewer;

using tukor::web::guarded;
using tukor::web::jsonString;
using tukor::web::kept;

Viewer* viewer = nullptr;  // goes with the instance, and what it has in WebGL with the context

Image pictureOf(int width, int height, const auto& pixelAt) {
    Image picture(width, height);
    std::size_t i = 0;
    for (glm::vec3& pixel : picture.pixels()) pixel = pixelAt(i++);
    return picture;
}

tukor::Scene modelOf(const char* name, std::span<const std::byte> bytes, const char* variant,
                     const char* animation, double seconds) {
    tukor::ModelOptions options;
    options.variant = variant;
    options.animation = animation;
    if (seconds >= 0.0) options.timeSeconds = seconds;
    tukor::Scene scene = tukor::loadGltf(name, bytes, options);
    tukor::forgetMemoryFiles();
    return scene;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* tukor_error() {
    return tukor::web::lastError.c_str();
}

EMSCRIPTEN_KEEPALIVE int tukor_start() {
    return guarded([] {
        viewer = new Viewer;
        return 0;
    });
}

EMSCRIPTEN_KEEPALIVE int tukor_clear_files() {
    tukor::forgetMemoryFiles();
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_add_file(const char* name, const std::byte* bytes, int size) {
    return guarded([&] {
        tukor::giveMemoryFile(name, std::vector<std::byte>(bytes, bytes + size));
        return 0;
    });
}

/// An image of the glTF file that is read next, four bytes a texel.
EMSCRIPTEN_KEEPALIVE int tukor_add_image(int index, const std::uint8_t* rgba, int width,
                                         int height) {
    return guarded([&] {
        tukor::giveGltfImage(static_cast<std::size_t>(index),
                             {width, height, 4, {rgba, rgba + std::ptrdiff_t{4} * width * height}});
        return 0;
    });
}

/// A glTF or GLB file; `seconds` below zero is none.
EMSCRIPTEN_KEEPALIVE int tukor_set_model(const char* name, const std::byte* bytes, int size,
                                         const char* variant, const char* animation,
                                         double seconds) {
    return guarded([&] {
        viewer->setScene(
            modelOf(name, {bytes, static_cast<std::size_t>(size)}, variant, animation, seconds));
        return 0;
    });
}

/// The same at another moment, without its images; 1 where it has other parts then, and is to be
/// set.
EMSCRIPTEN_KEEPALIVE int tukor_pose_model(const char* name, const std::byte* bytes, int size,
                                          const char* variant, const char* animation,
                                          double seconds) {
    return guarded([&] {
        return viewer->setPose(modelOf(name, {bytes, static_cast<std::size_t>(size)}, variant,
                                       animation, seconds))
                   ? 0
                   : 1;
    });
}

/// What extras_model() made.
EMSCRIPTEN_KEEPALIVE int tukor_set_scene(const std::byte* bytes, int size) {
    return guarded([&] {
        viewer->setScene(tukor::web::sceneFromBytes({bytes, static_cast<std::size_t>(size)}));
        return 0;
    });
}

EMSCRIPTEN_KEEPALIVE int tukor_set_materials(const char* specifications, float dispersion) {
    return guarded([&] {
        viewer->setMaterials(specifications, dispersion);
        return 0;
    });
}

/// A Radiance picture; the same for all pictures: 1 where it is no panorama, and
/// extras_environment() is to be asked.
EMSCRIPTEN_KEEPALIVE int tukor_set_environment(const char* name, const std::byte* bytes, int size) {
    return guarded([&] {
        const std::span file(bytes, static_cast<std::size_t>(size));
        if (!tukor::isRadiance(file))
            throw Error(fmt::format(
                "{}: not a picture: expected .hdr, .exr, .png, .jpg, .ktx2, .ktx or .dds", name));
        return viewer->setPanorama(tukor::decodeRadiance(file, name)) ? 0 : 1;
    });
}

/// Three floats a pixel, linear.
EMSCRIPTEN_KEEPALIVE int tukor_set_environment_radiance(const char*, const float* radiance,
                                                        int width, int height) {
    return guarded([&] {
        const auto pixel = [&](std::size_t i) {
            return glm::vec3(radiance[3 * i], radiance[3 * i + 1], radiance[3 * i + 2]);
        };
        return viewer->setPanorama(pictureOf(width, height, pixel)) ? 0 : 1;
    });
}

/// Four bytes a pixel, sRGB.
EMSCRIPTEN_KEEPALIVE int tukor_set_environment_srgb(const char*, const std::uint8_t* bytes,
                                                    int width, int height) {
    return guarded([&] {
        const auto& linear = tukor::linearFromSrgb8();
        const auto pixel = [&](std::size_t i) {
            return glm::vec3(linear[bytes[4 * i]], linear[bytes[4 * i + 1]],
                             linear[bytes[4 * i + 2]]);
        };
        return viewer->setPanorama(pictureOf(width, height, pixel)) ? 0 : 1;
    });
}

/// What extras_environment() made: six faces of three floats a texel.
EMSCRIPTEN_KEEPALIVE int tukor_set_environment_cube(const float* texels, int faceSize) {
    return guarded([&] {
        viewer->setCube(texels, faceSize);
        return 0;
    });
}

/// JSON of what the next frame needs of the third module: the light's address, width and height as
/// finish_light() takes them, and its scale; null for nothing.
EMSCRIPTEN_KEEPALIVE const char* tukor_light_wanted() {
    return kept(viewer->lightWanted());
}

/// What the third module made of it.
EMSCRIPTEN_KEEPALIVE int tukor_give_light(const std::uint64_t* chain, int chainBytes,
                                          const std::uint64_t* table, int tableBytes,
                                          const glm::vec4* ground, int groundBytes,
                                          const glm::vec4* spectrum, int spectrumBytes) {
    return guarded([&] {
        tukor::web::givenSpectrum.assign(spectrum, spectrum + spectrumBytes / 16);
        tukor::web::givenGround.assign(ground, ground + groundBytes / 16);
        tukor::web::givenLight = {{chain, chain + chainBytes / 8}, {table, table + tableBytes / 8}};
        return 0;
    });
}

EMSCRIPTEN_KEEPALIVE int tukor_give_shaders(const char* finish, const char* traced) {
    tukor::web::givenFinishShader = finish;
    tukor::web::givenTracedShader = traced;
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_set_option(const char* name, const char* text) {
    return guarded([&] {
        viewer->setOption(name, text);
        return 0;
    });
}

EMSCRIPTEN_KEEPALIVE int tukor_set_light(float rotation, float intensity) {
    viewer->setLight(rotation, intensity);
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_set_suns(const float* figures, int size) {
    viewer->setSuns({figures, static_cast<std::size_t>(size)});
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_set_max_depth(int depth) {
    viewer->setMaxDepth(depth);
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_set_background_blur(float blur) {
    viewer->setBackgroundBlur(blur);
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_set_ground(float height) {
    viewer->setGround(height);
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_set_exposure(float stops) {
    viewer->setExposure(stops);
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_set_camera(float eyeX, float eyeY, float eyeZ, float targetX,
                                          float targetY, float targetZ, float verticalFov) {
    tukor::Camera camera;
    camera.eye = glm::vec3(eyeX, eyeY, eyeZ);
    camera.target = glm::vec3(targetX, targetY, targetZ);
    camera.verticalFov = verticalFov;
    viewer->setCamera(camera);
    return 0;
}

/// Samples in the picture that is now in the canvas.
EMSCRIPTEN_KEEPALIVE int tukor_frame(int width, int height) {
    return guarded([&] { return viewer->drawFrame(width, height); });
}

/// The same while the picture changes.
EMSCRIPTEN_KEEPALIVE int tukor_moving_frame(int width, int height) {
    return guarded([&] { return viewer->drawMoving(width, height); });
}

/// Seconds that the last of tukor_moving_frame() took.
EMSCRIPTEN_KEEPALIVE void tukor_took(float seconds) {
    viewer->took(seconds);
}

EMSCRIPTEN_KEEPALIVE int tukor_restart() {
    viewer->restart();
    return 0;
}

/// Samples in the picture so far.
EMSCRIPTEN_KEEPALIVE int tukor_still_sample(int width, int height, int samples) {
    return guarded([&] { return viewer->drawStill(width, height, samples); });
}

/// Address of the picture's bytes; see Viewer::stillPixels.
EMSCRIPTEN_KEEPALIVE int tukor_still_pixels() {
    return guarded([] {
        return static_cast<int>(reinterpret_cast<std::uintptr_t>(viewer->stillPixels().data()));
    });
}

EMSCRIPTEN_KEEPALIVE int tukor_pick(float x, float y, float aspect) {
    return guarded([&] { return viewer->pick(x, y, aspect); });
}

/// JSON of the camera that shows the whole model: its eye and target, in metres, and its distance.
EMSCRIPTEN_KEEPALIVE const char* tukor_framing(float aspect) {
    const tukor::Camera camera = viewer->framing(aspect);
    const glm::vec3 eye = camera.eye, target = camera.target;
    return kept(fmt::format(R"({{"eye":[{},{},{}],"target":[{},{},{}],"size":{}}})", eye.x, eye.y,
                            eye.z, target.x, target.y, target.z,
                            tukor::boundsOf(viewer->scene()).radius()));
}

/// JSON array of the parts' names and of the names their materials have in the model.
EMSCRIPTEN_KEEPALIVE const char* tukor_parts() {
    std::string json = "[";
    for (const tukor::Part& part : viewer->scene().parts)
        json += fmt::format(R"({}{{"name":{},"material":{}}})", json.size() > 1 ? "," : "",
                            jsonString(part.name), jsonString(part.materialName));
    return kept(json + "]");
}

/// JSON array of sentences: what the files ask for and do not get.
EMSCRIPTEN_KEEPALIVE const char* tukor_warnings() {
    return kept(tukor::web::jsonArray(viewer->warnings()));
}
}
