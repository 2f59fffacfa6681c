#include "tukor/gl/frame_buffers.h"

#include <fmt/format.h>

#include "tukor/base/error.h"

namespace tukor::gl {

namespace {

Texture makePicture(GLenum format, int width, int height) {
    Texture texture = Texture::make();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void requireComplete(int width, int height) {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    throw Error(fmt::format("the OpenGL driver refuses a float framebuffer of {} x {} (0x{:x})",
                            width, height, status));
}

void clear() {
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

FrameBuffers::FrameBuffers(int width, int height)
    : width_(width), height_(height), frame_(makePicture(GL_RGBA16F, width, height)) {
    for (int i = 0; i < 2; ++i) sumFramebuffers_[i] = Framebuffer::make();
}

void FrameBuffers::makeDepth(Target& target, GLsizei samples) {
    target.framebuffer = Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    target.depth = Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, target.depth.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width_,
                                     height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                              target.depth.id());
}

void FrameBuffers::makeTarget(Target& target, GLsizei samples) {
    makeDepth(target, samples);
    if (samples > 0) {
        target.colour = Renderbuffer::make();
        glBindRenderbuffer(GL_RENDERBUFFER, target.colour.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA16F, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  target.colour.id());
    } else {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, frame_.id(), 0);
    }
    requireComplete(width_, height_);
}

void FrameBuffers::beginMultisampled() {
    if (multisampled_.framebuffer.id() == 0) makeTarget(multisampled_, 4);
    glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.framebuffer.id());
    clear();
}

void FrameBuffers::beginPlain() {
    if (plain_.framebuffer.id() == 0) makeTarget(plain_, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, plain_.framebuffer.id());
    clear();
}

void FrameBuffers::endMultisampled() {
    if (plain_.framebuffer.id() == 0) makeTarget(plain_, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.framebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.framebuffer.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    const GLenum finished[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, 2, finished);
}

void FrameBuffers::beginFirstHits() {
    if (firstHits_.id() == 0) {
        makeDepth(firstHitsTarget_, 0);
        firstHits_ = makePicture(GL_R32I, width_, height_);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, firstHits_.id(),
                               0);
        requireComplete(width_, height_);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, firstHitsTarget_.framebuffer.id());
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    const GLint none[] = {-1, -1, -1, -1};
    glClearBufferiv(GL_COLOR, 0, none);
}

void FrameBuffers::bindNextSum(Counting counting) {
    const int next = 1 - current_;
    const auto attach = [&](Texture& texture, GLenum attachment) {
        texture = makePicture(GL_RGBA32F, width_, height_);
        glBindFramebuffer(GL_FRAMEBUFFER, sumFramebuffers_[next].id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
        requireComplete(width_, height_);
    };
    if (sums_[next].id() == 0) attach(sums_[next], GL_COLOR_ATTACHMENT0);
    if (counting == Counting::all && counts_[next].id() == 0)
        attach(counts_[next], GL_COLOR_ATTACHMENT1);
    glBindFramebuffer(GL_FRAMEBUFFER, sumFramebuffers_[next].id());
    const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(counting == Counting::all ? 2 : 1, both);
}

void FrameBuffers::bindShownForReading() const {
    glBindFramebuffer(GL_FRAMEBUFFER, sumFramebuffers_[shown_].id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
}

void FrameBuffers::bindCountsForReading() const {
    glBindFramebuffer(GL_FRAMEBUFFER, sumFramebuffers_[current_].id());
    glReadBuffer(GL_COLOR_ATTACHMENT1);
}

}  // namespace tukor::gl
