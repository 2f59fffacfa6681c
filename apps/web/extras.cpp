// The second module, which a page fetches when it needs it: built-in shapes and skies, model
// formats other than glTF, and pictures of environments that are cube maps. What it makes goes to
// the first module as bytes.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <emscripten/emscripten.h>
#include <fmt/format.h>

#include "answers.h"
#include "scene_bytes.h"
#include "tukor/base/error.h"
#include "tukor/base/memory_file.h"
#include "tukor/environment/environment.h"
#include "tukor/environment/texture_chain.h"
#include "tukor/image/display.h"
#include "tukor/image/radiance_file.h"
#include "tukor/image/texture_file.h"
#include "tukor/scene/model_file.h"

namespace {

using tukor::Environment;
using tukor::Error;
using tukor::Image;
using tukor::web::guarded;

std::vector<std::byte> made;
std::vector<std::string> warnings;

// The faces one after the other; its result is their edge.
int keepCube(Environment environment) {
    made.clear();
    for (const tukor::CubeFace face : tukor::kCubeFaces) {
        const auto bytes = std::as_bytes(std::as_const(environment.radiance).texels(face));
        made.insert(made.end(), bytes.begin(), bytes.end());
    }
    warnings = std::move(environment.warnings);
    return environment.radiance.faceSize();
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* extras_error() {
    return tukor::web::lastError.c_str();
}

EMSCRIPTEN_KEEPALIVE int extras_add_file(const char* name, const std::byte* bytes, int size) {
    return guarded([&] {
        tukor::giveMemoryFile(name, std::vector<std::byte>(bytes, bytes + size));
        return 0;
    });
}

/// A built-in shape where there are no bytes. The scene's bytes are kept.
EMSCRIPTEN_KEEPALIVE int extras_model(const char* name, const std::byte* bytes, int size) {
    return guarded([&] {
        std::string path = name;
        if (size > 0) {
            if (path.find('.') == path.npos) path += ".ply";  // the contents decide
            tukor::giveMemoryFile(path, std::vector<std::byte>(bytes, bytes + size));
        }
        made = tukor::web::bytesFromScene(tukor::loadModel(path));
        tukor::forgetMemoryFiles();
        return 0;
    });
}

/// A built-in environment where there are no bytes, else a Radiance picture. The cube's texels are
/// kept, its edge returned.
EMSCRIPTEN_KEEPALIVE int extras_environment(const char* name, const std::byte* bytes, int size) {
    return guarded([&] {
        if (size > 0) {
            const std::span file(bytes, static_cast<std::size_t>(size));
            return keepCube(tukor::environmentFromPicture(name, tukor::decodeRadiance(file, name)));
        }
        std::optional<Environment> builtIn = tukor::builtInEnvironment(name);
        if (!builtIn)
            throw Error(
                fmt::format("{}: no such environment; built in are {}, anything else is a file",
                            name, fmt::join(tukor::builtInEnvironmentNames(), ", ")));
        return keepCube(std::move(*builtIn));
    });
}

/// Three floats a pixel, linear.
EMSCRIPTEN_KEEPALIVE int extras_environment_radiance(const char* name, const float* radiance,
                                                     int width, int height) {
    return guarded([&] {
        Image picture(width, height);
        for (glm::vec3& pixel : picture.pixels()) {
            pixel = glm::vec3(radiance[0], radiance[1], radiance[2]);
            radiance += 3;
        }
        return keepCube(tukor::environmentFromPicture(name, std::move(picture)));
    });
}

/// Four bytes a pixel, sRGB.
EMSCRIPTEN_KEEPALIVE int extras_environment_srgb(const char* name, const std::uint8_t* bytes,
                                                 int width, int height) {
    return guarded([&] {
        Image picture(width, height);
        const auto& linear = tukor::linearFromSrgb8();
        for (glm::vec3& pixel : picture.pixels()) {
            pixel = glm::vec3(linear[bytes[0]], linear[bytes[1]], linear[bytes[2]]);
            bytes += 4;
        }
        return keepCube(tukor::environmentFromPicture(name, std::move(picture)));
    });
}

/// A texture file, its first level.
EMSCRIPTEN_KEEPALIVE int extras_environment_texture(const char* name, const std::byte* bytes,
                                                    int size) {
    return guarded([&] {
        tukor::TextureFile texture =
            tukor::decodeTexture({bytes, static_cast<std::size_t>(size)}, name);
        if (texture.faces == 1)
            return keepCube(tukor::environmentFromPicture(name, std::move(texture.images.front())));
        std::vector<std::string> repairs = tukor::repairFaces(name, texture);
        return keepCube({name, tukor::cubeFromTexture(texture), std::move(repairs)});
    });
}

/// What was made last.
EMSCRIPTEN_KEEPALIVE const std::byte* extras_bytes() {
    return made.data();
}

EMSCRIPTEN_KEEPALIVE int extras_size() {
    return static_cast<int>(made.size());
}

/// JSON array of sentences about the environment made last; a scene holds its own.
EMSCRIPTEN_KEEPALIVE const char* extras_warnings() {
    return tukor::web::kept(tukor::web::jsonArray(warnings));
}
}
