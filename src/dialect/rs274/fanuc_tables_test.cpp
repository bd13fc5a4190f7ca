#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "dialect/rs274/fanuc.hpp"
#include "dialect/rs274/linuxcnc.hpp"

namespace obrys::dialect::rs274 {

using program::Modal;

namespace {

constexpr FanucControl mill{}, haas{.haas = true};
constexpr FanucControl lathe(GSystem s) { return {.machine = FanucMachine::lathe, .system = s}; }

Modal modal_of(int code, const FanucControl& c) {
    const FanucG* g = find_fanuc_g(code, c);
    EXPECT_NE(g, nullptr) << code;
    return g == nullptr ? Modal::rapid : g->modal;
}

}  // namespace

TEST(FanucTables, LiveParametersRise) {
    const auto rises = [](const program::LiveParameters& a, const program::LiveParameters& b) {
        return a.first < b.first;
    };
    for (const program::Traits* t :
         {&fanuc_traits(mill), &fanuc_traits(haas), &fanuc_traits(lathe(GSystem::a)), &linuxcnc_traits})
        EXPECT_TRUE(std::is_sorted(t->live.begin(), t->live.end(), rises));
}

TEST(FanucTables, NoCodeStandsTwice) {
    const auto check = [](std::span<const FanucG> table) {
        std::set<int> seen;
        for (const FanucG& g : table) EXPECT_TRUE(seen.insert(g.code).second) << g.code;
    };
    check(mill_g_table());
    check(haas_mill_g_table());
    for (const auto number : {&LatheG::a, &LatheG::b, &LatheG::c}) {
        std::set<int> seen;
        for (const LatheG& g : lathe_g_table())
            if (g.*number >= 0) {
                EXPECT_TRUE(seen.insert(g.*number).second) << g.*number;
            }
    }
}

TEST(FanucTables, WhatIsNotRunSaysWhatItIs) {
    const auto check = [](const FanucG& g) {
        const bool explained = g.use == FanucUse::refused || g.use == FanucUse::accepted;
        EXPECT_TRUE(!explained || !g.says.empty()) << g.code;
        EXPECT_EQ(g.use == FanucUse::special, g.special != FanucSpecial::none) << g.code;
    };
    for (const FanucG& g : mill_g_table()) check(g);
    for (const FanucG& g : haas_mill_g_table()) check(g);
    for (const LatheG& g : lathe_g_table()) check(g.meaning);
}

/// The list of G codes in the operator's manuals for lathes.
TEST(FanucTables, SystemsOfLathes) {
    struct Row {
        std::array<int, 3> numbers;
        Modal modal;
    };
    constexpr std::array rows{
        Row{{980, 940, 940}, Modal::feed_per_minute},  Row{{990, 950, 950}, Modal::feed_per_rev},
        Row{{200, 200, 700}, Modal::inch_all},         Row{{210, 210, 710}, Modal::metric_all},
        Row{{500, 920, 920}, Modal::position_becomes}, Row{{320, 330, 330}, Modal::thread},
        Row{{900, 770, 200}, Modal::turning_cycle},    Row{{920, 780, 210}, Modal::turning_cycle},
        Row{{940, 790, 240}, Modal::turning_cycle},    Row{{760, 760, 780}, Modal::turning_cycle},
        Row{{-1, 900, 900}, Modal::absolute},          Row{{-1, 910, 910}, Modal::incremental},
        Row{{-1, 980, 980}, Modal::retract_initial},
    };
    for (const Row& r : rows)
        for (const GSystem s : {GSystem::a, GSystem::b, GSystem::c})
            if (const int n = r.numbers[static_cast<std::size_t>(s)]; n >= 0) {
                EXPECT_EQ(modal_of(n, lathe(s)), r.modal) << n << " " << static_cast<int>(s);
            }
    EXPECT_EQ(find_fanuc_g(910, lathe(GSystem::a)), nullptr);
    EXPECT_EQ(find_fanuc_g(700, lathe(GSystem::a))->special, FanucSpecial::repetitive);
    EXPECT_EQ(find_fanuc_g(720, lathe(GSystem::c))->special, FanucSpecial::repetitive);
}

/// A code of FANUC's that has no effect there, and that a Haas has not, is no word that a Haas runs over in silence.
TEST(FanucTables, HaasAcceptsWhatItsOwnTableAcceptsAlone) {
    const auto own = [](std::span<const FanucG> table, int code) {
        return std::any_of(table.begin(), table.end(), [code](const FanucG& g) { return g.code == code; });
    };
    for (const FanucG& g : mill_g_table())
        EXPECT_TRUE(g.use != FanucUse::accepted || own(haas_mill_g_table(), g.code)) << g.code;
    for (const LatheG& g : lathe_g_table())
        EXPECT_TRUE(g.meaning.use != FanucUse::accepted || own(haas_lathe_g_table(), g.a)) << g.a;
}

TEST(FanucTables, HaasDiffers) {
    EXPECT_EQ(find_fanuc_g(1540, mill), nullptr);
    EXPECT_EQ(find_fanuc_g(1540, haas)->special, FanucSpecial::datum_number);
    EXPECT_EQ(find_fanuc_g(1120, haas)->number, 3);
    EXPECT_EQ(find_fanuc_g(1500, haas)->use, FanucUse::refused);
    EXPECT_EQ(find_fanuc_g(1500, mill)->use, FanucUse::accepted);
    EXPECT_EQ(find_fanuc_g(700, mill), nullptr);
    EXPECT_EQ(find_fanuc_g(700, haas)->special, FanucSpecial::local_pattern);
    EXPECT_EQ(find_fanuc_m(97, haas).use, FanucMUse::local_call);
    EXPECT_EQ(find_fanuc_m(97, mill).use, FanucMUse::unknown);
}

/// B-63684EN page 277: the tables of argument specification I and II.
TEST(FanucTables, Arguments) {
    constexpr std::string_view letters = "ABCDEFHIJKMQRSTUVWXYZ";
    constexpr std::array numbers{1, 2, 3, 7, 8, 9, 11, 4, 5, 6, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
    for (std::size_t i = 0; i < letters.size(); ++i)
        EXPECT_EQ(argument_parameter(letters[i]), numbers[i]) << letters[i];
    for (const char none : {'G', 'L', 'N', 'O', 'P'}) EXPECT_EQ(argument_parameter(none), 0);
    EXPECT_EQ(argument_parameter('I', 1), 4);
    EXPECT_EQ(argument_parameter('K', 1), 6);
    EXPECT_EQ(argument_parameter('I', 2), 7);
    EXPECT_EQ(argument_parameter('K', 10), 33);
    EXPECT_EQ(argument_parameter('I', 11), 0);
}

TEST(FanucTables, SystemVariables) {
    const auto is = [](std::uint32_t n, const FanucControl& c, FanucSystem s, int index = 0) {
        const FanucVariable v = system_variable(n, c);
        EXPECT_EQ(static_cast<int>(v.system), static_cast<int>(s)) << n;
        EXPECT_EQ(v.index, index) << n;
    };
    for (const std::uint32_t n : {1U, 33U, 100U, 199U, 500U, 999U, 5221U, 5328U, 7001U})
        is(n, mill, FanucSystem::storage);
    is(1000, mill, FanucSystem::unknown);
    is(2001, mill, FanucSystem::unknown);
    is(3000, mill, FanucSystem::alarm);
    is(3001, mill, FanucSystem::timer);
    is(3006, mill, FanucSystem::stop);
    is(5003, mill, FanucSystem::position, 3);
    is(5002, lathe(GSystem::a), FanucSystem::position, 3);  // the second axis of a lathe is Z
    is(5021, mill, FanucSystem::machine, 1);
    is(5062, mill, FanucSystem::probed, 2);
    is(4003, mill, FanucSystem::group, static_cast<int>(FanucGroup::distance));
    is(4002, mill, FanucSystem::group, static_cast<int>(FanucGroup::plane));
    is(4002, lathe(GSystem::a), FanucSystem::group, static_cast<int>(FanucGroup::surface_speed));
    is(4119, mill, FanucSystem::speed);
    is(10100, haas, FanucSystem::storage);
    is(10100, mill, FanucSystem::unknown);
}

TEST(FanucTables, TraitsOfTheirMachines) {
    EXPECT_EQ(fanuc_traits(mill).argument_parameters, 33U);
    EXPECT_TRUE(fanuc_traits(lathe(GSystem::a)).canned.empty());
    for (const FanucControl& c : {mill, haas})
        for (const program::CannedCycle& cycle : fanuc_traits(c).canned) {
            const FanucG* g = find_fanuc_g(cycle.number, c);
            ASSERT_NE(g, nullptr) << cycle.name;
            EXPECT_EQ(g->special, FanucSpecial::canned) << cycle.name;
        }
}

}  // namespace obrys::dialect::rs274
