/// Arcs that are resolved by the short way (interp: usual_arc) come out, and are complained about, as by the way that
/// looks at every word of a circle. TURN=0, no further turns, asks for that way and changes nothing.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "driver/fanuc_testing.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::driver {
namespace {

struct Turn {
    double u = 0, v = 0;
};

/// The k-th quarter of a turn of (10, 0), or of (6, 8).
Turn quarter(int k, bool slanting) {
    Turn t = slanting ? Turn{6, 8} : Turn{10, 0};
    for (int i = 0; i < k; ++i) t = {-t.v, t.u};
    return t;
}

/// An arc of quarters; seldom one that does not lie on its circle, or whose start nobody knows.
std::string any_arc(char u, char v, char w, std::string_view centres) {
    const Turn from = quarter(*rc::gen::inRange(0, 4), *rc::gen::arbitrary<bool>());
    const Turn to = quarter(*rc::gen::inRange(0, 4), *rc::gen::arbitrary<bool>());
    const double beside = *rc::gen::weightedElement<double>({{12, 0.0}, {3, 0.002}, {1, 0.02}, {1, 1.0}});
    std::string block = *rc::gen::element<std::string>("G2", "G3");
    const auto word = [&](char letter, double value) { block += std::string(" ") + letter + base::fixed(value, 3); };
    const bool is_incremental = *rc::gen::arbitrary<bool>();
    if (is_incremental) block = "G91 " + block;
    word(u, to.u - from.u + beside);
    word(v, to.v - from.v);
    if (*rc::gen::inRange(0, 4) == 0) word(w, *rc::gen::inRange(-3, 4));
    if (from.u != 0 || *rc::gen::arbitrary<bool>()) word(centres[0], -from.u);
    if (from.v != 0 || *rc::gen::arbitrary<bool>()) word(centres[1], -from.v);
    if (*rc::gen::inRange(0, 20) == 0) word(centres[2], 0);
    return block;
}

std::vector<std::string> any_program() {
    std::vector<std::string> lines;
    const int plane = *rc::gen::inRange(0, 3);
    const char u = "XZY"[plane], v = "YXZ"[plane], w = "ZYX"[plane];
    const std::string_view centres =
        std::array<std::string_view, 3>{"IJK", "KIJ", "JKI"}[static_cast<std::size_t>(plane)];
    lines.push_back(std::array<std::string, 3>{"G17", "G18", "G19"}[static_cast<std::size_t>(plane)]);
    if (*rc::gen::inRange(0, 8) != 0) lines.emplace_back("G0 X0 Y0 Z0");
    lines.push_back(*rc::gen::element<std::string>("G40", "G40", "G41 G1 X-20 Y-20 Z-20", "TRANS X5", "ROT RPL=30",
                                                   "SCALE X2 Y2 Z2", "SCALE X2", "G70", "DIAMON"));
    const int n = *rc::gen::inRange(1, 8);
    for (int i = 0; i < n; ++i) {
        if (*rc::gen::inRange(0, 3) == 0) lines.push_back("G90 G1 X" + base::fixed(*rc::gen::inRange(0, 30), 3));
        lines.push_back(any_arc(u, v, w, centres));
    }
    return lines;
}

std::string ran(const std::string& text) {
    testing::BareRun bare;
    shop::Tool tool;
    tool.number = 1;
    tool.radius = 2;
    bare.tools = {tool};
    const auto file = bare.sources.add("TEST.MPF", text, base::BlockNumbers::n_word);
    const std::vector<program::Unit> units = read::sinumerik::read(file, bare.sources, bare.names, bare.diagnostics);
    std::string out;
    const auto take = [&](const cl::Record& r) { out += testing::placeless(r); };
    const auto ending = bare.run(units.at(0), take).ending;
    return out + std::to_string(static_cast<int>(ending)) + "\n" + bare.messages();
}

}  // namespace

RC_GTEST_PROP(UsualArcs, come_out_as_arcs_with_every_word_looked_at, ()) {
    std::string usual = "G71 G90 G94\nT1 D1 M6\nS100 M3\nF100\n", general = usual;
    for (const std::string& line : any_program()) {
        const bool is_arc = line.find("G2 ") != std::string::npos || line.find("G3 ") != std::string::npos;
        usual += line + "\n";
        general += line + (is_arc ? " TURN=0\n" : "\n");
    }
    RC_LOG() << usual;
    const std::string records = ran(usual + "M30\n");
    RC_CLASSIFY(records.find("arc") != std::string::npos, "arcs come out");
    RC_ASSERT(records == ran(general + "M30\n"));
}

}  // namespace obrys::driver
