// Models set upright and to size: files of CAD have their z axis up and their lengths in
// millimetres.
#pragma once
#include <array>
#include <string_view>
#include <utility>

#include "tukor/scene/scene.h"

namespace tukor {

/// Which axis of a model points up.
enum class UpAxis { y, z };

inline constexpr std::array<std::pair<UpAxis, std::string_view>, 2> kUpAxisSpellings{
    {{UpAxis::y, "y"}, {UpAxis::z, "z"}}};

/// Turns what points `up` to +Y (z by a quarter about X, so that -y comes to the front) and
/// multiplies all lengths, those of cameras and lamps included, by `scale` > 0: what is seen stays
/// the same but for what a length is measured by, such as absorption.
void place(Scene& scene, UpAxis up, float scale);

}  // namespace tukor
