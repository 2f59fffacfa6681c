// Three channels and a spare one in one register: what the resampling loops compute with.
#pragma once
#include <cstring>

#include <glm/glm.hpp>

namespace tukor {

using Float4 = float __attribute__((vector_size(16)));

/// The pixel at `from`, and in the spare channel the first of the next one: 16 bytes are read.
[[nodiscard]] inline Float4 loadFloat4(const glm::vec3* from) noexcept {
    Float4 value;
    std::memcpy(&value, static_cast<const void*>(from), sizeof value);
    return value;
}

[[nodiscard]] inline Float4 float4(glm::vec3 value) noexcept {
    return Float4{value.x, value.y, value.z, 0.0f};
}

[[nodiscard]] inline glm::vec3 vec3FromFloat4(Float4 value) noexcept {
    return {value[0], value[1], value[2]};
}

[[nodiscard]] inline Float4 min(Float4 a, Float4 b) noexcept {
    return a < b ? a : b;
}

[[nodiscard]] inline Float4 max(Float4 a, Float4 b) noexcept {
    return a > b ? a : b;
}

}  // namespace tukor
