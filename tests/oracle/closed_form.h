// Pictures known in closed form: a sphere of any material under any environment, and the
// background.
//
// Everything is evaluated in double and shares no code with optics, transport or the renderers, so
// that it can judge them.
#pragma once
#include <functional>

#include <glm/glm.hpp>

#include "tukor/image/image.h"
#include "tukor/materials/material.h"
#include "tukor/scene/camera.h"
#include "tukor/scene/render_options.h"

namespace tukor::oracle {

/// Radiance that arrives from a unit world direction. Must be callable from many threads.
using Environment = std::function<glm::vec3(glm::vec3)>;

/// Radiance that an eye sees along a unit world direction.
using View = std::function<glm::dvec3(glm::dvec3 eye, glm::dvec3 direction)>;

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 1.0;
};

/// The environment alone.
[[nodiscard]] View background(Environment environment);

/// A sphere of a mirror or a metal: Lin(x, dr) R. Lecture row 10.
[[nodiscard]] View reflectingSphere(const Material& material, Environment environment,
                                    FresnelForm form = FresnelForm::exact, Sphere sphere = {});

/// The single-interface picture of a clear sphere: Lin(x, dr) R + Lin(x, dt) T. Lecture rows 11 to
/// 14. Upright, and not what glass looks like.
[[nodiscard]] View singleInterfaceSphere(const Material& material, Environment environment,
                                         FresnelForm form = FresnelForm::exact, Sphere sphere = {});

/// What a solid clear sphere really looks like from outside: every internal reflection, and
/// absorption along every chord.
///
/// All chords of one ray have the same length and meet the surface at the same angle, so that the
/// reflectance is the same each time. The series is summed until what remains is below 1e-6, and
/// that follows the last direction.
[[nodiscard]] View solidSphere(const Material& material, Environment environment,
                               Sphere sphere = {});

/// The mean of `samples` x `samples` regularly spaced views through each pixel.
[[nodiscard]] Image picture(const Camera& camera, int width, int height, int samples,
                            const View& view);

/// Unpolarised reflectance of index eta + i k from the complex amplitudes; 1 at total reflection.
[[nodiscard]] double fresnel(double cosThetaI, double eta, double k);

}  // namespace tukor::oracle
