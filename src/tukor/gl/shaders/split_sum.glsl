// Light from all around, exactly filtered for each roughness, and the table of what a surface makes of it.
uniform samplerCube chain;  // perceptual roughness from 0 to 1 over its levels
uniform sampler2D table;    // columns: root of the cosine, rows: roughness
uniform float lastLevel;

// What a surface of this roughness sees around `d`; `sharp` is the environment there.
vec3 blurred(vec3 d, float roughness, vec3 sharp) {
    float level = clamp(roughness, 0.0, 1.0) * lastLevel;
    vec3 L = textureLod(chain, d, max(level, 1.0)).rgb;
    return level < 1.0 ? mix(sharp, L, level) : L;
}

vec3 split(float cosTheta, float roughness) {
    float nodes = float(textureSize(table, 0).x);
    vec2 node = clamp(vec2(sqrt(max(cosTheta, 0.0)), roughness), 0.0, 1.0);
    return textureLod(table, (node * (nodes - 1.0) + 0.5) / nodes, 0.0).rgb;
}
