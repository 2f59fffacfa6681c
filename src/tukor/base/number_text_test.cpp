#include "tukor/base/number_text.h"

#include <cmath>
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

TEST(NumberText, FillsTheWholeText) {
    for (const char* text :
         {"", " 1", "1 ", "1,2", "0x10", "1e", "e5", "-", "+-1", ".", "infinity", "1f", "--1"})
        EXPECT_EQ(numberFromText(text), std::nullopt) << '"' << text << '"';
    EXPECT_EQ(numberFromText(std::string(1001, '1')), std::nullopt);
}

}  // namespace
}  // namespace tukor
