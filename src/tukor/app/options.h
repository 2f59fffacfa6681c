// Every option of a picture: what is shown, under which light, from where, how well, how developed.
//
// Each group is described once, by describe(); the command line, --help, JSON, the window's panel
// and docs/options.md are visitors of it. A flag is the name given there.
#pragma once
#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/base/options.h"
#include "tukor/image/image_file.h"
#include "tukor/scene/placement.h"
#include "tukor/scene/render_options.h"

namespace tukor {

/// How a text option is named in usage lines.
struct Placeholder {
    std::string_view text;
};

/// Bounds of a number together with the name of its unit in usage lines.
template <class T>
struct Measure {
    std::string_view unit;
    Range<T> range;
    bool byRatio = false;  // small values matter as much as large ones
};

/// Pixels across and down.
struct PictureSize {
    int width = 1280;
    int height = 720;

    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// The largest picture in pixels: 1.2 GB of radiance.
inline constexpr long kMostPicturePixels = 100'000'000;

enum class Renderer { gl, trace };

struct SubjectOptions {
    std::vector<std::string> models;     // files and built-in shapes
    std::vector<std::string> materials;  // NAME or PATTERN=NAME, later ones win
    std::string variant;                 // of the model's own looks; empty: its own choice
    std::string animation;               // of the model's own, by name or number; empty: the first
    std::optional<float> timeSeconds;    // of that animation; none: at rest
    UpAxis up = UpAxis::y;               // of model files
    float scale = 1.0f;                  // of their lengths
    std::optional<float> dispersion;     // factor on that of clear materials; none: the files' own

    friend bool operator==(const SubjectOptions&, const SubjectOptions&) = default;
};

struct LightOptions {
    std::string environment = "studio";
    float rotationDegrees = 0.0f;
    float intensity = 1.0f;
    std::optional<int> faceSize;  // texels per edge of its cube map; none: by its resolution
    Background background = Background::quad;
    float backgroundBlur = 0.0f;
    std::vector<std::string> lights;  // beside it: DIRECTION[/COLOUR]
    std::string ground;               // its height, or `lowest`; empty: none

    friend bool operator==(const LightOptions&, const LightOptions&) = default;
};

struct CameraOptions {
    std::string camera;  // by name, from the model; empty: frame the model
    std::optional<glm::vec3> eye;
    std::optional<glm::vec3> target;
    std::optional<glm::vec3> up;
    std::optional<float> fovDegrees;  // vertical
    float aperture = 0.0f;            // diameter of the lens in metres
    std::optional<float> focus;       // metres; none: the distance of the target

    friend bool operator==(const CameraOptions&, const CameraOptions&) = default;
};

struct QualityOptions {
    std::optional<Renderer> renderer;
    Fidelity fidelity = Fidelity::exact;
    FresnelForm fresnel = FresnelForm::exact;
    PictureSize size;
    std::optional<int> samples;  // per pixel; none: the renderer's own choice
    std::optional<float> error;  // RMSE in 8-bit sRGB
    std::optional<float> seconds;
    std::vector<AovLayer> layers;
    int seed = 0;
    int rayBudget = 128;
    float weightCutoff = RenderOptions{}.weightCutoff;
    int maxDepth = 64;
    std::optional<int> threads;

    friend bool operator==(const QualityOptions&, const QualityOptions&) = default;
};

struct DevelopOptions {
    float exposureStops = 0.0f;
    Tonemap tonemap = Tonemap::neutral;
    PngDepth pngDepth = PngDepth::bits8;
    int jpegQuality = 92;
    ExrPixels exrPixels = ExrPixels::full;

    friend bool operator==(const DevelopOptions&, const DevelopOptions&) = default;
};

/// All that a picture depends on: equal options, equal pictures.
struct SessionOptions {
    SubjectOptions subject;
    LightOptions light;
    CameraOptions camera;
    QualityOptions quality;
    DevelopOptions develop;

