// The lobes that environments are blurred with: radially symmetric weights around a direction.
#pragma once
#include <vector>

namespace tukor {

/// Shapes of lobes. Weights are those of a split-sum environment: seen along the normal, so that
/// view, normal and reflection coincide. [Karis 2013]
enum class LobeShape {
    ggx,       // microfacets of roughness alpha, weighted by the cosine; 1 is exactly lambert
    lambert,   // the cosine: irradiance over pi
    charlie,   // sheen of roughness alpha [Estevez & Kulla 2017], weighted by the cosine
    gaussian,  // heat kernel of standard deviation alpha radians: a blurred background
};

struct Lobe {
    LobeShape shape = LobeShape::ggx;
    double alpha = 1.0;  // above 0; not used by lambert
};

/// The weight at an angle from the middle, up to a common factor. Not for gaussian.
[[nodiscard]] double lobeWeight(const Lobe& lobe, double cosTheta) noexcept;

/// What a convolution with the normalised lobe multiplies each degree by, up to `degree`; the first
/// is
/// 1. By the Funk-Hecke theorem, the lobe's projections on the Legendre polynomials.
[[nodiscard]] std::vector<double> lobeFactors(const Lobe& lobe, int degree);

/// The degree beyond which the lobe lets nothing through: 6 / alpha, at least 128, at most
/// kMaxDegree.
///
/// At 3 / alpha a sun makes the result ring below zero.
[[nodiscard]] int lobeDegree(const Lobe& lobe) noexcept;

}  // namespace tukor
