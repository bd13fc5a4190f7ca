/// Plain blocks that are run as their like was (interp/flow/plain_block.cpp) do and say what they do and say where
/// every one of them is run with all that there is to look at: a statement without effect stands before each then,
/// behind which nothing is known of blocks that were run before.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "driver/fanuc_testing.hpp"
#include "read/rs274/read.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::driver {
namespace {

/// How a control writes what the programs are made of.
struct Writing {
    std::vector<std::string> others;  ///< blocks that change what is in force
    /// A statement without effect that goes with the block of this number.
    std::string (*nothing)(int number);
    std::string (*computed)(const std::string& number);  ///< a word's value as an expression
    std::string radius;                                  ///< how an arc's radius is written
    std::string head, end, tool_on, tool_off;
};

std::string coordinate_text() {
    const int um = *rc::gen::weightedOneOf<int>(
        {{8, rc::gen::map(rc::gen::inRange(-40, 41), [](int n) { return n * 500; })}, {1, rc::gen::just(0)}});
    return base::fixed(um / 1000.0, 3);
}

/// A block of G0 … G3, coordinates, centres and a feed. Most can be run: an arc's radius is larger than any way.
std::string any_plain_block(const Writing& w) {
    std::string block;
    const auto add = [&](const std::string& letter, const std::string& number) {
        block += letter + (*rc::gen::inRange(0, 6) == 0 ? w.computed(number) : number) + " ";
    };
    const int g = *rc::gen::weightedElement<int>({{5, -1}, {6, 1}, {2, 0}, {2, 2}, {2, 3}});
    if (g >= 0) block += "G" + std::to_string(g) + " ";
    for (const char c : {'X', 'Y', 'Z'})
        if (*rc::gen::inRange(0, 3) != 0) add({c}, coordinate_text());
    if (g >= 2) block += w.radius + "200. ";
    if (*rc::gen::inRange(0, 15) == 0) add({*rc::gen::element('I', 'J', 'K')}, coordinate_text());
    if (*rc::gen::inRange(0, 6) == 0) block += "F" + *rc::gen::element<std::string>("100.", "250.", "80.", "300.");
    if (*rc::gen::inRange(0, 60) == 0) block += "F0";
    return block.empty() ? "G1 X1." : block;
}

/// Half circles and lines that follow from one another, as contours have them.
std::string smooth_blocks() {
    std::string out;
    const int n = *rc::gen::inRange(2, 6);
    for (int i = 0; i < n; ++i)
        out += *rc::gen::element<std::string>("G91\nG1 X20.\nG2 X10. Y-10. I0. J-10.\nG1 Y-20.\nG90\n",
                                              "G91\nG1 X15.\nX5. Y1.\nG3 X10. Y10. I0. J10.\nG90\n");
    return out;
}

std::vector<std::string> any_program(const Writing& w) {
    std::vector<std::string> lines;
    const auto add = [&](const std::string& text) {
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            lines.push_back(text.substr(at, end - at));
            at = end + 1;
        }
    };
    const int n = *rc::gen::inRange(4, 30);
    for (int i = 0; i < n; ++i) switch (*rc::gen::inRange(0, 14)) {
            case 0: add(*rc::gen::elementOf(w.others)); break;
            case 1: add(w.tool_on + "\n" + smooth_blocks() + w.tool_off + "\n"); break;
            default: add(any_plain_block(w));
        }
    return lines;
}

template <class Read>
std::string ran(const std::string& text, Read read) {
    testing::BareRun bare;
    shop::Tool tool;
    tool.number = 1;
    tool.radius = 2;
    bare.tools = {tool};
    const auto file = bare.sources.add("TEST.NC", text, base::BlockNumbers::n_word);
    const std::vector<program::Unit> units = read(file, bare.sources, bare.names, bare.diagnostics);
    std::string out;
    const auto take = [&](const cl::Record& r) { out += testing::placeless(r); };
    const auto ending = bare.run(units.at(0), take).ending;
    return out + std::to_string(static_cast<int>(ending)) + "\n" + bare.messages();
}

template <class Read>
void expect_alike(const Writing& w, Read read) {
    const std::vector<std::string> lines = any_program(w);
    std::string alike = w.head, each = w.head;
    int number = 0;
    for (const std::string& line : lines) {
        alike += line + "\n";
        each += w.nothing(++number) + line + "\n";
    }
    RC_LOG() << alike;
    const std::string records = ran(alike + w.end, read);
    RC_CLASSIFY(std::count(records.begin(), records.end(), '\n') > 20, "long");
    RC_ASSERT(records == ran(each + w.end, read));
}

