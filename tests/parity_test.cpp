// One grid of 1,048,576 inputs through the C++ and the GLSL build of the same files.
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "parity/cases.h"
#include "tukor/gl/context.h"
#include "tukor/gl/full_viewport.h"
#include "tukor/gl/handles.h"
#include "tukor/gl/shaders.h"

namespace tukor::gl::shaders {
extern const ShaderSource parityFrag;
}

namespace tukor::parity {
namespace {

constexpr int kSize = 1024;
constexpr std::array kNames = {"fresnelDielectric",
                               "fresnelConductor",
                               "fresnelSchlick",
                               "reflectanceAtNormal",
                               "facing",
                               "reflectDirection",
                               "refractDirection",
                               "transmittance",
                               "none",
                               "reinhard",
                               "aces",
                               "agx",
                               "neutral",
                               "srgbFromLinear",
                               "linearFromSrgb",
                               "indexAt",
                               "spectrumSample"};
static_assert(kNames.size() == kCases);

struct Inputs {
    std::vector<vec4> a, b, c;
};

/// Columns and rows are a grid of cosine and index, both crowded to the ends; the rest is random.
Inputs makeInputs() {
    Inputs in;
    std::mt19937 random(14092026);
    std::normal_distribution<float> gauss;
    std::uniform_real_distribution<float> uniform;
    const auto unit = [&] {
        const glm::dvec3 v(gauss(random), gauss(random), gauss(random));
        return vec3(v / std::max(glm::length(v), 1e-6));
    };
    for (int row = 0; row < kSize; ++row) {
        const float eta = std::exp2(-2.0f + 4.0f * static_cast<float>(row) / (kSize - 1));
        for (int column = 0; column < kSize; ++column) {
            const float x = static_cast<float>(column) / (kSize - 1);
            const float cosThetaI = x < 0.5f ? 2.0f * x * x : 1.0f - 2.0f * (1.0f - x) * (1.0f - x);
            const vec3 d = unit();
            const vec3 n = column % 16 == 0 ? (column % 32 == 0 ? d : -d) : unit();
            // From deep shadow to a sun; some extinctions exactly 0.
            const auto level = [&] {
                return uniform(random) < 0.05f ? 0.0f : std::exp2(-14.0f + 21.0f * uniform(random));
            };
            const float r = level(), g = level(), b = level();
            in.a.push_back(vec4(d, eta));
            in.b.push_back(vec4(n, cosThetaI));
            in.c.push_back(vec4(r, g, b, std::exp2(-6.0f + 8.0f * uniform(random))));
        }
    }
    return in;
}

/// How far the two languages may be apart: both round every operation, and the pow, exp and log of
/// GPUs differ in the last bits. Where the slope is infinite (the critical angle) an ulp of the
/// input is sqrt(ulp) of the result.
float tolerance(int which, vec4 a, vec4 b, float expected) {
    const float eta = a.w;
    float cosThetaI = b.w;
    float toCritical = 1.0f;
    if (which == kRefract) {
        const Interface face = facing(vec3(a), vec3(b), eta);
        cosThetaI = face.cosThetaI;
        toCritical = std::abs(scaledCos2ThetaT(cosThetaI, face.eta));
    } else if (which == kFresnelDielectric) {
        toCritical = std::abs(scaledCos2ThetaT(cosThetaI, eta));
    } else if (which == kFresnelConductor) {
        for (const float factor : {1.0f, 1.3f, 0.7f}) {
            toCritical = std::min(toCritical, std::abs(scaledCos2ThetaT(cosThetaI, factor * eta)));
        }
    }
    if (toCritical < 1e-3f) return 2e-3f;
    // AgX puts log2 through a polynomial whose terms reach 40 and cancel: 1e-6 of them, a fortieth
    // of an 8-bit step.
    if (which == kTonemap + kAgx) return 1e-4f;
    return 1e-5f * std::max(1.0f, std::abs(expected));
}

gl::Texture texture(int unit, const std::vector<vec4>& texels) {
    gl::Texture made = gl::Texture::make();
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, made.id());
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, kSize, kSize);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return made;
}

TEST(Parity, CppAndGlslAgreeOnAMillionInputs) {
    const Inputs in = makeInputs();
    const gl::Context context;
    const gl::Texture a = texture(0, in.a), b = texture(1, in.b), c = texture(2, in.c);
    const gl::Program program(gl::shaders::fullViewportVert, gl::shaders::parityFrag);
    program.set("inputA", 0);
    program.set("inputB", 1);
    program.set("inputC", 2);
    std::printf("%s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    for (int which = 0; which < kCases; ++which) {
        program.set("which", which);
        const std::vector<vec4> shader = gl::runFullViewport(program, kSize, kSize);
        ASSERT_EQ(shader.size(), in.a.size());
        std::size_t equalBits = 0;
        int failures = 0;
        float worst = 0.0f;
        for (std::size_t i = 0; i < shader.size(); ++i) {
            const vec4 expected = caseResult(which, in.a[i], in.b[i], in.c[i]);
            if (std::memcmp(&expected, &shader[i], sizeof expected) == 0) {
                ++equalBits;
                continue;
            }
            // Both may call the critical angle differently by an ulp; the direction is the same.
            const bool total = which == kRefract && (expected.w == 2.0f) != (shader[i].w == 2.0f);
            for (int channel = 0; channel < (total ? 3 : 4); ++channel) {
                const float difference = std::abs(shader[i][channel] - expected[channel]);
                const float allowed = tolerance(which, in.a[i], in.b[i], expected[channel]);
                if (allowed < 1e-3f) worst = std::max(worst, difference);
                if (difference <= allowed || ++failures > 10) continue;
                ADD_FAILURE() << kNames[static_cast<std::size_t>(which)] << " of d " << in.a[i].x
                              << ' ' << in.a[i].y << ' ' << in.a[i].z << " eta " << in.a[i].w
                              << " n " << in.b[i].x << ' ' << in.b[i].y << ' ' << in.b[i].z
                              << " cosThetaI " << in.b[i].w << " colour " << in.c[i].x << ' '
                              << in.c[i].y << ' ' << in.c[i].z << " distance " << in.c[i].w
                              << ": C++ " << expected[channel] << ", GLSL " << shader[i][channel];
            }
        }
        EXPECT_EQ(failures, 0) << kNames[static_cast<std::size_t>(which)];
        std::printf("%-20s %6.2f %% bit for bit, largest difference %.1e\n",
                    kNames[static_cast<std::size_t>(which)],
                    100.0 * static_cast<double>(equalBits) / static_cast<double>(shader.size()),
                    static_cast<double>(worst));
    }
}

}  // namespace
}  // namespace tukor::parity
