#include "tukor/app/session.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tukor/app/option_text.h"
#include "tukor/app/suggestion.h"
#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/scene/assign_materials.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/model_file.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {
namespace {

enum class Naming { byName, byNumberToo };

bool isAmong(const std::vector<std::string>& names, const std::string& name, Naming naming) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return true;
    for (std::size_t i = 0; naming == Naming::byNumberToo && i < names.size(); ++i) {
        if (fmt::format("{}", i) == name) return true;
    }
    return false;
}

/// What each model is asked: a name of one model need not be known to the others, but to one.
std::vector<ModelOptions> modelOptions(const SubjectOptions& subject) {
    std::vector<ModelOptions> all(subject.models.size());
    if (subject.variant.empty() && subject.animation.empty() && !subject.timeSeconds) return all;
    bool variantKnown = subject.variant.empty();
    bool animationKnown = subject.animation.empty();
    std::vector<std::string> variants, animations;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const ModelChoices choices = choicesOf(subject.models[i]);
        for (const std::string& name : choices.variants) variants.push_back(printable(name));
        for (std::size_t n = 0; n < choices.animations.size(); ++n) {
            const std::string& name = choices.animations[n];
            animations.push_back(name.empty() ? fmt::format("{}", n) : printable(name));
        }
        if (isAmong(choices.variants, subject.variant, Naming::byName)) {
            all[i].variant = subject.variant;
            variantKnown = true;
        }
        const bool moves = subject.animation.empty() ||
                           isAmong(choices.animations, subject.animation, Naming::byNumberToo);
        animationKnown = animationKnown || moves;
        if (!moves) continue;
        all[i].animation = subject.animation;
        if (subject.timeSeconds) all[i].timeSeconds = *subject.timeSeconds;
    }
    const auto views = [](const std::vector<std::string>& names) {
        return std::vector<std::string_view>(names.begin(), names.end());
    };
    if (!variantKnown) throw Error(unknownInModel("variant", subject.variant, views(variants)));
    if (!animationKnown)
        throw Error(unknownInModel("animation", subject.animation, views(animations)));
    if (subject.timeSeconds && animations.empty())
        throw Error(
            fmt::format("time-seconds {}: the model has no animations (those of glTF "
                        "are shown)",
                        *subject.timeSeconds));
    return all;
}

Scene loadModels(const SubjectOptions& subject) {
    if (subject.models.empty()) throw Error("no model; a file or a built-in shape expected");
    const std::vector<ModelOptions> options = modelOptions(subject);
    Scene scene;
    for (std::size_t i = 0; i < options.size(); ++i) {
        Scene model = loadModel(subject.models[i], options[i]);
        if (!meansShape(subject.models[i])) place(model, subject.up, subject.scale);
        append(scene, std::move(model));
    }
    return scene;
}

std::vector<Material> materialsOf(const Scene& scene) {
    std::vector<Material> materials;
    for (const Part& part : scene.parts) materials.push_back(part.material);
    return materials;
}

/// Whether what renderers keep of a part for `before` lacks what `after` shows: its pictures, and
/// colours of its vertices.
bool showsMore(const Finish* after, const Finish* before) {
    if (after == nullptr || after == before) return false;
    if (before == nullptr || after->ignoresColors != before->ignoresColors) return true;
    return !std::equal(
        after->maps.begin(), after->maps.end(), before->maps.begin(),
        [](const TextureMap& a, const TextureMap& b) { return a.texels == b.texels; });
}

bool showMore(const Scene& scene, const std::vector<Material>& before) {
    for (std::size_t i = 0; i < before.size(); ++i)
        if (showsMore(scene.parts[i].material.finish.get(), before[i].finish.get())) return true;
    return false;
}

const Camera& namedCamera(const Scene& scene, const std::string& name) {
    std::vector<std::string_view> known;
    for (const NamedCamera& candidate : scene.cameras) {
        if (candidate.name == name) return candidate.camera;
        known.emplace_back(candidate.name);
    }
    throw Error(unknownInModel("camera", name, known));
}

