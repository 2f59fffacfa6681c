#include "tukor/gl/traced_drawer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tukor/gl/full_viewport.h"
#include "tukor/gl/lamps.h"
#include "tukor/gl/light_chain.h"
#include "tukor/gl/shaders.h"

namespace tukor::gl {

namespace {

// Drivers give up on draw calls of about two seconds. A weak GPU does some 20 million rays a
// second; few pixels use their whole budget.
constexpr int kRaysPerTile = 1 << 23;

int tileSize(int rayBudget) {
    const float pixels = static_cast<float>(kRaysPerTile) / static_cast<float>(rayBudget);
    return std::clamp(static_cast<int>(std::sqrt(pixels)), 32, 4096);
}

}  // namespace

const Program& TracedDrawer::programFor(Fidelity fidelity, FresnelForm fresnel,
                                        const ShaderSource& shader, std::string_view sceneDefines,
                                        Counting counting) {
    const std::string defines =
        fmt::format("#define FIDELITY {}\n#define FRESNEL {}\n#define COUNTING {}\n{}",
                    static_cast<int>(fidelity), static_cast<int>(fresnel),
                    counting == Counting::all ? 1 : 0, sceneDefines);
    const auto found = programs_.find(defines);
    if (found != programs_.end()) return found->second;
    return programs_.emplace(defines, Program(shaders::fullViewportVert, shader, defines))
        .first->second;
}

void TracedDrawer::drawFirstHits(const TracedScene& scene, const View& view) {
    if (!firstHitProgram_) firstHitProgram_.emplace(shaders::firstHitVert, shaders::firstHitFrag);
    firstHitProgram_->set("clipFromWorld", view.clipFromWorld);
    scene.drawTriangles(*firstHitProgram_);
}

void TracedDrawer::draw(TracedScene& scene, const EnvironmentTexture& environment,
                        const Frame& frame, Counting counting, const Units& units,
                        const Region& region) {
    std::string defines = std::string(environment.define()) + scene.defines();
    const std::vector<glm::vec4> lamps =
        lampTable(frame.lights, frame.view.eye, frame.environmentFromWorld, frame.emissionFactor);
    if (scene.finished() && !lamps.empty())
        defines += fmt::format("#define LAMPS {}\n", lamps.size() / 4);
    // A single sample would have a single colour, and flicker.
    const bool disperses = scene.disperses() && frame.options.samples != 1;
    if (disperses) defines += "#define DISPERSION\n";
    if (frame.ground) defines += "#define GROUND\n";
    const Program& program = programFor(
        frame.fidelity, frame.fresnel,
        scene.finished() || frame.ground || disperses ? wholeTracedShader() : shaders::tracedFrag,
        defines, counting);
    const RenderOptions& options = frame.options;
    environment.bind(0);
    program.set("environment", 0);
    program.set("environmentFaceSize", environment.faceSize());
    program.set("environmentFromWorld", frame.environmentFromWorld);
    scene.bind(program, 1, frame.view.eye);
    program.set("sum", units.sum);
    program.set("counted", units.sum + 1);
    if (scene.finished()) {
        program.set("raster", units.raster);
        program.set("chain", units.chain);
        program.set("table", units.chain + 1);
        program.set("lastLevel", static_cast<float>(kChainLevels - 1));
        program.set("unlitFactor", frame.emissionFactor);
        if (!lamps.empty()) program.set("lamps[0]", lamps);
    }
    if (disperses) program.set("spectrum[0]", spectrumTable());
    if (frame.ground) {
        program.set("ground", glm::vec4(frame.ground->middle, frame.ground->halfWidth));
        program.set("groundIrradiance", frame.ground->irradiance);
        program.set("groundUse", static_cast<int>(frame.ground->use));
        program.set("groundLight", units.groundLight);
        program.set("groundLevel", frame.ground->level);
        program.set("lit", units.ground);
    }
    program.set("first", frame.number == 0 ? 1 : 0);
    program.set("frame", static_cast<std::uint32_t>(frame.number));
    program.set("centred", frame.centred ? 1 : 0);
    program.set("firstHitsKnown", frame.firstHitsKnown ? 1 : 0);
    program.set("firstHits", units.firstHits);
    program.set("splitGrazing", frame.splitGrazing ? 1 : 0);
    program.set("pictureSeed", options.seed);
    const PictureWindow& window = frame.window;
    program.set("topLeft",
                glm::ivec2(window.left, window.fullHeight - window.bottom - window.height));
    program.set("windowSize", glm::ivec2(window.width, window.height));
    program.set("pictureWidth", window.fullWidth);
    program.set("background", options.background == Background::none ? 0 : 1);

    program.set("eye", frame.view.eye);
    const auto ray = [&](float x, float y) {
        return glm::vec3(frame.view.rayDirMatrix * glm::vec4(x, y, 0.0f, 1.0f));
    };
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    const glm::vec3 corner = ray(-1.0f, -1.0f);
    program.set("rayCorner", corner);
    program.set("rayPerColumn", (ray(1.0f, -1.0f) - corner) / static_cast<float>(viewport[2]));
    program.set("rayPerRow", (ray(-1.0f, 1.0f) - corner) / static_cast<float>(viewport[3]));
    program.set("footprintScale", frame.footprintScale);

    program.set("rayBudget", std::max(options.rayBudget, 1));
    program.set("maxDepth", std::max(options.maxDepth, 1));
    program.set("weightCutoff", options.weightCutoff);

    const int tile = tileSize(std::max(options.rayBudget, 1));
    glEnable(GL_SCISSOR_TEST);
    for (int y = 0; y < region.height; y += tile) {
        for (int x = 0; x < region.width; x += tile) {
            glScissor(region.left + x, region.bottom + y, std::min(tile, region.width - x),
                      std::min(tile, region.height - y));
            drawFullViewport(program);
            glFlush();
        }
    }
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace tukor::gl
