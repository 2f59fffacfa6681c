// In a page, which gathers none: its views show no ground while they move.
#include "tukor/gl/ground_light.h"

namespace tukor::gl {

int GroundLight::samples(const RenderOptions&) const noexcept {
    return 0;
}

float GroundLight::level() const noexcept {
    return 0.0f;
}

}  // namespace tukor::gl