std::string brackets(const std::string& n) { return "[" + n + "]"; }

const Writing linuxcnc{
    {"G91", "G90",     "G18",    "G17",   "G20", "G21",     "G93",  "G94",          "G55",   "G54",     "G80",
     "M5",  "S100 M3", "G92 X1", "G92.1", "G61", "#5221=3", "#7=1", "G10 L2 P1 X2", "G4 P1", "G64 P0.1"},
    [](int) { return std::string("#<nothing>=1\n"); },
    brackets,
    "R",
    "G21 G17 G90 G94 G40\nT1 M6\nG43 H1\nS100 M3\nG0 X0 Y0 Z0\nF100\n",
    "G40\nM2\n",
    "G0 X-50. Y-50.\nG41 D1 G1 X-30. Y-30. F100.",
    "G40 G0 X-60. Y-60."};

const Writing sinumerik{
    {"G91",    "G90",      "G18", "G17",     "G70",        "G71",   "G93 F2", "G94 F100", "G55",
     "G54",    "TRANS X1", "M5",  "S100 M3", "ROT RPL=30", "TRANS", "R7=1",   "G4 F1",    "CIP X1 Y1 I1=3 J1=4",
     "RNDM=1", "RNDM=0",   "G64", "G60",     "MCALL"},
    [](int n) {
        const std::string label = "AT" + std::to_string(n);
        return "GOTOF " + label + "\n" + label + ":\n";
    },
    [](const std::string& n) { return "=(" + n + ")"; },
    "CR=",
    "G71 G17 G90 G94 G40\nT1 D1 M6\nS100 M3\nG0 X0 Y0 Z0\nF100\n",
    "G40\nM30\n",
    "G0 X-50. Y-50.\nG41 G1 X-30. Y-30. F100.",
    "G40 G0 X-60. Y-60."};

const Writing fanuc{{"G91",           "G90",    "G18",
                     "G17",           "G20",    "G21",
                     "G94",           "G55",    "G54",
                     "G80",           "M5",     "S100 M3",
                     "G52 X1.",       "G52 X0", "G68 X0 Y0 R30.",
                     "G69",           "#7=1",   "G4 P100",
                     "G51 X0 Y0 P2.", "G50",    "G81 Z-5. R1. F100."},
                    [](int n) {
                        const std::string number = std::to_string(100 + n);
                        return "GOTO " + number + "\nN" + number + "\n";
                    },
                    brackets,
                    "R",
                    "O1\nG21 G17 G90 G94 G40\nT1 M6\nG43 H1\nS100 M3\nG0 X0 Y0 Z0\nF100.\n",
                    "G40\nM30\n",
                    "G0 X-50. Y-50.\nG41 D1 G1 X-30. Y-30. F100.",
                    "G40 G0 X-60. Y-60."};

}  // namespace

RC_GTEST_PROP(PlainBlocks, of_linuxcnc_run_as_their_like, ()) {
    expect_alike(linuxcnc, [](auto&&... a) { return read::rs274::read_linuxcnc(a...); });
}

RC_GTEST_PROP(PlainBlocks, of_sinumerik_run_as_their_like, ()) {
    expect_alike(sinumerik, [](auto&&... a) { return read::sinumerik::read(a...); });
}

RC_GTEST_PROP(PlainBlocks, of_fanuc_run_as_their_like, ()) {
    expect_alike(fanuc, [](auto&&... a) { return read::rs274::read_fanuc(a..., {}); });
}

/// Loops evaluate the words of their moves anew in every pass.
TEST(PlainBlocks, of_a_loop_move_by_what_their_words_hold_then) {
    const std::string head = "G21 G17 G90 G94\nS100 M3\nF100\nG0 X0 Y0 Z0\n#1=0\n";
    const std::string loop = head + "O100 while [#1 LT 5]\nG1 X[#1*2] Y-#1\n#1=[#1+1]\nO100 endwhile\nM2\n";
    std::string written = head;
    for (int i = 0; i < 5; ++i) written += "G1 X" + std::to_string(2 * i) + " Y" + std::to_string(-i) + "\n";
    const auto read = [](auto&&... a) { return read::rs274::read_linuxcnc(a...); };
    EXPECT_EQ(ran(loop, read), ran(written + "M2\n", read));
}

}  // namespace obrys::driver
