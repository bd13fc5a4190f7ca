#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "read/heidenhain/reading.hpp"

namespace obrys::read::heidenhain {

using testing::complaint;
using testing::f;
using testing::one;
using testing::Reading;

namespace {

/// The right side of an assignment.
std::string value(const std::string& formula) {
    const std::string tree = one("5 Q1 = " + formula);
    return tree.starts_with("Q1=") ? tree.substr(3) : tree;
}

}  // namespace

TEST(KlartextFormula, OrderOfOperations) {
    EXPECT_EQ(value("5 * 3 + 2 * 10"), "((5 * 3) + (2 * 10))");
    EXPECT_EQ(value("SQ 10 - 3^3"), "(" + f(program::Function::square, "10") + " - (3 ^ 3))");
    EXPECT_EQ(value("Q1 - Q2 - Q3"), "((Q1 - Q2) - Q3)");
    EXPECT_EQ(value("Q1 / Q2 * Q3"), "((Q1 / Q2) * Q3)");
    EXPECT_EQ(value("2 * 3 ^ 2"), "(2 * (3 ^ 2))");
    EXPECT_EQ(value("2 ^ 3 ^ 2"), "(2 ^ (3 ^ 2))");  // chained powers from right to left
    EXPECT_EQ(value("- 2 ^ 2"), "((neg 2) ^ 2)");    // the sign belongs to the number
    EXPECT_EQ(value("( Q1 + Q2 ) * Q3"), "((Q1 + Q2) * Q3)");
    EXPECT_EQ(value("Q1 * ( 1 - SIN Q3 )"), "(Q1 * (1 - " + f(program::Function::sin, "Q3") + "))");
    EXPECT_EQ(value("SIN Q3 * 2"), "(" + f(program::Function::sin, "Q3") + " * 2)");
    EXPECT_EQ(value("SIN ( Q3 * 2 )"), f(program::Function::sin, "(Q3 * 2)"));
    EXPECT_EQ(value("400 % 360"), "(400 mod 360)");
    EXPECT_EQ(value("+ 5"), "5");
    EXPECT_EQ(value("- ( Q2 )"), "(neg Q2)");
    EXPECT_EQ(value("Q2 * - Q3"), "(Q2 * (neg Q3))");
}

TEST(KlartextFormula, Functions) {
    using program::Function;
    const std::vector<std::pair<std::string, Function>> all{
        {"SIN", Function::sin},   {"COS", Function::cos},       {"TAN", Function::tan},   {"ASIN", Function::asin},
        {"ACOS", Function::acos}, {"ATAN", Function::atan},     {"SQ", Function::square}, {"SQRT", Function::sqrt},
        {"LN", Function::ln},     {"LOG", Function::log10},     {"EXP", Function::exp},   {"INT", Function::trunc},
        {"ABS", Function::abs},   {"FRAC", Function::fraction}, {"SGN", Function::sign}};
    for (const auto& [name, function] : all) {
        EXPECT_EQ(value(name + " Q2"), f(function, "Q2")) << name;
        EXPECT_EQ(value(name + "Q2"), f(function, "Q2")) << name;
        EXPECT_EQ(value(name + "( 4 )"), f(function, "4")) << name;
        EXPECT_EQ(value(name + " - 4"), f(function, "(neg 4)")) << name;
    }
    EXPECT_EQ(value("NEG Q2"), "(neg Q2)");
    EXPECT_EQ(value("PI"), "3.141592653589793r");
    EXPECT_EQ(value("ASIN ( ( Q96 + Q99 ) / Q94 )"), f(Function::asin, "((Q96 + Q99) / Q94)"));
}

TEST(KlartextFormula, Parameters) {
    EXPECT_EQ(one("QL5 = QR3 + Q1999"), "QL5=(QR3 + Q1999)");
    EXPECT_EQ(complaint("Q2000 = 1"), "there is no parameter Q2000");
    EXPECT_EQ(complaint("QL500 = 1"), "there is no parameter QL500");
    EXPECT_EQ(complaint("QR500 = 1"), "there is no parameter QR500");
    EXPECT_EQ(complaint("QS2000 = \"a\""), "there is no parameter QS2000");
    EXPECT_EQ(complaint("Q99999999999999999999 = 1"), "there is no parameter Q99999999999999999999");
    EXPECT_EQ(complaint("L XQ2000"), "there is no parameter Q2000");
    EXPECT_EQ(one("Q05 = 1"), "Q5=1");
}

TEST(KlartextFormula, Texts) {
    EXPECT_EQ(one("QS1 = \"ab\" || QS2"), "QS1=(\"ab\" << QS2)");
    EXPECT_EQ(one("DECLARE STRING QS1 = \"ab\""), "QS1=\"ab\"");
    EXPECT_EQ(one("QS1 = TOCHAR( DAT+Q2 DECIMALS3 )"), "QS1=" + f(program::Function::to_text, "Q2,3"));
    EXPECT_EQ(one("Q1 = TONUMB( SRC_QS1 )"), "Q1=" + f(program::Function::number, "QS1"));
    EXPECT_EQ(one("QS1 = SUBSTR( SRC_QS2 BEG2 LEN4 )"), "QS1=" + f(program::Function::substring, "QS2,2,4"));
    EXPECT_EQ(one("Q1 = INSTR( SRC_QS1 SEA_QS2 BEG0 )"), "Q1=" + f(program::Function::find_text, "QS1,QS2,0"));
    EXPECT_EQ(one("Q1 = STRLEN( SRC_QS1 )"), "Q1=" + f(program::Function::string_length, "QS1"));
    EXPECT_EQ(one("Q1 = STRCOMP( SRC_QS1 SEA_QS2 )"), "Q1=" + f(program::Function::compare_texts, "QS1,QS2"));
    EXPECT_EQ(complaint("QS1 = \"ab"), "this text has no closing quote");
}

TEST(KlartextFormula, Mistakes) {
    EXPECT_EQ(complaint("Q1 = ( Q2 + 1"), "this parenthesis is not closed");
    EXPECT_EQ(complaint("Q1 = Q2 + 1 )"), "this is left over at the end of the block: ')'");
    EXPECT_EQ(complaint("Q1 = Q2 +"), "the formula ends where a number, a Q parameter or a function is due");
    EXPECT_EQ(complaint("Q1 = "), "the formula ends where a number, a Q parameter or a function is due");
    EXPECT_EQ(complaint("Q1 = * 2"), "a number, a Q parameter or a function is due here, found '*'");
    EXPECT_EQ(complaint("Q1 = SINN Q2"), "the control has no function 'SINN'");
    EXPECT_EQ(complaint("Q1 = HELLO"), "the control has no function 'HELLO'");
    EXPECT_EQ(complaint("Q1 2"), "'=' is due here, found '2'");
    EXPECT_EQ(complaint("Q1 = 1 2"), "this is left over at the end of the block: '2'");
    EXPECT_EQ(complaint("Q1 = " + std::string(300, '(') + "1" + std::string(300, ')')),
              "the formula is nested more than 200 levels deep");
    std::string sum = "Q1 = 1";
    for (int i = 0; i < 2000; ++i) sum += " + 1";
    EXPECT_EQ(complaint(sum), "the formula has more than 1000 operators");
}

/// A formula written out of a random tree with all its parentheses reads back to that tree.
RC_GTEST_PROP(KlartextFormula, WrittenOutReadsBack, ()) {
    const auto signs =
        *rc::gen::nonEmpty(rc::gen::container<std::vector<char>>(rc::gen::elementOf(std::string("+-*/^"))));
    const auto sides = *rc::gen::container<std::vector<bool>>(signs.size(), rc::gen::arbitrary<bool>());
    RC_PRE(signs.size() < 60u);
    std::string text = "Q7", tree = "Q7";
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const std::string n = std::to_string(i), op(1, signs[i]);
        const std::string inner = i == 0 ? text : "( " + text + " )";
        text = sides[i] ? inner + " " + op + " " + n : n + op + inner;
        tree = sides[i] ? "(" + tree + " " + op + " " + n + ")" : "(" + n + " " + op + " " + tree + ")";
    }
    RC_ASSERT(value(text) == tree);
}

}  // namespace obrys::read::heidenhain
