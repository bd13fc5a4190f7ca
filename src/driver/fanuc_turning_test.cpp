/// Multiple repetitive cycles of FANUC and Haas lathes, from text to stream. All numbers expected here were computed by
/// hand from the contour, the allowances and the depth of cut.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cl/totals.hpp"
#include "driver/fanuc_testing.hpp"

namespace obrys::driver {
namespace {

using testing::Ran;

constexpr read::rs274::FanucOptions on_lathe{.machine = dialect::rs274::FanucMachine::lathe};

Ran turn(const std::string& lines, const read::rs274::FanucOptions& options = on_lathe, bool haas = false) {
    return testing::run("%\nO1\n" + lines + "\nM30\n%\n", options, haas);
}

/// "r X Z" rapid, "f X Z" feed, "a X Z I K" arc with its centre, "t X Z" thread; radius, three decimals; "G71 {" … "}".
std::string path(const Ran& r) {
    std::string out;
    const auto put = [&](const char* kind, const geom::Vec3& p) {
        out += std::string(kind) + " " + base::fixed(p.x, 3) + " " + base::fixed(p.z, 3);
    };
    for (const cl::Record& record : r.records) {
        if (const auto* l = std::get_if<cl::Linear>(&record.step))
            put(l->rapid ? "r" : "f", l->to);
        else if (const auto* t = std::get_if<cl::Thread>(&record.step))
            put("t", t->to);
        else if (const auto* a = std::get_if<cl::Arc>(&record.step)) {
            put("a", a->to);
            out += " " + base::fixed(a->centre.x, 3) + " " + base::fixed(a->centre.z, 3);
        } else if (const auto* b = std::get_if<cl::CycleBegin>(&record.step))
            out += b->cycle->name + " {";
        else if (std::holds_alternative<cl::CycleEnd>(record.step))
            out += "}";
        else
            continue;
        out += "\n";
    }
    return out;
}

/// Contour with a cylinder, a taper of 1:2, a quarter arc of 5 mm and a face; allowances 0.2 mm and 0.1 mm.
const std::string shaft = "N10 G0 X20.\nG1 Z-10. F0.1\nX30. Z-20.\nG2 X40. Z-25. R5.\nN20 G1 X52.\n";
/// Cuts at radius 22.2, 18.2, 14.2; the fourth would lie at 10.2, where the contour begins. At 18.2 the arc about
/// (20.2, -19.9) is 2 mm above its start: Z -19.9 - sqrt(25 - 4) = -24.483; at 14.2 the taper: -9.9 - 2 * 4 = -17.9.
const std::string shaft_roughed =
    "r 26.200 2.100\n"
    "r 22.200 2.100\nf 22.200 -24.900\nr 23.200 -23.900\nr 23.200 2.100\n"
    "r 18.200 2.100\nf 18.200 -24.483\nr 19.200 -23.483\nr 19.200 2.100\n"
    "r 14.200 2.100\nf 14.200 -17.900\nr 15.200 -16.900\nr 15.200 2.100\n"
    "r 10.200 2.100\nf 10.200 -9.900\nf 15.200 -19.900\na 20.200 -24.900 20.200 -19.900\nf 26.200 -24.900\n"
    "r 26.200 -24.900\nr 26.000 2.000\n";
const std::string shaft_finished =
    "r 10.000 2.000\nf 10.000 -10.000\nf 15.000 -20.000\na 20.000 -25.000 20.000 -20.000\nf 26.000 -25.000\n"
    "r 26.000 2.000\n";

}  // namespace

TEST(FanucTurning, StockRemovalAndFinishing) {
    const Ran r = turn("G21\nG0 X52. Z2.\nG71 U4. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\n" + shaft + "G70 P10 Q20\nG0 X60.");
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(path(r),
              "r 26.000 2.000\nG71 {\n" + shaft_roughed + "}\nG70 {\n" + shaft_finished + "}\nr 30.000 2.000\n");
}

/// The numbers of the codes in systems B and C; there G90 is a word of its own.
TEST(FanucTurning, SystemsBAndC) {
    auto options = on_lathe;
    const std::string wanted =
        "r 26.000 2.000\n{\n" + shaft_roughed + "}\n{\n" + shaft_finished + "}\nr 30.000 2.000\n";
    const auto without_names = [](std::string s) {
        for (std::size_t at; (at = s.find('G')) != std::string::npos;) s.erase(at, 4);
        return s;
    };
    options.system = dialect::rs274::GSystem::b;
    Ran r = turn("G21 G90\nG0 X52. Z2.\nG71 U4. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\n" + shaft + "G70 P10 Q20\nG0 X60.",
                 options);
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(without_names(path(r)), wanted);
    options.system = dialect::rs274::GSystem::c;
    r = turn("G71 G90\nG0 X52. Z2.\nG73 U4. R1.\nG73 P10 Q20 U0.4 W0.1 F0.3\n" + shaft + "G72 P10 Q20\nG0 X60.",
             options);
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(without_names(path(r)), wanted);
}

TEST(FanucTurning, OneBlock) {
    const std::string end = "G70 P10 Q20\nG0 X60.";
    // D counts increments whatever other numbers do; the escape is not in the block.
    Ran r = turn("G21\nG0 X52. Z2.\nG71 P10 Q20 U0.4 W0.1 D4000 F0.3\n" + shaft + end);
    EXPECT_EQ(r.messages, "G71: the escape is not programmed: 0.5 mm is taken for what parameter 5133 holds\n");
    EXPECT_NE(path(r).find("f 18.200 -24.483\nr 18.700 -23.983\nr 18.700 2.100\n"), std::string::npos) << path(r);
    // What an earlier first block said stays with the control, for G72 too.
    r = turn("G21\nG71 R1.\nG0 X52. Z2.\nG71 P10 Q20 U0.4 W0.1 D4000 F0.3\n" + shaft + end);
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(path(r),
              "r 26.000 2.000\nG71 {\n" + shaft_roughed + "}\nG70 {\n" + shaft_finished + "}\nr 30.000 2.000\n");
}

/// I and K of a Haas: the cuts leave 0.5 mm and 0.3 mm more, which the last pass takes: cuts at 22.2, 18.2, 14.2 end
/// at -24.9 + 0.3, at -19.6 - sqrt(25 - 2.5^2) = -23.930 and at -9.6 - 2 * 3.5 = -16.6.
TEST(FanucTurning, HaasLeavesAPassOfItsOwn) {
    const Ran r = turn("G21\nG0 X52. Z2.\nG71 P10 Q20 U0.4 W0.1 D4. I0.5 K0.3 F0.3\n" + shaft, on_lathe, true);
    EXPECT_NE(r.messages.find("0.05 inch, taken for setting 73"), std::string::npos) << r.messages;
    std::string ends;
    const std::string all = path(r);
    for (std::size_t at = all.find("f "); at != std::string::npos; at = all.find("\nf ", at)) {
        at = at == 0 ? 0 : at + (all[at] == '\n' ? 1 : 0);
        ends += all.substr(at, all.find('\n', at) - at) + ";";
    }
    EXPECT_EQ(ends,
              "f 22.200 -24.600;f 18.200 -23.930;f 14.200 -16.600;f 10.200 -9.900;f 15.200 -19.900;f 26.200 -24.900;");
}

/// Cuts across at Z -2 + 2.1 …: 0.1, -1.9 end at radius 15.2, -5.9 on the slope from (15.2, -4.9) to (20.2, -9.9).
TEST(FanucTurning, StockRemovalAcross) {
    const Ran r =
        turn("G21\nG0 X52. Z2.\nG72 W4. R0.5\nG72 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 Z-10.\nG1 X40.\nX30. Z-5.\nN20 Z2.");
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(path(r),
              "r 26.000 2.000\nG72 {\nr 26.200 2.100\n"
              "r 26.200 -1.900\nf 15.200 -1.900\nr 15.700 -1.400\nr 26.200 -1.400\n"
              "r 26.200 -5.900\nf 16.200 -5.900\nr 16.700 -5.400\nr 26.200 -5.400\n"
              "r 26.200 -9.900\nf 20.200 -9.900\nf 15.200 -4.900\nf 15.200 2.100\nr 15.200 2.100\nr 26.000 2.000\n}\n");
}

/// Three passes: 3 mm and 2 mm away, half of that, none; each with the allowances.
TEST(FanucTurning, PatternRepeating) {
    const std::string contour = "N30 G0 X20. Z1.\nG1 Z-10.\nN40 X30. Z-15.";
    const std::string wanted =
        "r 26.000 2.000\nG73 {\n"
        "r 29.200 4.100\nr 13.200 3.100\nf 13.200 -7.900\nf 18.200 -12.900\n"
        "r 27.700 3.100\nr 11.700 2.100\nf 11.700 -8.900\nf 16.700 -13.900\n"
        "r 26.200 2.100\nr 10.200 1.100\nf 10.200 -9.900\nf 15.200 -14.900\nr 26.000 2.000\n}\n";
    Ran r = turn("G21\nG0 X52. Z2.\nG73 U3. W2. R3\nG73 P30 Q40 U0.4 W0.1 F0.3\n" + contour);
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(path(r), wanted);
    r = turn("G21\nG0 X52. Z2.\nG73 P30 Q40 I3. K2. U0.4 W0.1 D3 F0.3\n" + contour);
    EXPECT_EQ(path(r), wanted) << r.messages;
}

/// Pecks of 5 mm from Z 2 to -10, steps of 4 mm from radius 26 to 20: at 26, 22 and 20.
TEST(FanucTurning, PecksInTheFace) {
    const auto column = [](const std::string& x) {
        return "f " + x + " -3.000\nr " + x + " -2.500\nf " + x + " -8.000\nr " + x + " -7.500\nf " + x +
               " -10.000\nr " + x + " 2.000\n";
    };
    const std::string wanted = "r 26.000 2.000\nG74 {\n" + column("26.000") + "r 22.000 2.000\n" + column("22.000") +
                               "r 20.000 2.000\n" + column("20.000") + "r 26.000 2.000\n}\n";
    Ran r = turn("G21\nG0 X52. Z2.\nG74 R0.5\nG74 X40. Z-10. P4000 Q5000 F0.1");
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(path(r), wanted);
    r = turn("G21\nG0 X52. Z2.\nG74 R0.5\nG74 U-12. W-12. I4. K5. F0.1");
    EXPECT_EQ(path(r), wanted) << r.messages;
    r = turn("G21\nG0 X0 Z2.\nG74 R1.\nG74 Z-6. Q5000 F0.1");
    EXPECT_EQ(path(r), "r 0.000 2.000\nG74 {\nf 0.000 -3.000\nr 0.000 -2.000\nf 0.000 -6.000\nr 0.000 2.000\n}\n");
}

/// Relief at the bottom (R of the second block) from the second peck on, away from the direction of the steps.
TEST(FanucTurning, Grooves) {
    const std::string wanted =
        "r 26.000 -10.000\nG75 {\n"
        "f 23.000 -10.000\nr 23.500 -10.000\nf 20.000 -10.000\nr 26.000 -10.000\n"
        "r 26.000 -13.000\nf 23.000 -13.000\nr 23.500 -13.000\nf 20.000 -13.000\nr 20.000 -12.900\nr 26.000 -12.900\n"
        "r 26.000 -14.000\nf 23.000 -14.000\nr 23.500 -14.000\nf 20.000 -14.000\nr 20.000 -13.900\nr 26.000 -13.900\n"
        "r 26.000 -10.000\n}\n";
    Ran r = turn("G21\nG0 X52. Z-10.\nG75 R0.5\nG75 X40. Z-14. P3000 Q3000 R0.1 F0.1");
    EXPECT_EQ(path(r), wanted) << r.messages;
    r = turn("G21\nG0 X52. Z-10.\nG75 R0.5\nG75 X40. Z-14. I3. K3. D100 F0.1");
    EXPECT_EQ(path(r), wanted) << r.messages;
}

namespace {

/// Radius and Z of the starts, and radius of the ends, of all threads.
struct Pass {
    double start_z = 0, radius = 0;
};
std::vector<Pass> passes(const Ran& r) {
    std::vector<Pass> all;
    geom::Vec3 at;
    for (const cl::Record& record : r.records) {
        if (std::holds_alternative<cl::Thread>(record.step)) all.push_back({at.z, at.x});
        at = cl::position_after(at, record.step);
    }
    return all;
}

}  // namespace

/// Height 1 mm, first cut 0.4: 0.4 sqrt n is 0.4, 0.566, 0.693, 0.8; the fifth, 0.894, would be less than 0.1 mm more:
/// 0.9. 0.95 leaves the allowance, two passes at full depth. Infeed along 30 degrees. No run-out.
TEST(FanucTurning, ThreadInPasses) {
    const Ran r = turn("G21\nM3 S500\nG0 X22. Z5.\nG76 P020060 Q100 R0.05\nG76 X18. Z-20. P1000 Q400 F1.5");
    EXPECT_EQ(r.messages, "G76: all passes end at the same place; their starts are shifted by the infeed angle\n");
    const std::vector<double> depths{0.4, 0.4 * std::sqrt(2.0), 0.4 * std::sqrt(3.0), 0.8, 0.9, 0.95, 1, 1};
    const auto all = passes(r);
    ASSERT_EQ(all.size(), depths.size()) << path(r);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        EXPECT_NEAR(all[i].radius, 10 - depths[i], 1e-9) << i;
        EXPECT_NEAR(all[i].start_z, 5 - depths[i] / std::sqrt(3.0), 1e-9) << i;
    }
}

