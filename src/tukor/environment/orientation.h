// Which way other programs look: what their panoramas show in the middle, and how the faces of
// their cube maps stand.
#pragma once
#include <array>
#include <string_view>
#include <utility>

#include "tukor/base/options.h"
#include "tukor/environment/cube_axes.h"

namespace tukor {

/// Programs whose files differ. Directions are this project's, which are glTF's: a model exchanged
/// as glTF stands the same way in the light in all of them. Seen from inside, no panorama is
/// mirrored.
///
///     name      middle of a panorama   six faces, crosses, strips and texture files
///     opengl    -Z                     looked up by the direction itself: the table of cube_map.h
///     blender   +X                     none of its own; as opengl
///     three     +X                     looked up by (-x, y, z): +X and -X exchanged, all mirrored
///     openexr   +Z                     six upright pictures seen from inside, as ImfEnvmap.h draws
///     filament  +Z                     as opengl (cmgen reads and writes them with --no-mirror)
///     unreal    -Z                     looked up by (x, z, y): Z is up, and left-handed
enum class Orientation { opengl, blender, three, openexr, filament, unreal };

inline constexpr std::array<std::pair<Orientation, std::string_view>, 6> kOrientationSpellings = {
    {{Orientation::opengl, "opengl"},
     {Orientation::blender, "blender"},
     {Orientation::three, "three"},
     {Orientation::openexr, "openexr"},
     {Orientation::filament, "filament"},
     {Orientation::unreal, "unreal"}}};

/// Radians about +Y, counter-clockwise seen from above, by which a panorama in that orientation
/// must be turned to be in this project's.
[[nodiscard]] double turnFrom(Orientation orientation) noexcept;

/// The faces of that program's cube maps.
[[nodiscard]] CubeAxes cubeAxesOf(Orientation orientation) noexcept;

}  // namespace tukor
