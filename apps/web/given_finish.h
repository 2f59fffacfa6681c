// What the third module made for surfaces with a finish, as the page hands it over: it stands in
// for gl/finish_parts.cpp.
#pragma once
#include <string>

#include "tukor/gl/finish_parts.h"

namespace tukor::web {

inline gl::FinishLight givenLight;  // taken by the next that asks
inline std::string givenFinishShader;
inline std::string givenTracedShader;

}  // namespace tukor::web