/// Frames the scene whatever the field of view: the distance grows as the view narrows.
Camera framing(const Scene& scene, float aspect, const std::optional<float>& fovDegrees) {
    Camera camera = framingCamera(scene, aspect);
    if (fovDegrees) {
        const float fov = glm::radians(*fovDegrees);
        camera.eye =
            camera.target + (camera.eye - camera.target) *
                                (std::sin(0.5f * camera.verticalFov) / std::sin(0.5f * fov));
        camera.verticalFov = fov;
    }
    return camera;
}

}  // namespace

SessionOptions withModels(SessionOptions options, std::vector<std::string> models) {
    const std::optional<float> dispersion = options.subject.dispersion;
    options.subject = {};
    options.subject.models = std::move(models);
    options.subject.dispersion = dispersion;
    options.camera = {};
    return options;
}

Camera cameraFromOptions(const CameraOptions& options, const Scene& scene, PictureSize size) {
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    Camera camera = options.camera.empty() ? framing(scene, aspect, options.fovDegrees)
                                           : namedCamera(scene, options.camera);
    if (options.eye) camera.eye = *options.eye;
    if (options.target) camera.target = *options.target;
    if (options.up) camera.up = *options.up;
    if (options.fovDegrees) camera.verticalFov = glm::radians(*options.fovDegrees);
    camera.lensDiameter = options.aperture;
    camera.focus = options.focus.value_or(0.0f);
    if (camera.eye == camera.target) {
        throw Error(
            fmt::format("eye and target are both {},{},{}; a camera needs a direction to "
                        "look in: give another --eye or --target",
                        camera.eye.x, camera.eye.y, camera.eye.z));
    }
    if (camera.up == glm::vec3(0.0f)) throw Error("up is 0,0,0; a direction expected, as in 0,1,0");
    return camera;
}

CameraOptions optionsFromCamera(const Camera& camera, const CameraOptions& before) {
    CameraOptions options;
    options.eye = camera.eye;
    options.target = camera.target;
    if (camera.up != Camera{}.up) options.up = camera.up;
    options.aperture = camera.lensDiameter;
    if (camera.focus > 0.0f) options.focus = camera.focus;
    const float degrees = before.fovDegrees.value_or(40.0f);
    options.fovDegrees =
        glm::radians(degrees) == camera.verticalFov ? degrees : glm::degrees(camera.verticalFov);
    return options;
}

Light lightFromText(std::string_view text) {
    const Measure<float> any{"X,Y,Z", {-1e6f, 1e6f}};
    const auto slash = text.find('/');
    Light light;
    light.name = text;
    try {
        const glm::vec3 from = valueFromText(ValueType<glm::vec3>{}, any, text.substr(0, slash));
        if (!(glm::length(from) > 0.0f)) throw Error("0,0,0 is no direction");
        light.direction = -glm::normalize(from);
        glm::vec3 colour(1.0f);
        if (slash != text.npos)
            colour = valueFromText(ValueType<glm::vec3>{}, Measure<float>{"R,G,B", {0.0f, 1e6f}},
                                   text.substr(slash + 1));
        light.intensity = colour * std::numbers::pi_v<float>;
    } catch (const Error& error) {
        throw Error(fmt::format("light '{}': {}; expected X,Y,Z or X,Y,Z/R,G,B", text.substr(0, 60),
                                error.what()));
    }
    return light;
}

std::optional<float> groundFromText(std::string_view text, const Scene& scene) {
    if (text.empty()) return std::nullopt;
    if (text == "lowest") {
        const Bounds bounds = boundsOf(scene);
        return bounds.empty() ? 0.0f : bounds.least.y;
    }
    try {
        return valueFromText(ValueType<float>{}, Measure<float>{"Y", {-1e6f, 1e6f}}, text);
    } catch (const Error& error) {
        throw Error(
            fmt::format("ground: {}; expected a height in metres, or lowest", error.what()));
    }
}

