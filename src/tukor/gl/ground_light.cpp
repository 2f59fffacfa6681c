#include "tukor/gl/ground_light.h"

#include <algorithm>
#include <cmath>

namespace tukor::gl {

namespace {

constexpr float kSmooth = 256.0f;  // samples, of a texel and its neighbours

}  // namespace

GroundLight::Subject GroundLight::subjectOf(const RenderOptions& picture) noexcept {
    return {picture.ground.value_or(0.0f), picture.environmentRotation,
            picture.environmentIntensity, picture.fidelity, picture.fresnel};
}

int GroundLight::samples(const RenderOptions& picture) const noexcept {
    return subjectOf(picture) == subject_ ? samples_ : 0;
}

void GroundLight::bindNext() {
    const int next = 1 - current_;
    if (means_[next].id() == 0) {
        means_[next] = Texture::make();
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, means_[next].id());
        glTexStorage2D(GL_TEXTURE_2D, kLevels, GL_RGBA16F, kSize, kSize);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
        framebuffers_[next] = Framebuffer::make();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[next].id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               means_[next].id(), 0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[next].id());
}

void GroundLight::count(const RenderOptions& picture) noexcept {
    samples_ = samples(picture) + 1;
    subject_ = subjectOf(picture);
    current_ = 1 - current_;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, mean().id());
    glGenerateMipmap(GL_TEXTURE_2D);
}

float GroundLight::level() const noexcept {
    const float few = kSmooth / static_cast<float>(std::max(samples_, 1));
    return std::clamp(0.5f * std::log2(few), 0.0f, static_cast<float>(kLevels - 1));
}

}  // namespace tukor::gl
