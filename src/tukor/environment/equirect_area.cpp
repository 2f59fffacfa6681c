#include "tukor/environment/equirect_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tukor/base/parallel.h"
#include "tukor/environment/float4.h"

namespace tukor {

namespace {

constexpr double kPi = std::numbers::pi;

// Both the faces beside the horizon and those around the poles fall into four quarters of
// longitude, and so does a panorama. In a quarter `a` runs along a line of texels at the distance
// `rho` from the polar axis, in the direction of growing longitude, which is atan(a / rho) from the
// middle of the quarter. Along a span of longitudes solid angle is the difference of depths, 1 -
// cos(colatitude), so that rows of pixels and lines of texels are clipped against each other by
// their depths.

/// A span of longitudes within one texel and one column of pixels.
struct Piece {
    int texel;
    std::array<int, 4> columns;  // of pixels, in each quarter of a group
    float longitudes;            // width in radians
};

/// The pieces of a line, and by piece 1 + (a / rho)^2 in the middle of each.
struct Pieces {
    std::vector<Piece> list;
    std::vector<float> slopes;
};

/// What a texel gathers in each quarter, north and mirrored.
struct Gathered {
    std::array<Float4, 4> north, south;
    std::array<float, 4> weights;
};

/// Where pixel edges lie within a quarter. Wide pixels are cut into narrow parts.
class Sectors {
public:
    Sectors(int width, double quarter, int finer)
        : width_(width), parts_(std::max(1, 256 / width)), finer_(finer) {
        const double middle = parts_ * width * (0.5 + 0.25 * quarter);
        const double reach = 0.125 * parts_ * width;
        first_ = static_cast<int>(std::floor(middle - reach + 1e-7)) + 1;
        for (int edge = first_; edge < middle + reach - 1e-7; ++edge) {
            angles_.push_back((edge - middle) * 2.0 * kPi / (parts_ * width));
            tangents_.push_back(std::tan(angles_.back()));
        }
    }

    /// The pieces of a line of texels whose edges have these tangents a / rho, from -1 to 1.
    void split(const std::vector<double>& edges, Pieces& out) const {
        out.list.clear();
        out.slopes.clear();
        std::size_t texel = 1, sector = 0;
        double fromTangent = -1.0, fromAngle = -0.25 * kPi;
        while (texel < edges.size()) {
            const bool atPixel = sector < tangents_.size() && tangents_[sector] < edges[texel];
            const double tangent = atPixel ? tangents_[sector] : edges[texel];
            const double angle = atPixel ? angles_[sector] : std::atan(tangent);
            if (angle > fromAngle) {
                Piece piece;
                piece.texel = static_cast<int>(texel) - 1;
                const int column = (first_ - 1 + static_cast<int>(sector)) / parts_;
                for (int i = 0; i < 4; ++i)
                    piece.columns[static_cast<std::size_t>(i)] =
                        (column + i * (width_ / 4) + width_) % width_;
                // A line of texels crosses rows of pixels where it is far from the middle: its
                // depth in the middle of a piece then stands for too much.
                const double rise = 0.5 * std::abs(tangent + fromTangent) * (angle - fromAngle);
                const double most = 0.8 * kPi / width_;  // 0.4 of a pixel
                const int cuts = rise > most / finer_ ? 2 * finer_ : 1;
                piece.longitudes = static_cast<float>((angle - fromAngle) / cuts);
                for (int cut = 0; cut < cuts; ++cut) {
                    const double middle =
                        fromTangent + (cut + 0.5) / cuts * (tangent - fromTangent);
                    out.list.push_back(piece);
                    out.slopes.push_back(static_cast<float>(1.0 + middle * middle));
                }
            }
            fromTangent = tangent;
            fromAngle = angle;
            atPixel ? ++sector : ++texel;
        }
    }

private:
    int width_;
    int parts_;  // of a pixel
    int finer_;
    int first_;  // the first edge within
    std::vector<double> angles_, tangents_;
};

/// The panorama by rows, any pixel of which can be loaded as 16 bytes, and the depths of its rows.
class Rows {
public:
    explicit Rows(const Image& panorama)
        : pixels_(panorama.pixels().data()),
          width_(static_cast<std::size_t>(panorama.width())),
          last_(panorama.height() - 1),
          lastRow_(panorama.pixels().end() - panorama.width(), panorama.pixels().end()) {
        lastRow_.emplace_back(0.0f);
        for (int row = 0; row <= panorama.height(); ++row) {
            const double sine = std::sin(0.5 * kPi * row / panorama.height());
            depths_.push_back(static_cast<float>(2.0 * sine * sine));
        }
        depths_.back() = 3.0f;  // below everything, so that a walk ends there whatever the rounding
    }

