#version 300 es
// A sky box or a sky dome: any surface around the eye shows the same picture, as a point of it is
// the direction to it.
layout(location = 0) in vec3 vertexPosition;  // from the eye, in the environment's axes
uniform mat4 clipFromRay;
out vec4 rayDir;

void main() {
    rayDir = vec4(vertexPosition, 1.0);
    vec4 clip = clipFromRay * vec4(vertexPosition, 1.0);
    gl_Position = vec4(clip.xy, 0.999 * clip.w, clip.w);
}
