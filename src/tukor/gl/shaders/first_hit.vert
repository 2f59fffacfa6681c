#version 300 es
// The triangles of the tree, by the number of the vertex alone: corners are read from the tree's texture.
#include "tukor/geometry/bvh_fetch.h"

uniform mat4 clipFromWorld;
flat out int triangle;

void main() {
    triangle = gl_VertexID / 3;
    gl_Position = clipFromWorld * vec4(bvhTriangleTexel(gl_VertexID).xyz, 1.0);
}
