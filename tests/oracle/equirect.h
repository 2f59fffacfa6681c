// Equirectangular panoramas sampled directly, without a cube map between: what a background must
// show.
#pragma once
#include "oracle/closed_form.h"

namespace tukor::oracle {

/// Bilinear radiance of `panorama`: the centre is -Z, +X to the right of it, the top row +Y,
/// longitude wraps, pixel centres at (i + 0.5) / N.
///
/// Texels that are not finite or negative count as 0, as after loading.
[[nodiscard]] Environment equirect(Image panorama);

}  // namespace tukor::oracle
