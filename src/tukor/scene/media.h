// The dielectrics of a scene as rays pass through them: one table, ordered by what displaces what.
#pragma once
#include <vector>

#include "tukor/scene/scene.h"

namespace tukor {

/// Index and absorption of a clear medium; that of materials with a colourSize is fitted to the
/// largest part that it fills.
struct DielectricMedium {
    float eta = 1.0f;         // against vacuum
    glm::vec3 sigmaA{0.0f};   // 1/m
    float dispersion = 0.0f;  // 20 over Abbe's number
};

/// Rays carry the set of media around them as 32 bits, of which the highest is the one that is
/// there (tukor/transport/media.h).
struct MediaTable {
    std::vector<DielectricMedium> media;  // ascending priority; of equals the first part comes last
    std::vector<int> mediumOfPart;        // index into media; -1 for mirrors and metals
};

inline constexpr int kMaxMedia = 32;

/// One medium a part, as long as there are enough; then parts of equal material share one where
/// their bounds are disjoint, or else all of them. Throws Error above 32 different materials.
[[nodiscard]] MediaTable mediaOf(const Scene& scene);

}  // namespace tukor
