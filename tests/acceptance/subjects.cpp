#include "acceptance/subjects.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/model_file.h"
#ifdef TUKOR_TRACE
#include "tukor/trace/render.h"
#endif
#ifdef TUKOR_GL
#include "tukor/gl/render.h"
#endif

namespace tukor::acceptance {

namespace {

constexpr bool available([[maybe_unused]] Renderer renderer) {
#ifndef TUKOR_TRACE
    if (renderer == Renderer::trace) return false;
#endif
#ifndef TUKOR_GL
    if (renderer == Renderer::gl) return false;
#endif
    return true;
}

/// A background has no sphere in it: the camera looks the other way and the sphere is behind it.
Camera cameraFor(const Subject& subject, Camera camera) {
    if (subject.truth == Truth::background) camera.target = 2.0f * camera.eye - camera.target;
    return camera;
}

}  // namespace

std::vector<Trial> trials() {
    constexpr int kSamples = 64;
    std::vector<Trial> all;
    const auto add = [&](const Trial& trial) {
        if (available(trial.renderer)) all.push_back(trial);
    };
    const Subject nothing{"", Truth::background};
    for (const Renderer renderer : {Renderer::gl, Renderer::trace}) {
        add({nothing, renderer, Fidelity::single, kSamples, 0.7});
    }
    for (const char* material : {"gold", "silver", "mirror:0.9,0.8,0.7"}) {
        const Subject subject{material, Truth::reflecting};
        add({subject, Renderer::gl, Fidelity::single, kSamples, 1.0});
        add({subject, Renderer::gl, Fidelity::single, std::nullopt, 2.5});
        add({subject, Renderer::gl, Fidelity::exact, kSamples, 0.5});
        add({subject, Renderer::trace, Fidelity::exact, kSamples, 0.5});
    }
    for (const char* material : {"glass", "water"}) {
        const Subject subject{material, Truth::singleInterface};
        add({subject, Renderer::gl, Fidelity::single, kSamples, 1.0});
        add({subject, Renderer::gl, Fidelity::single, std::nullopt, 2.5});
        add({subject, Renderer::trace, Fidelity::single, kSamples, 1.0});
    }
    for (const char* material : {"glass", "water", "ior:1.2", "ior:2.42"}) {
        const Subject subject{material, Truth::solid};
        add({subject, Renderer::trace, Fidelity::exact, kSamples, 0.5});
        add({subject, Renderer::gl, Fidelity::exact, kSamples, 1.0});
        if (std::string_view(material) == "glass") {
            add({subject, Renderer::trace, Fidelity::two, kSamples, 12.0});
            add({subject, Renderer::gl, Fidelity::two, kSamples, 12.0});
        }
    }
    return all;
}

std::string describe(const Subject& subject) {
    switch (subject.truth) {
        case Truth::background:
            return "background";
        case Truth::reflecting:
            return subject.material;
        case Truth::singleInterface:
            return subject.material + ", one interface";
        case Truth::solid:
            return subject.material + ", solid";
    }
    return "";
}

std::string describe(const Trial& trial) {
    constexpr std::array kFidelities = {"single", "double", "exact"};
    return fmt::format("{} {} {}", trial.renderer == Renderer::gl ? "gl" : "trace",
                       kFidelities[static_cast<std::size_t>(trial.fidelity)],
                       trial.samples ? fmt::format("{} samples", *trial.samples) : "default");
}

Image expected(const Subject& subject, const oracle::Environment& light, const Camera& camera,
               int width, int height, int samples) {
    const auto view = [&]() -> oracle::View {
        switch (subject.truth) {
            case Truth::background:
                break;
            case Truth::reflecting:
                return oracle::reflectingSphere(parseMaterial(subject.material), light);
            case Truth::singleInterface:
                return oracle::singleInterfaceSphere(parseMaterial(subject.material), light);
            case Truth::solid:
                return oracle::solidSphere(parseMaterial(subject.material), light);
        }
        return oracle::background(light);
    };
    return oracle::picture(cameraFor(subject, camera), width, height, samples, view());
}

Rendering rendered(const Trial& trial, const Environment& environment, const Camera& camera,
                   int width, int height) {
    Scene scene = loadModel("sphere");
    const bool nothing = trial.subject.material.empty();
    for (Part& part : scene.parts) {
        part.material = parseMaterial(nothing ? "mirror" : trial.subject.material);
    }
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.samples = trial.samples;
    options.fidelity = trial.fidelity;
    const Camera placed = cameraFor(trial.subject, camera);
#ifdef TUKOR_TRACE
    if (trial.renderer == Renderer::trace)
        return trace::render(scene, environment, placed, options);
#endif
#ifdef TUKOR_GL
    if (trial.renderer == Renderer::gl) return gl::render(scene, environment, placed, options);
#endif
    throw Error(fmt::format("{}: not in this build", describe(trial)));
}

std::vector<std::string> installedPanoramas() {
    std::vector<std::string> found;
    for (const char* folder : {"/usr/share/blender/datafiles/studiolights/world"}) {
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
            if (entry.path().extension() == ".exr") found.push_back(entry.path().string());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace tukor::acceptance
