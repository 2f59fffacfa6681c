#include "oracle/equirect.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace tukor::oracle {

namespace {

glm::vec3 bilinear(const Image& image, glm::vec3 direction) {
    const double x = direction.x;
    const double y = direction.y;
    const double z = direction.z;
    const double longitude = std::atan2(x, -z);                 // 0 at -Z, pi / 2 at +X
    const double colatitude = std::atan2(std::hypot(x, z), y);  // 0 at +Y
    const double u = (0.5 + 0.5 * longitude / std::numbers::pi) * image.width() - 0.5;
    const double v = colatitude / std::numbers::pi * image.height() - 0.5;
    const double left = std::floor(u);
    const double top = std::floor(v);
    const auto texel = [&](double column, double row) {
        const int w = image.width();
        const int i = (static_cast<int>(column) % w + w) % w;
        const int j = std::clamp(static_cast<int>(row), 0, image.height() - 1);
        return glm::dvec3(image.at(i, j));
    };
    const glm::dvec3 above = glm::mix(texel(left, top), texel(left + 1, top), u - left);
    const glm::dvec3 below = glm::mix(texel(left, top + 1), texel(left + 1, top + 1), u - left);
    return glm::vec3(glm::mix(above, below, v - top));
}

}  // namespace

Environment equirect(Image panorama) {
    for (glm::vec3& pixel : panorama.pixels()) {
        for (int channel = 0; channel < 3; ++channel) {
            if (!(std::isfinite(pixel[channel]) && pixel[channel] > 0.0f)) pixel[channel] = 0.0f;
        }
    }
    const auto shared = std::make_shared<const Image>(std::move(panorama));
    return [shared](glm::vec3 direction) { return bilinear(*shared, direction); };
}

}  // namespace tukor::oracle
