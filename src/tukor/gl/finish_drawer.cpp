#include "tukor/gl/finish_drawer.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "tukor/gl/lamps.h"
#include "tukor/gl/shaders.h"

namespace tukor::gl {

namespace {

// Names in finish.frag of the textures, by TextureRole.
constexpr std::string_view kRoles[kTextureRoles] = {
    "BASE_COLOR",      "METALLIC_ROUGHNESS",  "NORMAL",           "OCCLUSION",
    "EMISSION",        "TRANSMISSION",        "SPECULAR",         "SPECULAR_COLOR",
    "CLEARCOAT",       "CLEARCOAT_ROUGHNESS", "CLEARCOAT_NORMAL", "SHEEN_COLOR",
    "SHEEN_ROUGHNESS", "ANISOTROPY",          "IRIDESCENCE",      "IRIDESCENCE_THICKNESS"};
constexpr int kFirstUnit = 3;
constexpr int kUnits = 16;  // that every OpenGL ES 3 has

GLint wrapOf(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::mirror:
            return GL_MIRRORED_REPEAT;
        case Wrap::clamp:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

}  // namespace

const Program& FinishDrawer::programFor(const std::string& defines) {
    const auto found = programs_.find(defines);
    if (found != programs_.end()) return found->second;
    return programs_.emplace(defines, Program(shaders::finishVert, finishShader(), defines))
        .first->second;
}

const Texture& FinishDrawer::textureOf(const TextureMap& map, TextureRole role) {
    Texture& texture = textures_[{map.texels, isSrgb(role)}];
    if (texture.id() != 0) return texture;
    texture = Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const Texels& texels = *map.texels;
    // Larger ones than the driver's are thinned out: seen at full size they would fill many
    // screens.
    const int step = (std::max(texels.width, texels.height) + largest - 1) / largest;
    const int width = std::max(texels.width / step, 1), height = std::max(texels.height / step, 1);
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height) * 4);
    const auto n = static_cast<std::size_t>(texels.channels);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto from =
                (static_cast<std::size_t>(row * step) * static_cast<std::size_t>(texels.width) +
                 static_cast<std::size_t>(column * step)) *
                n;
            const auto to = (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(column)) *
                            4;
            for (std::size_t c = 0; c < 4; ++c) rgba[to + c] = c < n ? texels.bytes[from + c] : 255;
        }
    int levels = 1;
    while (std::max(width, height) >> levels) ++levels;
    glTexStorage2D(GL_TEXTURE_2D, levels, isSrgb(role) ? GL_SRGB8_ALPHA8 : GL_RGBA8, width, height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    return texture;
}

