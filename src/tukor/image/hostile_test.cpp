// Files that mean harm, through loadImage: one error, within a second and 200 MB.
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "tukor/base/error.h"
#include "tukor/base/file.h"
#include "tukor/image/image_file.h"
#include "tukor/image/texture_file.h"

namespace tukor {
namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMeasured = false;  // the sanitizers' own time and memory would be measured
#else
constexpr bool kMeasured = true;
#endif

/// Ends the process: status 0 with the message on stderr, 3 when it took too much.
[[noreturn]] void loadAndExit(const fs::path& path) {
    try {
        if (path.filename().string().ends_with("_texture"))
            (void)loadTexture(path);
        else
            (void)loadImage(path);
        std::fprintf(stderr, "it was read");
    } catch (const Error& error) {
        std::fprintf(stderr, "%s", error.what());
    }
    if (path.filename().string().starts_with("hostile_")) fs::remove(path);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double seconds =
        static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
        1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    const long megabytes = usage.ru_maxrss / 1024;
    if (kMeasured && (seconds > 1.0 || megabytes > 200)) {
        std::fprintf(stderr, " after %g s and %ld MB", seconds, megabytes);
        std::_Exit(3);
    }
    std::_Exit(0);
}

class HostileImageDeathTest : public testing::Test {
protected:
    HostileImageDeathTest() : path_(testing::TempDir() + "hostile_" + std::to_string(getpid())) {
        GTEST_FLAG_SET(death_test_style, "threadsafe");  // the child starts with no threads
    }
    ~HostileImageDeathTest() override { fs::remove(path_); }

    void expect(const std::vector<std::byte>& bytes, const std::string& message) {
        writeFile(path_, bytes);
        EXPECT_EXIT(loadAndExit(path_), testing::ExitedWithCode(0), message);
    }
    void expect(const std::string& text, const std::string& message) {
        const auto bytes = std::as_bytes(std::span(text));
        expect(std::vector<std::byte>(bytes.begin(), bytes.end()), message);
    }

    fs::path path_;
};

std::vector<std::byte> sample(const std::string& extension) {
    Image image(64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) image.at(x, y) = glm::vec3(float(x * y % 17) / 16.0f);
    return encodeImage(image, extension);
}

void patch(std::vector<std::byte>& bytes, std::size_t at, std::vector<int> values) {
    for (int value : values) bytes.at(at++) = static_cast<std::byte>(value);
}

std::size_t find(const std::vector<std::byte>& bytes, std::string_view what) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.find(what);
}

TEST_F(HostileImageDeathTest, WrongKindsOfFiles) {
    EXPECT_EXIT(loadAndExit("/nowhere/a.exr"), testing::ExitedWithCode(0),
                "/nowhere/a.exr: no such file");
    EXPECT_EXIT(loadAndExit("/tmp"), testing::ExitedWithCode(0), "/tmp: is a folder");
    expect("", "hostile_.*: is empty; expected an OpenEXR, Radiance");
    expect("GIF89a\x01\x02", "starts with `GIF89a.x01.x02`, no format known here; expected");
}

TEST_F(HostileImageDeathTest, TruncatedFiles) {
    for (const char* extension : {".exr", ".hdr", ".png", ".jpg"}) {
        const auto whole = sample(extension);
        for (std::size_t part : {4u, 10u, 50u, 90u}) {
            auto cut = whole;
            cut.resize(whole.size() * part / 100);
            expect(cut, "hostile_[0-9]+: (damaged|cut off|the Radiance header|no resolution)");
        }
    }
}

TEST_F(HostileImageDeathTest, CorruptFiles) {
    for (const char* extension : {".exr", ".hdr", ".png", ".jpg"}) {
        auto bytes = sample(extension);
        unsigned state = 7;
        for (std::size_t i = bytes.size() / 3; i < bytes.size(); i += 13) {
            state = state * 1664525u + 1013904223u;
            bytes[i] = static_cast<std::byte>(state >> 24);
        }
        // A Radiance file has no redundancy: some damage is just another picture.
        expect(bytes, "hostile_[0-9]+: (damaged|cut off)|it was read");
    }
}

