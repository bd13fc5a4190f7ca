/// A code that is not run keeps the words of its block: no other motion takes its coordinates. Every refused code of
/// every control's table is put into a block behind a straight one; nothing may go where the block says.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>

#include "cl/totals.hpp"
#include "dialect/heidenhain/g_codes.hpp"
#include "dialect/rs274/fanuc.hpp"
#include "dialect/sinumerik/tables.hpp"
#include "driver/fanuc_testing.hpp"
#include "driver/golden_cases_testing.hpp"

namespace obrys::driver {
namespace {

using dialect::rs274::FanucControl;
using dialect::rs274::FanucG;
using dialect::rs274::FanucMachine;

std::string code_name(int tenths) {
    return "G" + std::to_string(tenths / 10) + (tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "");
}

/// A move has ended at X `x`, mm.
bool goes_to(const std::vector<cl::Record>& records, double x) {
    geom::Vec3 at{NAN, NAN, NAN};
    for (const cl::Record& r : records) {
        at = cl::position_after(at, r.step);
        if (cl::is_move(r.step) && std::abs(at.x - x) < 1e-6) return true;
    }
    return false;
}

/// Codes that are not run and own the coordinates of their block. Those that hold on own the next block's, too.
void hold(const FanucG& g, int code, bool haas, bool lathe) {
    if (g.use != dialect::rs274::FanucUse::refused || g.order != dialect::rs274::Order::motion || code < 0) return;
    if (code == 131 || code == 1130) return;  // G13.1, G113: what they end was not run, and they are
    const std::string name = code_name(code);
    const std::string third = lathe ? "" : " Y71.";
    read::rs274::FanucOptions options;
    if (lathe) options.machine = FanucMachine::lathe;
    const std::string text = "%\nO1\nG21 G40\nS500 M3\nG0 X10. Z5.\nG1 X20. F100.\n" + name + " X70." + third +
                             " Z-3.\nX80. Z-4.\nG0 X10.\nM30\n%\n";
    const auto ran = testing::run(text, options, haas);
    EXPECT_NE(ran.messages, "") << name;
    const double part = lathe ? 0.5 : 1;  // X is a diameter
    EXPECT_TRUE(goes_to(ran.records, 20 * part)) << name << "\n" << ran.messages;
    EXPECT_FALSE(goes_to(ran.records, 70 * part)) << name << "\n" << ran.moves;
    const bool stays = g.modal == program::Modal::canned;
    EXPECT_FALSE(stays && goes_to(ran.records, 80 * part)) << name << "\n" << ran.moves;
}

TEST(RefusedCodes, KeepTheirCoordinatesOnFanucAndHaas) {
    for (const FanucG& g : dialect::rs274::mill_g_table()) hold(g, g.code, false, false);
    for (const FanucG& g : dialect::rs274::haas_mill_g_table()) hold(g, g.code, true, false);
    for (const FanucG& g : dialect::rs274::haas_lathe_g_table()) hold(g, g.code, true, true);
    for (const dialect::rs274::LatheG& g : dialect::rs274::lathe_g_table()) hold(g.meaning, g.a, false, true);
}

/// A hole cycle that is in the tables and not run as it stands.
TEST(RefusedCodes, AHoleCycleInOtherCoordinatesKeepsTheBlocksBehindIt) {
    const auto ran = testing::run(
        "%\nO1\nG21 G17 G40\nS500 M3\nG0 X0. Y0. Z5.\nG1 X20. F100.\nG91 G87 X50. Z-5. R-3. Q1. F80.\nX60.\nG80\n"
        "G90 G0 X10.\nM30\n%\n");
    EXPECT_FALSE(goes_to(ran.records, 70));
    EXPECT_FALSE(goes_to(ran.records, 80));
    EXPECT_TRUE(goes_to(ran.records, 10));
}

std::vector<cl::Record> run_refused(const std::string& file, const std::string& text, std::string_view control) {
    Session s;
    EXPECT_TRUE(testing::open_case(s, {file, file, text}, control, shop::MachineKind::mill));
    std::vector<cl::Record> records;
    interpret(s, [&](const cl::Record& r) { records.push_back(r); });
    EXPECT_FALSE(s.diagnostics.all().empty()) << text;
    return records;
}

TEST(RefusedCodes, KeepTheirCoordinatesOnSinumerik) {
    int looked_at = 0;
    for (int n = 0; n < 1000; ++n) {
        const auto g = dialect::sinumerik::find_g(n);
        if (!g || g->use != dialect::sinumerik::Use::unsupported_block) continue;
        const std::string text =
            "T1 D1 S500 M3\nG0 X10 Y0 Z5\nG1 X20 F100\nG" + std::to_string(n) + " X70 Y71 Z-3\nG0 X10\nM30\n";
        EXPECT_FALSE(goes_to(run_refused("A.MPF", text, "sinumerik-840d"), 70)) << text;
        ++looked_at;
    }
    EXPECT_GT(looked_at, 10);
}

TEST(RefusedCodes, KeepTheirCoordinatesOnHeidenhain) {
    int looked_at = 0;
    for (int n = 0; n < 1000; ++n) {
        const auto* g = dialect::heidenhain::find_g(n);
        if (g == nullptr || g->use != dialect::heidenhain::Use::refused || !g->block_only) continue;
        const std::string text =
            "%A G71 *\nN10 T1 G17 S500*\nN20 G00 G40 G90 X+10 Y+0 Z+5 M3*\nN30 G01 X+20 F100*\nN40 G" +
            std::to_string(n) + " X+70 Y+71 Z-3*\nN50 G00 X+10*\nN60 M30*\nN99999999 %A G71 *\n";
        EXPECT_FALSE(goes_to(run_refused("A.I", text, "heidenhain-itnc530"), 70)) << text;
        ++looked_at;
    }
    EXPECT_GT(looked_at, 5);
}

}  // namespace
}  // namespace obrys::driver