/// Run-out of 1.0 lead: at Z -20 + 1.5 the tool leaves at 45 degrees. Taper R-1: the start lies 1 mm deeper.
TEST(FanucTurning, ThreadWithRunOutAndTaper) {
    Ran r = turn("G21\nM3 S500\nG0 X24. Z5.\nG76 P011000 Q100 R0\nG76 X18. Z-20. P1000 Q1000 F1.5");
    EXPECT_EQ(
        path(r),
        "r 12.000 5.000\nG76 {\nr 12.000 5.000\nr 9.000 5.000\nt 9.000 -18.500\nt 10.500 -20.000\nr 12.000 -20.000\n"
        "r 12.000 5.000\n}\n")
        << r.messages;
    r = turn("G21\nM3 S500\nG0 X24. Z5.\nG76 P010000 Q100 R0\nG76 X18. Z-20. R-1. P1000 Q1000 F1.5");
    EXPECT_EQ(
        path(r),
        "r 12.000 5.000\nG76 {\nr 12.000 5.000\nr 8.000 5.000\nt 9.000 -20.000\nr 12.000 -20.000\nr 12.000 5.000\n}\n")
        << r.messages;
}

/// One block: P says the method. 3: equal depths on one flank, 4: on both, where even passes start on the other side
/// of the last one. tan 30 degrees = 0.57735.
TEST(FanucTurning, ThreadInOneBlock) {
    const std::string before = "G21\nM3 S500\nG0 X24. Z5.\nG76 X18. Z-20. K1. D400 A60 F1.5";
    const double flank = 1 / std::sqrt(3.0);
    auto all = passes(turn(before + " P3"));
    ASSERT_EQ(all.size(), 3u);
    EXPECT_NEAR(all[0].radius, 9.6, 1e-9);
    EXPECT_NEAR(all[1].radius, 9.2, 1e-9);
    EXPECT_NEAR(all[1].start_z, 5 - 0.8 * flank, 1e-9);
    all = passes(turn(before + " P4"));
    ASSERT_EQ(all.size(), 3u);
    EXPECT_NEAR(all[0].start_z, 5 - 0.4 * flank, 1e-9);
    EXPECT_NEAR(all[1].start_z, 5 - 1.2 * flank, 1e-9);
    EXPECT_NEAR(all[2].start_z, 5 - 1.0 * flank, 1e-9);
    EXPECT_NE(turn(before + " P7").messages.find("the method of infeed must be a whole number from 1 to 4"),
              std::string::npos);
}

