#include <gtest/gtest.h>

#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

using program::Function;
using program::SystemVariable;
using testing::one;

namespace {

std::string value(const std::string& text) {
    const std::string all = one("X" + text);
    return all.starts_with("X=") ? all.substr(2) : all;
}
std::string f(Function function) { return "f" + std::to_string(static_cast<int>(function)); }

}  // namespace

// rs274 (LinuxCNC 2.9): [2**3**2] is 64, [-2**2] is 4, [1+2 mod 3*2 eq 1 and 0 or 1] is 1.
TEST(Rs274Expression, OperatorsBindAsInLinuxCnc) {
    EXPECT_EQ(value("[2**3**2]"), "((2 ^ 3) ^ 2)");
    EXPECT_EQ(value("[-2**2]"), "(-2 ^ 2)");
    EXPECT_EQ(value("[1 + 2 mod 3*2 eq 1 and 0 or 1]"), "((((1 + ((2 mod 3) * 2)) == 1) and 0) or 1)");
    EXPECT_EQ(value("[1 lt 2 - 3 / 4]"), "(1 < (2 - (3 / 4)))");
    EXPECT_EQ(value("[1 xor 2 ne 3]"), "(1 xor (2 <> 3))");
}

TEST(Rs274Expression, Functions) {
    EXPECT_EQ(value("sin[30]"), f(Function::sin) + "(30)");
    EXPECT_EQ(value("atan[1]/[-#2]"), f(Function::atan2) + "(1,(neg #2))");
    EXPECT_EQ(value("fix[#1]"), f(Function::round_down) + "(#1)");
    EXPECT_EQ(value("[fup[1.5]+round[#1]]"),
              "(" + f(Function::round_up) + "(1.5r) + " + f(Function::round_away) + "(#1))");
    EXPECT_EQ(value("exists[#<a>]"), f(Function::is_variable) + "(\"A\")");
    EXPECT_EQ(value("exists[#5]"), "1");
}

TEST(Rs274Expression, Parameters) {
    EXPECT_EQ(value("#5"), "#5");
    EXPECT_EQ(value("##2"), "R[#2]");
    EXPECT_EQ(value("#[1+#2]"), "R[(1 + #2)]");
    EXPECT_EQ(value("-#<Long Name>"), "(neg LONGNAME)");
    EXPECT_EQ(value("+#1"), "#1");
    EXPECT_EQ(
        value("#<_ini[axis_x]max>"),
        "#<_INI[AXIS_X]MAX>#" + std::to_string(static_cast<int>(SystemVariable::ini_value)) + "[\"AXIS_X\",\"MAX\"]");
}

TEST(Rs274Expression, ErrorsStandWhereTheyAre) {
    EXPECT_EQ(value("[1,2]"), "1:4 expected ] or an operator, found ','");
    EXPECT_EQ(value("[1+]"), "1:5 expected a value, found ']'");
    EXPECT_EQ(value("sin 90"), "1:2 the name of a function is not followed by [");
    EXPECT_EQ(value("atan[1]"), "1:9 expected / behind the first argument of ATAN, found end of block");
    EXPECT_EQ(value("#5602"), "1:2 there is no parameter #5602");
    EXPECT_EQ(value("#-1"), "1:2 there is no parameter #-1");
    EXPECT_EQ(value("#2.5"), "1:2 the number of a parameter is a whole one");
    EXPECT_EQ(value("#<a"), "1:3 the name is not closed");
    EXPECT_EQ(value(""), "1:1 X has no value");
    EXPECT_EQ(value("."), "1:2 a point is no number");
    EXPECT_EQ(one("#1 5"), "1:5 expected = behind the parameter, found end of block");
}

TEST(Rs274Expression, NeitherDepthNorLengthIsUnbounded) {
    EXPECT_EQ(value(std::string(200, '[')).substr(0, 6), "1:103 ");
    EXPECT_EQ(value(std::string(200, '-') + "1").substr(2, 100), "103 the expression is nested too deep");
    EXPECT_NE(value(std::string(300, '1')).find("this line is"), std::string::npos);
}

}  // namespace obrys::read::rs274
