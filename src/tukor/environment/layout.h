// The layouts in which a cube map or panorama comes as one picture, or as six.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tukor/base/options.h"
#include "tukor/environment/cube_map.h"
#include "tukor/image/image.h"

namespace tukor {

/// Faces stand in the pictures as OpenGL stores them; `-Z*` is turned by 180 degrees.
///
///     hcross              vcross         hstrip                  vstrip
///      .  +Y  .  .         .  +Y  .      +X -X +Y -Y +Z -Z       the same, downwards
///     -X  +Z +X -Z        -X  +Z +X
///      .  -Y  .  .         .  -Y  .
///                          .  -Z*  .
enum class Layout { equirect, hcross, vcross, hstrip, vstrip };

/// The layout that a picture of this size has; none when its shape fits no layout.
[[nodiscard]] std::optional<Layout> layoutOfShape(int width, int height) noexcept;

/// The faces of a cross or strip. Its shape must be that of `layout`.
[[nodiscard]] CubeMap cubeFromLayout(const Image& picture, Layout layout);

/// The cross or strip of a cube map; black where a cross has no face.
[[nodiscard]] Image pictureFromCube(const CubeMap& cube, Layout layout);

/// The picture of one face.
[[nodiscard]] Image pictureOfFace(const CubeMap& cube, CubeFace face);

/// The names that files of the six faces go by, in face order: `px`, `posx` or `right` for +X.
inline constexpr std::array<std::array<std::string_view, 6>, 3> kFaceNames = {{
    {"px", "nx", "py", "ny", "pz", "nz"},
    {"posx", "negx", "posy", "negy", "posz", "negz"},
    {"right", "left", "top", "bottom", "front", "back"},
}};

/// The files of the six faces in face order, from a pattern with `{}` for the face's name or from a
/// folder with one file for each name. Throws Error naming what is missing.
[[nodiscard]] std::array<std::filesystem::path, 6> faceFiles(const std::string& patternOrFolder);

/// Six square pictures of one size. `names` are for messages.
[[nodiscard]] CubeMap cubeFromFaces(std::span<const Image, 6> faces,
                                    std::span<const std::string, 6> names);

}  // namespace tukor