TEST(FanucTurning, FirstBlockSaysTheType) {
    const std::string pocket = "G1 Z-10.\nX16. Z-15.\nZ-20.\nN20 X52.";
    Ran r = turn("G21\nG0 X52. Z2.\nG71 U4. R1.\nG71 P10 Q20 F0.3\nN10 G0 X20.\n" + pocket);
    EXPECT_EQ(r.ending, interp::Ending::alarm);
    EXPECT_NE(r.messages.find("G71: the contour has a pocket here"), std::string::npos) << r.messages;
    r = turn("G21\nG0 X52. Z2.\nG71 U4. R1.\nG71 P10 Q20 F0.3\nN10 G0 X20. W0\n" + pocket);
    EXPECT_EQ(r.messages, "G71: the order of the cuts in pockets\n");
    EXPECT_NE(path(r).find("f 22.000 -20.000"), std::string::npos) << "the first cut lies one infeed below the start";
    EXPECT_EQ(path(r).find("f 26.000 -20.000\nr"), path(r).rfind("f 26.000 -20.000\nr")) << path(r);
    EXPECT_NE(path(r).find("f 8.000 -20.000"), std::string::npos) << "the pocket's bottom";
    r = turn("G21\nG0 X52. Z2.\nG71 P10 Q20 D4. R1 F0.3\nN10 G0 X20.\n" + pocket, on_lathe, true);
    EXPECT_NE(path(r).find("f 8.000 -20.000"), std::string::npos) << "Haas: R1 says it" << r.messages;
}

