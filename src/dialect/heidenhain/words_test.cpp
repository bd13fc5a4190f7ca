#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "dialect/heidenhain/cycles.hpp"
#include "dialect/heidenhain/functions.hpp"
#include "dialect/heidenhain/g_codes.hpp"
#include "dialect/heidenhain/m_functions.hpp"
#include "dialect/heidenhain/sysread.hpp"

namespace obrys::dialect::heidenhain {
namespace {

/// Appendix `n` of the thesis; empty where its text is not at hand.
std::string appendix(int n) {
    const auto path = std::filesystem::path(OBRYS_SOURCE_DIR) / "../shared/sources/001_94e4b26c3b5c654d.txt";
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    const std::string all = text.str();
    const std::string head = "\nP\xC5\x99\xC3\xADloha ";
    const auto begin = all.find(head + std::to_string(n) + "\n");
    const auto end = all.find(head + std::to_string(n + 1) + "\n");
    return begin == std::string::npos || end == std::string::npos ? "" : all.substr(begin, end - begin);
}

template <typename Table>
void expect_sorted(const Table& table) {
    for (std::size_t i = 1; i < table.size(); ++i) EXPECT_LT(table[i - 1].number, table[i].number);
    for (const auto& entry : table) EXPECT_FALSE(entry.text.empty()) << entry.number;
}

TEST(HeidenhainWords, TablesAreSortedAndHaveTexts) {
    expect_sorted(all_m());
    expect_sorted(all_g());
    expect_sorted(all_fn());
    expect_sorted(all_errors());
}

namespace {

/// G17, G28* … in front of a tab, behind one of `before` or at the text's begin.
std::vector<std::pair<int, bool>> codes(const std::string& text, char letter, const std::string& before) {
    std::vector<std::pair<int, bool>> found;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != letter || (i > 0 && before.find(text[i - 1]) == std::string::npos)) continue;
        std::size_t end = i + 1;
        int number = 0;
        for (; end < text.size() && text[end] >= '0' && text[end] <= '9'; ++end)
            number = number * 10 + (text[end] - '0');
        const bool star = end < text.size() && text[end] == '*';
        const std::size_t tab = end + (star ? 1 : 0);
        if (end > i + 1 && tab < text.size() && text[tab] == '\t') found.emplace_back(number, star);
    }
    return found;
}

}  // namespace

TEST(HeidenhainWords, GCodesAreThoseOfTheAppendix) {
    const std::string text = appendix(1);
    if (text.empty()) GTEST_SKIP() << "needs ../shared";
    std::map<int, bool> listed;  // number, star
    for (const auto& [number, star] : codes(text, 'G', "\n")) listed[number] = star;
    std::map<int, bool> ours;
    for (const GCode& g : all_g())
        if (g.listed) ours[g.number] = g.block_only;
    EXPECT_GT(listed.size(), 100U);
    EXPECT_EQ(ours, listed);
}

TEST(HeidenhainWords, MFunctionsOfTheAppendixAreKnown) {
    const std::string text = appendix(2);
    if (text.empty()) GTEST_SKIP() << "needs ../shared";
    std::set<int> listed;
    for (const auto& [number, star] : codes(text, 'M', "\n\t")) listed.insert(number);
    EXPECT_EQ(listed.size(), 59U);
    for (const int n : listed) EXPECT_NE(find_m(n), nullptr) << "M" << n;
    // In the manual, not in the appendix.
    const std::set<int> more{7, 19, 112, 113, 148, 149, 150, 201, 202, 203};
    for (const MFunction& m : all_m())
        EXPECT_EQ(listed.count(m.number) == 0, more.count(m.number) == 1) << "M" << m.number;
}

TEST(HeidenhainWords, MFunctions) {
    EXPECT_EQ(find_m(3)->when, When::start);
    EXPECT_EQ(find_m(5)->when, When::end);
    EXPECT_EQ(find_m(9)->when, When::end);
    EXPECT_EQ(find_m(98)->when, When::end);
    EXPECT_EQ(find_m(91)->when, When::start);
    EXPECT_TRUE(find_m(91)->block_only);
    EXPECT_FALSE(find_m(120)->block_only);
    EXPECT_EQ(find_m(120)->parameters, "LA");
    for (const int n : {92, 114, 118, 128, 130, 101, 124, 144, 200}) EXPECT_EQ(find_m(n)->use, Use::refused) << n;
    for (const int n :
         {0, 1, 2, 30, 3, 4, 5, 6, 7, 8, 9, 13, 14, 19, 89, 91, 97, 98, 99, 103, 109, 110, 111, 120, 136, 140})
        EXPECT_EQ(find_m(n)->use, Use::run) << n;
    for (const int n : {90, 94, 126, 127}) EXPECT_EQ(find_m(n)->use, Use::accepted) << n;
    for (const int n : {-1, 31, 88, 146, 205}) EXPECT_EQ(find_m(n), nullptr) << n;
}

