// Draws scenes in whatever OpenGL ES 3 or WebGL 2 context is current: frames, summed while nothing
// changes.
#pragma once
#include <optional>
#include <vector>

#include "tukor/environment/environment.h"
#include "tukor/gl/background_drawer.h"
#include "tukor/gl/environment_texture.h"
#include "tukor/gl/finish_drawer.h"
#include "tukor/gl/frame_buffers.h"
#include "tukor/gl/ground_light.h"
#include "tukor/gl/light_chain.h"
#include "tukor/gl/single_drawer.h"
#include "tukor/gl/surface_buffers.h"
#include "tukor/gl/traced_drawer.h"
#include "tukor/gl/traced_scene.h"
#include "tukor/gl/view.h"
#include "tukor/image/display.h"
#include "tukor/scene/render_options.h"
#include "tukor/scene/scene.h"

namespace tukor::gl {

/// A second way to render, shown right of `splitX` (0 is the left edge of the picture, 1 the
/// right).
struct Comparison {
    float splitX = 0.5f;
    Fidelity fidelity = Fidelity::exact;
    FresnelForm fresnel = FresnelForm::exact;

    friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// Before or after the scene: the same picture; after is less work.
enum class BackgroundOrder { first, last };

struct FrameOptions {
    RenderOptions picture;  // `samples` is how many the caller means to accumulate, if it knows
    std::optional<Comparison> comparison;
    BackgroundOrder backgroundOrder = BackgroundOrder::last;

    friend bool operator==(const FrameOptions&, const FrameOptions&) = default;
};

/// How radiance becomes colour on the screen.
struct DisplayOptions {
    float exposureStops = 0.0f;
    Tonemap tonemap = Tonemap::none;
    glm::vec3 behind{0.18f};  // linear; seen where there is no background

    friend bool operator==(const DisplayOptions&, const DisplayOptions&) = default;
};

/// A rectangle of the framebuffer that is drawn into, from its bottom-left corner, in pixels.
struct Viewport {
    int left = 0;
    int bottom = 0;
    int width = 0;
    int height = 0;
};

/// Belongs to the context that is current when it is made. Every function throws Error for what
/// OpenGL reports.
class Renderer {
public:
    Renderer() = default;

    /// `Preparation::single` when no other fidelity will be asked for.
    void setScene(const Scene& scene, Preparation preparation = Preparation::all);

    /// The parts of the scene that was set, moved: materials and textures stay.
    void setPose(const Scene& scene, Preparation preparation = Preparation::all);
    /// The material of one part of the scene; cheap.
    void setMaterial(int part, const Material& material);
    /// In place of the scene's; cheap.
    void setLights(const std::vector<Light>& lights);
    void setEnvironment(const Environment& environment, Preparation preparation = Preparation::all);

    /// Whether read() also gives what was counted on the way, at fidelities that trace rays.
    void setCounting(Counting counting) {
        counting_ = counting;
        resetAccumulation();
    }

    /// Draws one frame and adds it to the picture; begins anew when scene, camera, light or options
    /// differ from the frame before. A scene and an environment are needed.
    ///
    /// Leaves framebuffer 0 bound.
    void drawFrame(const Camera& camera, const FrameOptions& options);

    /// A window of the picture only: for pictures that are larger than textures.
    void drawFrame(const Camera& camera, const FrameOptions& options, const PictureWindow& window);

    /// Adds a sample, while there are too few, to the light that frames of one sample then show on
    /// the ground; at fidelities that trace rays, as drawFrame() with these options would.
    void gatherGroundLight(const Camera& camera, const FrameOptions& options);

    /// Whether a frame with these options has to prepare the light of finishes or a ground, or
    /// dispersion.
    [[nodiscard]] bool preparesLight(const RenderOptions& options) const noexcept;
    [[nodiscard]] const LightChain& lightChain() const noexcept { return environment_.chain; }

    /// Forgets the frames so far.
    void resetAccumulation() noexcept {
        samples_ = 0;
        frames_ = 0;
    }

    /// Samples a pixel in the picture so far: four from every frame of fidelity `single` alone,
    /// else one.
    [[nodiscard]] int accumulatedSamples() const noexcept { return samples_; }

    /// Shows the picture so far in a viewport of the framebuffer that is bound, of any size.
    void present(const DisplayOptions& options, const Viewport& viewport);

    /// The picture so far, linear, radiance multiplied by coverage; with coverage as its alpha
    /// where there is no background. Waits for the GPU.
    [[nodiscard]] Rendering read();

private:
    struct Subject {
        Camera camera;
        FrameOptions options;
        PictureWindow window;

        friend bool operator==(const Subject&, const Subject&) = default;
    };

    /// One way of rendering, in the columns of the window from `left` to `right`.
    struct Look {
        Fidelity fidelity;
        FresnelForm fresnel;
        int left;
        int right;
    };
    [[nodiscard]] std::vector<Look> looksOf(const Subject& subject) const;
    [[nodiscard]] std::vector<Look> askedLooks(const Subject& subject) const;
    void drawRasterised(const Subject& subject, const std::vector<Look>& looks, glm::vec2 point);
    void accumulate(const Look& look);
    [[nodiscard]] View tracedView(const Subject& subject, glm::vec2 point) const;
    [[nodiscard]] bool centred(const Subject& subject) const;
    [[nodiscard]] bool firstHitsHelp(const Subject& subject) const;
    void drawTraced(const Subject& subject, const Look& look, const View& view);
    /// Nothing where the options ask for none, or all is dark. Binds what lights it.
    [[nodiscard]] std::optional<TracedDrawer::Ground> groundOf(const RenderOptions& picture,
                                                               TracedDrawer::GroundUse use);
    /// Scene or light is another one.
    void forget() noexcept {
        groundLight_.clear();
        resetAccumulation();
    }
    void blurBackground(const Subject& subject);

    struct Surroundings {
        Surroundings() = default;
        Surroundings(const Environment& environment, Preparation preparation)
            : texture(environment, preparation), chain(environment, texture.scale()) {}

        EnvironmentTexture texture;
        LightChain chain;
    };
    /// The environment, or darkness where its intensity is 0.
    [[nodiscard]] Surroundings& surroundings(float intensity);
    /// Sums count in units of the texels of that, so that half floats hold them.
    [[nodiscard]] float radiancePerUnit(float intensity);
    [[nodiscard]] float radiancePerSum();

    Bounds bounds_;
    std::vector<Material> materials_;
    std::vector<Light> lights_;
    SurfaceBuffers surfaces_;
    Surroundings environment_;
    Surroundings darkness_;  // made when it is first asked for
    FrameBuffers buffers_;
    BackgroundDrawer background_;
    SingleDrawer single_;
    FinishDrawer finishes_;
    TracedScene tracedScene_;
    TracedDrawer traced_;
    GroundLight groundLight_;
    Counting counting_ = Counting::none;
    std::optional<Program> accumulateProgram_;
    std::optional<Program> presentProgram_;
    std::optional<Subject> subject_;
    int samples_ = 0;
    int frames_ = 0;
};

}  // namespace tukor::gl