/// Chamfers, roundings, macro variables and incremental words are parts of the contour.
TEST(FanucTurning, ContourWithCornersAndVariables) {
    const Ran r = turn(
        "G21\n#1=20.\nG0 X52. Z2.\nG71 U10. R1.\nG71 P10 Q20 F0.3\nN10 G0 X#1\nG1 W-12. ,R2.\nU10. ,C1.\n"
        "Z-20.\nN20 X52.\nG70 P10 Q20");
    EXPECT_EQ(r.messages, "");
    // The rounding is concave: about (12, -8); the chamfer's legs are 1 mm.
    const std::string contour =
        "f 10.000 -8.000\na 12.000 -10.000 12.000 -8.000\nf 14.000 -10.000\nf 15.000 -11.000\nf 15.000 -20.000\n"
        "f 26.000 -20.000\n";
    const std::string all = path(r);
    const std::size_t first = all.find(contour);
    ASSERT_NE(first, std::string::npos) << all;
    EXPECT_NE(all.find(contour, first + 1), std::string::npos) << "finished as it was roughed:\n" << all;
}

/// F, S, T of the contour hold in G70 alone; compensation too.
TEST(FanucTurning, WordsOfTheContourActInFinishing) {
    const Ran r = turn(
        "G21\nG0 X52. Z2.\nG71 U8. R1.\nG71 P10 Q20 F0.3 S300 M3\nN10 G42 G0 X20. S900\nG1 Z-10. F0.1\n"
        "N20 G40 X52.\nG0 X60.\nG70 P10 Q20");
    EXPECT_NE(r.messages.find("tool nose radius compensation does not act in this cycle"), std::string::npos);
    std::string order;
    for (const cl::Record& record : r.records) {
        if (const auto* b = std::get_if<cl::CycleBegin>(&record.step)) order += b->cycle->name + " ";
        if (const auto* f = std::get_if<cl::Feed>(&record.step)) order += "F" + base::shortest(f->value) + " ";
        if (const auto* s = std::get_if<cl::Spindle>(&record.step)) order += "S" + base::shortest(s->speed) + " ";
        if (std::holds_alternative<cl::CycleEnd>(record.step)) order += "} ";
    }
    EXPECT_EQ(order, "S300 F0.3 G71 } G70 S900 F0.1 } ");
}

