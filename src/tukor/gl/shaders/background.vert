#version 300 es
// The full-viewport quad behind everything: lecture rows 17 to 19.
uniform mat4 rayDirMatrix;
out vec4 rayDir;

void main() {
    // A strip of four corners. What becomes of the homogeneous divide? w of rayDir depends on the
    // z of the corner alone: it is the same over the quad, and positive, so xyz is the direction.
    vec4 vertexPosition = vec4(float(gl_VertexID & 1) * 2.0 - 1.0, float(gl_VertexID & 2) - 1.0, 0.999, 1.0);
    rayDir = rayDirMatrix * vertexPosition;
    gl_Position = vec4(vertexPosition.xy, 0.999, 1.0);
}
