// The module's functions, called by web/src/engine.js. Results below zero are errors: tukor_error()
// has the sentence.
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <emscripten/emscripten.h>
#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/memory_file.h"
#include "tukor/image/display.h"
#include "tukor/image/radiance_file.h"
#include "viewer.h"

namespace {

using tukor::Error;
using tukor::Image;
using tukor::web::Viewer;

std::unique_ptr<Viewer> viewer;
std::string lastError;
std::string lastText;

template <class Body>
int guarded(const Body& body) {
    try {
        return body();
    } catch (const std::bad_alloc&) {
        lastError = "out of memory";
    } catch (const std::exception& error) {
        lastError = error.what();
    }
    return -1;
}

std::string jsonString(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') json += '\\';
        if (static_cast<unsigned char>(c) < 0x20)
            json += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            json += c;
    }
    return json + '"';
}

const char* kept(std::string text) {
    lastText = std::move(text);
    return lastText.c_str();
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* tukor_error() {
    return lastError.c_str();
}

EMSCRIPTEN_KEEPALIVE int tukor_start() {
    return guarded([] {
        viewer = std::make_unique<Viewer>();
        return 0;
    });
}

EMSCRIPTEN_KEEPALIVE void tukor_stop() {
    viewer.reset();
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

/// A built-in shape where there are no bytes.
EMSCRIPTEN_KEEPALIVE int tukor_set_model(const char* name, const std::byte* bytes, int size) {
    return guarded([&] {
        std::string path = name;
        if (size > 0) {
            if (path.find('.') == path.npos) path += ".glb";  // the contents decide
            tukor::giveMemoryFile(path, std::vector<std::byte>(bytes, bytes + size));
        }
        viewer->setModel(path);
        tukor::forgetMemoryFiles();
        return 0;
    });
}

EMSCRIPTEN_KEEPALIVE int tukor_set_materials(const char* specifications) {
    return guarded([&] {
        viewer->setMaterials(specifications);
        return 0;
    });
}

/// A built-in environment where there are no bytes, else a Radiance picture.
EMSCRIPTEN_KEEPALIVE int tukor_set_environment(const char* name, const std::byte* bytes, int size) {
    return guarded([&] {
        if (size == 0) {
            viewer->setBuiltInEnvironment(name);
            return 0;
        }
        const std::span file(bytes, static_cast<std::size_t>(size));
        if (!tukor::isRadiance(file))
            throw Error(fmt::format("{}: not a picture: expected .hdr, .exr, .png or .jpg", name));
        viewer->setEnvironment(name, tukor::decodeRadiance(file, name));
        return 0;
    });
}

/// Three floats a pixel, linear.
EMSCRIPTEN_KEEPALIVE int tukor_set_environment_radiance(const char* name, const float* radiance,
                                                        int width, int height) {
    return guarded([&] {
        Image picture(width, height);
        for (glm::vec3& pixel : picture.pixels()) {
            pixel = glm::vec3(radiance[0], radiance[1], radiance[2]);
            radiance += 3;
        }
        viewer->setEnvironment(name, std::move(picture));
        return 0;
    });
}

/// Four bytes a pixel, sRGB.
EMSCRIPTEN_KEEPALIVE int tukor_set_environment_srgb(const char* name, const std::uint8_t* bytes,
                                                    int width, int height) {
    return guarded([&] {
        Image picture(width, height);
        const auto& linear = tukor::linearFromSrgb8();
        for (glm::vec3& pixel : picture.pixels()) {
            pixel = glm::vec3(linear[bytes[0]], linear[bytes[1]], linear[bytes[2]]);
            bytes += 4;
        }
        viewer->setEnvironment(name, std::move(picture));
        return 0;
    });
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

EMSCRIPTEN_KEEPALIVE int tukor_restart() {
    viewer->restart();
    return 0;
}

EMSCRIPTEN_KEEPALIVE int tukor_still_sample(int width, int height) {
    return guarded([&] {
        viewer->drawStill(width, height);
        return 0;
    });
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
    std::string json = "[";
    for (const std::string& warning : viewer->warnings())
        json += (json.size() > 1 ? "," : "") + jsonString(warning);
    return kept(json + "]");
}
}