    friend bool operator==(const SessionOptions&, const SessionOptions&) = default;
};

inline constexpr std::array<std::pair<Renderer, std::string_view>, 2> kRendererSpellings{
    {{Renderer::gl, "gl"}, {Renderer::trace, "trace"}}};
inline constexpr std::array<std::pair<Fidelity, std::string_view>, 3> kFidelitySpellings{
    {{Fidelity::single, "single"}, {Fidelity::two, "double"}, {Fidelity::exact, "exact"}}};
inline constexpr std::array<std::pair<FresnelForm, std::string_view>, 2> kFresnelSpellings{
    {{FresnelForm::exact, "exact"}, {FresnelForm::schlick, "schlick"}}};
inline constexpr std::array<std::pair<Background, std::string_view>, 4> kBackgroundSpellings{
    {{Background::quad, "quad"},
     {Background::box, "box"},
     {Background::dome, "dome"},
     {Background::none, "none"}}};
inline constexpr std::array<std::pair<AovLayer, std::string_view>, 4> kAovSpellings{
    {{AovLayer::depth, "depth"},
     {AovLayer::normal, "normal"},
     {AovLayer::material, "material"},
     {AovLayer::bounces, "bounces"}}};

/// `T` or `const T`.
template <class Options, class T>
concept OptionsOf = std::same_as<std::remove_const_t<Options>, T>;

template <OptionsOf<SubjectOptions> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("material", o.materials, Placeholder{"[PATTERN=]NAME"},
          "material of everything, or of the parts whose mesh or material name matches PATTERN (* "
          "and ? as in a shell); may be repeated, later ones win. NAME as in `tukor materials`, or "
          "figures: ior:1.2, metal:0.21,0.485,1.29/3.13,2.23,1.76, mirror:0.9,0.8,0.7, "
          "matt:0.8,0.2,0.1; rough where a roughness from 0 to 1 follows: gold+rough:0.2");
    field("variant", o.variant, Placeholder{"NAME"}, "one of the looks that a glTF model offers");
    field("animation", o.animation, Placeholder{"NAME"},
          "which animation of a glTF model, by name or by number from 0; the first without it");
    field("time-seconds", o.timeSeconds, Measure<float>{"S", {0.0f, 1e6f}},
          "a moment of a glTF model's animation; without it the model stands at rest");
    field("model-up", o.up, Spellings<UpAxis>(kUpAxisSpellings),
          "which axis of model files points up: y as in glTF, or z as in most STL and CAD, whose "
          "front, -y, then faces the camera; built-in shapes stay as they are");
    field("model-scale", o.scale, Measure<float>{"X", {1e-6f, 1e6f}, true},
          "factor on the lengths of model files, which are taken as metres: 0.001 for millimetres; "
          "how much coloured glass absorbs goes by them");
    field("dispersion", o.dispersion, Measure<float>{"X", {0.0f, 100.0f}},
          "factor on the dispersion of clear materials, 1 as measured; without it named materials "
          "have none and those of glTF files what the file says; a single sample shows none");
}

template <OptionsOf<LightOptions> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("environment", o.environment, Placeholder{"FILE|NAME"},
          "light from all around: .hdr, .exr, .png or .jpg (equirectangular, cross or six faces), "
          "or built in: studio, sky");
    field("environment-rotation", o.rotationDegrees, Measure<float>{"DEG", {-360.0f, 360.0f}},
          "turn of the environment about +Y, counter-clockwise seen from above");
    field("environment-intensity", o.intensity, Measure<float>{"X", {0.0f, 1e6f}},
          "factor on the environment's radiance");
    field(
        "background", o.background, Spellings<Background>(kBackgroundSpellings),
        "how the environment is drawn behind the model; quad, box and dome give the same picture; "
        "none: clear, but what glass refracts is in the picture");
    field(
        "background-blur", o.backgroundBlur, Measure<float>{"X", {0.0f, 1.0f}},
        "shows it behind the model as a surface of this roughness would; 0 is sharp, as is what is "
        "seen through glass");
    field(
        "light", o.lights, Placeholder{"X,Y,Z[/R,G,B]"},
        "light from one direction besides, seen by rough, diffuse and textured surfaces: where it "
        "comes from, and the colour of a white matt surface that faces it, 1,1,1 unless given; "
        "glass is dark in it; may be repeated");
    field("ground", o.ground, Placeholder{"Y|lowest"},
          "a ground at this height, or under the lowest point of the model: it shows the "
          "environment behind it, with the shadows on it and the light that things throw there; a "
          "single sample of gl shows none");
}

