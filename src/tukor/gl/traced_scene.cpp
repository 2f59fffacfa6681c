#include "tukor/gl/traced_scene.h"

#include <algorithm>

#include "tukor/gl/eye_media.h"
#include "tukor/gl/table.h"
#include "tukor/scene/media.h"
#include "tukor/scene/spheres.h"

namespace tukor::gl {

namespace {

void bindTexture(int unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

constexpr std::size_t kPartsPerRow = 128;  // as traced.frag has it

}  // namespace

TracedScene::TracedScene(const Scene& scene) {
    const Mesh nothing;
    const std::vector<std::optional<Sphere>> spheres = spheresOf(scene);
    std::vector<const Mesh*> meshes;
    std::vector<Material> materials;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        meshes.push_back(spheres[i] ? &nothing : &part.mesh);
        if (spheres[i]) {
            spheres_.emplace_back(spheres[i]->centre, spheres[i]->radius);
            spheres_.emplace_back(static_cast<float>(i), 0.0f, 0.0f, 0.0f);
        }
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
    const bool finished = std::any_of(materials.begin(), materials.end(),
                                      [](const Material& m) { return m.finish != nullptr; });
    if (finished) finishes_.emplace(scene, bvh_);
    setMaterials(materials);
}

void TracedScene::setMaterials(const std::vector<Material>& materials) {
    const std::size_t parts = outline_.parts.size();
    for (std::size_t i = 0; i < parts; ++i) outline_.parts[i].material = materials[i];
    const MediaTable table = mediaOf(outline_);
    media_.clear();
    dispersions_.assign((table.media.size() + 3) / 4, glm::vec4(0.0f));
    for (std::size_t i = 0; i < table.media.size(); ++i) {
        media_.emplace_back(table.media[i].eta, table.media[i].sigmaA);
        dispersions_[i / 4][static_cast<int>(i % 4)] = table.media[i].dispersion;
    }

    // First of each part: kind, media inside, media outside; tint or index; extinction. Then its
    // finish. Floats as their bits, which no sampler touches.
    const std::size_t rows = std::max<std::size_t>(1, (parts + kPartsPerRow - 1) / kPartsPerRow);
    std::vector<glm::uvec4> texels(rows * kTexelsPerPart * kPartsPerRow, glm::uvec4(0));
    const auto bits = [](glm::vec3 v) { return glm::uvec4(glm::floatBitsToUint(v), 0u); };
    insideOfPart_.assign(parts, 0u);
    for (std::size_t i = 0; i < parts; ++i) {
        const Material& material = materials[i];
        if (table.mediumOfPart[i] >= 0) insideOfPart_[i] = 1u << table.mediumOfPart[i];
        const std::span own(&texels[kTexelsPerPart * i], kTexelsPerPart);
        own[0] = {static_cast<std::uint32_t>(material.kind), insideOfPart_[i], 0u, 0u};
        own[1] = bits(material.kind == MaterialKind::mirror ? material.tint : material.eta);
        own[2] = bits(material.k);
        if (finishes_) finishes_->describe(i, material, own);
    }
    surfaces_ =
        makeTable(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                  static_cast<int>(kTexelsPerPart * kPartsPerRow), texels.size(), texels.data());
    eyeKnown_ = false;
}

bool TracedScene::disperses() const noexcept {
    return std::any_of(dispersions_.begin(), dispersions_.end(),
                       [](glm::vec4 d) { return d != glm::vec4(0.0f); });
}

void TracedScene::drawTriangles(const Program& program) const {
    bindTexture(0, triangles_);
    program.set("bvhTriangles", 0);
    program.use();
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(bvh_.triangles.size()));
}

void TracedScene::bind(const Program& program, int unit, glm::vec3 eye) {
    if (!eyeKnown_ || eye != eye_) {
        eye_ = eye;
        eyeMedia_ = mediaAround(eye, bvh_, insideOfPart_);
        for (std::size_t i = 0; i < spheres_.size(); i += 2) {
            if (glm::distance(eye, glm::vec3(spheres_[i])) < spheres_[i].w)
                eyeMedia_ |= insideOfPart_[static_cast<std::size_t>(spheres_[i + 1].x)];
        }
        eyeKnown_ = true;
    }
    bindTexture(unit, nodes_);
    bindTexture(unit + 1, triangles_);
    bindTexture(unit + 2, normals_);
    bindTexture(unit + 3, surfaces_);
    if (finishes_) finishes_->bind(program, unit + 4);
    program.set("bvhNodes", unit);
    program.set("bvhTriangles", unit + 1);
    program.set("bvhNormals", unit + 2);
    program.set("surfaces", unit + 3);
    program.set("sphereCount", static_cast<int>(spheres_.size() / 2));
    program.set("spheres[0]", spheres_);
    program.set("eyeMedia", eyeMedia_);
    program.set("media[0]", media_);
    program.set("dispersions[0]", dispersions_);
}

}  // namespace tukor::gl
