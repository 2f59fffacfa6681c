#include "tukor/base/number_text.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace tukor {
namespace {

TEST(NumberText, IsTheNearestDouble) {
    EXPECT_EQ(numberFromText("0.1"), 0.1);
    EXPECT_EQ(numberFromText("-12.5e-3"), -12.5e-3);
    EXPECT_EQ(numberFromText("+.5"), 0.5);
    EXPECT_EQ(numberFromText("5."), 5.0);
    EXPECT_EQ(numberFromText("1.7976931348623157E308"), 1.7976931348623157e308);
    EXPECT_TRUE(std::isinf(numberFromText("1e999").value()));
    EXPECT_TRUE(std::isinf(numberFromText("-inf").value()));
    EXPECT_TRUE(std::isnan(numberFromText("nan").value()));
}

TEST(NumberText, IsInfiniteOrZeroBeyondTheDoubles) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::string zeros(400, '0');
    EXPECT_EQ(numberFromText("-1.5E+999"), -infinity);
    EXPECT_EQ(numberFromText("1" + zeros), infinity);
    EXPECT_EQ(numberFromText("0.1e" + zeros + "99999999999"), infinity);
    EXPECT_EQ(numberFromText("+1e-999"), 0.0);
    EXPECT_EQ(numberFromText("." + zeros + "1"), 0.0);
    EXPECT_EQ(numberFromText("123e-99999999999"), 0.0);
    EXPECT_EQ(numberFromText("." + zeros + "1e401"), 1.0);
    EXPECT_EQ(numberFromText("5e-324"), std::numeric_limits<double>::denorm_min());
    EXPECT_TRUE(std::signbit(numberFromText("-0").value()));
}

TEST(NumberText, HasAPointInEveryLocale) {
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    bool found = false;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "hu_HU.UTF-8"})
        found = found || std::setlocale(LC_NUMERIC, name) != nullptr;
    if (!found) GTEST_SKIP() << "no locale with a decimal comma is installed";
    EXPECT_EQ(numberFromText("0.5"), 0.5);
    EXPECT_EQ(numberFromText("0,5"), std::nullopt);
    std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(NumberText, FillsTheWholeText) {
    for (const char* text :
         {"", " 1", "1 ", "1,2", "0x10", "1e", "e5", "-", "+-1", ".", "infinity", "1f", "--1"})
        EXPECT_EQ(numberFromText(text), std::nullopt) << '"' << text << '"';
    EXPECT_EQ(numberFromText(std::string(1001, '1')), std::nullopt);
}

}  // namespace
}  // namespace tukor