void FinishDrawer::drawPart(const SurfaceBuffers& surfaces, int part, const Finish& finish,
                            Solidity solidity, float eta, const FinishFrame& frame) {
    std::string defines(frame.environmentDefine);
    defines += fmt::format("#define ALPHA_MODE {}\n#define SOLID {}\n",
                           static_cast<int>(finish.alphaMode), static_cast<int>(solidity));
    const auto define = [&](std::string_view name, bool wanted) {
        if (wanted) defines += fmt::format("#define {}\n", name);
    };
    define("UNLIT", finish.unlit);
    define("CLEARCOAT", finish.clearcoat > 0.0f);
    define("SHEEN", finish.sheenColor != glm::vec3(0.0f));
    define("ANISOTROPIC", finish.anisotropy > 0.0f);
    define("FILM", finish.iridescence > 0.0f);
    define("TRANSMISSIVE", finish.transmission > 0.0f);

    const std::vector<glm::vec4> lamps =
        lampTable(frame.lights, frame.view.eye, frame.environmentFromWorld, frame.emissionFactor);
    if (!lamps.empty()) defines += fmt::format("#define LAMPS {}\n", lamps.size() / 4);

    std::vector<std::size_t> mapped;
    std::vector<glm::vec4> places(2 * kTextureRoles, glm::vec4(0.0f));
    for (std::size_t i = 0; i < kTextureRoles; ++i) {
        const TextureMap& map = finish.maps[i];
        if (!finish.has(static_cast<TextureRole>(i)) ||
            kFirstUnit + static_cast<int>(mapped.size()) >= kUnits)
            continue;
        defines += fmt::format("#define MAP_{}\n", kRoles[i]);
        mapped.push_back(i);
        places[2 * i] = {map.imageFromUv[0], map.imageFromUv[1]};
        places[2 * i + 1] = {map.imageFromUv[2], static_cast<float>(map.uvSet), 0.0f};
    }
    const Program& program = programFor(defines);
    for (std::size_t i = 0; i < mapped.size(); ++i) {
        const TextureMap& map = finish.maps[mapped[i]];
        const int unit = kFirstUnit + static_cast<int>(i);
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, textureOf(map, static_cast<TextureRole>(mapped[i])).id());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapOf(map.wrapU));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapOf(map.wrapV));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, map.smooth ? GL_LINEAR : GL_NEAREST);
        program.set(fmt::format("map{}", mapped[i]), unit);
    }
    program.set("places[0]", places);
    if (!lamps.empty()) program.set("lamps[0]", lamps);
    program.set("clipFromWorld", frame.view.clipFromWorld);
    program.set("environmentFromWorld", frame.environmentFromWorld);
    program.set("eye", frame.view.eye);
    program.set("environment", 0);
    program.set("chain", 1);
    program.set("table", 2);
    program.set("lastLevel", static_cast<float>(kChainLevels - 1));
    program.set("footprintMiddle", frame.footprintMiddle);
    program.set("baseColor", glm::vec4(finish.baseColor, finish.alpha));
    program.set("alphaCutoff", finish.alphaCutoff);
    program.set("metallicRoughness", glm::vec2(finish.metallic, finish.roughness));
    program.set("emission", finish.emission * frame.emissionFactor);
    program.set("unlitFactor", frame.emissionFactor);
    program.set("normalScale", finish.normalScale);
    program.set("occlusionStrength", finish.occlusionStrength);
    const float ratio = (finish.ior - 1.0f) / (finish.ior + 1.0f);
    program.set("specularF0", ratio * ratio * finish.specularColor);
    program.set("specularWeight", finish.specular);
    program.set("transmission", finish.transmission);
    program.set("eta", eta);
    program.set("coat", glm::vec3(finish.clearcoat, finish.clearcoatRoughness,
                                  finish.clearcoatNormalScale));
    program.set("sheen", glm::vec4(finish.sheenColor, finish.sheenRoughness));
    program.set("anisotropy", glm::vec2(finish.anisotropy, finish.anisotropyRotation));
    program.set("film", glm::vec4(finish.iridescence, finish.iridescenceIor,
                                  finish.iridescenceThinnest, finish.iridescenceThickest));
    if (finish.alphaMode == AlphaMode::opaque)
        surfaces.draw(part, frame.view.eye);
    else
        surfaces.drawBothSides(part);
}

void FinishDrawer::draw(const SurfaceBuffers& surfaces, const std::vector<Material>& materials,
                        Pass pass, LightChain& light, const FinishFrame& frame) {
    std::vector<int> parts;
    for (int part = 0; part < surfaces.parts(); ++part) {
        const Finish* const finish = materials[static_cast<std::size_t>(part)].finish.get();
        if (finish && (finish->alphaMode == AlphaMode::blend) == (pass == Pass::blended))
            parts.push_back(part);
    }
    if (parts.empty()) return;
    light.bind(1);
    glDepthRangef(0.0f, 0.999f);
    if (pass == Pass::blended) {
        const auto distance = [&](int part) {
            return glm::distance(surfaces.boundsOfPart(part).centre(), frame.view.eye);
        };
        std::stable_sort(parts.begin(), parts.end(),
                         [&](int a, int b) { return distance(a) > distance(b); });
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glDepthMask(GL_FALSE);
    }
    surfaces.bind();
    for (const int part : parts) {
        const Material& material = materials[static_cast<std::size_t>(part)];
        const bool solid = material.kind == MaterialKind::dielectric;
        drawPart(surfaces, part, *material.finish, solid ? Solidity::solid : Solidity::thin,
                 material.eta.x, frame);
    }
    glBindVertexArray(0);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDepthRangef(0.0f, 1.0f);
}

}  // namespace tukor::gl