/// The contour that stands behind the cycle is left out, one before it or behind the program's end is not gone to.
TEST(FanucTurning, WhereTheRunGoesOn) {
    const std::string after = "G0 X80.";
    Ran r = turn("G21\nG0 X52. Z2.\nG71 U30. R1.\nG71 P10 Q20 F0.3\nN10 G0 X20.\nN20 G1 Z-5.\n" + after);
    EXPECT_EQ(path(r),
              "r 26.000 2.000\nG71 {\nr 26.000 2.000\nr 10.000 2.000\nf 10.000 -5.000\nr 26.000 -5.000\nr 26.000 "
              "2.000\n}\nr 40.000 2.000\n")
        << r.messages;
    r = turn("G21\nG0 X52. Z2.\nG71 U30. R1.\nG71 P10 Q20 F0.3\n" + after + "\nM30\nN10 G0 X20.\nN20 G1 Z-5.");
    EXPECT_NE(path(r).find("}\nr 40.000 2.000\n"), std::string::npos) << path(r);
    r = turn("G21\nG0 X52. Z2.\nGOTO 5\nN10 G0 X20.\nN20 G1 Z-5.\nN5 G71 U30. R1.\nG71 P10 Q20 F0.3\n" + after);
    EXPECT_NE(path(r).find("}\nr 40.000 2.000\n"), std::string::npos) << path(r) << r.messages;
    r = turn("G21\nG0 X52. Z2.\nG71 U30. R1.\nG71 P10 Q20 F0.3\nM8\nN10 G0 X20.\nN20 G1 Z-5.\n" + after);
    EXPECT_NE(r.messages.find("the blocks between the cycle and the contour are left out"), std::string::npos);
}