TEST(HeidenhainWords, GCodes) {
    EXPECT_EQ(find_g(0)->klartext, "L FMAX");
    EXPECT_EQ(find_g(79)->klartext, "CYCL CALL");
    EXPECT_EQ(find_g(28)->cycle, 8);
    EXPECT_EQ(find_g(83)->cycle, 1);
    EXPECT_EQ(find_g(425)->use, Use::refused);
    for (const int n : {-1, 8, 14, 33, 64, 92, 500}) EXPECT_EQ(find_g(n), nullptr) << n;
}

TEST(HeidenhainWords, CyclesOfGCodesAreTreatedAlike) {
    const std::map<Cycle::Use, Use> same{
        {Cycle::Use::run, Use::run}, {Cycle::Use::accepted, Use::accepted}, {Cycle::Use::refused, Use::refused}};
    for (const GCode& g : all_g()) {
        if (g.cycle == 0) continue;
        const Cycle* cycle = find_cycle(g.cycle);
        ASSERT_NE(cycle, nullptr) << "G" << g.number;
        EXPECT_EQ(g.use, same.at(cycle->use)) << "G" << g.number;
    }
}

TEST(HeidenhainWords, Functions) {
    EXPECT_EQ(find_fn(14)->name, "ERROR");
    EXPECT_EQ(find_fn(18)->use, Use::run);
    EXPECT_EQ(find_fn(23)->use, Use::refused);
    for (const int n : {-1, 21, 22, 30, 36, 39}) EXPECT_EQ(find_fn(n), nullptr) << n;
    EXPECT_EQ(all_errors().size(), 100U);
    EXPECT_EQ(error_text(1000), "Spindle?");
    EXPECT_EQ(error_text(1010), "Feed rate is missing");
    EXPECT_EQ(error_text(1022), "Rounding-off undefined");
    EXPECT_EQ(error_text(999), "");
    EXPECT_EQ(error_message(1005), "ERROR 1005: Start position incorrect");
    EXPECT_EQ(error_message(20), "ERROR 20");
    EXPECT_EQ(error_text(1100), "");
}

TEST(HeidenhainWords, SystemData) {
    for (std::size_t i = 0; i < all_sysread().size(); ++i) {
        const SysReadEntry& e = all_sysread()[i];
        EXPECT_LE(e.nr, e.nr_last);
        EXPECT_LE(e.idx_first, e.idx_last);
        EXPECT_EQ(find_sysread(e.id, e.nr, e.idx_first), &e);
        EXPECT_EQ(find_sysread(e.id, e.nr_last, e.idx_last), &e);
        if (e.what == SysRead::other) {
            EXPECT_EQ(e.use, Use::refused);
        }
        if (i == 0) continue;
        const SysReadEntry& before = all_sysread()[i - 1];
        EXPECT_TRUE(before.id < e.id || (before.id == e.id && before.nr_last < e.nr)) << e.id << " " << e.nr;
    }
    EXPECT_EQ(find_sysread(20, 1)->what, SysRead::tool_number);
    EXPECT_EQ(find_sysread(50, 2, 31)->what, SysRead::table_tool);
    EXPECT_EQ(find_sysread(270, 1, 3)->what, SysRead::position);
    EXPECT_EQ(find_sysread(270, 1), nullptr);
    EXPECT_EQ(find_sysread(270, 1, 10), nullptr);
    EXPECT_EQ(find_sysread(500, 12, 2)->what, SysRead::datum_table_value);
    EXPECT_EQ(find_sysread(10, 5), nullptr);
    EXPECT_EQ(find_sysread(0, 0), nullptr);
    EXPECT_EQ(find_sysread(999, 1), nullptr);
    EXPECT_EQ(find_sysread(-1, -1, -1), nullptr);
}

}  // namespace
}  // namespace obrys::dialect::heidenhain
