#include "write/magazine.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "write/post_testing.hpp"
#include "write/writer_testing.hpp"

namespace obrys::write {
namespace {

MagazineForm of_places(std::uint32_t places) {
    MagazineForm form;
    form.places = places;
    return form;
}

TEST(Magazine, IsBalancedHoweverManyToolsItHolds) {
    for (const std::uint32_t places : {1U, 2U, 7U, 12U, 32U, 40U}) {
        const MagazineForm form = of_places(places);
        Magazine magazine(form);
        std::string why;
        std::vector<std::uint32_t> at;
        for (std::uint32_t n = 1; n <= places && 2 * n <= form.last_offset; ++n) {
            const MagazineSlot* slot = magazine.take(100 + n, why);
            ASSERT_NE(slot, nullptr) << why;
            ASSERT_GE(slot->place, 1U);
            ASSERT_LE(slot->place, places);
            ASSERT_EQ(std::count(at.begin(), at.end(), slot->place), 0);
            at.push_back(slot->place);
            // No gap of the ring is more than twice another one, and a place wider.
            std::vector<std::uint32_t> ring = at;
            std::sort(ring.begin(), ring.end());
            std::uint32_t widest = 0, narrowest = places;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const std::uint32_t next = i + 1 < ring.size() ? ring[i + 1] : ring[0] + places;
                widest = std::max(widest, next - ring[i]), narrowest = std::min(narrowest, next - ring[i]);
            }
            EXPECT_LE(widest, 2 * narrowest + 1) << places << " places, " << n << " tools";
        }
    }
}

TEST(Magazine, ToolsKeepWhatTheyHave) {
    MagazineForm form = of_places(8);
    form.tools = {{7, 3, 4}, {9, 0, 1}};
    Magazine magazine(form);
    std::string why;
    const MagazineSlot seven = *magazine.take(7, why);
    EXPECT_EQ(seven.place, 3U);
    EXPECT_EQ(seven.approach(), 1U);
    EXPECT_EQ(seven.entry(), 2U);
    const MagazineSlot nine = *magazine.take(9, why);
    EXPECT_EQ(nine.offset, 5U);
    EXPECT_EQ(nine.entry(), 5U);
    EXPECT_EQ(magazine.take(8, why)->offset, 6U);
    EXPECT_EQ(magazine.take(7, why)->place, 3U);
    EXPECT_EQ(text_of(magazine.slots()).substr(0, 33), "tool 7: place 3, offsets 1 to 4\nt");
}

TEST(Magazine, IsFullAtSomeTime) {
    MagazineForm form = of_places(2);
    Magazine full(form);
    std::string why;
    EXPECT_NE(full.take(1, why), nullptr);
    EXPECT_NE(full.take(2, why), nullptr);
    EXPECT_EQ(full.take(3, why), nullptr);
    EXPECT_NE(why.find("2 places"), std::string::npos);
    form.places = 9, form.last_offset = 3;
    Magazine offsets(form);
    EXPECT_NE(offsets.take(1, why), nullptr);
    EXPECT_EQ(offsets.take(2, why), nullptr);
    EXPECT_NE(why.find("number 3"), std::string::npos);
    form = of_places(4);
    form.balanced = false;
    Magazine numbered(form);
    EXPECT_EQ(numbered.take(3, why)->place, 3U);
    EXPECT_EQ(numbered.take(5, why), nullptr);
}

const char* const magazine_words =
    "[modal]\ncoordinates = [\"X\", \"Z\"]\nwords = [\"D\"]\ngroups = [[\"G0\", \"G1\"]]\n[motion]\nrapid = \"G0 X{x} "
    "Z{z} D{approach}\"\n"
    "linear = \"G1 X{x} Z{z} D{entry}\"\n[tool]\nchange = \"T{place}\"\n[magazine]\nplaces = 10\n";

TEST(Magazine, IsWrittenWithTheTool) {
    cl::ToolChange a, b;
    a.number = 12, b.number = 5;
    const auto at = [](double x, double z, bool rapid) { return cl::Linear{{x, 0, z}, {0, 0, 1}, rapid}; };
    const Written w = write(post_of(magazine_words), {a, at(0, 9, true), at(0, -1, false), at(5, -1, false),
                                                      at(5, 9, true), b, at(6, 9, true), at(6, 2, true)});
    EXPECT_EQ(w.text, "T1\nG0 X0 Z9 D1\nG1 Z-1 D2\nX5\nG0 Z9 D1\nT6\nX6 Z9 D3\nZ2\n");
    EXPECT_TRUE(w.lost.empty());
}

TEST(Magazine, WhatIsMissingIsLostAndSaid) {
    const auto at = [](double x, bool rapid) { return cl::Linear{{x, 0, 0}, {0, 0, 1}, rapid}; };
    cl::ToolChange tool;
    tool.number = 1;
    // No tool is called before the cut; said once.
    EXPECT_EQ(write(post_of(magazine_words), {at(0, true), at(1, false), at(2, false)}).lost.size(), 1U);
    EXPECT_EQ(write(post_of(magazine_words), {tool, at(0, true), at(1, false)}).lost.size(), 0U);
    const Post one = post_of(std::string(magazine_words) + "last_offset = 1\n");
    EXPECT_EQ(write(one, {tool, at(0, true)}).lost.size(), 1U);
}

TEST(Magazine, FaultsOfItsTable) {
    const auto fault = [](const std::string& more) { return faults_of("[magazine]\n" + more); };
    EXPECT_EQ(fault("places = 20\noffsets = 4\n"), "");
    EXPECT_NE(fault("offsets = 2\n").find("places"), std::string::npos);
    EXPECT_NE(fault("places = 20\noffsets = 3\n").find("one, two or four"), std::string::npos);
    EXPECT_NE(fault("places = 0\n"), "");
    EXPECT_NE(fault("places = 4\n[[magazine.tool]]\nnumber = 1\nplace = 5\n"), "");
    EXPECT_NE(fault("places = 4\n[[magazine.tool]]\nnumber = 1\nplace = 2\n[[magazine.tool]]\nnumber = 3\nplace = 2\n")
                  .find("place 2"),
              std::string::npos);
}

}  // namespace
}  // namespace obrys::write
