#include "tukor/gl/finish_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tukor/base/parallel.h"
#include "tukor/gl/table.h"
#include "tukor/image/display.h"
#include "tukor/scene/finish.h"

namespace tukor::gl {

namespace {

constexpr int kManyLayers = 24;  // so many of 512 texels take 32 MB; more are smaller
constexpr TextureRole kDrawn[] = {TextureRole::baseColor, TextureRole::metallicRoughness,
                                  TextureRole::emission};

glm::vec4 texelOf(const Texels& texels, TextureRole role, int column, int row) {
    const std::uint8_t* const t =
        &texels.bytes[(static_cast<std::size_t>(row) * static_cast<std::size_t>(texels.width) +
                       static_cast<std::size_t>(column)) *
                      static_cast<std::size_t>(texels.channels)];
    const auto value = [&](int c) {
        return isSrgb(role) ? linearFromSrgb8()[t[c]] : static_cast<float>(t[c]) / 255.0f;
    };
    const float alpha = texels.channels == 4 ? static_cast<float>(t[3]) / 255.0f : 1.0f;
    return {value(0), value(1), value(2), alpha};
}

/// A square picture of means, in linear values.
std::vector<glm::vec4> resized(const Texels& texels, TextureRole role, int side) {
    std::vector<glm::vec4> means(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    const auto first = [&](int i, int size) {
        return static_cast<int>(static_cast<long>(i) * size / side);
    };
    parallelFor(0, side, 16, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < side; ++column) {
                const int top = first(row, texels.height), left = first(column, texels.width);
                const int bottom = std::max(first(row + 1, texels.height), top + 1);
                const int right = std::max(first(column + 1, texels.width), left + 1);
                glm::vec4 sum(0.0f);
                for (int y = top; y < bottom; ++y)
                    for (int x = left; x < right; ++x) sum += texelOf(texels, role, x, y);
                means[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                      static_cast<std::size_t>(column)] =
                    sum / static_cast<float>((bottom - top) * (right - left));
            }
    });
    return means;
}

glm::vec4 meanOf(const Finish& finish, TextureRole role) {
    return finish.has(role) ? resized(*finish.map(role).texels, role, 1)[0] : glm::vec4(1.0f);
}

bool lieAlike(const TextureMap& a, const TextureMap& b) {
    return a.uvSet == b.uvSet && a.imageFromUv == b.imageFromUv && a.wrapU == b.wrapU &&
           a.wrapV == b.wrapV;
}

bool hasUvs(const Mesh& mesh, int set) {
    return set >= 0 && set < 2 &&
           mesh.uvs[static_cast<std::size_t>(set)].size() == mesh.positions.size();
}

/// Of the colours' roots, which eight bits suffice for.
std::uint32_t packedRoots(glm::vec4 c) {
    const glm::vec4 roots(glm::sqrt(glm::clamp(glm::vec3(c), 0.0f, 1.0f)),
                          glm::clamp(c.w, 0.0f, 1.0f));
    const glm::uvec4 bytes(roots * 255.0f + 0.5f);
    return bytes.x | bytes.y << 8 | bytes.z << 16 | bytes.w << 24;
}

Texture makeDetails(const Scene& scene, const Bvh& bvh, const std::vector<int>& uvSets) {
    const std::size_t rows = (3 * bvh.sources.size() + kBvhTextureWidth - 1) / kBvhTextureWidth;
    std::vector<glm::uvec4> texels(rows * kBvhTextureWidth, glm::uvec4(0));
    for (std::size_t i = 0; i < bvh.sources.size(); ++i) {
        const BvhSource source = bvh.sources[i];
        const Mesh& mesh = scene.parts[source.part].mesh;
        const Material& material = scene.parts[source.part].material;
        if (!material.finish) continue;
        const glm::uvec3 corners = mesh.triangles[source.triangle];
        std::array<glm::uvec2, 3> uvs{};
        std::array<std::uint32_t, 3> colors{};
        for (int c = 0; c < 3; ++c) {
            const auto at = static_cast<std::size_t>(c);
            if (uvSets[source.part] >= 0)
                uvs[at] = glm::floatBitsToUint(
                    mesh.uvs[static_cast<std::size_t>(uvSets[source.part])][corners[c]]);
            colors[at] = packedRoots(mesh.colors.empty() ||
                                             (kFinishesByName && material.finish->ignoresColors)
                                         ? glm::vec4(1.0f)
                                         : mesh.colors[corners[c]]);
        }
        texels[3 * i] = {uvs[0], uvs[1]};
        texels[3 * i + 1] = {uvs[2], colors[0], colors[1]};
        texels[3 * i + 2] = {colors[2], 0u, 0u, 0u};
    }
    return makeTable(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, kBvhTextureWidth, texels.size(),
                     texels.data());
}

}  // namespace

