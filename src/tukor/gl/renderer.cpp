#include "tukor/gl/renderer.h"

#include <algorithm>
#include <cmath>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/gl/errors.h"
#include "tukor/gl/full_viewport.h"
#include "tukor/gl/shaders.h"

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

void bindTexture(int unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

}  // namespace

void Renderer::setScene(const Scene& scene) {
    bounds_ = boundsOf(scene);
    materials_.clear();
    for (const Part& part : scene.parts) materials_.push_back(part.material);
    surfaces_ = SurfaceBuffers(scene);
    resetAccumulation();
    throwPendingErrors("uploading the model");
}

void Renderer::setMaterial(int part, const Material& material) {
    TUKOR_ASSERT(part >= 0 && part < surfaces_.parts());
    materials_[static_cast<std::size_t>(part)] = material;
    resetAccumulation();
}

void Renderer::setEnvironment(const Environment& environment, EnvironmentLevels levels) {
    environment_ = EnvironmentTexture(environment.radiance);
    if (levels == EnvironmentLevels::all) environment_.needLevels(environment.radiance);
    resetAccumulation();
    throwPendingErrors("uploading the environment");
}

void Renderer::drawFrame(const Camera& camera, const FrameOptions& options) {
    const int width = options.picture.width;
    const int height = options.picture.height;
    drawFrame(camera, options, {width, height, 0, 0, width, height});
}

void Renderer::drawFrame(const Camera& camera, const FrameOptions& options,
                         const PictureWindow& window) {
    TUKOR_ASSERT(environment_.faceSize() > 0);
    const Subject subject{camera, options, window};
    if (subject_ != subject) resetAccumulation();
    subject_ = subject;
    if (buffers_.width() != window.width || buffers_.height() != window.height)
        buffers_ = FrameBuffers(window.width, window.height);

    // The look-ups tile the pixel: see surface.frag. A plain frame looks from anywhere in the pixel
    // and its look-ups move half as far as it does; a multisampled one has its own spread already
    // and moves only within the quarter that each of its samples stands for.
    const bool multisampled =
        frames_ < kMultisampledFrames && options.picture.samples.value_or(0) < 32;
    const int planned =
        (options.picture.samples.value_or(0) + kSamplesPerFrame - 1) / kSamplesPerFrame;
    const glm::vec2 point = frames_ < planned ? evenPoint(frames_, planned) : evenPoint(frames_);
    const glm::vec2 jitter = multisampled ? 0.25f * point : point;
    const glm::vec2 footprintMiddle = 0.5f * point - jitter;

    glViewport(0, 0, window.width, window.height);
    glDisable(GL_SCISSOR_TEST);
    setState(true);
    if (multisampled)
        buffers_.beginMultisampled();
    else
        buffers_.beginPlain();
    environment_.bind(0);

    const RenderOptions& picture = options.picture;
    if (!options.comparison) {
        drawLook(picture.fidelity, picture.fresnel, subject, jitter, footprintMiddle);
    } else {
        const Comparison& other = *options.comparison;
        const int split = std::clamp(
            static_cast<int>(std::lround(other.splitX * static_cast<float>(window.fullWidth))) -
                window.left,
            0, window.width);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, split, window.height);
        drawLook(picture.fidelity, picture.fresnel, subject, jitter, footprintMiddle);
        glScissor(split, 0, window.width - split, window.height);
        drawLook(other.fidelity, other.fresnel, subject, jitter, footprintMiddle);
        glDisable(GL_SCISSOR_TEST);
    }

    if (multisampled) buffers_.endMultisampled();
    accumulate();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    throwPendingErrors("drawing a frame");
}

void Renderer::drawLook(Fidelity, FresnelForm fresnel, const Subject& subject, glm::vec2 jitter,
                        glm::vec2 footprintMiddle) {
    const RenderOptions& picture = subject.options.picture;
    const View view = viewOf(subject.camera, subject.window, jitter, bounds_);
    const glm::mat3 turn = environmentFromWorld(picture.environmentRotation);
    const auto drawBackground = [&] {
        background_.draw(picture.background, view, turn, footprintMiddle, environment_.faceSize());
    };
    if (subject.options.backgroundOrder == BackgroundOrder::first) drawBackground();
    single_.draw(surfaces_, materials_, fresnel, view, turn, footprintMiddle);
    if (subject.options.backgroundOrder == BackgroundOrder::last) drawBackground();
}

void Renderer::accumulate() {
    if (!accumulateProgram_)
        accumulateProgram_.emplace(shaders::fullViewportVert, shaders::accumulateFrag);
    setState(false);
    buffers_.bindNextSum();
    bindTexture(0, buffers_.frame());
    bindTexture(1, buffers_.sum());
    accumulateProgram_->set("frame", 0);
    accumulateProgram_->set("sum", 1);
    accumulateProgram_->set("first", frames_ == 0 ? 1 : 0);
    drawFullViewport(*accumulateProgram_);
    buffers_.swapSums();
    ++frames_;
    samples_ += kSamplesPerFrame;
}

void Renderer::present(const DisplayOptions& options, const Viewport& viewport) {
    if (frames_ == 0) return;
    if (!presentProgram_) presentProgram_.emplace(shaders::fullViewportVert, shaders::presentFrag);
    setState(false);
    glDisable(GL_SCISSOR_TEST);
    glViewport(viewport.left, viewport.bottom, viewport.width, viewport.height);
    bindTexture(0, buffers_.sum());
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

float Renderer::radiancePerSum() const {
    return environment_.scale() * subject_->options.picture.environmentIntensity /
           static_cast<float>(frames_);
}

Rendering Renderer::read() {
    const int width = buffers_.width();
    const int height = buffers_.height();
    Rendering rendering;
    rendering.radiance = Image(width, height);
    if (frames_ == 0) return rendering;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<glm::vec4> sums(count);
    buffers_.bindSumForReading();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, sums.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    throwPendingErrors("reading the picture");

    const bool transparent = subject_->options.picture.background == Background::none;
    if (transparent) rendering.radiance.alpha.resize(count);
    const float factor = radiancePerSum();
    const float coverage = 1.0f / static_cast<float>(frames_);
    parallelFor(0, height, 64, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const auto from = static_cast<std::size_t>(height - 1 - row) *
                              static_cast<std::size_t>(width);  // OpenGL's rows go up
            const auto to = static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
            for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i) {
                rendering.radiance.pixels()[to + i] = factor * glm::vec3(sums[from + i]);
                if (transparent) rendering.radiance.alpha[to + i] = coverage * sums[from + i].w;
            }
        }
    });
    return rendering;
}

}  // namespace tukor::gl