Session::Session(const SessionOptions& options, LookUps lookUps) : lookUps_(lookUps) {
    // before anything is loaded, which is work for them, too
    if (options.quality.threads) setThreadCount(*options.quality.threads);
    apply(options);
}

void Session::apply(const SessionOptions& options) {
    const bool first = !environment_;
    std::optional<Scene> scene;
    std::optional<Environment> environment;
    std::vector<Material> own = ownMaterials_;
    const bool modelsChange = first || options.subject.models != options_.subject.models ||
                              options.subject.variant != options_.subject.variant ||
                              options.subject.animation != options_.subject.animation ||
                              options.subject.timeSeconds != options_.subject.timeSeconds ||
                              options.subject.up != options_.subject.up ||
                              options.subject.scale != options_.subject.scale;
    const bool materialsChange = modelsChange ||
                                 options.subject.materials != options_.subject.materials ||
                                 options.subject.dispersion != options_.subject.dispersion;
    if (modelsChange) {
        scene = loadModels(options.subject);
        own = materialsOf(*scene);
    }
    if (first || options.light.environment != options_.light.environment ||
        options.light.faceSize != options_.light.faceSize) {
        environment = loadEnvironment(
            options.light.environment,
            {.faceSize = options.light.faceSize, .cubeBesidePanorama = lookUps_ == LookUps::cube});
    }
    std::vector<Light> ownLights = scene ? scene->lights : ownLights_;
    std::vector<Light> lights = ownLights;
    for (const std::string& light : options.light.lights) lights.push_back(lightFromText(light));
    const bool lightsChange = modelsChange || options.light.lights != options_.light.lights;
    Scene& target = scene ? *scene : scene_;
    (void)groundFromText(options.light.ground, target);
    const std::vector<Material> before = materialsOf(target);
    try {
        if (materialsChange) {
            for (std::size_t i = 0; i < own.size(); ++i) target.parts[i].material = own[i];
            assignMaterials(target, options.subject.materials);
            if (options.subject.dispersion) setDispersion(target, *options.subject.dispersion);
        }
        camera_ = cameraFromOptions(options.camera, target, options.quality.size);
    } catch (const Error&) {
        for (std::size_t i = 0; i < before.size(); ++i) target.parts[i].material = before[i];
        throw;
    }
    if (scene) {
        scene_ = std::move(*scene);
        ownMaterials_ = std::move(own);
    }
    if (showMore(scene_, before)) ++sceneRevision_;
    if (lightsChange) {
        scene_.lights = std::move(lights);
        ownLights_ = std::move(ownLights);
        ++sceneRevision_;
    }
    if (environment) {
        environment_ = std::move(environment);
        ++environmentRevision_;
    }
    if (options.quality.threads != options_.quality.threads) {
        setThreadCount(options.quality.threads.value_or(0));
    }
    options_ = options;
}

RenderOptions Session::renderOptions() const {
    const QualityOptions& quality = options_.quality;
    RenderOptions render;
    render.width = quality.size.width;
    render.height = quality.size.height;
    render.samples = quality.samples;
    render.error = quality.error;
    render.timeSeconds = quality.seconds;
    render.layers = quality.layers;
    render.seed = static_cast<std::uint32_t>(quality.seed);
    render.fidelity = quality.fidelity;
    render.fresnel = quality.fresnel;
    render.background = options_.light.background;
    render.backgroundBlur = options_.light.backgroundBlur;
    render.environmentRotation = glm::radians(options_.light.rotationDegrees);
    render.environmentIntensity = options_.light.intensity;
    render.rayBudget = quality.rayBudget;
    render.weightCutoff = quality.weightCutoff;
    render.maxDepth = quality.maxDepth;
    render.ground = groundFromText(options_.light.ground, scene_);
    return render;
}

}  // namespace tukor