TEST(FanucTurning, RefusedAsTheControlDoes) {
    const auto alarm = [](const std::string& cycle, const std::string& contour = "N10 G0 X20.\nG1 Z-5.\nN20 X52.") {
        const Ran r = turn("G21\nG0 X52. Z2.\n" + cycle + "\n" + contour);
        EXPECT_EQ(r.ending, interp::Ending::alarm) << cycle << r.messages;
        const std::string all = r.messages.substr(0, r.messages.size() - 1);  // the alarm is the last one
        return all.substr(all.rfind('\n') + 1);
    };
    const std::string u = "G71 U2. R1.\n", call = u + "G71 P10 Q20 F0.3";
    EXPECT_EQ(alarm(u + "G71 P10 F0.3"), "G71: the number of the contour's last block (Q) is missing");
    EXPECT_EQ(alarm("G70"), "G70: the number of the contour's first block (P) is missing");
    EXPECT_EQ(alarm(u + "G71 P11 Q20 F0.3"), "G71: there is no block N11 in this program");
    EXPECT_EQ(alarm(u + "G71 P20 Q10 F0.3"), "G71: the contour's last block stands before its first one");
    EXPECT_EQ(alarm("G71 U0 R1.\nG71 P10 Q20 F0.3"), "G71: the depth of cut must be greater than 0");
    EXPECT_EQ(alarm(call, "N10 G3 X20. Z-3. R20.\nN20 G1 Z-5."),
              "G71: the first block of the contour is no straight move");
    EXPECT_EQ(alarm(call, "N10 S500\nG0 X20.\nN20 G1 Z-5."),
              "G71: the first block of the contour does not move X, the axis of the infeed");
    EXPECT_EQ(alarm(call, "N10 G0 Z1.\nX20.\nN20 G1 Z-5."),
              "G71: the first block of the contour does not move X, the axis of the infeed");
    EXPECT_EQ(alarm(call, "N10 G0 X20.\nG1 Z-5.\nX30. Z-2.\nN20 X52."),
              "G71: the contour turns back here: along the cuts it must run in one direction");
    EXPECT_EQ(alarm(call, "N10 G0 X20.\nM98 P2\nN20 X52."), "G71: this cannot stand in the blocks of the contour");
    EXPECT_EQ(alarm(call, "N10 G0 X20.\nG28 U0\nN20 X52."), "G71: this cannot stand in the blocks of the contour");
    EXPECT_EQ(alarm(call, "N10 G0 X20.\nG1 Z-5.\nN20 X52. ,C1."), "G71: the contour ends with a chamfer or rounding");
    EXPECT_EQ(alarm("G73 U2. R0\nG73 P10 Q20"), "G73: the number of passes must be a whole number from 1 to 10000");
    EXPECT_EQ(alarm("G76 X18. Z-20. P0 Q400 F1.5"), "G76: depth of the thread must be greater than 0");
    EXPECT_EQ(alarm("G75 X40. Z-3. P2000 Q0"), "G75: the step must not be 0 where the other axis moves");
}

TEST(FanucTurning, ALeadFromBeforeTheProgramIsNotKnown) {  // F is modal: the control has the last one it was given
    const Ran r = turn("G21\nG0 X52. Z2.\nG76 X18. Z-20. P1000 Q400");
    EXPECT_NE(r.messages.find("no F stands before it, and the control keeps the last one it had"), std::string::npos);
    EXPECT_NE(r.messages.find("G76 is not run: its path is not known here"), std::string::npos) << r.messages;
}

}  // namespace obrys::driver
