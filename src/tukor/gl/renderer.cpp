#include "tukor/gl/renderer.h"

#include <algorithm>
#include <cmath>

#include "tukor/base/error.h"
#include "tukor/gl/errors.h"
#include "tukor/gl/full_viewport.h"
#include "tukor/gl/shaders.h"
#include "tukor/transport/look_ups.h"

namespace tukor::gl {

namespace {

// A multisampled frame has four samples of the outline and four look-ups; a plain one has one of
// the outline, which jitter spreads over the whole pixel. The first few frames are multisampled.
constexpr int kSamplesPerFrame = 4;
constexpr int kMultisampledFrames = 2;

/// Directions of the world in the environment's own axes: the environment turned by `angle` about
/// +Y, counter-clockwise seen from above, is looked up turned back.
glm::mat3 environmentFromWorld(float angle) {
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return {c, 0.0f, s, 0.0f, 1.0f, 0.0f, -s, 0.0f, c};
}

/// Directional lights that shine on ground, in the environment's axes; `factor` on their intensity.
std::vector<LitDirection> sunsOnGround(const std::vector<Light>& lights, const glm::mat3& turn,
                                       float factor) {
    std::vector<LitDirection> suns;
    for (const Light& light : lights)
        if (light.kind == LightKind::directional && light.direction.y < 0.0f)
            suns.push_back(
                {turn * -light.direction, light.intensity * (factor * -light.direction.y)});
    return suns;
}

void setState(bool depthTest) {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DITHER);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (depthTest) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
    } else {
        glDisable(GL_DEPTH_TEST);
    }
}

/// What frames are drawn as: a blurred background is added to their sum.
RenderOptions framePicture(const FrameOptions& options) {
    RenderOptions picture = options.picture;
    if (blursBackground(picture)) picture.background = Background::none;
    return picture;
}

void bindTexture(int unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

constexpr TracedDrawer::Units kUnits{7, 9, 10, 12, 13, 14};  // after the environment and the scene

}  // namespace

void Renderer::setScene(const Scene& scene, Preparation preparation) {
    materials_.clear();
    for (const Part& part : scene.parts) materials_.push_back(part.material);
    finishes_.clear();
    setPose(scene, preparation);
}

void Renderer::setPose(const Scene& scene, Preparation preparation) {
    TUKOR_ASSERT(scene.parts.size() == materials_.size());
    bounds_ = boundsOf(scene);
    surfaces_ = SurfaceBuffers(scene);
    tracedScene_ = preparation == Preparation::all ? TracedScene(scene) : TracedScene();
    setLights(scene.lights);
    throwPendingErrors("uploading the model");
}

void Renderer::setLights(const std::vector<Light>& lights) {
    lights_ = lights;
    forget();
}

void Renderer::setMaterial(int part, const Material& material) {
    TUKOR_ASSERT(part >= 0 && part < surfaces_.parts());
    materials_[static_cast<std::size_t>(part)] = material;
    if (tracedScene_.ready()) tracedScene_.setMaterials(materials_);
    forget();
}

void Renderer::setEnvironment(const Environment& environment, Preparation preparation) {
    environment_ = Surroundings(environment, preparation);
    forget();
    throwPendingErrors("uploading the environment");
}

void Renderer::drawFrame(const Camera& camera, const FrameOptions& options) {
    const int width = options.picture.width;
    const int height = options.picture.height;
    drawFrame(camera, options, {width, height, 0, 0, width, height});
}

void Renderer::drawFrame(const Camera& camera, const FrameOptions& options,
                         const PictureWindow& window) {
    TUKOR_ASSERT(environment_.texture.faceSize() > 0);
    const Subject subject{camera, options, window};
    if (subject_ != subject) resetAccumulation();
    subject_ = subject;
    if (buffers_.width() != window.width || buffers_.height() != window.height)
        buffers_ = FrameBuffers(window.width, window.height);

    const std::vector<Look> looks = looksOf(subject);
    const bool traced = std::any_of(looks.begin(), looks.end(), [](const Look& look) {
        return look.fidelity != Fidelity::single;
    });
    const bool rasterised =
        tracedScene_.finished() || std::any_of(looks.begin(), looks.end(), [](const Look& look) {
            return look.fidelity == Fidelity::single;
        });
    const int perFrame = traced ? 1 : kSamplesPerFrame;
    const int planned = (options.picture.samples.value_or(0) + perFrame - 1) / perFrame;
    const glm::vec2 point = frames_ < planned ? evenPoint(frames_, planned) : evenPoint(frames_);

    glViewport(0, 0, window.width, window.height);
    glDisable(GL_SCISSOR_TEST);
    if (rasterised) drawRasterised(subject, looks, point);
    const View view = tracedView(subject, point);
    if (traced && firstHitsHelp(subject)) {
        setState(true);
        buffers_.beginFirstHits();
        traced_.drawFirstHits(tracedScene_, view);
    }
    buffers_.bindNextSum(rasterised ? Counting::none : counting_);
    setState(false);
    for (const Look& look : looks) {
        if (look.fidelity == Fidelity::single)
            accumulate(look);
        else
            drawTraced(subject, look, view);
    }
    buffers_.swapSums();
    ++frames_;
    samples_ += perFrame;
    if (blursBackground(options.picture)) blurBackground(subject);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    throwPendingErrors("drawing a frame");
}

