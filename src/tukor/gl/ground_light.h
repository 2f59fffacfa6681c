// The light on a ground by place, gathered while nothing but the camera changes: what a moving view
// shows of its shadows and caustics.
#pragma once
#include "tukor/gl/handles.h"
#include "tukor/scene/render_options.h"

namespace tukor::gl {

/// The mean of samples so far, in half floats, which textures can be filtered in: as a share of
/// what nothing shadows, in alpha the share that is hidden. Places as traced.frag has them: finest
/// in the middle, all of the ground.
class GroundLight {
public:
    static constexpr int kSize = 256;  // of the texture
    static constexpr int kLevels = 5;
    static constexpr int kEnough = 128;  // samples: no more are gathered

    void clear() noexcept { samples_ = 0; }
    /// Those of a ground that is lit and rendered so.
#ifdef __EMSCRIPTEN__  // a page gathers none
    [[nodiscard]] static constexpr int samples(const RenderOptions&) noexcept {
        return 0;
    }
#else
    [[nodiscard]] int samples(const RenderOptions& picture) const noexcept;
#endif

    [[nodiscard]] const Texture& mean() const noexcept {
        return means_[current_];
    }
    /// The sharpest level of mean() on which what is left to chance is hardly seen.
    [[nodiscard]] float level() const noexcept;

    /// Binds the target of the mean with one sample more, which count() then takes for mean().
    void bindNext();
    void count(const RenderOptions& picture) noexcept;

private:
    /// What it depends on, besides the scene and the environment.
    struct Subject {
        float height, rotation, intensity;
        Fidelity fidelity;
        FresnelForm fresnel;

        friend bool operator==(const Subject&, const Subject&) = default;
    };
    [[nodiscard]] static Subject subjectOf(const RenderOptions& picture) noexcept;

    Subject subject_{};
    Texture means_[2];
    Framebuffer framebuffers_[2];
    int current_ = 0;
    int samples_ = 0;
};

}  // namespace tukor::gl
