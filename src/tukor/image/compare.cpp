#include "tukor/image/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/image/display.h"
#include "tukor/image/tonemap.h"

namespace tukor {

namespace {

constexpr std::size_t kWorst = 10;

void checkSizes(const Image& a, const Image& b) {
    if (a.width() != b.width() || a.height() != b.height())
        throw Error(fmt::format("pictures of {} x {} and {} x {} pixels cannot be compared",
                                a.width(), a.height(), b.width(), b.height()));
}

bool bothFinite(float a, float b) {
    return std::isfinite(a) && std::isfinite(b);
}

int difference8(float a, float b) {
    return bothFinite(a, b) ? std::abs(int{srgb8(a)} - int{srgb8(b)}) : 255;
}

int difference8(glm::vec3 a, glm::vec3 b) {
    return std::max({difference8(a.x, b.x), difference8(a.y, b.y), difference8(a.z, b.z)});
}

double meanMagnitude(const Image& image) {
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels())
        for (int c = 0; c < 3; ++c)
            if (std::isfinite(pixel[c])) sum += std::abs(double{pixel[c]});
    return sum / (3.0 * static_cast<double>(image.pixels().size()));
}

/// A difference and where it is, to sort by.
struct Candidate {
    int codes;
    double relative;
    std::size_t index;

    [[nodiscard]] bool worseThan(const Candidate& other) const {
        if (codes != other.codes) return codes > other.codes;
        if (relative != other.relative) return relative > other.relative;
        return index < other.index;
    }
};

}  // namespace

Comparison compareImages(const Image& a, const Image& b) {
    checkSizes(a, b);
    Comparison out;
    const double floor = 0.01 * meanMagnitude(b) + 1e-30;  // the 1e-30 for two black pictures
    double squares8 = 0.0;
    double squares = 0.0;
    std::uint64_t close = 0;
    std::vector<Candidate> worst;  // a heap, the least bad on top
    const auto worse = [](const Candidate& x, const Candidate& y) { return x.worseThan(y); };
    const std::size_t count = a.pixels().size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 p = a.pixels()[i];
        const glm::vec3 q = b.pixels()[i];
        if (p == q) {
            ++close;
            continue;
        }
        Candidate here{0, 0.0, i};
        for (int c = 0; c < 3; ++c) {
            const int codes = difference8(p[c], q[c]);
            here.codes = std::max(here.codes, codes);
            squares8 += static_cast<double>(codes * codes);
            out.mean8 += codes;
            if (!bothFinite(p[c], q[c])) {
                ++out.nonFinite;
                continue;
            }
            const double relative =
                std::abs(double{p[c]} - q[c]) / (std::abs(double{q[c]}) + floor);
            here.relative = std::max(here.relative, relative);
            squares += relative * relative;
            out.relativeMean += relative;
        }
        if (here.codes <= 2) ++close;
        out.maximum8 = std::max(out.maximum8, here.codes);
        out.relativeMaximum = std::max(out.relativeMaximum, here.relative);
        if (worst.size() == kWorst && !here.worseThan(worst.front())) continue;
        if (worst.size() == kWorst) {
            std::pop_heap(worst.begin(), worst.end(), worse);
            worst.pop_back();
        }
        worst.push_back(here);
        std::push_heap(worst.begin(), worst.end(), worse);
    }
    const double components = 3.0 * static_cast<double>(std::max<std::size_t>(count, 1));
    out.rmse8 = std::sqrt(squares8 / components);
    out.mean8 /= components;
    out.relativeRmse = std::sqrt(squares / components);
    out.relativeMean /= components;
    if (count > 0) out.withinTwo8 = static_cast<double>(close) / static_cast<double>(count);
    std::sort_heap(worst.begin(), worst.end(), worse);
    for (const Candidate& w : worst)
        out.worst.push_back({static_cast<int>(w.index % static_cast<std::size_t>(a.width())),
                             static_cast<int>(w.index / static_cast<std::size_t>(a.width())),
                             a.pixels()[w.index], b.pixels()[w.index], w.codes});
    return out;
}

std::string report(const Comparison& c) {
    std::string text = fmt::format(
        "8-bit sRGB: RMSE {:.3f}, mean {:.3f}, maximum {}, {:.3f} % of the pixels within 2\n"
        "relative:   RMSE {:.3g}, mean {:.3g}, maximum {:.3g}\n",
        c.rmse8, c.mean8, c.maximum8, 100.0 * c.withinTwo8, c.relativeRmse, c.relativeMean,
        c.relativeMaximum);
    if (c.nonFinite > 0) text += fmt::format("{} components are not finite\n", c.nonFinite);
    for (const PixelDifference& p : c.worst)
        text +=
            fmt::format("({}, {}): {} codes apart: {:.5g} {:.5g} {:.5g} and {:.5g} {:.5g} {:.5g}\n",
                        p.column, p.row, p.difference8, p.a.x, p.a.y, p.a.z, p.b.x, p.b.y, p.b.z);
    return text;
}

Image heatMap(const Image& a, const Image& b, float fullScale8) {
    checkSizes(a, b);
    // As sRGB, evenly spaced; brightness rises all the way, so that it also reads in grey.
    const glm::vec3 stops[] = {{0.0f, 0.0f, 0.0f},  {0.25f, 0.05f, 0.45f}, {0.75f, 0.1f, 0.35f},
                               {0.98f, 0.5f, 0.1f}, {1.0f, 0.9f, 0.3f},    {1.0f, 1.0f, 1.0f}};
    constexpr int kLast = 5;
    Image out(a.width(), a.height());
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const float codes = static_cast<float>(difference8(a.pixels()[i], b.pixels()[i]));
        const float x = std::min(codes / fullScale8, 1.0f) * kLast;
        const int stop = std::min(static_cast<int>(x), kLast - 1);
        out.pixels()[i] = tonemap::linearFromSrgb(
            glm::mix(stops[stop], stops[stop + 1], x - static_cast<float>(stop)));
    }
    return out;
}

}  // namespace tukor
