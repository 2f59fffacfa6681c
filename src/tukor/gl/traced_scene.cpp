#include "tukor/gl/traced_scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/gl/eye_media.h"
#include "tukor/scene/media.h"

namespace tukor::gl {

namespace {

void bindTexture(int unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

/// A table of texels that shaders read one by one.
Texture makeTable(GLenum internal, GLenum format, GLenum type, int width, std::size_t texels,
                  const void* data) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const std::size_t height = texels / static_cast<std::size_t>(width);
    if (height > static_cast<std::size_t>(largest))
        throw Error(fmt::format(
            "the model has too many triangles for this OpenGL driver, whose textures have at most "
            "{} rows; --renderer trace has no such limit",
            largest));
    Texture texture = Texture::make();
    bindTexture(0, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, internal, width, static_cast<GLsizei>(height));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, static_cast<GLsizei>(height), format, type,
                    data);
    return texture;
}

constexpr int kPartsPerRow = 256;  // as traced.frag has it

}  // namespace

TracedScene::TracedScene(const Scene& scene) {
    std::vector<const Mesh*> meshes;
    std::vector<Material> materials;
    for (const Part& part : scene.parts) {
        meshes.push_back(&part.mesh);
        materials.push_back(part.material);
        const Bounds bounds = boundsOf(part.mesh);
        Part outline{part.name, part.materialName, part.material, {}};
        outline.mesh.positions = {bounds.least, bounds.most};
        outline_.parts.push_back(std::move(outline));
    }
    bvh_ = buildBvh(meshes);
    nodes_ = makeTable(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, kBvhTextureWidth,
                       bvh_.nodes.size(), bvh_.nodes.data());
    triangles_ = makeTable(GL_RGBA32F, GL_RGBA, GL_FLOAT, kBvhTextureWidth, bvh_.triangles.size(),
                           bvh_.triangles.data());
    normals_ = makeTable(GL_RGBA32F, GL_RGBA, GL_FLOAT, kBvhTextureWidth, bvh_.normals.size(),
                         bvh_.normals.data());
    setMaterials(materials);
}

void TracedScene::setMaterials(const std::vector<Material>& materials) {
    const std::size_t parts = outline_.parts.size();
    for (std::size_t i = 0; i < parts; ++i) outline_.parts[i].material = materials[i];
    const MediaTable table = mediaOf(outline_);
    media_.clear();
    for (const DielectricMedium& medium : table.media)
        media_.emplace_back(medium.eta, medium.sigmaA);

    // Three texels a part: kind, media inside, media outside; tint or index; extinction. Floats as
    // their bits, which no sampler touches.
    const std::size_t rows = std::max<std::size_t>(1, (parts + kPartsPerRow - 1) / kPartsPerRow);
    std::vector<glm::uvec4> texels(rows * 3 * kPartsPerRow, glm::uvec4(0));
    const auto bits = [](glm::vec3 v) { return glm::uvec4(glm::floatBitsToUint(v), 0u); };
    insideOfPart_.assign(parts, 0u);
    for (std::size_t i = 0; i < parts; ++i) {
        const Material& material = materials[i];
        if (table.mediumOfPart[i] >= 0) insideOfPart_[i] = 1u << table.mediumOfPart[i];
        texels[3 * i] = {static_cast<std::uint32_t>(material.kind), insideOfPart_[i], 0u, 0u};
        texels[3 * i + 1] =
            bits(material.kind == MaterialKind::mirror ? material.tint : material.eta);
        texels[3 * i + 2] = bits(material.k);
    }
    surfaces_ = makeTable(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 3 * kPartsPerRow,
                          texels.size(), texels.data());
    eyeKnown_ = false;
}

void TracedScene::bind(const Program& program, int unit, glm::vec3 eye) {
    if (!eyeKnown_ || eye != eye_) {
        eye_ = eye;
        eyeMedia_ = mediaAround(eye, bvh_, insideOfPart_);
        eyeKnown_ = true;
    }
    bindTexture(unit, nodes_);
    bindTexture(unit + 1, triangles_);
    bindTexture(unit + 2, normals_);
    bindTexture(unit + 3, surfaces_);
    program.set("bvhNodes", unit);
    program.set("bvhTriangles", unit + 1);
    program.set("bvhNormals", unit + 2);
    program.set("surfaces", unit + 3);
    program.set("eyeMedia", eyeMedia_);
    program.set("media[0]", media_);
}

}  // namespace tukor::gl
