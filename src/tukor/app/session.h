// What the options of a picture name, loaded: scene, environment and camera, for every front end.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/app/options.h"
#include "tukor/environment/environment.h"
#include "tukor/scene/render_options.h"
#include "tukor/scene/scene.h"

namespace tukor {

/// Where the renderer looks up light: in the cube map whatever it was made of, or in the panorama
/// where there is one, as trace does; the cube beside it is then a coarse one.
enum class LookUps { cube, panorama };

class Session {
public:
    /// Loads all that the options name. Throws Error.
    explicit Session(const SessionOptions& options, LookUps lookUps = LookUps::cube);

    /// Takes other options and loads what they change. Throws Error, and then nothing has changed.
    void apply(const SessionOptions& options);

    [[nodiscard]] const SessionOptions& options() const noexcept { return options_; }
    [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
    [[nodiscard]] const Environment& environment() const noexcept { return *environment_; }

    /// From the options, the model's camera they name, and where neither says, framing the scene.
    [[nodiscard]] const Camera& camera() const noexcept { return camera_; }

    /// The options as renderers take them.
    [[nodiscard]] RenderOptions renderOptions() const;

    /// What the model and environment files ask for and do not get; one sentence each.
    [[nodiscard]] std::vector<std::string> warnings() const;

    /// Counts up whenever the geometry, the lights or the environment are others, or finishes
    /// appear, or other pictures on them.
    [[nodiscard]] std::uint64_t sceneRevision() const noexcept { return sceneRevision_; }
    [[nodiscard]] std::uint64_t environmentRevision() const noexcept {
        return environmentRevision_;
    }

private:
    LookUps lookUps_;
    SessionOptions options_;
    Scene scene_;
    std::vector<Light> ownLights_;        // the model's
    std::vector<Material> ownMaterials_;  // the parts' materials before --material
    std::optional<Environment> environment_;
    Camera camera_;
    std::uint64_t sceneRevision_ = 0;
    std::uint64_t environmentRevision_ = 0;
};

/// The options with other models, and without what was about the old ones: materials, variant,
/// animation and its moment, camera.
[[nodiscard]] SessionOptions withModels(SessionOptions options, std::vector<std::string> models);

/// The camera that the options describe for a scene. Throws Error on an unknown camera name and
/// where eye and target coincide.
[[nodiscard]] Camera cameraFromOptions(const CameraOptions& options, const Scene& scene,
                                       PictureSize size);

/// `--light`'s X,Y,Z[/R,G,B]. Throws Error.
[[nodiscard]] Light lightFromText(std::string_view text);

/// The height that `--ground` names; none where it is empty. Throws Error.
[[nodiscard]] std::optional<float> groundFromText(std::string_view text, const Scene& scene);

/// The options that describe this camera completely. `before` is where it came from: a field of
/// view that did not change keeps its value in degrees to the last digit.
[[nodiscard]] CameraOptions optionsFromCamera(const Camera& camera, const CameraOptions& before);

}  // namespace tukor
