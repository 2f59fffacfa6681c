#include "tukor/base/number_text.h"

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tukor/base/test_folder.h"

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

TEST(NumberText, HasAPointWhereTheLocaleHasAComma) {
    const TestFolder folder;  // a German locale of its own, for few machines have one
    const std::string command = "localedef -i de_DE -f UTF-8 '" + folder.path("comma") + "'";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    ASSERT_EQ(setenv("LOCPATH", folder.path().c_str(), 1), 0);
    ASSERT_NE(std::setlocale(LC_NUMERIC, "comma"), nullptr);
    ASSERT_STREQ(std::localeconv()->decimal_point, ",");
    EXPECT_EQ(numberFromText("0.5"), 0.5);
    EXPECT_EQ(numberFromText("0,5"), std::nullopt);
    std::setlocale(LC_NUMERIC, "C");
    unsetenv("LOCPATH");
}

TEST(NumberText, FillsTheWholeText) {
    for (const char* text :
         {"", " 1", "1 ", "1,2", "0x10", "1e", "e5", "-", "+-1", ".", "infinity", "1f", "--1"})
        EXPECT_EQ(numberFromText(text), std::nullopt) << '"' << text << '"';
    EXPECT_EQ(numberFromText(std::string(1001, '1')), std::nullopt);
}

}  // namespace
}  // namespace tukor
