// Martin Newell's teapot.
#pragma once
#include "tukor/geometry/mesh.h"

namespace tukor {

/// Three closed solids that overlap: spout and handle reach into the body.
struct Teapot {
    Mesh body;  // with lid, rim and bottom
    Mesh spout;
    Mesh handle;
};

/// The 32 bicubic patches of 1975, height as Blinn's, y up, spout towards +x, its axis the y axis,
/// two thirds of a metre to each side. [Crow 1987]
///
/// Massive: the patches are an outer skin, so of glass it is a block in the shape of a teapot. What
/// the patches leave open is closed by flat surfaces: the gap between lid and rim, the mouth of the
/// spout, and the ends inside the body, to which the lower end of the handle is prolonged.
[[nodiscard]] Teapot makeTeapot();

}  // namespace tukor
