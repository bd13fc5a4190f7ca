#include "interp/calls/print_form.hpp"

#include <gtest/gtest.h>

#include <random>

namespace obrys::interp {
namespace {

FilledForm fill(std::string_view form) {
    const auto value = [](std::string_view name) {
        if (name == "Q1") return Value::real(-3.14159);
        if (name == "QS1") return Value::string("TEXT");
        return Value::unknown();
    };
    return fill_form(form, value, "PART.H");
}

TEST(PrintForm, Numbers) {
    EXPECT_EQ(fill("\"%9.3LF|\", Q1;").text, "   -3.142|\n");
    EXPECT_EQ(fill("\"%-9.3F|\", q1;").text, "-3.142   |\n");
    EXPECT_EQ(fill("\"%07.2f|\", Q1;").text, "-003.14|\n");
    EXPECT_EQ(fill("\"%d|%5D|\", Q1, Q1;").text, "-3|   -3|\n");
    EXPECT_EQ(fill("\"%9.3LF|\", Q2;").text, "        ?|\n");
}

TEST(PrintForm, TextsAndKeywords) {
    EXPECT_EQ(fill("\"A %6S %-6RS|\", QS1, QS1;\r\nCALL_PATH;\r\n").text, "A   TEXT TEXT  |\nPART.H\n");
    EXPECT_EQ(fill("L_GERMAN;\n\"a\";\nL_ENGLISH;\n\"b\";\nL_ALL;\n\"c\";").text, "b\nc\n");
    EXPECT_TRUE(fill("M_CLOSE;").close);
    EXPECT_TRUE(fill("m_append").append);
    EXPECT_TRUE(fill("\"%d\", DAY;").clock);
    EXPECT_EQ(fill("; comment\n\n").text, "");
}

TEST(PrintForm, WhatIsNotUnderstoodIsSaid) {
    for (const char* form : {"\"open", "WHAT;", "\"%Q\", Q1;", "\"%d\";", "\"none\", Q1;", "\"%"})
        EXPECT_EQ(fill(form).problems.size(), 1U) << form;
    EXPECT_LE(fill(std::string(10000, '\n') + std::string(100, 'X')).problems.size(), 10U);
}

TEST(PrintForm, AnyTextEnds) {
    std::mt19937 random(7);
    constexpr std::string_view pieces[] = {"\"", "%",  "9.3", "LF", "S", "d",       ";",
                                           ",",  "Q1", "\n",  "-",  "0", "M_CLOSE", " "};
    for (int run = 0; run < 3000; ++run) {
        std::string form;
        for (auto n = random() % 30; n > 0; --n) form += pieces[random() % std::size(pieces)];
        EXPECT_LE(fill(form).text.size(), 20000U) << "seed 7, run " << run << ": " << form;
    }
}

}  // namespace
}  // namespace obrys::interp