template <OptionsOf<CameraOptions> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    // 1000 km: beyond that a float has no centimetres left
    const Measure<float> place{"X,Y,Z", {-1e6f, 1e6f}};
    field("eye", o.eye, place, "where the camera stands; chosen to show the whole model");
    field("target", o.target, place, "what it looks at; the centre of the model");
    field("up", o.up, place,
          "which way is up in the picture; +Y, as in models and environments, which this does not "
          "turn");
    field("fov", o.fovDegrees, Measure<float>{"DEG", {0.1f, 175.0f}},
          "vertical field of view; 40, or that of --camera");
    field("camera", o.camera, Placeholder{"NAME"}, "a camera of the model file");
    field("aperture", o.aperture, Measure<float>{"M", {0.0f, 1e6f}},
          "diameter of the lens in metres, 0.018 for 50 mm at f/2.8: blurs what is nearer or "
          "farther than --focus; 0 blurs nothing (trace)");
    field("focus", o.focus, Measure<float>{"M", {1e-6f, 1e6f}, true},
          "distance from the eye, along the view, of what is sharp; that of the target");
}

template <OptionsOf<QualityOptions> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("size", o.size, Measure<int>{"WxH", {1, 16384}}, "picture size in pixels");
    field("samples", o.samples, Measure<int>{"N", {1, 65536}},
          "camera rays per pixel; the renderer's own choice, which for trace is: where they are "
          "worth most, at most 64, until --error 1");
    field(
        "error", o.error, Measure<float>{"E", {0.01f, 100.0f}},
        "go on until the expected RMSE of the picture, in 8-bit sRGB, is below E; --samples is "
        "then the most that a pixel gets; where suns glint in glass it may end above, and says so "
        "(trace)");
    field("time", o.seconds, Measure<float>{"S", {0.0f, 1e6f}},
          "stop after S seconds with the picture so far (trace)");
    field(
        "aov", o.layers, Spellings<AovLayer>(kAovSpellings),
        "further layers of an .exr, separated by commas: distance from the eye in metres, shading "
        "normal, number of the part, longest light path (trace)");
    field("seed", o.seed, Measure<int>{"N", {0, 2147483647}},
          "another one gives other noise of the same size (trace; gl at double and exact)");
    field(
        "fidelity", o.fidelity, Spellings<Fidelity>(kFidelitySpellings),
        "single: the textbook's one reflection and one refraction at the first surface; double: a "
        "second surface; exact: every reflection and refraction, inside and between objects");
    field("fresnel", o.fresnel, Spellings<FresnelForm>(kFresnelSpellings),
          "Fresnel's equations, or Schlick's approximation of them");
    field("renderer", o.renderer, Spellings<Renderer>(kRendererSpellings),
          "trace: the CPU; gl: OpenGL ES 3. By default trace for pictures, gl for the window");
    field("ray-budget", o.rayBudget, Measure<int>{"N", {1, 65536}},
          "rays that one camera ray may become at fidelity exact");
    field("weight-cutoff", o.weightCutoff, Measure<float>{"X", {0.0f, 1.0f}, true},
          "branches lighter than this become one look-up of the environment");
    field("max-depth", o.maxDepth, Measure<int>{"N", {1, 64}},
          "surfaces along one branch at fidelity exact");
    field("threads", o.threads, Measure<int>{"N", {1, 1024}}, "CPU threads; all cores");
}

template <OptionsOf<DevelopOptions> Options, class Visitor>
void describe(Options& o, Visitor&& field) {
    field("exposure", o.exposureStops, Measure<float>{"STOPS", {-16.0f, 16.0f}},
          "each stop doubles the radiance; 0 leaves it as it is");
    field("tonemap", o.tonemap, Spellings<Tonemap>(kTonemapSpellings),
          "how radiance becomes .png and .jpg; none clips. .exr and .hdr keep radiance");
    field("png-depth", o.pngDepth, Spellings<PngDepth>(kPngDepthSpellings), "bits a channel");
    field("jpeg-quality", o.jpegQuality, Measure<int>{"N", {1, 100}}, "100 is nearly lossless");
    field("exr-pixels", o.exrPixels, Spellings<ExrPixels>(kExrPixelsSpellings),
          "full: 32-bit floats; half: 16-bit, clipped at 65504");
}

/// Every group with its heading: group(heading, options of the group).
template <OptionsOf<SessionOptions> Options, class Visitor>
void describeGroups(Options& o, Visitor&& group) {
    group("Model", o.subject);
    group("Light", o.light);
    group("Camera", o.camera);
    group("Quality", o.quality);
    group("Development", o.develop);
}

}  // namespace tukor
