// Material libraries of Wavefront OBJ files.
#pragma once
#include <map>
#include <span>
#include <string>

#include "tukor/scene/file_textures.h"
#include "tukor/scene/notes.h"
#include "tukor/scene/surface.h"

namespace tukor {

/// The materials of a library by name. Lines that make no sense are passed over, as other readers
/// do.
///
/// Metallic: `Pm`, or a mirror (`illum` 3 or 5 with a specular colour). Transmissive: `d` below a
/// half, or without `map_Kd` an `illum` of glass or refraction (4, 6, 7, 9); such are clear and
/// have no textures.
/// Textures: `map_Kd`, `map_Ke`, `map_d`, `map_Pm`, `map_Pr`, `norm`, and `bump` or `map_Bump` as
/// normalsOf() reads them.
[[nodiscard]] std::map<std::string, Surface> readMtl(std::span<const std::byte> bytes,
                                                     FileTextures& textures, Notes& notes);

}  // namespace tukor