bool Renderer::preparesLight(const RenderOptions& options) const noexcept {
    const LightChain& chain = environment_.chain;
    if (options.ground && !chain.groundReady()) return true;
    if (tracedScene_.disperses() && !partsAtHand()) return true;
    const bool finished = std::any_of(materials_.begin(), materials_.end(),
                                      [](const Material& m) { return m.finish != nullptr; });
    return (finished || tracedScene_.finished() || options.backgroundBlur > 0.0f) && !chain.ready();
}

std::vector<Renderer::Look> Renderer::looksOf(const Subject& subject) const {
    const bool finished = std::all_of(materials_.begin(), materials_.end(),
                                      [](const Material& m) { return m.finish != nullptr; });
    std::vector<Look> looks = askedLooks(subject);
    if (finished && !subject.options.picture.ground)  // nothing to trace through or by
        for (Look& look : looks) look.fidelity = Fidelity::single;
    return looks;
}

std::vector<Renderer::Look> Renderer::askedLooks(const Subject& subject) const {
    const RenderOptions& picture = subject.options.picture;
    const int width = subject.window.width;
    if (!subject.options.comparison) return {{picture.fidelity, picture.fresnel, 0, width}};
    const Comparison& other = *subject.options.comparison;
    const auto column =
        static_cast<int>(std::lround(other.splitX * static_cast<float>(subject.window.fullWidth)));
    const int split = std::clamp(column - subject.window.left, 0, width);
    std::vector<Look> looks;
    if (split > 0) looks.push_back({picture.fidelity, picture.fresnel, 0, split});
    if (split < width) looks.push_back({other.fidelity, other.fresnel, split, width});
    return looks;
}

void Renderer::drawRasterised(const Subject& subject, const std::vector<Look>& looks,
                              glm::vec2 point) {
    // The look-ups tile the pixel. A plain frame looks from anywhere in the pixel and its look-ups
    // move half as far as it does; a multisampled one has its own spread already and moves only
    // within the quarter that each of its samples stands for.
    const RenderOptions picture = framePicture(subject.options);
    const bool single = std::all_of(looks.begin(), looks.end(), [](const Look& look) {
        return look.fidelity == Fidelity::single;
    });
    const bool multisampled =
        single && frames_ < kMultisampledFrames && picture.samples.value_or(0) < 32;
    const glm::vec2 jitter = multisampled ? 0.25f * point : point;
    const glm::vec2 footprintMiddle = 0.5f * point - jitter;
    const View view = viewOf(subject.camera, subject.window, jitter, bounds_);
    const glm::mat3 turn = environmentFromWorld(picture.environmentRotation);

    setState(true);
    if (multisampled)
        buffers_.beginMultisampled();
    else
        buffers_.beginPlain();
    Surroundings& around = surroundings(picture.environmentIntensity);
    around.texture.bind(0);
    const auto drawBackground = [&] {
        background_.draw(picture.background, view, turn, footprintMiddle, around.texture);
    };
    const FinishFrame frame{view,
                            turn,
                            footprintMiddle,
                            around.texture.define(),
                            1.0f / radiancePerUnit(picture.environmentIntensity),
                            lights_};
    const auto drawFinishes = [&](FinishDrawer::Pass pass) {
        finishes_.draw(surfaces_, materials_, pass, around.chain, frame);
    };
    glEnable(GL_SCISSOR_TEST);
    for (const Look& look : looks) {
        glScissor(look.left, 0, look.right - look.left, subject.window.height);
        if (look.fidelity != Fidelity::single) {  // smooth surfaces only hide what is behind them
            glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
            single_.draw(surfaces_, materials_, look.fresnel, view, turn, footprintMiddle,
                         around.texture.define());
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            drawFinishes(FinishDrawer::Pass::opaque);
            drawFinishes(FinishDrawer::Pass::blended);
            continue;
        }
        if (subject.options.backgroundOrder == BackgroundOrder::first) drawBackground();
        single_.draw(surfaces_, materials_, look.fresnel, view, turn, footprintMiddle,
                     around.texture.define());
        drawFinishes(FinishDrawer::Pass::opaque);
        if (subject.options.backgroundOrder == BackgroundOrder::last) drawBackground();
        drawFinishes(FinishDrawer::Pass::blended);
    }
    glDisable(GL_SCISSOR_TEST);
    if (multisampled) buffers_.endMultisampled();
}

