#include "tukor/scene/json_document.h"

#include <string>

#include <gtest/gtest.h>

#include "tukor/base/error.h"

namespace tukor {
namespace {

JsonDocument parsed(std::string_view text) {
    return parseJson("a.json", std::as_bytes(std::span(text)));
}

std::string errorOf(std::string_view text) {
    try {
        (void)parsed(text);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(JsonDocument, HoldsWhatTheTextSays) {
    const JsonDocument json = parsed(
        "\xef\xbb\xbf {\"b\": [1, -2.5e-3, [], true], \"a\": \"x\", \"b2\": {\"c\": null}}\n");
    ASSERT_EQ(json.kind(0), JsonKind::object);
    ASSERT_EQ(json.size(0), 3u);
    EXPECT_STREQ(json.name(json.child(0, 0)), "a") << "in the order of names";
    const std::size_t list = json.find(0, "b").value();
    ASSERT_EQ(json.size(list), 4u);
    EXPECT_EQ(json.number(json.child(list, 1)), -2.5e-3);
    EXPECT_EQ(json.size(json.child(list, 2)), 0u);
    EXPECT_TRUE(json.truth(json.child(list, 3)));
    EXPECT_EQ(json.text(json.find(0, "a").value()), "x");
    EXPECT_EQ(json.kind(json.find(json.find(0, "b2").value(), "c").value()), JsonKind::null);
    EXPECT_FALSE(json.find(0, "c"));
}

TEST(JsonDocument, TakesTheLastOfMembersOfOneName) {
    const JsonDocument json = parsed(R"({"a": 1, "b": 5, "a": 2, "a": 3})");
    EXPECT_EQ(json.number(json.find(0, "a").value()), 3.0);
}

TEST(JsonDocument, ReadsEscapesAndUtf8) {
    const JsonDocument json = parsed(
        "\"\\\"\\\\\\/\\b\\f\\n\\r\\t \\u0041\\u00e9\\u20ac\\ud83d\\ude00 "
        "\xc3\xa9\xf0\x9f\x98\x80\"");
    EXPECT_EQ(json.text(0),
              "\"\\/\b\f\n\r\t A\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80 \xc3\xa9\xf0\x9f\x98\x80");
}

TEST(JsonDocument, RefusesWhatIsNotJson) {
    for (const char* text : {"",
                             " ",
                             "nul",
                             "tru",
                             "[1",
                             "[1,]",
                             "{\"a\"}",
                             "{\"a\":1,}",
                             "{a:1}",
                             "01",
                             "1.",
                             ".5",
                             "+1",
                             "1e",
                             "-",
                             "\"a",
                             "\"\\x\"",
                             "\"\\u12g4\"",
                             "\"\\ud800\"",
                             "\"\\udc00\"",
                             "\"\n\"",
                             "1 2",
                             "[1]]",
                             "NaN",
                             "\"\xff\"",
                             "\"\xc0\x80\"",
                             "\"\xed\xa0\x80\"",
                             "\"\xe2\x82\"",
                             "\"\xf4\x90\x80\x80\""})
        EXPECT_EQ(errorOf(text).rfind("a.json: not JSON: wrong at byte ", 0), 0u)
            << text << ": " << errorOf(text);
    EXPECT_EQ(errorOf("[1, 2"), "a.json: not JSON: wrong at byte 6 of 5");
    EXPECT_EQ(errorOf("-1e999"), "a.json: not JSON: a number is beyond all bounds");
}

}  // namespace
}  // namespace tukor
