// The round brilliant cut.
#pragma once
#include "tukor/geometry/mesh.h"

namespace tukor {

/// Lengths are fractions of the girdle's diameter, angles in radians, defaults near Tolkowsky's.
/// [Tolkowsky 1919]
struct BrilliantOptions {
    double tableDiameter = 0.53;      // from corner to corner
    double crownAngle = 0.602139;     // 34.5 degrees
    double pavilionAngle = 0.711222;  // 40.75 degrees
    double girdleThickness = 0.03;    // where it is thickest
    double starLength = 0.5;          // of the way from table to girdle, seen from above
    double lowerHalfLength = 0.77;    // of the way from girdle to culet, seen from below
    int girdleFacets = 96;            // a multiple of 16
};

/// A stone of 57 facets and a faceted girdle, table up, diameter 2, the middle of its height at the
/// origin. Every facet is flat: one normal for all its corners.
[[nodiscard]] Mesh makeBrilliant(const BrilliantOptions& options = {});

}  // namespace tukor
