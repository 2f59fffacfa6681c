#version 300 es
// Which triangle a pixel shows.
flat in int triangle;
layout(location = 0) out int nearest;

void main() {
    nearest = triangle;
}
