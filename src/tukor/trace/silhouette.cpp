#include "tukor/trace/silhouette.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/mat3x3.hpp>

#include "tukor/base/parallel.h"

namespace tukor::trace {

namespace {

/// A point in homogeneous pixels: seen at (x / z, y / z) where z > 0, else behind the eye.
using Point = glm::dvec3;

/// What is left of a triangle after up to three cuts.
struct Polygon {
    std::array<Point, 6> corners;
    int count = 0;

    void add(const Point& p) noexcept { corners[static_cast<std::size_t>(count++)] = p; }
};

/// The part where dot(plane, p) >= 0.
Polygon cut(const Polygon& polygon, const Point& plane) noexcept {
    Polygon rest;
    for (int i = 0; i < polygon.count; ++i) {
        const Point& a = polygon.corners[static_cast<std::size_t>(i)];
        const Point& b = polygon.corners[static_cast<std::size_t>((i + 1) % polygon.count)];
        const double inA = dot(plane, a), inB = dot(plane, b);
        if (inA >= 0.0) rest.add(a);
        if ((inA >= 0.0) != (inB >= 0.0)) rest.add(a + inA / (inA - inB) * (b - a));
    }
    return rest;
}

class Raster {
public:
    Raster(const RayGenerator& camera, int width, int height)
        : eye_(camera.eye),
          width_(width),
          height_(height),
          margin_(1.0 / 16.0 + 1e-6 * std::max(width, height)),
          mask_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {
        pixelsFromWorld_ = inverse(glm::dmat3(
            glm::dvec3(camera.perColumn), glm::dvec3(camera.perRow), glm::dvec3(camera.corner)));
    }

    void draw(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) noexcept {
        const Point p = seen(a), q = seen(b), r = seen(c);
        if (p.z > 0.0 && q.z > 0.0 && r.z > 0.0) {
            const auto [left, right] = std::minmax({p.x / p.z, q.x / q.z, r.x / r.z});
            const auto [top, bottom] = std::minmax({p.y / p.z, q.y / q.z, r.y / r.z});
            const int first = pixelAt(top - margin_), last = pixelAt(bottom + margin_);
            // A small one is not much smaller than the square around it.
            if (last - first < 2 || right - left < 1.0) {
                for (int y = std::max(first, 0); y <= std::min(last, height_ - 1); ++y)
                    mark(y, left, right);
            } else {
                drawRows({{p, q, r}, 3}, first, last);
            }
        } else if (!(p.z <= 0.0 && q.z <= 0.0 && r.z <= 0.0)) {
            drawRows(cut({{p, q, r}, 3}, {0.0, 0.0, 1.0}), 0, height_ - 1);
        }
    }

    [[nodiscard]] std::vector<std::uint8_t> takeMask() noexcept { return std::move(mask_); }

private:
    [[nodiscard]] Point seen(const glm::dvec3& p) const noexcept {
        return pixelsFromWorld_ * (p - eye_);
    }

    /// That contains a place, clamped to what an int holds; NaN is right of all.
    [[nodiscard]] static int pixelAt(double place) noexcept {
        return static_cast<int>(std::floor(std::max(-1e9, std::min(1e9, place))));
    }

    void drawRows(const Polygon& polygon, int first, int last) noexcept {
        for (int y = std::max(first, 0); y <= std::min(last, height_ - 1); ++y) {
            const Polygon row =
                cut(cut(polygon, {0.0, 1.0, margin_ - y}), {0.0, -1.0, y + 1.0 + margin_});
            if (row.count == 0) continue;
            double left = std::numeric_limits<double>::infinity(), right = -left;
            for (int i = 0; i < row.count; ++i) {
                const Point& p = row.corners[static_cast<std::size_t>(i)];
                // What has been cut at the eye's plane is seen at infinity.
                const bool far = p.z <= 1e-9 * (std::abs(p.x) + std::abs(p.y));
                left = std::min(left, far ? (p.x > 0.0 ? left : -1e9) : p.x / p.z);
                right = std::max(right, far ? (p.x < 0.0 ? right : 1e9) : p.x / p.z);
            }
            mark(y, left, right);
        }
    }

    /// Threads may set the same pixel.
    void mark(int y, double left, double right) noexcept {
        const int first = std::max(pixelAt(left - margin_), 0);
        const int last = std::min(pixelAt(right + margin_), width_ - 1);
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
        for (int x = first; x <= last; ++x) {
            const std::atomic_ref<std::uint8_t> pixel(mask_[row + static_cast<std::size_t>(x)]);
            if (pixel.load(std::memory_order_relaxed) == 0)
                pixel.store(1, std::memory_order_relaxed);
        }
    }

    glm::dmat3 pixelsFromWorld_;
    glm::dvec3 eye_;
    int width_, height_;
    double margin_;  // pixels, by which the arithmetic of rays may be off
    std::vector<std::uint8_t> mask_;
};

/// Quadrangles that touch a sphere from outside, as two triangles each.
void drawAround(Raster& raster, const Sphere& sphere) {
    constexpr int kSlices = 32, kStacks = 16;
    constexpr double kStep = 2.0 * std::numbers::pi / kSlices;
    const double cosine = std::cos(0.5 * kStep);
    const double radius = static_cast<double>(sphere.radius) * 1.0001 / (cosine * cosine);
    const auto point = [&](int stack, int slice) {
        const double theta = stack * kStep, phi = slice * kStep;
        return glm::dvec3(sphere.centre) + radius * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                               std::cos(theta),
                                                               std::sin(theta) * std::sin(phi));
    };
    for (int i = 0; i < kStacks; ++i) {
        for (int j = 0; j < kSlices; ++j) {
            raster.draw(point(i, j), point(i + 1, j), point(i, j + 1));
            raster.draw(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
        }
    }
}

}  // namespace

std::vector<std::uint8_t> silhouetteOf(const SurfaceTable& surfaces, const RayGenerator& camera,
                                       int width, int height) {
    Raster raster(camera, width, height);
    for (const SurfaceTable::Entry& entry : surfaces.entries()) {
        if (entry.sphere) {
            drawAround(raster, *entry.sphere);
            continue;
        }
        const auto& p = entry.positions;
        parallelFor(0, static_cast<int>(entry.indices.size()), 4096, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const glm::uvec3 t = entry.indices[static_cast<std::size_t>(i)];
                raster.draw(p[t.x], p[t.y], p[t.z]);
            }
        });
    }
    return raster.takeMask();
}

}  // namespace tukor::trace
