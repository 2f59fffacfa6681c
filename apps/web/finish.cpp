// The third module, which a page fetches once there is a surface that is not ideally smooth, a
// ground or dispersion: its light and its shaders, handed to the first module as bytes.
#include <cstddef>
#include <cstring>
#include <string>

#include <emscripten/emscripten.h>

#include "answers.h"
#include "tukor/gl/finish_parts.h"

namespace {

using tukor::gl::FinishLight;
using tukor::web::guarded;

FinishLight light;
std::vector<glm::vec4> ground, spectrum;

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* finish_error() {
    return tukor::web::lastError.c_str();
}

/// Three floats a texel of a panorama, or of a cube map's faces below each other. Returns how many
/// bytes there are of the chain.
EMSCRIPTEN_KEEPALIVE int finish_light(const float* radiance, int width, int height, float scale) {
    return guarded([&] {
        tukor::gl::LightSource source;
        const std::size_t size = sizeof(glm::vec3) * static_cast<std::size_t>(width);
        if (width == 2 * height) {
            tukor::Image panorama(width, height);
            std::memcpy(panorama.pixels().data(), radiance, size * height);
            source.panorama = std::make_shared<tukor::Image>(std::move(panorama));
        } else {
            tukor::CubeMap cube(width);
            for (const tukor::CubeFace face : tukor::kCubeFaces)
                std::memcpy(cube.texels(face).data(),
                            radiance + 3 * width * width * static_cast<int>(face), size * width);
            source.cube = std::make_shared<tukor::CubeMap>(std::move(cube));
        }
        light = tukor::gl::finishLight(source, scale);
        spectrum = tukor::gl::spectrumTable();
        ground = tukor::gl::groundLight(source, scale, {});
        return static_cast<int>(8 * light.chain.size());
    });
}

EMSCRIPTEN_KEEPALIVE const void* finish_chain() {
    return light.chain.data();
}

EMSCRIPTEN_KEEPALIVE const void* finish_table() {
    return light.table.data();
}

/// Nothing, or 32 bytes for each of gl::kLitDirections.
EMSCRIPTEN_KEEPALIVE const void* finish_ground() {
    return ground.data();
}

EMSCRIPTEN_KEEPALIVE const void* finish_spectrum() {
    return spectrum.data();
}

EMSCRIPTEN_KEEPALIVE int finish_ground_bytes() {
    return static_cast<int>(16 * ground.size());
}

EMSCRIPTEN_KEEPALIVE const char* finish_shader() {
    return tukor::gl::finishShader().text;
}

EMSCRIPTEN_KEEPALIVE const char* finish_traced_shader() {
    return tukor::gl::wholeTracedShader().text;
}
}
