#include "tukor/trace/appearance.h"

#include <algorithm>
#include <cmath>

#include "tukor/optics/thin_film.h"
#include "tukor/transport/footprint.h"

namespace tukor::trace {

namespace {

constexpr float kLeastAlpha = 1e-4f;

/// Tangent frame of the front side: from the mesh, else along the texture's u.
struct Frame3 {
    glm::vec3 n, t, b;
};

glm::vec3 anyTangent(glm::vec3 n) noexcept {
    const glm::vec3 axis = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(axis - glm::dot(axis, n) * n);
}

Frame3 frameOf(glm::vec3 n, glm::vec3 tangent, float sign) noexcept {
    Frame3 f{n, tangent - glm::dot(tangent, n) * n, glm::vec3(0.0f)};
    const float length = glm::length(f.t);
    f.t = length > 1e-12f && std::isfinite(length) ? f.t / length : anyTangent(n);
    f.b = glm::cross(n, f.t) * (sign < 0.0f ? -1.0f : 1.0f);
    return f;
}

Frame3 frameAlongUv(glm::vec3 n, glm::vec3 e1, glm::vec3 e2, glm::vec2 d1, glm::vec2 d2) noexcept {
    const float det = d1.x * d2.y - d1.y * d2.x;
    if (!(std::abs(det) > 1e-20f)) return frameOf(n, anyTangent(n), 1.0f);
    const glm::vec3 perU = (e1 * d2.y - e2 * d1.y) / det;
    const glm::vec3 perV = (e2 * d1.x - e1 * d2.x) / det;
    // v runs down the picture, the bitangent up.
    return frameOf(n, perU, -glm::dot(glm::cross(n, perU), perV));
}

glm::vec3 perturbed(const Frame3& f, glm::vec4 texel, float scale) noexcept {
    const glm::vec3 m = glm::vec3(texel) * 2.0f - 1.0f;
    const glm::vec3 n = m.x * scale * f.t + m.y * scale * f.b + m.z * f.n;
    const float length = glm::length(n);
    return length > 1e-6f ? n / length : f.n;
}

/// On the viewer's side, as far as need be.
glm::vec3 turnedTo(glm::vec3 n, glm::vec3 wo) noexcept {
    constexpr float kLeast = 1e-3f;
    const float c = glm::dot(n, wo);
    return c >= kLeast ? n : glm::normalize(n + (2.0f * kLeast - c) * wo);
}

}  // namespace

FinishTable::FinishTable(const Scene& scene) {
    using Clear = std::shared_ptr<const ClearAlbedo>;
    std::map<float, std::pair<Clear, Clear>> albedos;  // by index
    for (const Part& part : scene.parts) {
        PartFinish& entry = parts_.emplace_back();
        if (!part.material.finish) continue;
        empty_ = false;
        entry.finish = part.material.finish.get();
        entry.mesh = &part.mesh;
        if (part.material.kind == MaterialKind::dielectric) {
            const float eta = part.material.eta.x;
            auto& known = albedos[eta];
            if (!known.first)
                known = {std::make_shared<ClearAlbedo>(eta),
                         std::make_shared<ClearAlbedo>(1.0f / eta)};
            entry.entering = known.first;
            entry.leaving = known.second;
        }
        for (std::size_t i = 0; i < kTextureRoles; ++i) {
            const TextureMap& map = entry.finish->maps[i];
            if (map.uvSet < 0 || map.uvSet > 1) continue;
            const auto& uvs = part.mesh.uvs[static_cast<std::size_t>(map.uvSet)];
            if (uvs.size() != part.mesh.positions.size()) continue;  // factors count alone
            entry.pyramids[i] = store_.pyramidOf(map, static_cast<TextureRole>(i));
        }
    }
}

FinishTable::Place FinishTable::placeOf(const RayHit& hit, const transport::SurfaceHit& surface,
                                        float area) const noexcept {
    Place place{};
    place.part = &parts_[static_cast<std::size_t>(hit.surface)];
    const Mesh& mesh = *place.part->mesh;
    place.corners = mesh.triangles[static_cast<std::size_t>(hit.triangle)];
    place.weights = {1.0f - hit.u - hit.v, hit.u, hit.v};
    const float facet = glm::length(glm::cross(surface.e1, surface.e2));
    for (std::size_t set = 0; set < 2; ++set) {
        const auto& uvs = mesh.uvs[set];
        if (uvs.size() != mesh.positions.size()) continue;
        const glm::vec2 a = uvs[place.corners.x], b = uvs[place.corners.y],
                        c = uvs[place.corners.z];
        place.uv[set] = place.weights.x * a + place.weights.y * b + place.weights.z * c;
        const glm::vec2 d1 = b - a, d2 = c - a;
        const float share = std::abs(d1.x * d2.y - d1.y * d2.x) / std::max(facet, 1e-30f);
        place.width[set] = std::sqrt(std::max(area * share, 0.0f));
    }
    return place;
}

glm::vec4 FinishTable::look(const Place& place, TextureRole role) noexcept {
    const auto i = static_cast<std::size_t>(role);
    const TexturePyramid* const pyramid = place.part->pyramids[i];
    if (pyramid == nullptr) return glm::vec4(1.0f);
    const TextureMap& map = place.part->finish->maps[i];
    return pyramid->at(place.uv[map.uvSet], place.width[map.uvSet], map);
}

glm::vec4 FinishTable::baseColorAt(const Place& place) noexcept {
    const Finish& finish = *place.part->finish;
    glm::vec4 c = glm::vec4(finish.baseColor, finish.alpha) * look(place, TextureRole::baseColor);
    const auto& colors = place.part->mesh->colors;
    if (!colors.empty() && !finish.ignoresColors)
        c *= place.weights.x * colors[place.corners.x] + place.weights.y * colors[place.corners.y] +
             place.weights.z * colors[place.corners.z];
    if (finish.alphaMode == AlphaMode::opaque) c.w = 1.0f;
    if (finish.alphaMode == AlphaMode::mask) c.w = c.w >= finish.alphaCutoff ? 1.0f : 0.0f;
    return c;
}

float FinishTable::clearness(const RayHit& hit,
                             const transport::SurfaceHit& surface) const noexcept {
    const PartFinish& part = parts_[static_cast<std::size_t>(hit.surface)];
    if (part.finish->alphaMode == AlphaMode::opaque) return 0.0f;
    return 1.0f - baseColorAt(placeOf(hit, surface, 0.0f)).w;
}

Appearance FinishTable::at(const RayHit& hit, const transport::SurfaceHit& surface,
                           const transport::Facing& face, glm::vec3 d,
                           const transport::Footprint& at) const noexcept {
    const Place place = placeOf(hit, surface, glm::length(glm::cross(at.originX, at.originY)));
    const Finish& finish = *place.part->finish;
    const Mesh& mesh = *place.part->mesh;
    Appearance s{};
    const glm::vec4 base = baseColorAt(place);
    s.baseColor = glm::vec3(base);
    s.alpha = base.w;
    const glm::vec4 figures = look(place, TextureRole::metallicRoughness);
    s.metallic = finish.metallic * figures.z;
    s.roughness = finish.roughness * figures.y;
    s.emission = finish.emission * glm::vec3(look(place, TextureRole::emission));

    Frame3 frame;
    const glm::vec3 front = face.n * face.side;
    if (!mesh.tangents.empty()) {
        const glm::vec4 t0 = mesh.tangents[place.corners.x];
        const glm::vec4 t = place.weights.x * t0 +
                            place.weights.y * mesh.tangents[place.corners.y] +
                            place.weights.z * mesh.tangents[place.corners.z];
        frame = frameOf(front, glm::vec3(t), t0.w);
    } else {
        const auto& uvs = mesh.uvs[finish.map(TextureRole::normal).uvSet == 1 ? 1 : 0];
        if (uvs.size() != mesh.positions.size())
            frame = frameOf(front, anyTangent(front), 1.0f);
        else
            frame = frameAlongUv(front, surface.e1, surface.e2,
                                 uvs[place.corners.y] - uvs[place.corners.x],
                                 uvs[place.corners.z] - uvs[place.corners.x]);
    }
    const auto has = [&](TextureRole role) {
        return place.part->pyramids[static_cast<std::size_t>(role)] != nullptr;
    };
    glm::vec3 n = frame.n, coat = frame.n;
    if (has(TextureRole::normal))
        n = perturbed(frame, look(place, TextureRole::normal), finish.normalScale);
    if (has(TextureRole::clearcoatNormal))
        coat = perturbed(frame, look(place, TextureRole::clearcoatNormal),
                         finish.clearcoatNormalScale);
    s.n = turnedTo(n * face.side, -d);
    s.coatNormal = turnedTo(coat * face.side, -d);

    float strength = finish.anisotropy, turn = finish.anisotropyRotation;
    if (has(TextureRole::anisotropy)) {
        const glm::vec4 texel = look(place, TextureRole::anisotropy);
        strength *= texel.z;
        turn += std::atan2(2.0f * texel.y - 1.0f, 2.0f * texel.x - 1.0f);
    }
    const Frame3 turned = frameOf(
        s.n, strength > 0.0f ? std::cos(turn) * frame.t + std::sin(turn) * frame.b : frame.t, 1.0f);
    s.t = turned.t;
    s.b = turned.b;
    const float alpha = std::max(s.roughness * s.roughness, kLeastAlpha);
    s.a = glm::vec2(glm::mix(alpha, 1.0f, strength * strength), alpha);

    const float ratio = (finish.ior - 1.0f) / (finish.ior + 1.0f);
    const float weight = finish.specular * look(place, TextureRole::specular).w;
    s.F0 = glm::min(ratio * ratio * finish.specularColor *
                        glm::vec3(look(place, TextureRole::specularColor)),
                    glm::vec3(1.0f)) *
           weight;
    s.F90 = glm::vec3(weight);
    s.metalF0 = s.baseColor;
    const float film = finish.iridescence * look(place, TextureRole::iridescence).x;
    if (film > 0.0f) {
        const float c = glm::clamp(-glm::dot(d, s.n), 0.0f, 1.0f);
        const float thickness = glm::mix(finish.iridescenceThinnest, finish.iridescenceThickest,
                                         look(place, TextureRole::iridescenceThickness).y);
        s.F0 =
            glm::mix(s.F0, optics::filmAtNormal(c, finish.iridescenceIor, thickness, s.F0), film);
        s.metalF0 = glm::mix(
            s.metalF0, optics::filmAtNormal(c, finish.iridescenceIor, thickness, s.metalF0), film);
    }
    s.transmission = finish.transmission * look(place, TextureRole::transmission).x;
    s.coat = finish.clearcoat * look(place, TextureRole::clearcoat).x;
    s.coatRoughness = finish.clearcoatRoughness * look(place, TextureRole::clearcoatRoughness).y;
    s.sheen = finish.sheenColor * glm::vec3(look(place, TextureRole::sheenColor));
    s.sheenRoughness = finish.sheenRoughness * look(place, TextureRole::sheenRoughness).w;
    return s;
}

}  // namespace tukor::trace
