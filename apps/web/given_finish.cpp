#include "given_finish.h"

#include <utility>

namespace tukor::gl {

FinishLight finishLight(LightSource&, float) {
    return std::exchange(web::givenLight, {});
}

BackdropLight backdropLight(LightSource&, float, float) {
    return {};
}

std::vector<glm::vec4> groundLight(const LightSource&, float, std::span<const LitDirection>) {
    return web::givenGround;
}

std::vector<glm::vec4> spectrumTable() {
    return web::givenSpectrum;
}

bool partsAtHand() noexcept {
    return !web::givenTracedShader.empty();
}

const ShaderSource& finishShader() {
    static const char* const files[] = {"finish.frag"};
    static ShaderSource source{nullptr, files};
    source.text = web::givenFinishShader.c_str();
    return source;
}

const ShaderSource& wholeTracedShader() {
    static const char* const files[] = {"traced.frag"};
    static ShaderSource source{nullptr, files};
    source.text = web::givenTracedShader.c_str();
    return source;
}

}  // namespace tukor::gl
