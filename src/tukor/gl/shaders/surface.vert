#version 300 es
// Surfaces of the scene, seen from the eye, in the axes of the environment: turned once a vertex
// rather than once a look-up.
layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec3 vertexNormal;
uniform mat4 clipFromWorld;
uniform mat3 environmentFromWorld;
uniform vec3 eye;
out vec3 fromEye;
out vec3 normal;

void main() {
    fromEye = environmentFromWorld * (vertexPosition - eye);
    normal = environmentFromWorld * vertexNormal;
    gl_Position = clipFromWorld * vec4(vertexPosition, 1.0);
}
