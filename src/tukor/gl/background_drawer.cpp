#include "tukor/gl/background_drawer.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "tukor/gl/shaders.h"

namespace tukor::gl {

namespace {

void addQuadrangle(std::vector<glm::vec3>& triangles, glm::vec3 a, glm::vec3 b, glm::vec3 c,
                   glm::vec3 d) {
    triangles.insert(triangles.end(), {a, b, c, c, b, d});
}

std::vector<glm::vec3> boxTriangles() {
    std::vector<glm::vec3> triangles;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            const auto corner = [&](float s, float t) {
                glm::vec3 point(0.0f);
                point[axis] = side;
                point[(axis + 1) % 3] = s;
                point[(axis + 2) % 3] = t;
                return point;
            };
            addQuadrangle(triangles, corner(-1, -1), corner(1, -1), corner(-1, 1), corner(1, 1));
        }
    }
    return triangles;
}

std::vector<glm::vec3> domeTriangles() {
    constexpr int kRings = 16;
    constexpr int kSectors = 32;
    const auto point = [](int ring, int sector) {
        const float theta = std::numbers::pi_v<float> * static_cast<float>(ring) / kRings;
        const float phi =
            2.0f * std::numbers::pi_v<float> * static_cast<float>(sector % kSectors) / kSectors;
        // The poles exactly, so that their triangles close.
        const float radius = ring == 0 || ring == kRings ? 0.0f : std::sin(theta);
        return glm::vec3(radius * std::cos(phi), std::cos(theta), radius * std::sin(phi));
    };
    std::vector<glm::vec3> triangles;
    for (int ring = 0; ring < kRings; ++ring)
        for (int sector = 0; sector < kSectors; ++sector)
            addQuadrangle(triangles, point(ring, sector), point(ring, sector + 1),
                          point(ring + 1, sector), point(ring + 1, sector + 1));
    return triangles;
}

}  // namespace

BackgroundDrawer::Shell BackgroundDrawer::makeShell(Background background) {
    const std::vector<glm::vec3> triangles =
        background == Background::box ? boxTriangles() : domeTriangles();
    Shell shell{VertexArray::make(), Buffer::make(), static_cast<GLsizei>(triangles.size())};
    glBindVertexArray(shell.vertexArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, shell.vertices.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec3)),
                 triangles.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    glBindVertexArray(0);
    return shell;
}

void BackgroundDrawer::draw(Background background, const View& view,
                            const glm::mat3& environmentFromWorld, glm::vec2 footprintMiddle,
                            const EnvironmentTexture& environment) {
    if (background == Background::none) return;
    const bool quad = background == Background::quad;
    const auto key = std::pair(quad, environment.define());
    if (!programs_.contains(key))
        programs_.emplace(key,
                          Program(quad ? shaders::backgroundVert : shaders::backgroundShellVert,
                                  shaders::backgroundFrag, environment.define()));
    const Program& program = programs_.at(key);
    program.set("environment", 0);
    program.set("footprintMiddle", footprintMiddle);
    const glm::mat4 rayFromWorld(environmentFromWorld);
    if (quad) {
        program.set("rayDirMatrix", rayFromWorld * view.rayDirMatrix);
        glBindVertexArray(0);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        return;
    }
    Shell& shell = background == Background::box ? box_ : dome_;
    if (shell.count == 0) shell = makeShell(background);
    program.set("clipFromRay", glm::inverse(rayFromWorld * view.rayDirMatrix));
    glBindVertexArray(shell.vertexArray.id());
    glDrawArrays(GL_TRIANGLES, 0, shell.count);
}

void BackgroundDrawer::drawBehind(int frames, const View& view,
                                  const glm::mat3& environmentFromWorld, float level) {
    if (!behind_) behind_.emplace(shaders::backgroundVert, shaders::behindFrag);
    behind_->set("sum", 0);
    behind_->set("blurred", 1);
    behind_->set("frames", static_cast<float>(frames));
    behind_->set("level", level);
    behind_->set("rayDirMatrix", glm::mat4(environmentFromWorld) * view.rayDirMatrix);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace tukor::gl
