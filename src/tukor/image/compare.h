// How far two pictures are apart: as a screen shows them, and as radiance.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tukor/image/image.h"

namespace tukor {

/// One pixel of a comparison.
struct PixelDifference {
    int column;
    int row;
    glm::vec3 a;
    glm::vec3 b;
    int difference8;  // the largest of its components', in 8-bit codes
};

/// Of `a` against the reference `b`, over all pixels and components; alpha is left out.
///
/// The figures named 8 are in codes of 8-bit sRGB, 0 to 255, of the pictures clipped to [0, 1] and
/// not tone mapped. Relative differences are |a - b| / (|b| + mean|b| / 100): the second term keeps
/// black pixels from counting without limit.
struct Comparison {
    double rmse8 = 0.0;
    double mean8 = 0.0;
    int maximum8 = 0;
    double withinTwo8 = 1.0;  // the fraction of pixels with no component further apart than 2 codes
    double relativeRmse = 0.0;
    double relativeMean = 0.0;
    double relativeMaximum = 0.0;
    std::uint64_t nonFinite = 0;  // components not finite in either picture: 255 codes apart, and
                                  // not in the relative figures
    std::vector<PixelDifference> worst;  // at most ten, the worst first; none that are equal
};

/// Throws Error when the sizes differ.
[[nodiscard]] Comparison compareImages(const Image& a, const Image& b);

/// The figures and the worst pixels, a line each, as people read them.
[[nodiscard]] std::string report(const Comparison& comparison);

/// The 8-bit difference of each pixel as a colour: black for none, through violet, red and yellow
/// to white for `fullScale8` codes and more. To be shown without tone mapping.
[[nodiscard]] Image heatMap(const Image& a, const Image& b, float fullScale8 = 32.0f);

}  // namespace tukor
