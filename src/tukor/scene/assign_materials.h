// Which part is made of what: `--material gold`, `--material 'stone*=diamond'`.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/scene/scene.h"

namespace tukor {

/// Carries out specifications in order, so that later ones win.
///
/// Each is `NAME` for all parts, or `PATTERN=NAME` for the parts whose name or material name the
/// pattern matches; `*` stands for any characters, `?` for one, letters match in either case. NAME
/// is what materialFromText() takes. Throws Error; a pattern without a match lists what there is.
void assignMaterials(Scene& scene, std::span<const std::string> specifications);

/// Lets clear materials disperse light: those of the table as is known of them, others as their
/// file says, both times `factor`.
void setDispersion(Scene& scene, float factor);

/// Whether the whole of `text` matches. Time grows with the product of the lengths at most.
[[nodiscard]] bool matchesPattern(std::string_view text, std::string_view pattern) noexcept;

/// Moves the parts, cameras and warnings of `added` behind those of `scene`.
void append(Scene& scene, Scene added);

/// One sentence for each glass or liquid in the scene whose surface is not that of a solid; parts
/// of one material count together, as files cut solids up.
[[nodiscard]] std::vector<std::string> closednessWarnings(const Scene& scene);

}  // namespace tukor
