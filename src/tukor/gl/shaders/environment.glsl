// The environment as textures hold it, and as a fragment sees it: the mean of four look-ups spread
// over the pixel, their directions extrapolated by screen-space derivatives.
//
// PANORAMA: 1, an equirectangular picture looked up as it is; 0, a cube map, seamless.
#if PANORAMA == 1
uniform sampler2D environment;
#else
uniform samplerCube environment;
#endif
uniform vec2 footprintMiddle;  // of the four look-ups, in pixels from the fragment's centre

// `d`, of any length, in the environment's own axes.
vec3 environmentRadiance(vec3 d, float level) {
#if PANORAMA == 1
    // The centre is -Z, +X lies to the right of it, the first row is +Y. atan and not acos, which
    // drivers approximate badly near 1.
    vec2 place = vec2(0.5 + 0.15915494 * atan(d.x, -d.z), 0.31830989 * atan(length(vec2(d.x, d.z)), d.y));
    return textureLod(environment, place, level).rgb;
#else
    return textureLod(environment, d, level).rgb;
#endif
}

// Radians a pixel. Beyond it, at silhouettes, extrapolation says nothing about the neighbours.
const float kLargestStep = 0.1;

vec3 limitedStep(vec3 step) {
    return step * min(1.0, kLargestStep * inversesqrt(max(dot(step, step), 1e-12)));
}

// Derivatives: to be called by all fragments of a quad alike.
vec3 footprintRadiance(vec3 d) {
    vec3 right = limitedStep(dFdx(d));
    vec3 up = limitedStep(dFdy(d));
    vec3 middle = d + footprintMiddle.x * right + footprintMiddle.y * up;
    vec3 a = 0.25 * (right + up);
    vec3 b = 0.25 * (right - up);
    return 0.25 * (environmentRadiance(middle + a, 0.0) + environmentRadiance(middle - a, 0.0) +
                   environmentRadiance(middle + b, 0.0) + environmentRadiance(middle - b, 0.0));
}
