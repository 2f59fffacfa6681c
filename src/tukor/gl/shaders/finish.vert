#version 300 es
// Surfaces with a finish: as surface.vert, with what textures need.
layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec3 vertexNormal;
layout(location = 2) in vec4 vertexUv;  // two sets
layout(location = 3) in vec4 vertexTangent;
layout(location = 4) in vec4 vertexColor;
uniform mat4 clipFromWorld;
uniform mat3 environmentFromWorld;
uniform vec3 eye;
out vec3 fromEye;
out vec3 normal;
out vec4 uv;
out vec4 tangent;
out vec4 color;

void main() {
    fromEye = environmentFromWorld * (vertexPosition - eye);
    normal = environmentFromWorld * vertexNormal;
    uv = vertexUv;
    tangent = vec4(environmentFromWorld * vertexTangent.xyz, vertexTangent.w);
    color = vertexColor;
    gl_Position = clipFromWorld * vec4(vertexPosition, 1.0);
}
