// The contract of shared source: what lets one file compile as C++20 and as GLSL ES 3.00.
//
// A shared file uses float, int, uint, bool, vecN, matN, structs filled field by field and GLSL's
// built-in functions; literals carry `f`; arguments go by value; results that need two values are
// structs or TUKOR_OUT parameters. No swizzles, references, auto, default arguments, constructors
// or namespaces of its own. Local vectors are made by vec3(x, y, z).
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/integer.hpp>

#define TUKOR_SHARED_BEGIN(module) \
    namespace tukor::module {      \
    using namespace tukor::glsl;
#define TUKOR_SHARED_END }
/// After TUKOR_SHARED_BEGIN: the names of a module below.
#define TUKOR_SHARED_USING(module) using namespace tukor::module;
/// Before every function of shared source.
#define TUKOR_FN [[nodiscard]] inline
/// Before a function without a result.
#define TUKOR_PROCEDURE inline void
/// Parameters that are written, or read and written.
#define TUKOR_OUT(type) type&
#define TUKOR_INOUT(type) type&
/// Constants of file scope.
#define TUKOR_CONST inline constexpr

/// GLSL's types and built-ins under their own names, for shared source and its C++ callers.
namespace tukor::glsl {
using uint = glm::uint;
using glm::ivec2, glm::ivec3, glm::ivec4, glm::uvec2, glm::uvec3, glm::uvec4;
using glm::vec2, glm::vec3, glm::vec4, glm::mat3, glm::mat4;

using glm::abs, glm::acos, glm::asin, glm::atan, glm::ceil, glm::clamp, glm::cos, glm::cross,
    glm::distance, glm::dot, glm::exp, glm::exp2, glm::floatBitsToUint, glm::floor, glm::fract,
    glm::inversesqrt, glm::length, glm::log, glm::log2, glm::max, glm::min, glm::mix, glm::mod,
    glm::normalize, glm::pow, glm::sign, glm::sin, glm::smoothstep, glm::sqrt, glm::step, glm::tan,
    glm::transpose, glm::uintBitsToFloat;
}  // namespace tukor::glsl
#else
#define TUKOR_SHARED_BEGIN(module)
#define TUKOR_SHARED_END
#define TUKOR_SHARED_USING(module)
#define TUKOR_FN
#define TUKOR_PROCEDURE void
#define TUKOR_OUT(type) out type
#define TUKOR_INOUT(type) inout type
#define TUKOR_CONST const
#endif
