// What the third module made for surfaces with a finish, a ground and dispersion, as the page hands
// it over: it stands in for gl/finish_parts.cpp.
#pragma once
#include <string>

#include "tukor/gl/finish_parts.h"

namespace tukor::web {

inline gl::FinishLight givenLight;          // taken by the next that asks
inline std::vector<glm::vec4> givenGround;  // stays
inline std::vector<glm::vec4> givenSpectrum;
inline std::string givenFinishShader;
inline std::string givenTracedShader;

}  // namespace tukor::web
