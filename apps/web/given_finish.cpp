#include "given_finish.h"

#include <utility>

namespace tukor::gl {

FinishLight finishLight(const LightSource&, float) {
    return std::exchange(web::givenLight, {});
}

BackdropLight backdropLight(const LightSource&, float, float) {
    return {};
}

const ShaderSource& finishShader() {
    static const char* const files[] = {"finish.frag"};
    static ShaderSource source{nullptr, files};
    source.text = web::givenFinishShader.c_str();
    return source;
}

const ShaderSource& tracedFinishesShader() {
    static const char* const files[] = {"traced.frag"};
    static ShaderSource source{nullptr, files};
    source.text = web::givenTracedShader.c_str();
    return source;
}

}  // namespace tukor::gl
