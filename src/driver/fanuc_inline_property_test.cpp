/// What a word means follows from the blocks that were run before it, by whichever way the run came: a program with
/// subprograms, jumps, loops and conditions runs as the one in which all blocks stand in the order of the run.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "driver/fanuc_testing.hpp"

namespace obrys::driver {
namespace {

using Blocks = std::vector<std::string>;

const Blocks mill_blocks{
    "G0 X10. Y20.", "G1 X15. Y5. F100.",  "G1 X40. Y25.",     "G2 X30. Y10. R40. F50.", "X10. ,C2.",
    "Y12.",         "X25. ,R1.",          "X30. Y30.",        "X30. Y60.",              "G81 X5. Y5. Z-5. R2. F100.",
    "X7. K3",       "G82 Z-3. R1. P500",  "X8. P200",         "G80",                    "G16",
    "G15",          "G90",                "G91",              "G68 X1. Y2. R30.",       "G69",
    "G51 X1. Y1. Z0 P2.", "G50",          "G51.1 X3.",        "G51.1 Y4.",              "G50.1 X0",
    "G50.1",        "G0 G53 Z0.",         "G53 X1.",          "G95",                    "G94",
    "F20",          "F150",               "X3000",            "G18",                    "G17",
    "M29",          "G84 Z-4. R1. F100.", "G98",              "G99",                    "G4 P100",
    "G52 X5.",      "G10 L2 P1 X1. Y1.",  "G33 Z-10. F2.",    "Z-12.",                  "G65 P9 A1. F20",
    "G87 Z-1. R-5. Q1. F50.",             "R3.",              "G92 X1.",                "G54",
    "Z5.",          "G1 Z-1. ,A30.",      "G40",              "S500 M3",                "X11. /Y9."};
const Blocks lathe_blocks{
    "G0 X60. Z5.",      "G1 X58. Z-2. F0.2", "Z-20. C2.",         "X64.",        "X70. R1.",
    "X30. K1.",         "Z-40. I2.",         "G90 X56. Z-20. F0.1", "X54.",      "X52. R-1.",
    "G92 X29. Z-20. F2.", "X28.",            "G94 X20. Z-1. F0.2", "Z-2.",       "G98",
    "G99",              "F120",              "F20",               "G4 X1.",      "G96 S100",
    "G97 S500",         "U-2. W-3.",         "G83 Z-10. R-2. F0.1", "C90.",      "C180. K2",
    "G80",              "G1 Z-5. ,C2.",      "X66. A30.",         "#1=101",      "T#1",
    "G32 Z-10. F2.",    "Z-15.",             "G28 U0 W0",         "G0 G53 Z0",   "G50 S2000",
    "G84 Z-8. R-2. F1.", "H30.",             "G12.1",             "G13.1",       "G1 C10. X20.",
    "G74 R1.",          "G74 Z-10. Q3000 F0.1", "G76 X28. Z-10. P1000 Q300 F1.5"};

/// Two programs that are to run alike.
struct Pair {
    std::string main, subs, inlined;
    int number = 100;  ///< of the next block or program
};

std::string any_block(const Blocks& from) { return *rc::gen::elementOf(from) + "\n"; }

void add_item(Pair& p, std::string& text, const Blocks& from, int depth, bool in_loop);

void add_items(Pair& p, std::string& text, const Blocks& from, int depth, bool in_loop) {
    const int n = *rc::gen::inRange(1, 5);
    for (int i = 0; i < n; ++i) add_item(p, text, from, depth, in_loop);
}

void add_call(Pair& p, std::string& text, const Blocks& from, int depth) {
    const std::string name = std::to_string(++p.number);
    text += "M98 P" + name + "\n";
    std::string sub = "O" + name + "\n";
    add_items(p, sub, from, depth + 1, false);
    p.subs += sub + "M99\n";
}

void add_loop(Pair& p, std::string& text, const Blocks& from, int depth) {
    const std::string counter = "#" + std::to_string(20 + depth);
    text += counter + "=0\nWHILE [" + counter + " LT 2] DO 1\n";
    const std::size_t at = p.inlined.size();
    add_items(p, text, from, depth + 1, true);
    text += counter + "=" + counter + "+1\nEND 1\n";
    p.inlined += p.inlined.substr(at);
}

void add_item(Pair& p, std::string& text, const Blocks& from, int depth, bool in_loop) {
    const int kind = *rc::gen::inRange(0, depth < 3 ? 10 : 8);
    const std::string block = any_block(from), other = any_block(from);
    if (kind >= 9 && !in_loop) return add_loop(p, text, from, depth);
    if (kind >= 8) return add_call(p, text, from, depth);
    if (kind == 7) {  // past blocks that are not run
        const std::string n = std::to_string(++p.number);
        text += "GOTO " + n + "\n" + other + any_block(from) + "N" + n + " " + block;
    } else if (kind == 6) {
        text += "IF [1 EQ 0] THEN " + (other[0] == '#' ? "#2=1\n" : other) + block;
    } else if (kind == 5) {
        text += "IF [1 EQ 1] THEN " + block;
    } else {
        text += block;
    }
    p.inlined += block;
}


std::string stream_of(const testing::Ran& r) {
    std::string out;
    for (const cl::Record& record : r.records) {
        const std::string line = cl::to_text(record);
        if (line.starts_with("call ") || line.starts_with("part-end") || line.starts_with("repetition")) continue;
        out += line.substr(0, line.find(" @")) + "\n";
    }
    return out;
}

void alike(const Blocks& from, dialect::rs274::FanucMachine machine, bool haas) {
    Pair p;
    std::string text;
    add_items(p, text, from, 0, false);
    add_items(p, text, from, 0, false);
    const std::string head = "%\nO1\nG21\nG54\n", macro = "O9\nG1 X#1 F#9\nM99\n";
    // Whether C is an axis is a question to the whole text, which is not the same here.
    const bool c_axis = *rc::gen::arbitrary<bool>();
    const read::rs274::FanucOptions options{.machine = machine, .c_axis = c_axis, .whole_numbers_known = true};
    const std::string one = head + text + "G0 X99. Z99.\nM30\n" + p.subs + macro + "%\n";
    const std::string two = head + p.inlined + "G0 X99. Z99.\nM30\n" + macro + "%\n";
    const testing::Ran ran = testing::run(one, options, haas), straight = testing::run(two, options, haas);
    RC_LOG() << one << "--- as\n" << two;
    RC_LOG() << "--- " << ran.messages << "--- as\n" << straight.messages;
    RC_ASSERT(stream_of(ran) == stream_of(straight));
    RC_ASSERT(ran.ending == straight.ending);
}

}  // namespace

RC_GTEST_PROP(FanucInline, Mill, ()) { alike(mill_blocks, dialect::rs274::FanucMachine::mill, false); }
RC_GTEST_PROP(FanucInline, Lathe, ()) { alike(lathe_blocks, dialect::rs274::FanucMachine::lathe, false); }
RC_GTEST_PROP(FanucInline, HaasMill, ()) { alike(mill_blocks, dialect::rs274::FanucMachine::mill, true); }
RC_GTEST_PROP(FanucInline, HaasLathe, ()) { alike(lathe_blocks, dialect::rs274::FanucMachine::lathe, true); }

}  // namespace obrys::driver
