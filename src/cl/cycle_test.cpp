#include "cl/cycle.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace obrys::cl {
namespace {

/// Every enumerator has a word of its own, which leads back to it; the last one is `last`.
template <class Enum, class Find>
void each_has_a_word(Enum last, Find find) {
    std::set<std::string_view> seen;
    for (int i = 0; i <= static_cast<int>(last); ++i) {
        const auto e = static_cast<Enum>(i);
        const std::string_view word = spelling(e);
        EXPECT_FALSE(word.empty()) << i;
        EXPECT_TRUE(seen.insert(word).second) << word;
        EXPECT_EQ(find(word), e) << word;
    }
    EXPECT_EQ(find("no-such-word"), std::nullopt);
    EXPECT_EQ(find(""), std::nullopt);
}

TEST(CycleWords, EachKindAndRoleHasOne) {
    each_has_a_word(CycleKind::probe, cycle_kind_spelt);
    each_has_a_word(CycleRole::turned_axes, cycle_role_spelt);
}

TEST(CycleWords, StandWithTheirEnumerators) {
    EXPECT_EQ(spelling(CycleKind::peck), "peck");
    EXPECT_EQ(spelling(CycleKind::canned_circular_pocket), "canned-circular-pocket");
    EXPECT_EQ(spelling(CycleKind::lathe_box_across), "lathe-box-across");
    EXPECT_EQ(spelling(CycleKind::contour_train), "contour-train");
    EXPECT_EQ(spelling(CycleKind::probe), "probe");
    EXPECT_EQ(spelling(CycleRole::surface), "surface");
    EXPECT_EQ(spelling(CycleRole::feed_reference), "feed-reference");
    EXPECT_EQ(spelling(CycleRole::pitch_circle), "pitch-circle");
    EXPECT_EQ(spelling(CycleRole::retract_plane), "retract-plane");
    EXPECT_EQ(spelling(CycleRole::turned_axes), "turned-axes");
}

}  // namespace
}  // namespace obrys::cl
