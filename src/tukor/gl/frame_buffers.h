// Where frames are drawn and summed: a 4x multisampled half-float picture with depth, its resolved
// copy, the sum of all frames so far in 32-bit floats, and the triangle that each pixel shows.
#pragma once
#include "tukor/gl/handles.h"

namespace tukor::gl {

/// Whether rays, leaks and the like are counted, into a second picture.
enum class Counting { none, all };

class FrameBuffers {
public:
    FrameBuffers() = default;
    FrameBuffers(int width, int height);

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }

    /// Binds the picture of the next frame and clears it: multisampled, or one sample a pixel.
    void beginMultisampled();
    void beginPlain();

    /// Resolves what was drawn since begin; frame() has it then.
    void endMultisampled();

    /// Binds the numbers of the triangles that the pixels show, and clears them: -1, none.
    void beginFirstHits();
    [[nodiscard]] const Texture& firstHits() const noexcept { return firstHits_; }

    /// Binds the target of the next sum, and of the next counts where they are wanted; sum() is
    /// the one before until swapSums().
    void bindNextSum(Counting counting);
    void swapSums() noexcept { shown_ = current_ = 1 - current_; }
    /// Of the next sum, until then: it is shown in the place of this one, which goes on.
    void showNextSum() noexcept { shown_ = 1 - current_; }

    [[nodiscard]] const Texture& frame() const noexcept { return frame_; }
    [[nodiscard]] const Texture& sum() const noexcept { return sums_[current_]; }
    [[nodiscard]] const Texture& shown() const noexcept { return sums_[shown_]; }
    /// Sums of what was counted; black unless it was.
    [[nodiscard]] const Texture& counts() const noexcept { return counts_[current_]; }
    /// Bind what is shown, and the counts, for glReadPixels.
    void bindShownForReading() const;
    void bindCountsForReading() const;

private:
    struct Target {
        Framebuffer framebuffer;
        Renderbuffer colour;  // multisampled targets only
        Renderbuffer depth;
    };
    void makeDepth(Target& target, GLsizei samples);
    void makeTarget(Target& target, GLsizei samples);

    int width_ = 0;
    int height_ = 0;
    int current_ = 0;
    int shown_ = 0;
    Texture frame_;
    Target multisampled_;
    Target plain_;
    Texture firstHits_;
    Target firstHitsTarget_;
    Texture sums_[2];
    Texture counts_[2];
    Framebuffer sumFramebuffers_[2];
};

}  // namespace tukor::gl