    /// Adds what kQuarters quarters show between depths along each piece.
    template <std::size_t kQuarters>
    void gather(const Pieces& pieces, const std::vector<float>& from,
                const std::vector<float>& until, std::size_t quarter,
                std::vector<Gathered>& texels) const {
        int row = 0;
        for (std::size_t i = 0; i < pieces.list.size(); ++i) {
            const Piece& piece = pieces.list[i];
            float top = from[i];
            while (row > 0 && depths_[static_cast<std::size_t>(row)] > top) --row;
            while (depths_[static_cast<std::size_t>(row) + 1] <= top) ++row;
            std::array<Float4, kQuarters> north{}, south{};
            for (;;) {
                const float bottom = std::min(depths_[static_cast<std::size_t>(row) + 1], until[i]);
                const float part = bottom - top;
                const glm::vec3* const above = rowAt(row);
                const glm::vec3* const below = rowAt(last_ - row);
                for (std::size_t q = 0; q < kQuarters; ++q) {
                    north[q] += part * loadFloat4(above + piece.columns[q]);
                    south[q] += part * loadFloat4(below + piece.columns[q]);
                }
                if (depths_[static_cast<std::size_t>(row) + 1] >= until[i]) break;
                top = bottom;
                ++row;
            }
            Gathered& texel = texels[static_cast<std::size_t>(piece.texel)];
            for (std::size_t q = 0; q < kQuarters; ++q) {
                texel.north[quarter + q] += piece.longitudes * north[q];
                texel.south[quarter + q] += piece.longitudes * south[q];
                texel.weights[quarter + q] += piece.longitudes * (until[i] - from[i]);
            }
        }
    }

private:
    [[nodiscard]] const glm::vec3* rowAt(int row) const noexcept {
        return row == last_ ? lastRow_.data() : pixels_ + static_cast<std::size_t>(row) * width_;
    }

