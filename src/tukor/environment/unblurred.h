// Panoramas whose bilinear look-ups have given means.
#pragma once
#include "tukor/image/image.h"

namespace tukor {

/// The panorama of which a bilinear look-up, averaged over each pixel, gives the pixels of `means`:
/// such a mean takes 1/8, 3/4, 1/8 of three pixels along each axis, which is undone here.
///
/// Never negative where `means` is not, and of the same sum: beside a sun, where no such panorama
/// exists, it is the likeliest [Richardson 1972]. A constant stays exactly constant.
[[nodiscard]] Image unblurred(const Image& means);

/// The same of what may be negative, wherever that leads.
[[nodiscard]] Image sharpened(const Image& means);

}  // namespace tukor
