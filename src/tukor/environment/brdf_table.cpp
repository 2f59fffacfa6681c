#include "tukor/environment/brdf_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tukor/base/parallel.h"

namespace tukor {

namespace {

/// A point of Gauss and Legendre's rule on [0, 1].
struct Node {
    double at, weight;
};

std::vector<Node> gaussRule(int count) {
    std::vector<Node> nodes;
    for (int i = 0; i < count; ++i) {
        double z = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 0.0;
        for (int step = 0; step < 5; ++step) {  // Newton's, from three good digits
            double p = 1.0, before = 0.0;
            for (int j = 0; j < count; ++j) {
                const double next = ((2 * j + 1) * z * p - j * before) / (j + 1);
                before = p;
                p = next;
            }
            slope = count * (z * p - before) / (z * z - 1.0);
            z -= p / slope;
        }
        nodes.push_back({0.5 * (1.0 - z), 1.0 / ((1.0 - z * z) * slope * slope)});
    }
    return nodes;
}

// 12 are within 2e-3 of 300, 16 within 7e-4, 20 within 1e-4, these within 3e-5.
constexpr int kNodes = 24;

const std::vector<Node>& nodes() {
    static const std::vector<Node> rule = gaussRule(kNodes);
    return rule;
}

/// Azimuths from 0 to pi, in two halves: seen from the side, facets tilted away end at once.
const std::vector<Node>& azimuths() {
    static const std::vector<Node> rule = [] {
        std::vector<Node> both;
        for (const double from : {0.0, 0.5})
            for (const Node& node : gaussRule(kNodes / 2))
                both.push_back({std::numbers::pi * (from + 0.5 * node.at),
                                std::numbers::pi * 0.5 * node.weight});
        return both;
    }();
    return rule;
}

/// Smith's Lambda for GGX. [Heitz 2014]
double lambda(double cosTheta, double a2) {
    return 0.5 * (std::sqrt(1.0 + a2 * (1.0 / (cosTheta * cosTheta) - 1.0)) - 1.0);
}

/// Charlie's fibres with the visibility of [Neubelt & Pettineo 2013].
double sheen(double cosOut, double alpha) {
    const double sinOut = std::sqrt(1.0 - cosOut * cosOut);
    // Steeper than this the density is below exp(-20) of its peak. Squares bring points to where
    // it rises: incidence from the side, and straight ahead.
    const double most = std::min(1.0, 13.0 * std::sqrt(alpha));
    double sum = 0.0;
    for (const Node& x : nodes()) {
        const double cosIn = most * x.at * x.at, sinIn = std::sqrt(1.0 - cosIn * cosIn);
        double ring = 0.0;
        for (const Node& y : nodes()) {
            const double cosBoth =
                cosOut * cosIn - sinOut * sinIn * std::cos(std::numbers::pi * y.at * y.at);
            const double cosHalf2 =
                (cosOut + cosIn) * (cosOut + cosIn) / std::max(2.0 + 2.0 * cosBoth, 1e-30);
            if (cosHalf2 >= 1.0) continue;
            ring += std::pow(1.0 - cosHalf2, 0.5 / alpha) * 2.0 * y.at * y.weight;
        }
        sum +=
            ring * cosIn / (4.0 * (cosOut + cosIn - cosOut * cosIn)) * 2.0 * most * x.at * x.weight;
    }
    return (2.0 + 1.0 / alpha) * sum;
}

/// Over the slopes of facets, p towards the view and q across, in circles about the normal: what
/// they reflect above the surface is the disc (p - tan)^2 + q^2 < 1 + tan^2, tan that of the view.
/// The radius is alpha sinh(s): the lobe is as wide as 1 in s, what alpha ever is, and its tail,
/// which Fresnel and the disc's edge cut where slopes are about 1, falls off exponentially.
glm::vec3 entry(double cosOut, double roughness) {
    const double alpha = roughness * roughness, a2 = alpha * alpha;
    const double sinOut = std::sqrt(1.0 - cosOut * cosOut), tanOut = sinOut / cosOut;
    const double lambdaOut = lambda(cosOut, a2);
    double scale = 0.0, bias = 0.0;
    for (const Node& azimuth : azimuths()) {
        const double cosPhi = std::cos(azimuth.at), middle = tanOut * cosPhi;
        const double root = std::sqrt(middle * middle + 1.0);
        const double edge = middle > 0.0 ? root + middle : 1.0 / (root - middle);
        const double most = std::min(std::asinh(edge / alpha), 15.0);  // 1e-6 is beyond
        for (const Node& x : nodes()) {
            const double rise = std::exp(most * x.at);
            const double sinhS = 0.5 * (rise - 1.0 / rise), coshS = 0.5 * (rise + 1.0 / rise);
            const double slope = alpha * sinhS, p = slope * cosPhi;
            const double cosHalf = 1.0 / std::sqrt(1.0 + slope * slope);
            const double outHalf = std::min((cosOut + sinOut * p) * cosHalf, 1.0);
            const double cosIn = std::clamp(2.0 * outHalf * cosHalf - cosOut, 1e-12, 1.0);
            const double weight = (1.0 + tanOut * p) / (1.0 + lambdaOut + lambda(cosIn, a2)) *
                                  sinhS / (coshS * coshS * coshS) * most * x.weight *
                                  azimuth.weight;
            const double away = 1.0 - outHalf, away2 = away * away;
            const double fresnel = away2 * away2 * away;
            scale += weight * (1.0 - fresnel);
            bias += weight * fresnel;
        }
    }
    constexpr double kBothSides = 2.0 / std::numbers::pi;
    return glm::vec3(
        glm::dvec3(kBothSides * scale, kBothSides * bias, sheen(cosOut, std::max(alpha, 1e-3))));
}

/// `at(column, row)` for all, which takes microseconds each. Empty where it was stopped.
template <class At>
Image tableOf(int size, const Progress& progress, const At& at) {
    Image table(size, size);
    const bool whole = parallelFor(0, size * size, 32, progress, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) table.at(i % size, i / size) = at(i % size, i / size);
    });
    return whole ? std::move(table) : Image();
}

}  // namespace

Image brdfTable(int size, const Progress& progress) {
    return tableOf(size, progress, [size](int column, int row) {
        return entry((column + 0.5) / size, (row + 0.5) / size);
    });
}

Image brdfNodeTable(int size) {
    return tableOf(size, {}, [size](int column, int row) {
        const double x = std::max(static_cast<double>(column) / (size - 1), 0.02);
        return entry(x * x, std::max(static_cast<double>(row) / (size - 1), 0.02));
    });
}

}  // namespace tukor