FinishTables::FinishTables(const Scene& scene, const Bvh& bvh) {
    struct Layer {
        const Texels* texels;
        TextureRole role;
    };
    std::vector<Layer> layers;
    std::vector<int> uvSets;  // -1: none is used
    bool colored = false;
    for (const Part& part : scene.parts) {
        Pictures& own = pictures_.emplace_back();
        int& uvSet = uvSets.emplace_back(-1);
        if (!part.material.finish) continue;
        const Finish& finish = *part.material.finish;
        colored =
            colored || (!part.mesh.colors.empty() && !(kFinishesByName && finish.ignoresColors));
        own.transmission = meanOf(finish, TextureRole::transmission).x;
        const TextureMap* placed = nullptr;
        glm::vec4* const means[] = {&own.baseColor, &own.figures, &own.emission};
        for (std::uint32_t i = 0; i < 3; ++i) {
            const TextureRole role = kDrawn[i];
            const TextureMap& map = finish.map(role);
            if (!finish.has(role)) continue;
            if (!hasUvs(part.mesh, map.uvSet)) continue;  // factors count alone
            if (placed && !lieAlike(*placed, map)) {
                *means[i] = meanOf(finish, role);
                continue;
            }
            if (!placed) {
                placed = &map;
                uvSet = map.uvSet;
                own.imageFromUv = map.imageFromUv;
                own.bits = static_cast<std::uint32_t>(map.wrapU) |
                           static_cast<std::uint32_t>(map.wrapV) << 2 |
                           static_cast<std::uint32_t>(layers.size()) << 8;
            }
            own.bits |= 16u << i;
            layers.push_back({map.texels.get(), role});
        }
    }
    if (layers.empty() && !colored) return;

    const int side = layers.size() > kManyLayers ? 256 : 512;
    layers_ = Texture::make();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, layers_.id());
    int levels = 1;
    while (side >> levels) ++levels;
    const auto depth = static_cast<GLsizei>(std::max<std::size_t>(layers.size(), 1));
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, levels, GL_SRGB8_ALPHA8, side, side, depth);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(side) *
                                    static_cast<std::size_t>(side) * 4);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::vector<glm::vec4> means = resized(*layers[i].texels, layers[i].role, side);
        for (std::size_t j = 0; j < means.size(); ++j) {
            for (int c = 0; c < 3; ++c)
                bytes[4 * j + static_cast<std::size_t>(c)] = srgb8(means[j][c]);
            bytes[4 * j + 3] = static_cast<std::uint8_t>(means[j].w * 255.0f + 0.5f);
        }
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(i), side, side, 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, bytes.data());
    }
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    details_ = makeDetails(scene, bvh, uvSets);
}

void FinishTables::describe(std::size_t part, const Material& material,
                            std::span<glm::uvec4> texels) const {
    if (!material.finish) return;
    const Finish& finish = *material.finish;
    const Pictures& own = pictures_[part];
    constexpr std::uint32_t kFinished = 1, kMasked = 2, kBlended = 4, kUnlit = 8, kThin = 16;
    std::uint32_t& kind = texels[0].w;
    kind = kFinished;
    if (finish.alphaMode == AlphaMode::mask) kind |= kMasked;
    if (finish.alphaMode == AlphaMode::blend) kind |= kBlended;
    if (finish.unlit) kind |= kUnlit;
    if (material.kind != MaterialKind::dielectric) kind |= kThin;
    const auto bits = [](glm::vec4 v) { return glm::floatBitsToUint(v); };
    const float ratio = (finish.ior - 1.0f) / (finish.ior + 1.0f);
    texels[3] = bits(glm::vec4(finish.baseColor, finish.alpha) * own.baseColor);
    texels[4] = bits({finish.metallic * own.figures.z, finish.roughness * own.figures.y,
                      finish.specular, finish.transmission * own.transmission});
    texels[5] = bits({ratio * ratio * finish.specularColor, finish.alphaCutoff});
    texels[6] = bits({finish.emission * glm::vec3(own.emission), finish.clearcoat});
    texels[7] = bits({own.imageFromUv[0], own.imageFromUv[1]});
    texels[8] = bits({own.imageFromUv[2], 0.0f, finish.clearcoatRoughness});
    texels[8].z = own.bits;
}

void FinishTables::bind(const Program& program, int unit) const {
    if (details_.id() == 0) return;
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, details_.id());
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit + 1));
    glBindTexture(GL_TEXTURE_2D_ARRAY, layers_.id());
    program.set("details", unit);
    program.set("layers", unit + 1);
}

}  // namespace tukor::gl