TEST_F(HostileImageDeathTest, HeadersOfTwoToThe31) {
    auto exr = sample(".exr");
    const std::size_t box = find(exr, "dataWindow") + 11 + 6 + 4;
    patch(exr, box + 8, {0xfe, 0xff, 0xff, 0x7f, 0xfe, 0xff, 0xff, 0x7f});
    expect(exr, "hostile_[0-9]+: damaged OpenEXR file");

    auto png = sample(".png");
    patch(png, 16, {0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff});
    expect(png, "hostile_[0-9]+: ");

    auto jpg = sample(".jpg");
    patch(jpg, find(jpg, "\xff\xc0") + 5, {0xff, 0xff, 0xff, 0xff});
    expect(jpg, "hostile_[0-9]+: damaged JPEG file: Maximum supported image dimension is 65500");

    expect("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2147483647 +X 2147483647\n",
           "2147483647 x 2147483647 pixels; at most 268435456");
}

TEST_F(HostileImageDeathTest, HeadersOfAllowedSizesWithNothingBehindThem) {
    auto exr = sample(".exr");
    for (const char* window : {"dataWindow", "displayWindow"})
        patch(exr, find(exr, window) + std::strlen(window) + 1 + 6 + 4 + 8,
              {0xff, 0x3f, 0, 0, 0xff, 0x3f, 0, 0});
    expect(exr, "hostile_[0-9]+: (damaged|16384 x 16384 pixels cannot be in)");

    auto png = sample(".png");
    patch(png, 16, {0, 0, 0x40, 0, 0, 0, 0x40, 0});
    expect(png, "hostile_[0-9]+: ");

    auto jpg = sample(".jpg");
    patch(jpg, find(jpg, "\xff\xc0") + 5, {0x40, 0, 0x40, 0});
    expect(jpg, "16384 x 16384 pixels cannot be in [0-9]+ bytes; the file is damaged");

    expect("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n\x02\x02",
           "damaged or cut off in scanline 1 of 16384");
}

TEST_F(HostileImageDeathTest, ATinyDataWindowInAHugeDisplayWindow) {
    auto exr = sample(".exr");
    patch(exr, find(exr, "displayWindow") + 14 + 6 + 4 + 8, {0xff, 0x3f, 0, 0, 0xff, 0x3f, 0, 0});
    expect(exr, "16384 x 16384 pixels cannot be in");
}

TEST_F(HostileImageDeathTest, SparseFilesOfTwoGigabytes) {
    for (const char* extension : {".exr", ".hdr", ".png", ".jpg"}) {
        auto bytes = sample(extension);
        bytes.resize(bytes.size() / 2);
        writeFile(path_, bytes);
        fs::resize_file(path_, kMaxFileBytes);
        EXPECT_EXIT(loadAndExit(path_), testing::ExitedWithCode(0), "");
    }
    fs::resize_file(path_, kMaxFileBytes + 1);
    EXPECT_EXIT(loadAndExit(path_), testing::ExitedWithCode(0),
                "2147483649 bytes; the largest file accepted is 2147483648 bytes");
}

class HostileTextureDeathTest : public HostileImageDeathTest {
protected:
    HostileTextureDeathTest() { path_ += "_texture"; }
};

TEST_F(HostileTextureDeathTest, HeadersCorruptionAndSparseFiles) {
    TextureFile texture{64, 64, 6, 1, std::vector<Image>(6, Image(64, 64))};
    struct Case {
        const char* extension;
        std::size_t width;  // where it is
        std::size_t height;
    };
    const Case cases[] = {{".dds", 16, 12}, {".ktx", 36, 40}, {".ktx2", 20, 24}};
    for (int i = 0; i < 6; ++i) {
        const Case& c = cases[i / 2];
        const auto texels = i % 2 == 0 ? TexelFormat::rgba16f : TexelFormat::bc6h;
        const auto whole = encodeTexture(texture, c.extension, {.texels = texels});
        auto cut = whole;
        cut.resize(whole.size() - 1);
        expect(cut, "hostile_.*: cut off: the file ends after");
        for (int highest : {0x7f, 0}) {  // 2^31 - 1, and 4096, which would be allowed
            auto bytes = whole;
            const int low = highest == 0 ? 0 : 0xff;
            const int middle = highest == 0 ? 0x10 : 0xff;
            patch(bytes, c.width, {low, middle, low, highest});
            patch(bytes, c.height, {low, middle, low, highest});
            expect(bytes, "hostile_.*: (cut off|damaged|.* pixels are accepted)");
        }
        writeFile(path_, cut);
        fs::resize_file(path_, kMaxFileBytes);
        EXPECT_EXIT(loadAndExit(path_), testing::ExitedWithCode(0), "it was read");
    }
}

}  // namespace
}  // namespace tukor
