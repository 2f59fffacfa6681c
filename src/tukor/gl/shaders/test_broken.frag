#version 300 es
// Does not compile: line 6 names what does not exist.
#include "tukor/optics/fresnel.h"
out vec4 fragmentColor;
void main() {
    fragmentColor = vec4(noSuchThing);
}
