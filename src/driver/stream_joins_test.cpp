/// Every move of a stream starts where the last one ended, whatever the program says: all golden programs, and these
/// with blocks left out, doubled, exchanged and with words of contours put in. Lines have no start of their own; arcs
/// and splines have, and the stream's verifier holds them to it.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "base/codes.hpp"
#include "cl/verify.hpp"
#include "driver/golden_cases_testing.hpp"

namespace obrys::driver {
namespace {

using testing::Case;

constexpr unsigned seed = 20261123;

/// What is wrong with the stream; nothing where it holds. `tolerance`: mm by which the control itself lets the radii of
/// an arc differ.
std::string faults(const Case& c, std::string_view control, shop::MachineKind kind, double tolerance) {
    Session s;
    if (!testing::open_case(s, c, control, kind)) return {};
    base::Diagnostics found;
    cl::VerifyOptions options;
    options.circle_tolerance = tolerance;
    cl::Verifier verifier(found, options, &s.stacks);
    interpret(s, [&](const cl::Record& r) { verifier(r); });
    std::string out;
    for (const base::Diagnostic& d : found.all()) out += base::render(d, s.sources) + "\n";
    return out;
}

struct Way {
    std::string folder;
    std::string_view control;
    shop::MachineKind kind = shop::MachineKind::mill;
    std::vector<std::string_view> words;
    int mutations = 50;  ///< of each program
    double tolerance = 0.01;
};

/// The number of streams looked at.
int hold(const Way& way) {
    std::mt19937 random(seed);
    int looked_at = 0;
    for (const Case& c : testing::golden_cases(way.folder)) {
        Case m = c;
        for (int n = 0; n <= way.mutations; ++n) {
            const std::string wrong = faults(m, way.control, way.kind, way.tolerance);
            EXPECT_EQ(wrong, "") << "seed " << seed << ", " << c.name << ", mutation " << n << " of 0:\n" << m.text;
            ++looked_at;
            m.text = testing::mutated(c.text, random, way.words);
        }
    }
    return looked_at;
}

const std::vector<std::string_view> klartext{" RL",
                                             " RR",
                                             " R0",
                                             " M97",
                                             " M98",
                                             "\nRND R2",
                                             "\nCHF 1",
                                             "\nAPPR LCT X+5 Y+5 R4 RL F100",
                                             "\nAPPR CT X+3 Y+4 CCA90 R+5 RR",
                                             "\nDEP LCT X-9 Y-9 R6",
                                             "\nDEP CT CCA90 R+5",
                                             "\nDEP LT LEN7",
                                             "\nCR X+7 Y+7 R+8 DR-",
                                             "\nSTOP",
                                             "\nL IX+5 IY+5 R0"};
const std::vector<std::string_view> iso_words{
    " G41", " G42", " G40", " G90", "\nG26 R5*", "\nG27 R4*", "\nG25 R2*", "\nG00 G40 X-9 Y-9*", "\nG02 X+7 Y+7 R8*"};
const std::vector<std::string_view> letters{
    " G41",  " G42",  " G40", "\nG1 X5 Y5 F100", "\nG2 X7 Y7 I3 J3", "\nG3 X9 Y1 I-2 J2", "\nM0", "\nG91",
    "\nG90", "\nG18", "\nG17"};

TEST(StreamJoins, OnHeidenhain) {
    EXPECT_GT(hold({"heidenhain", "heidenhain-itnc530", shop::MachineKind::mill, klartext}), 10000);
    EXPECT_GT(hold({"heidenhain", "heidenhain-itnc530", shop::MachineKind::mill, iso_words}), 10000);
}

TEST(StreamJoins, OnSinumerik) {
    EXPECT_GT(hold({"sinumerik", "sinumerik-840d", shop::MachineKind::mill, letters}), 8000);
    EXPECT_GT(hold({"sinumerik", "sinumerik-840d", shop::MachineKind::lathe, letters}), 8000);
}

TEST(StreamJoins, OnFanuc) {
    EXPECT_GT(hold({"fanuc", "fanuc", shop::MachineKind::mill, letters, 4}), 600);
    EXPECT_GT(hold({"fanuc", "fanuc", shop::MachineKind::lathe, letters, 4}), 600);
}

/// LinuxCNC runs arcs whose radii differ by 0.0283 mm as they are written (Traits::arc_tolerance).
TEST(StreamJoins, OnLinuxCnc) {
    EXPECT_GT(hold({"linuxcnc", "linuxcnc", shop::MachineKind::mill, letters, 50, 0.03}), 4000);
    EXPECT_GT(hold({"linuxcnc", "linuxcnc", shop::MachineKind::lathe, letters, 50, 0.03}), 4000);
}

}  // namespace
}  // namespace obrys::driver
