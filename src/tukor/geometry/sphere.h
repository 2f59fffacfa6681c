// The unit sphere as evenly sized triangles.
#pragma once
#include "tukor/geometry/mesh.h"

namespace tukor {

/// A geodesic sphere of 20 frequency^2 triangles, frequency >= 1, with the exact normals of the
/// unit sphere.
///
/// Its vertices lie a hair outside of the unit sphere: at the radius that makes the mesh's area
/// that of the sphere. By Cauchy's theorem its outline then covers, averaged over all views,
/// exactly the disc of the true sphere; with vertices on the sphere it would always be smaller.
[[nodiscard]] Mesh makeSphere(int frequency);

}  // namespace tukor
