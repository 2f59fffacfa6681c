// A model and an environment to a picture: the whole way through the library.
//
//     minimal [MODEL [ENVIRONMENT [PICTURE]]]
#include <cstdio>
#include <exception>
#include <string>

#include "tukor/environment/environment.h"
#include "tukor/image/image_file.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/model_file.h"
#include "tukor/trace/render.h"

int main(int argc, char** argv) try {
    const auto argument = [&](int i, const char* otherwise) {
        return std::string(argc > i ? argv[i] : otherwise);
    };
    tukor::Scene scene = tukor::loadModel(argument(1, "torus-knot"));
    for (tukor::Part& part : scene.parts) part.material = tukor::parseMaterial("copper");

    tukor::RenderOptions options;
    options.width = 320;
    options.height = 180;
    options.samples = 16;
    const tukor::Rendering rendering =
        tukor::trace::render(scene, tukor::loadEnvironment(argument(2, "studio")),
                             tukor::framingCamera(scene, 16.0f / 9.0f), options);
    tukor::saveImage(argument(3, "minimal.png"), rendering.radiance);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "minimal: %s\n", error.what());
    return 1;
}
