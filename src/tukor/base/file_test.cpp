#include "tukor/base/file.h"

#include <cstdio>
#include <cstring>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tukor/base/error.h"
#include "tukor/base/test_folder.h"

namespace tukor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class FileTest : public testing::Test {
protected:
    [[nodiscard]] fs::path in(const char* name) const { return folder_.path(name); }
    [[nodiscard]] static std::string text(const fs::path& path) {
        const auto bytes = readFile(path);
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    [[nodiscard]] int entries() const {
        int count = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_.path())) ++count;
        return count;
    }

private:
    TestFolder folder_;
};

TEST_F(FileTest, ReadsBackWhatItWrote) {
    writeFile(in("a"), "one");
    writeFile(in("a"), "two");
    EXPECT_EQ(text(in("a")), "two");
    const MappedFile mapped(in("a"));
    ASSERT_EQ(mapped.bytes().size(), 3u);
    EXPECT_EQ(std::memcmp(mapped.bytes().data(), "two", 3), 0);
    EXPECT_EQ(entries(), 1);  // nothing partial is left
}

TEST_F(FileTest, AnEmptyFileIsEmpty) {
    writeFile(in("empty"), "");
    EXPECT_TRUE(readFile(in("empty")).empty());
    EXPECT_TRUE(MappedFile(in("empty")).bytes().empty());
}

TEST_F(FileTest, NamesWhatCannotBeRead) {
    EXPECT_THAT([&] { (void)readFile(in("none")); },
                ThrowsMessage<Error>(HasSubstr("none: no such file")));
    EXPECT_THAT([&] { (void)MappedFile(in("none")); },
                ThrowsMessage<Error>(HasSubstr("none: no such file")));
    EXPECT_THAT([&] { (void)readFile(in(".")); }, ThrowsMessage<Error>(HasSubstr("is a folder")));
    EXPECT_THAT([&] { (void)readFile("/dev/zero"); },
                ThrowsMessage<Error>(HasSubstr("/dev/zero: not a regular file")));
    writeFile(in("four"), "four");
    EXPECT_THAT(
        [&] { (void)readFile(in("four"), 3); },
        ThrowsMessage<Error>(HasSubstr("four: 4 bytes; the largest file accepted is 3 bytes")));
}

TEST_F(FileTest, MapsASparseFileOfTwoGigabytesWithoutReadingIt) {
    writeFile(in("sparse"), "x");
    fs::resize_file(in("sparse"), kMaxFileBytes);
    const MappedFile mapped(in("sparse"));
    EXPECT_EQ(mapped.bytes().size(), kMaxFileBytes);
    EXPECT_EQ(mapped.bytes().back(), std::byte{0});
}

TEST_F(FileTest, NamesWhatCannotBeWritten) {
    EXPECT_THAT([&] { writeFile(in("no/where"), "x"); },
                ThrowsMessage<Error>(HasSubstr("where: cannot be written: there is no folder")));
    EXPECT_THAT([&] { writeFile(in("."), "x"); },
                ThrowsMessage<Error>(HasSubstr("it is a folder")));
    EXPECT_EQ(entries(), 0);
}

TEST_F(FileTest, KnowsBeforehandWhatCannotBeWritten) {
    EXPECT_THAT([&] { requireWritable(in("no/where")); },
                ThrowsMessage<Error>(HasSubstr("where: there is no folder")));
    EXPECT_THAT([&] { requireWritable(in(".")); }, ThrowsMessage<Error>(HasSubstr("is a folder")));
    requireWritable(in("new"));
    requireWritable("/dev/null");
    EXPECT_EQ(entries(), 0);
}

TEST_F(FileTest, FollowsLinksAndWritesDevicesInPlace) {
    writeFile(in("target"), "old");
    fs::create_symlink(in("target"), in("link"));
    writeFile(in("link"), "new");
    EXPECT_TRUE(fs::is_symlink(in("link")));
    EXPECT_EQ(text(in("target")), "new");
    writeFile("/dev/null", "x");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(FileTest, ExtensionsAreInLowerCase) {
    EXPECT_EQ(lowerExtension("a/b.EXR"), ".exr");
    EXPECT_EQ(lowerExtension("a.b/c"), "");
}

}  // namespace
}  // namespace tukor
