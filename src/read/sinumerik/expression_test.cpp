#include <gtest/gtest.h>

#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

namespace {

using testing::one;

/// The right side of `R1=…` as a tree.
std::string value(const std::string& text) {
    const std::string tree = one("R1=" + text);
    return tree.starts_with("R1=") ? tree.substr(3) : tree;
}

}  // namespace

TEST(SinumerikExpression, PriorityFollowsTheManual) {
    EXPECT_EQ(value("1+2*3-4/5"), "((1 + (2 * 3)) - (4 / 5))");
    EXPECT_EQ(value("R2 DIV 3 MOD 2 * 4"), "(((R2 div 3) mod 2) * 4)");
    EXPECT_EQ(value("R2 B_OR R3 B_XOR R4 B_AND R5+1"), "(R2 bor (R3 bxor (R4 band (R5 + 1))))");
    EXPECT_EQ(value("R2 OR R3 XOR R4 AND R5 B_OR R6"), "(R2 or (R3 xor (R4 and (R5 bor R6))))");
    // Comparisons bind loosest of all, looser than << and AND: parentheses are needed around them.
    EXPECT_EQ(value("R2==R3 AND R4"), "(R2 == (R3 and R4))");
    EXPECT_EQ(value("\"A\"<<R2+1 == \"B\""), "((\"A\" << (R2 + 1)) == \"B\")");
    EXPECT_EQ(value("NOT R2 AND B_NOT R3"), "((not R2) and (bnot R3))");
}

TEST(SinumerikExpression, EqualPriorityGoesFromLeftToRight) {
    EXPECT_EQ(value("10-4-3"), "((10 - 4) - 3)");
    EXPECT_EQ(value("100/10/2"), "((100 / 10) / 2)");
    EXPECT_EQ(value("1<2<3"), "((1 < 2) < 3)");
}

TEST(SinumerikExpression, ComparisonSigns) {
    EXPECT_EQ(value("R2<>R3"), "(R2 <> R3)");
    EXPECT_EQ(value("R2<=R3"), "(R2 <= R3)");
    EXPECT_EQ(value("R2>=R3"), "(R2 >= R3)");
    EXPECT_EQ(value("R2>R3"), "(R2 > R3)");
}

TEST(SinumerikExpression, SignsAndNumbers) {
    EXPECT_EQ(value("-5"), "-5");
    EXPECT_EQ(value("- -5"), "5");
    EXPECT_EQ(value("-R2*3"), "((neg R2) * 3)");
    EXPECT_EQ(value("2--3"), "(2 - -3)");
    EXPECT_EQ(value(".5+5."), "(0.5r + 5r)");
    EXPECT_EQ(value("1.5EX-3"), "0.0015r");
    EXPECT_EQ(value("-.50EX2"), "-50r");
    EXPECT_EQ(value("2ex+3"), "2000r");
    EXPECT_EQ(value("'H1F'+'B101'"), "(31 + 5)");
    EXPECT_EQ(value("'A'"), "\"A\"");
    EXPECT_EQ(value("TRUE"), "TRUE");
}

TEST(SinumerikExpression, Variables) {
    EXPECT_EQ(value("R[R2+1]"), "R[(R2 + 1)]");
    EXPECT_EQ(value("$R[5]+$R6"), "($R#1[5] + R6)");
    EXPECT_EQ(value("arr[1,2,R3]"), "ARR[1,2,R3]");
    EXPECT_EQ(value("ARR[1][2]"), "ARR[1,2]");
    EXPECT_EQ(value("$AA_IM[X]"),
              "$AA_IM#" + std::to_string(static_cast<int>(program::SystemVariable::machine_position)) + "[X]");
    EXPECT_EQ(value("$TC_DP12[1,2]"),
              "$TC_DP12#" + std::to_string(static_cast<int>(program::SystemVariable::tool_parameter)) + "[1,2]");
    EXPECT_EQ(value("$NOT_KNOWN[1]"), "$NOT_KNOWN#0[1]");
    EXPECT_EQ(value("R_BOTTOM"), "R_BOTTOM");
}

TEST(SinumerikExpression, Functions) {
    EXPECT_EQ(value("SIN(30)"), "f0(30)");
    EXPECT_EQ(value("ATAN2(R2,-3)"), "f5(R2,-3)");
    EXPECT_EQ(value("MINE(1,,\"a\")"), "MINE(1,_,\"a\")");
    EXPECT_EQ(value("TRUNC(R2/(3+4))"), "f9((R2 / (3 + 4)))");
    EXPECT_EQ(value("<<R2<<\"mm\""), "((\"\" << R2) << \"mm\")");
}

TEST(SinumerikExpression, FramesAreChained) {
    EXPECT_EQ(one("$P_UIFR[1]=CTRANS(X,-37.8,Y,25):CROT(Z,45)"), "$P_UIFR#17[1]=(f31(X,-37.8r,Y,25) : f32(Z,45))");
}

TEST(SinumerikExpression, NestingAndLengthAreLimited) {
    const std::string open(150, '('), close(150, ')');
    EXPECT_EQ(value(open + "1" + close), "1");
    const std::string deep(201, '(');
    EXPECT_NE(value(deep + "1" + std::string(201, ')')).find("nested more than 200 deep"), std::string::npos);
    EXPECT_NE(value(std::string(5000, '-') + "1").find("nested more than 200 deep"), std::string::npos);
    std::string sum = "1";
    for (int i = 0; i < 1000; ++i) sum += "+1";
    EXPECT_EQ(value(sum).find("error"), std::string::npos);
    std::string nested = "1";
    for (int i = 0; i < 150; ++i) nested = "(" + nested + "+1+1+1+1+1+1+1+1+1+1)";
    EXPECT_NE(value(nested).find("more than 1000 operators"), std::string::npos);
    EXPECT_NE(value(sum + "+1").find("more than 1000 operators"), std::string::npos);
}

}  // namespace obrys::read::sinumerik
