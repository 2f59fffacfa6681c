// The built-in sky as a panorama of 32-bit floats with a smaller, brighter sun: radiance 1e5, of
// the same irradiance. Halves end at 65504.
//
// usage: bright_sky WIDTH OUT.exr
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "tukor/environment/panorama.h"
#include "tukor/environment/procedural.h"
#include "tukor/image/image_file.h"

namespace tukor {
namespace {

float brightest(const Image& image) {
    float most = 0.0f;
    for (const glm::vec3& pixel : image.pixels()) most = std::max(most, pixel.x);
    return most;
}

void run(int width, const char* path) {
    const auto sky = [&](float sunSize) {
        return panoramaFromCube(skyCube(width / 2, {.sunSize = sunSize}), width);
    };
    const Image picture = sky(std::sqrt(brightest(sky(1.0f)) / 1e5f));
    saveImage(path, picture);
    fmt::print("{} x {}, at most {:.4g}\n", width, width / 2, brightest(picture));
}

}  // namespace
}  // namespace tukor

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "usage: bright_sky WIDTH OUT.exr\n");
        return 2;
    }
    try {
        tukor::run(std::atoi(argv[1]), argv[2]);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "bright_sky: {}\n", error.what());
        return 1;
    }
}