void Renderer::accumulate(const Look& look) {
    if (!accumulateProgram_)
        accumulateProgram_.emplace(shaders::fullViewportVert, shaders::accumulateFrag);
    bindTexture(0, buffers_.frame());
    bindTexture(1, buffers_.sum());
    accumulateProgram_->set("frame", 0);
    accumulateProgram_->set("sum", 1);
    accumulateProgram_->set("first", frames_ == 0 ? 1 : 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(look.left, 0, look.right - look.left, buffers_.height());
    drawFullViewport(*accumulateProgram_);
    glDisable(GL_SCISSOR_TEST);
}

void Renderer::blurBackground(const Subject& subject) {
    buffers_.bindNextSum(Counting::none);
    bindTexture(0, buffers_.sum());
    const RenderOptions& picture = subject.options.picture;
    const float level =
        surroundings(picture.environmentIntensity).chain.bindBlurred(1, picture.backgroundBlur);
    background_.drawBehind(frames_,
                           viewOf(subject.camera, subject.window, glm::vec2(0.0f), bounds_),
                           environmentFromWorld(picture.environmentRotation), level);
    buffers_.showNextSum();
}

Renderer::Surroundings& Renderer::surroundings(float intensity) {
    if (intensity > 0.0f) return environment_;
    if (darkness_.texture.faceSize() == 0) {
        Environment none{"", CubeMap(1), {}};
        darkness_ = Surroundings(none, Preparation::all);
    }
    return darkness_;
}

float Renderer::radiancePerUnit(float intensity) {
    return surroundings(intensity).texture.scale() * (intensity > 0.0f ? intensity : 1.0f);
}

View Renderer::tracedView(const Subject& subject, glm::vec2 point) const {
    return viewOf(subject.camera, subject.window, tracedScene_.finished() ? point : glm::vec2(0.0f),
                  bounds_);
}

bool Renderer::centred(const Subject& subject) const {
    return tracedScene_.finished() || subject.options.picture.samples.value_or(0) == 1;
}

bool Renderer::firstHitsHelp(const Subject& subject) const {
    return centred(subject) && liesBeyondNearPlane(subject.camera, bounds_);
}

void Renderer::drawTraced(const Subject& subject, const Look& look, const View& view) {
    if (!tracedScene_.ready()) throw Error("the scene was prepared for fidelity single alone");
    const RenderOptions picture = framePicture(subject.options);
    const bool finished = tracedScene_.finished();
    Surroundings& around = surroundings(picture.environmentIntensity);
    // Neighbouring samples are as far apart as the number of them says, if it is known; else as the
    // number so far.
    // From there on a sample is small enough for few to graze: see docs/notes/rims.md.
    constexpr float kSplitFrom = 64.0f;
    const auto samples = static_cast<float>(std::max(picture.samples.value_or(0), frames_ + 1));
    bindTexture(kUnits.sum, buffers_.sum());
    bindTexture(kUnits.sum + 1, buffers_.counts());
    if (finished) {
        bindTexture(kUnits.raster, buffers_.frame());
        around.chain.bind(kUnits.chain);
    }
    if (firstHitsHelp(subject)) bindTexture(kUnits.firstHits, buffers_.firstHits());
    const glm::mat3 turn = environmentFromWorld(picture.environmentRotation);
    const float emissionFactor = 1.0f / radiancePerUnit(picture.environmentIntensity);
    std::optional<TracedDrawer::Ground> ground;
    if (picture.samples != 1)
        ground = groundOf(picture, TracedDrawer::GroundUse::traced);
    else if (groundLight_.samples(picture) > 0) {
        ground = groundOf(picture, TracedDrawer::GroundUse::known);
        bindTexture(kUnits.groundLight, groundLight_.mean());
        if (ground) ground->level = groundLight_.level();
    }
    const bool count = counting_ == Counting::all && !subject.options.comparison;
    traced_.draw(tracedScene_, around.texture,
                 {view, subject.window, picture, look.fidelity, look.fresnel, turn,
                  transport::kSampleFootprint / std::sqrt(samples),
                  picture.splitGrazing && samples >= kSplitFrom, frames_, centred(subject),
                  firstHitsHelp(subject), lights_, emissionFactor, ground},
                 count ? Counting::all : Counting::none, kUnits,
                 {look.left, 0, look.right - look.left, subject.window.height});
}

std::optional<TracedDrawer::Ground> Renderer::groundOf(const RenderOptions& picture,
                                                       TracedDrawer::GroundUse use) {
    if (!picture.ground) return std::nullopt;
    Surroundings& around = surroundings(picture.environmentIntensity);
    const std::vector<LitDirection> suns =
        sunsOnGround(lights_, environmentFromWorld(picture.environmentRotation),
                     around.texture.scale() / radiancePerUnit(picture.environmentIntensity));
    const glm::vec3 middle = bounds_.empty() ? glm::vec3(0.0f) : bounds_.centre();
    const TracedDrawer::Ground ground{
        {middle.x, *picture.ground, middle.z},
        kGroundSize * std::max(bounds_.empty() ? 1.0f : bounds_.radius(), 1e-3f),
        around.chain.bindGround(kUnits.ground, suns),
        use};
    if (ground.irradiance == glm::vec3(0.0f)) return std::nullopt;
    return ground;
}

void Renderer::gatherGroundLight(const Camera& camera, const FrameOptions& options) {
    const RenderOptions& picture = options.picture;
    const int samples = groundLight_.samples(picture);
    if (samples >= GroundLight::kEnough || picture.fidelity == Fidelity::single ||
        !tracedScene_.ready())
        return;
    const std::optional<TracedDrawer::Ground> ground =
        groundOf(picture, TracedDrawer::GroundUse::gathered);
    if (!ground) return;
    Surroundings& around = surroundings(picture.environmentIntensity);
    bindTexture(kUnits.sum, groundLight_.mean());
    if (tracedScene_.finished()) around.chain.bind(kUnits.chain);
    constexpr int kSize = GroundLight::kSize;
    constexpr PictureWindow kAll{kSize, kSize, 0, 0, kSize, kSize};
    glViewport(0, 0, kSize, kSize);
    glDisable(GL_SCISSOR_TEST);
    groundLight_.bindNext();
    setState(false);
    traced_.draw(tracedScene_, around.texture,
                 {viewOf(camera, kAll, glm::vec2(0.0f), bounds_), kAll, picture, picture.fidelity,
                  picture.fresnel, environmentFromWorld(picture.environmentRotation),
                  transport::kSampleFootprint / std::sqrt(static_cast<float>(GroundLight::kEnough)),
                  false, samples, false, false, lights_,
                  1.0f / radiancePerUnit(picture.environmentIntensity), ground},
                 Counting::none, kUnits, {0, 0, kSize, kSize});
    groundLight_.count(picture);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    throwPendingErrors("gathering the light on the ground");
}

void Renderer::present(const DisplayOptions& options, const Viewport& viewport) {
    if (frames_ == 0) return;
    if (!presentProgram_) presentProgram_.emplace(shaders::fullViewportVert, shaders::presentFrag);
    setState(false);
    glDisable(GL_SCISSOR_TEST);
    glViewport(viewport.left, viewport.bottom, viewport.width, viewport.height);
    bindTexture(0, buffers_.shown());
    presentProgram_->set("sum", 0);
    presentProgram_->set("corner", glm::vec2(viewport.left, viewport.bottom));
    presentProgram_->set("sumPerPixel", glm::vec2(buffers_.width(), buffers_.height()) /
                                            glm::vec2(viewport.width, viewport.height));
    presentProgram_->set("factor", std::exp2(options.exposureStops) * radiancePerSum());
    presentProgram_->set("coverage", 1.0f / static_cast<float>(frames_));
    presentProgram_->set("tonemap", static_cast<int>(options.tonemap));
    presentProgram_->set("behind", options.behind);
    drawFullViewport(*presentProgram_);
    throwPendingErrors("showing the picture");
}

float Renderer::radiancePerSum() {
    return radiancePerUnit(subject_->options.picture.environmentIntensity) /
           static_cast<float>(frames_);
}

}  // namespace tukor::gl
