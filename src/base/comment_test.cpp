#include "base/comment.hpp"

#include <gtest/gtest.h>

#include "base/text.hpp"

namespace obrys::base {
namespace {

TEST(Comment, KeepsToTheCharactersOfTheControl) {
    const CommentRules fanuc{.plain = true, .holds_brackets = false};
    EXPECT_EQ(comment_text("Schruppen (Tasche Ü1) 50%", fanuc), "SCHRUPPEN <TASCHE UE1> 50");
    EXPECT_EQ(comment_text("Příruba č. 5, Ø10", fanuc), "PRIRUBA C. 5, D10");
    EXPECT_EQ(comment_text("two\nlines", fanuc), "TWO LINES");
    EXPECT_EQ(comment_text("Tasche \"A\" (Ü)", CommentRules{.holds_quotes = false}), "Tasche 'A' (Ü)");
}

TEST(Comment, HasTheLettersOfWindows1252WhereThereAreSuch) {
    EXPECT_EQ(without_marks("Příruba Ø10 Ω", true), "Príruba Ø10 ?");
    EXPECT_EQ(without_marks("Příruba Ø10 Ω"), "Priruba D10 ?");
}

TEST(Comment, DoesNothingWhereItsBeginningWouldDoSomething) {
    const CommentRules rules{.holds_brackets = false, .active = {"MSG,", "ABORT,"}};
    EXPECT_EQ(comment_text(" abort, if it hums", rules), "- abort, if it hums");
    EXPECT_EQ(comment_text("no abort, please", rules), "no abort, please");
}

TEST(Comment, EndsWithItsLine) {
    EXPECT_EQ(comment_text("goes on ~", {}), "goes on");
    EXPECT_EQ(comment_text("12345678", CommentRules{.longest = 4}), "1234");
}

/// Whatever the text was: what a plain comment holds is of the seven bit code, and no bracket closes it.
TEST(Comment, IsPlainWhateverCharacterStandsInIt) {
    const CommentRules fanuc{.plain = true, .holds_brackets = false};
    for (unsigned c = 1; c < 0x800; ++c) {
        std::string text = "a";
        if (c < 0x80) text += static_cast<char>(c);
        if (c >= 0x80) text += {static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))};
        for (const char out : comment_text(text + "b", fanuc)) {
            EXPECT_TRUE(out >= ' ' && out <= 'Z') << c;
            EXPECT_TRUE(out != '(' && out != ')' && out != '%') << c;
        }
    }
}

}  // namespace
}  // namespace obrys::base
