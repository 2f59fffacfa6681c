// BC6H blocks decoded by the OpenGL driver and by us: the same floats, bit for bit.
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "tukor/gl/context.h"
#include "tukor/gl/full_viewport.h"
#include "tukor/gl/shaders.h"
#include "tukor/image/bc6h.h"

namespace tukor::gl::shaders {
extern const ShaderSource texelsFrag;
}  // namespace tukor::gl::shaders

namespace tukor {
namespace {

// EXT_texture_compression_bptc
constexpr GLenum kUnsignedFloat = 0x8e8f;
constexpr GLenum kSignedFloat = 0x8e8e;
constexpr int kEdge = 128;  // blocks along an edge: 512 of each of the 32 lowest five bits

/// Random blocks, of all modes and the reserved ones in turn.
std::vector<std::byte> randomBlocks() {
    std::vector<std::byte> blocks(std::size_t{kEdge} * kEdge * kBc6hBytes);
    std::mt19937 random(17);
    for (std::byte& byte : blocks) byte = static_cast<std::byte>(random() & 255u);
    for (std::size_t i = 0; i < blocks.size() / kBc6hBytes; ++i) {
        std::byte& low = blocks[i * kBc6hBytes];
        low = (low & std::byte{0xe0}) | static_cast<std::byte>(i & 31);
    }
    return blocks;
}

std::vector<glm::vec4> byTheDriver(const std::vector<std::byte>& blocks, GLenum format) {
    const gl::Texture texture = gl::Texture::make();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, 4 * kEdge, 4 * kEdge, 0,
                           static_cast<GLsizei>(blocks.size()), blocks.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    const gl::Program program(gl::shaders::fullViewportVert, gl::shaders::texelsFrag);
    program.set("texels", 0);
    return gl::runFullViewport(program, 4 * kEdge, 4 * kEdge);
}

std::uint32_t bitsOf(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

void expectTheSame(GLenum format, Bc6hSign sign) {
    const gl::Context context;
    const char* extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    ASSERT_NE(std::strstr(extensions, "GL_EXT_texture_compression_bptc"), nullptr)
        << "nothing to compare with; Mesa's software has it";
    const std::vector<std::byte> blocks = randomBlocks();
    const std::vector<glm::vec4> theirs = byTheDriver(blocks, format);
    Image ours(4 * kEdge, 4 * kEdge);
    decodeBc6h(blocks, sign, ours);
    int different = 0;
    for (std::size_t i = 0; i < theirs.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (bitsOf(theirs[i][c]) != bitsOf(ours.pixels()[i][c]) && ++different <= 10) {
                const std::size_t block = i / (16 * kEdge) * kEdge + i % (4 * kEdge) / 4;
                ADD_FAILURE() << "texel " << i << " channel " << c << " of low bits "
                              << (block & 31) << ": " << theirs[i][c] << ", ours "
                              << ours.pixels()[i][c];
            }
    EXPECT_EQ(different, 0);
}

TEST(Bc6hDriver, DecodesEveryUnsignedModeAsWeDo) {
    expectTheSame(kUnsignedFloat, Bc6hSign::none);
}

TEST(Bc6hDriver, DecodesEverySignedModeAsWeDo) {
    expectTheSame(kSignedFloat, Bc6hSign::one);
}

}  // namespace
}  // namespace tukor
