// The environment as a fragment sees it: the mean of four look-ups spread over the pixel. The
// directions between pixels are extrapolated by screen-space derivatives; all read the finest level.
uniform samplerCube environment;
uniform vec2 footprintMiddle;  // of the four look-ups, in pixels from the fragment's centre

// Radians a pixel. Beyond it, at silhouettes, extrapolation says nothing about the neighbours.
const float kLargestStep = 0.5;

vec3 limitedStep(vec3 step) {
    return step * min(1.0, kLargestStep * inversesqrt(max(dot(step, step), 1e-12)));
}

// `d` needs no unit length. Derivatives: to be called by all fragments of a quad alike.
vec3 footprintRadiance(vec3 d) {
    vec3 right = limitedStep(dFdx(d));
    vec3 up = limitedStep(dFdy(d));
    vec3 middle = d + footprintMiddle.x * right + footprintMiddle.y * up;
    vec3 a = 0.25 * (right + up);
    vec3 b = 0.25 * (right - up);
    return 0.25 * (textureLod(environment, middle + a, 0.0).rgb + textureLod(environment, middle - a, 0.0).rgb +
                   textureLod(environment, middle + b, 0.0).rgb + textureLod(environment, middle - b, 0.0).rgb);
}
