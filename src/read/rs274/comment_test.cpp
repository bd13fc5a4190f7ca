#include <gtest/gtest.h>

#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

using program::Function;
using program::Procedure;
using program::StateQuery;
using program::SystemVariable;
using testing::one;
using testing::Reading;

namespace {

std::string call(Procedure p, const std::string& arguments) {
    return "procedure " + std::to_string(static_cast<int>(p)) + "(" + arguments + ")";
}
std::string shown(const std::string& value, int decimals) {
    return "f" + std::to_string(static_cast<int>(Function::to_text)) + "(" + value + "," + std::to_string(decimals) +
           ")";
}

}  // namespace

TEST(Rs274Comment, TheLastOfABlockCounts) {
    EXPECT_EQ(one("X1 ( a ) Y2 ( b )"), "comment{b } X1 Y2");
    EXPECT_EQ(one("X1 ; (a)"), "X1");
    EXPECT_EQ(Reading("; nothing\n\n  ; else\n").tree(), "");
}

// Formats and their effect as rs274 (LinuxCNC 2.9) prints them.
TEST(Rs274Comment, ValuesAreShownByTheLastFormat) {
    EXPECT_EQ(one("(debug,a #1 %.3f#2)"),
              call(Procedure::message, "(((\"a \" << " + shown("#1", 6) + ") << \" \") << " + shown("#2", 3) + ")"));
    EXPECT_EQ(one("(print,%d#1%f#1)"), call(Procedure::print, "(" + shown("#1", 0) + " << " + shown("#1", 4) + ")"));
    EXPECT_EQ(one("(print,100% %.12f #[1] #5602)"), call(Procedure::print, "\"100% .12f #[1] ######\""));
    EXPECT_EQ(one("(log,#<Foo Bar>)"), call(Procedure::log, shown("FOOBAR", 6)));
    EXPECT_EQ(one("(abort,#<_x>)"),
              call(Procedure::abort, shown("#<_X>#" + std::to_string(static_cast<int>(SystemVariable::state)) + "[" +
                                               std::to_string(static_cast<int>(StateQuery::x)) + "]",
                                           6)));
}

TEST(Rs274Comment, OthersKeepTheirText) {
    EXPECT_EQ(one("( MSG, #1 )"), call(Procedure::message, "\" #1 \""));
    EXPECT_EQ(one("(logopen,a.txt)"), call(Procedure::log_open, "\"a.txt\""));
    EXPECT_EQ(one("(logappend,a.txt)"), call(Procedure::log_append, "\"a.txt\""));
    EXPECT_EQ(one("(logclose)"), call(Procedure::log_close, ""));
    EXPECT_EQ(one("(logclose )"), "comment{logclose }");
    EXPECT_EQ(one("(MSG , x)"), "comment{MSG , x}");
    EXPECT_EQ(one("(probeopen a.txt)"),
              "0 " + call(Procedure::probe_log_open, "\"a.txt\"") + "\n1 +comment{probeopen a.txt}\n");
}

TEST(Rs274Comment, ActBeforeTheirBlock) {
    EXPECT_EQ(one("X1 (msg,go)"), "0 " + call(Procedure::message, "\"go\"") + "\n1 +X1\n");
}

TEST(Rs274Comment, ScriptsAreNotRun) {
    EXPECT_EQ(one("(py, x)"), "unsupported{(py, x)|a script in Python}");
    EXPECT_EQ(one(";py,x=1"), "unsupported{;py,x=1|a script in Python}");
    EXPECT_EQ(one("X1 ;py,x=1"), "X1");
}

TEST(Rs274Comment, OLinesShowNone) {
    EXPECT_EQ(Reading("o1 if [1] (debug, x)\no1 endif (y)\nM2\n").unit().texts.size(), 0U);
}

}  // namespace obrys::read::rs274
