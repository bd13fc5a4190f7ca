/// FANUC and Haas programs from text to stream.

#include <gtest/gtest.h>

#include <algorithm>

#include "driver/fanuc_testing.hpp"

namespace obrys::driver {
namespace {

using testing::Ran;
using testing::run;

std::string on_mill(const std::string& lines) {
    const Ran r = run("%\nO1\nG21 G90 G17\nG1 X0 Y0 Z0 F100\n" + lines + "\nM30\n%\n",
                      {.machine = dialect::rs274::FanucMachine::mill});
    return r.messages + r.moves.substr(r.moves.find('\n') + 1);
}

}  // namespace

TEST(FanucRun, EmptyParameters) {
    EXPECT_EQ(on_mill("X#1 Y5."), "linear 0 5 0\n") << "a word with an empty parameter is left out";
    EXPECT_EQ(on_mill("#1=0\nX#1 Y5.\nIF [#1 EQ #0] THEN #1=7\nX#1"), "linear 0 5 0\nlinear 0 5 0\n");
    EXPECT_EQ(on_mill("IF [#1 EQ #0] THEN #1=7\nX#1"), "linear 7 0 0\n");
    EXPECT_EQ(on_mill("IF [#1 EQ 0] THEN #2=7\nX#2 Y1."), "linear 0 1 0\n") << "empty is not 0";
    EXPECT_EQ(on_mill("#1=3\n#1=#0\nX#1 Y1."), "linear 0 1 0\n");
    EXPECT_EQ(on_mill("X[#1+1]"), "linear 1 0 0\n") << "it counts as 0 in an expression";
}

TEST(FanucRun, MacrosHaveTheirOwnParameters) {
    EXPECT_EQ(
        on_mill(
            "#1=5\nG65 P100 A1. X2. L2\nX#1\nM98 P200\nX#2\nM30\nO100\nX#1 Y#24 Z#2\n#1=#1+1\nM99\nO200\n#2=9\nM99"),
        "linear 1 2 0\nlinear 2 2 0\nlinear 5 2 0\nlinear 9 2 0\n");
}

TEST(FanucRun, LoopsAndJumps) {
    EXPECT_EQ(on_mill("#1=2\nWHILE [#1 GT 0] DO 1\nX#1\n#1=#1-1\nEND 1\nGOTO 20\nX99.\nN20 Y#5041"),
              "linear 2 0 0\nlinear 1 0 0\nlinear 1 1 0\n");
    const Ran r = run("%\nO1\nG21\n#3000=5 (TOO FAR)\nM30\n%\n");
    EXPECT_EQ(r.ending, interp::Ending::alarm);
    EXPECT_NE(r.messages.find("3005 TOO FAR"), std::string::npos) << r.messages;
}

TEST(FanucRun, HoleCycles) {
    EXPECT_EQ(on_mill("G0 Z10.\nG99 G81 X1. Y2. Z-3. R1. F50\nG98 X4.\nG80"),
              "rapid 0 0 10\nrapid 1 2 10\nrapid 1 2 1\nlinear 1 2 -3\nrapid 1 2 1\nrapid 4 2 1\nlinear 4 2 -3\nrapid "
              "4 2 10\n");
}

TEST(FanucRun, TransformationsAboutTheirCentres) {
    EXPECT_EQ(on_mill("G51 X1. Y0 Z0 P2000\nX3. Y1.\nG50\nX3."), "linear 5 2 0\nlinear 3 2 0\n");
    EXPECT_EQ(on_mill("G51.1 X5.\nX1. Y1.\nG50.1 X0\nX1."), "linear 9 1 0\nlinear 1 1 0\n");
    const std::string turned = on_mill("G68 X1. Y0 R90.\nX3. Y0\nG69\nX0 Y0");
    EXPECT_EQ(turned, "linear 1 2 0\nlinear 0 0 0\n");
}

TEST(FanucRun, SingleTurningCycles) {
    const Ran r = run("%\nO1\nG21\nG0 X52. Z2.\nG90 X48. Z-30. F0.25\nX44.\nG94 X20. Z-1.\nG0 X60.\nM30\n%\n",
                      {.machine = dialect::rs274::FanucMachine::lathe});
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(r.moves,
              "rapid 26 0 2\n"
              "rapid 24 0 2\nlinear 24 0 -30\nlinear 26 0 -30\nrapid 26 0 2\n"
              "rapid 22 0 2\nlinear 22 0 -30\nlinear 26 0 -30\nrapid 26 0 2\n"
              "rapid 26 0 -1\nlinear 10 0 -1\nlinear 10 0 2\nrapid 26 0 2\n"
              "rapid 30 0 2\n");
}

TEST(FanucRun, LocalSubprogramsOfHaas) {
    const Ran r = run("%\nO1\nG21 G91\nG1 X1. F100.\nM97 P100 L3\nM30\nN100 Y1.\nM99\n%\n",
                      {.machine = dialect::rs274::FanucMachine::mill}, true);
    EXPECT_EQ(std::count(r.moves.begin(), r.moves.end(), '\n'), 4) << r.moves << r.messages;
}

TEST(FanucRun, CoordinatesCountInIncrements) {
    EXPECT_EQ(on_mill("X1.23456"), "linear 1.235 0 0\n");
    EXPECT_EQ(on_mill("#1=12.3456\nX#1"), "linear 12.346 0 0\n") << "operator's manual, custom macro";
    EXPECT_EQ(on_mill("G91 X0.3339\nX0.3339\nX0.3339"), "linear 0.334 0 0\nlinear 0.668 0 0\nlinear 1.002 0 0\n")
        << "each block for itself";
    EXPECT_EQ(on_mill("X12.345"), "linear 12.345 0 0\n");
    const Ran inch = run("%\nO1\nG20 G90 G17\nG1 X0 Y0 Z0 F10.\nX1.00004\nM30\n%\n",
                         {.machine = dialect::rs274::FanucMachine::mill});
    EXPECT_NE(inch.moves.find("linear 25.4 0 0\n"), std::string::npos) << inch.moves;
}

}  // namespace obrys::driver
