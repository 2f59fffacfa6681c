// What is in an environment: figures for people and programs, and a picture of it.
#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tukor/environment/environment_work.h"
#include "tukor/environment/harmonics.h"
#include "tukor/environment/sun.h"

namespace tukor {

struct EnvironmentInfo {
    std::string layout;
    int width = 0, height = 0;  // of the picture, or of one face
    // Of the pixels that came out of the file.
    glm::vec3 least = glm::vec3(std::numeric_limits<float>::infinity());
    glm::vec3 most = glm::vec3(0.0f);
    glm::dvec3 mean{};                 // over the sphere
    std::size_t aboveHalf = 0;         // pixels with a component that half floats cannot hold
    int faceSize = 0;                  // of the cube map that it is, or that suits it
    std::vector<std::string> repairs;  // as Environment::warnings
    std::optional<Sun> sun;
    Harmonics harmonics;  // of radiance, three bands
};

[[nodiscard]] EnvironmentInfo infoOf(WorkSource source);

/// A figure a line, after its name.
[[nodiscard]] std::string textOf(const EnvironmentInfo& info);

/// An object; `sun` is null where there is none. Harmonics are a list by l (l + 1) + m, of real,
/// orthonormal functions without the Condon-Shortley sign, y up.
[[nodiscard]] std::string jsonOf(const EnvironmentInfo& info);

/// Three exposures, two stops apart around the mean, and the six faces.
[[nodiscard]] Image contactSheet(WorkSource source);

}  // namespace tukor