    const glm::vec3* pixels_;
    std::size_t width_;
    int last_;
    std::vector<glm::vec3> lastRow_;  // and one pixel behind it
    std::vector<float> depths_;       // of the edges of pixel rows
};

/// Calls visit(sectors, quarter, count) for the quarters one after the other, or for all four
/// together where they cut pixels in the same places.
template <class Visit>
void visitQuarters(const std::vector<Sectors>& sectors, const Visit& visit) {
    if (sectors.size() == 1) return visit(sectors[0], 0u, std::integral_constant<std::size_t, 4>());
    for (std::size_t q = 0; q < 4; ++q)
        visit(sectors[q], q, std::integral_constant<std::size_t, 1>());
}

void fillSides(const Rows& rows, const std::vector<Sectors>& sectors, CubeMap& cube) {
    constexpr std::array kFaces = {CubeFace::negZ, CubeFace::posX, CubeFace::posZ, CubeFace::negX};
    const int size = cube.faceSize();
    const auto count = static_cast<std::size_t>(size);
    std::vector<double> edges;
    for (int i = 0; i <= size; ++i) edges.push_back((2.0 * i - size) / size);
    std::array<Pieces, 4> pieces;
    visitQuarters(sectors, [&](const Sectors& sector, std::size_t quarter, auto) {
        sector.split(edges, pieces[quarter]);
    });
    // A row and its mirror image below the horizon at a time.
    parallelFor(0, (size + 1) / 2, 8, [&](int begin, int end) {
        std::vector<float> from, until;
        std::vector<Gathered> texels;
        const auto depthsAt = [&](int line, const Pieces& line_pieces, std::vector<float>& out) {
            const float t = static_cast<float>(2 * line - size) / static_cast<float>(size);
            out.resize(line_pieces.slopes.size());
            for (std::size_t i = 0; i < out.size(); ++i)
                out[i] = 1.0f + t / std::sqrt(line_pieces.slopes[i] + t * t);
        };
        for (int row = begin; row < end; ++row) {
            texels.assign(count, Gathered{});
            visitQuarters(sectors, [&](const Sectors&, std::size_t quarter, auto quarters) {
                depthsAt(row, pieces[quarter], from);
                depthsAt(row + 1, pieces[quarter], until);
                rows.gather<quarters()>(pieces[quarter], from, until, quarter, texels);
            });
            for (std::size_t q = 0; q < 4; ++q) {
                const std::span<glm::vec3> face = cube.texels(kFaces[q]);
                // Longitude runs against s: a cube map is seen from outside, a panorama from
                // inside.
                glm::vec3* above = &face[static_cast<std::size_t>(row) * count + count - 1];
                glm::vec3* below =
                    &face[static_cast<std::size_t>(size - 1 - row) * count + count - 1];
                for (const Gathered& texel : texels) {
                    *above-- = vec3FromFloat4(texel.north[q] / texel.weights[q]);
                    *below-- = vec3FromFloat4(texel.south[q] / texel.weights[q]);
                }
            }
        }
    });
}

/// By square rings around the poles. A ring's lines of texels are cut into thinner ones, along
/// which pixel edges are taken to run straight outwards.
void fillPoles(const Rows& rows, const std::vector<Sectors>& sectors, double pixelsPerTexel,
               int finer, CubeMap& cube) {
    const int size = cube.faceSize();
    const int lines = finer * std::max(3, static_cast<int>(std::ceil(2.2 * pixelsPerTexel)));
    parallelFor(0, (size + 1) / 2, 8, [&](int begin, int end) {
        Pieces pieces;
        std::vector<double> edges;
        std::vector<float> from, until;
        std::vector<Gathered> texels;
        for (int margin = begin; margin < end; ++margin) {
            const int count = size - 2 * margin;  // texels along a side of the ring
            const double outer = static_cast<double>(count) / size;
            const double inner = std::max(0.0, outer - 2.0 / size);
            texels.assign(static_cast<std::size_t>(count), Gathered{});
            for (int line = 0; line < lines; ++line) {
                const double near = inner + (outer - inner) * line / lines;
                const double far = inner + (outer - inner) * (line + 1) / lines;
                edges.clear();
                for (int i = 0; i <= count; ++i)
                    edges.push_back(
                        std::clamp((2.0 * i - count) / size / (0.5 * (near + far)), -1.0, 1.0));
                const auto depthsAt = [&](double rho, std::vector<float>& out) {
                    out.resize(pieces.slopes.size());
                    const auto rho2 = static_cast<float>(rho * rho);
                    for (std::size_t i = 0; i < out.size(); ++i) {
                        const float r2 = rho2 * pieces.slopes[i];
                        const float length = std::sqrt(1.0f + r2);
                        out[i] = r2 / (length * (length + 1.0f));  // 1 - 1 / length, to its digits
                    }
                };
                visitQuarters(sectors,
                              [&](const Sectors& sector, std::size_t quarter, auto quarters) {
                                  sector.split(edges, pieces);
                                  depthsAt(near, from);
                                  depthsAt(far, until);
                                  rows.gather<quarters()>(pieces, from, until, quarter, texels);
                              });
            }
            // The last texel of a side is the first of the next; a single one is that of all.
            const std::size_t last = texels.size() - 1;
            for (std::size_t q = 0; q < 4; ++q)
                for (std::size_t i = 0; i < std::max<std::size_t>(last, 1); ++i) {
                    Float4 north = texels[i].north[q], south = texels[i].south[q];
                    float weight = texels[i].weights[q];
                    for (std::size_t more = 1; i == 0 && more <= (last == 0 ? 3u : 1u); ++more) {
                        const std::size_t before = (q + 4 - more) % 4;
                        north += texels[last].north[before];
                        south += texels[last].south[before];
                        weight += texels[last].weights[before];
                    }
                    const int along = margin + static_cast<int>(i), back = size - 1 - along;
                    const int rowOf[] = {margin, along, size - 1 - margin, back};
                    const int columnOf[] = {along, size - 1 - margin, back, margin};
                    cube.texels(
                        CubeFace::posY)[static_cast<std::size_t>(rowOf[q] * size + columnOf[q])] =
                        vec3FromFloat4(north / weight);
                    cube.texels(CubeFace::negY)[static_cast<std::size_t>(
                        (size - 1 - rowOf[q]) * size + columnOf[q])] =
                        vec3FromFloat4(south / weight);
                }
        }
    });
}

}  // namespace

CubeMap areaCubeFromEquirect(const Image& panorama, int faceSize) {
    const Rows rows(panorama);
    // Chains of filtered levels begin with small maps; many pixels to a texel average errors out.
    const double pixelsPerTexel = panorama.width() / kPi / faceSize;
    const int finer = faceSize <= 512 && pixelsPerTexel < 3.0 ? 3 : 1;
    const int quarters = panorama.width() % 4 == 0 ? 1 : 4;
    std::vector<Sectors> sectors;
    sectors.reserve(static_cast<std::size_t>(quarters));
    for (int quarter = 0; quarter < quarters; ++quarter)
        sectors.emplace_back(panorama.width(), quarter, finer);
    CubeMap cube(faceSize);
    fillSides(rows, sectors, cube);
    fillPoles(rows, sectors, pixelsPerTexel, finer, cube);
    return cube;
}

}  // namespace tukor
