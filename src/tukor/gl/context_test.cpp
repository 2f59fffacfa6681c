#include "tukor/gl/context.h"

#include <GLES3/gl3.h>
#include <gmock/gmock.h>

#include "tukor/base/error.h"
#include "tukor/gl/full_viewport.h"
#include "tukor/gl/shaders.h"
#include "tukor/optics/fresnel.h"

namespace tukor::gl::shaders {
extern const ShaderSource testBrokenFrag;
extern const ShaderSource testCoordinatesFrag;
}  // namespace tukor::gl::shaders

namespace tukor::gl {
namespace {

using testing::HasSubstr;

template <class Body>
std::string messageOf(Body&& body) {
    try {
        body();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Context, GivesUnroundedFloatsOfEveryPixel) {
    const Context context;
    const Program program(shaders::fullViewportVert, shaders::testCoordinatesFrag,
                          "#define FROM_DEFINE 7.5\n");
    program.set("eta", 1.5f);
    const auto pixels = runFullViewport(program, 16, 5);
    ASSERT_EQ(pixels.size(), 80u);
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 16; ++column) {
            const glm::vec4 pixel = pixels[static_cast<std::size_t>(row * 16 + column)];
            const float x = static_cast<float>(column) + 0.5f;
            EXPECT_EQ(pixel.x, x);
            EXPECT_EQ(pixel.y, static_cast<float>(row) + 0.5f);
            EXPECT_NEAR(pixel.z, optics::fresnelDielectric(x / 16.0f, 1.5f), 1e-5f);
            EXPECT_EQ(pixel.w, 7.5f);
        }
    }
}

TEST(Context, BringsBackTheContextBeforeIt) {
    const Context outer;
    const Texture texture = Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    { const Context inner; }
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(bound, static_cast<GLint>(texture.id()));
}

TEST(Program, NamesFileAndLineOfAShaderError) {
    const Context context;
    const std::string message = messageOf(
        [] { const Program program(shaders::fullViewportVert, shaders::testBrokenFrag); });
    EXPECT_THAT(message, HasSubstr("tukor/gl/shaders/test_broken.frag:6"));
    EXPECT_THAT(message, HasSubstr("noSuchThing"));
}

TEST(Program, TranslatesTheLogFormsOfDrivers) {
    static const char* const files[] = {"a.frag", "b.h"};
    const ShaderSource source{"", files};
    EXPECT_EQ(namedLog("0:17(3): error: x\n1:2(4): error\n", source),
              "a.frag:17(3): error: x\nb.h:2(4): error");
    EXPECT_EQ(namedLog("ERROR: 1:5: 'q' : undeclared", source), "ERROR: b.h:5: 'q' : undeclared");
    EXPECT_EQ(namedLog("7:5: unknown file", source), "7:5: unknown file");
}

TEST(Errors, AreThrownByTheNextCheckOnce) {
    const Context context;
    glEnable(GL_TEXTURE_2D);  // not an ES 3 capability
    EXPECT_THAT(messageOf([] { throwPendingErrors("testing"); }),
                HasSubstr("OpenGL failed while testing: "));
    EXPECT_EQ(messageOf([] { throwPendingErrors("testing"); }), "no error");
}

}  // namespace
}  // namespace tukor::gl
