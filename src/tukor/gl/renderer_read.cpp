// The picture so far, back from the GPU.
#include "tukor/base/parallel.h"
#include "tukor/gl/errors.h"
#include "tukor/gl/renderer.h"

namespace tukor::gl {

Rendering Renderer::read() {
    const int width = buffers_.width();
    const int height = buffers_.height();
    Rendering rendering;
    rendering.radiance = Image(width, height);
    if (frames_ == 0) return rendering;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<glm::vec4> sums(count);
    buffers_.bindShownForReading();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, sums.data());
    if (buffers_.counts().id() != 0 && counting_ == Counting::all) {
        std::vector<glm::vec4> counts(count);
        buffers_.bindCountsForReading();
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, counts.data());
        glm::dvec4 total(0.0);
        for (const glm::vec4& pixel : counts) total += glm::dvec4(pixel);
        rendering.rays = static_cast<std::uint64_t>(total.x);
        rendering.leaks = static_cast<std::uint64_t>(total.y);
        rendering.inconsistencies = static_cast<std::uint64_t>(total.z);
        rendering.truncated = static_cast<std::uint64_t>(total.w);
    }
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
