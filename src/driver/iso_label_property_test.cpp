/// DIN/ISO: what a word means is the run's to say, not the order of the text. A program that calls labels and the same
/// one with their blocks written where they are called make the same stream.

#include <gtest/gtest.h>

#include <iterator>
#include <random>

#include "base/codes.hpp"
#include "driver/every_word_testing.hpp"

namespace obrys::driver {
namespace {

using Random = std::mt19937;

int below(Random& random, int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }

/// "+35": so small that R+500 spans any two places.
std::string coordinate(Random& random) {
    const int v = below(random, 81) - 40;
    return (v < 0 ? "" : "+") + std::to_string(v);
}

/// One block of what DIN/ISO lets hold from block to block, or of what such states decide.
std::string block(Random& random) {
    const std::string x = " X" + coordinate(random), y = " Y" + coordinate(random), h = " H" + coordinate(random);
    switch (below(random, 26)) {
        case 0:
        case 1: return "G90";
        case 2:
        case 3: return "G91";
        case 4: return x.substr(1) + " G91" + y;
        case 5: return "G91" + x + " G90";
        case 6:
        case 7:
        case 8: return x.substr(1) + y;
        case 9: return "G01" + x + y + " F200";
        case 10: return "G00" + x + y;
        case 11: return "G01" + x + " F MAX";
        case 12: return "I" + coordinate(random) + " J" + coordinate(random);
        case 13: return "G91 I" + coordinate(random) + " J+3";
        case 14: return "G11 R+20" + h + " F150";
        case 15: return "G13" + h;
        case 16: return "G12" + h;
        case 17: return "R+15" + h;
        case 18: return "G02" + x + y + " R+500";
        case 19: return "G05" + x + y + " R+500";
        case 20: return "G07" + x;
        case 21: return below(random, 2) == 0 ? "G07 G43" + x : "G07 G44" + y;
        case 22: return "G54 X" + coordinate(random);
        case 23: return "G73 H" + coordinate(random);
        case 24: return "G29";
        default: return "F MAX" + x + y;
    }
}

using Body = std::vector<std::string>;

/// Blocks, among them calls "L2,0" of labels behind `first`.
Body body(Random& random, int labels, int first) {
    Body out;
    for (int n = 2 + below(random, 6); n > 0; --n)
        out.push_back(first < labels && below(random, 4) == 0
                          ? "L" + std::to_string(first + 1 + below(random, labels - first)) + ",0"
                          : block(random));
    return out;
}

struct Written {
    std::string text;
    int number = 1;
    void add(const std::string& words) { text += "N" + std::to_string(number++) + " " + words + " *\n"; }
};

Written begun() {
    Written w;
    w.text = "%IN G71 *\n";
    w.add("G99 T1 L+0 R+2");
    w.add("T1 G17 S1000");
    w.add("G00 G40 G90 X+1 Y+2 Z+3 F100 M3");
    w.add("I+5 J+4");
    return w;
}

std::string ended(Written w) { return w.text + "N99999999 %IN G71 *\n"; }

void write_in_place(Written& w, const std::vector<Body>& bodies, std::size_t which) {
    for (const std::string& b : bodies[which]) {
        if (b[0] == 'L')
            write_in_place(w, bodies, static_cast<std::size_t>(b[1] - '0'));
        else
            w.add(b);
    }
}

std::string in_place(const std::vector<Body>& bodies) {
    Written w = begun();
    write_in_place(w, bodies, 0);
    w.add("M2");
    return ended(w);
}

/// Labels in any order, and between them blocks that no run comes to.
std::string with_labels(Random& random, const std::vector<Body>& bodies) {
    Written w = begun();
    for (const std::string& b : bodies[0]) w.add(b);
    w.add("M2");
    std::vector<std::size_t> order;
    for (std::size_t k = 1; k < bodies.size(); ++k) order.push_back(k);
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t k : order) {
        if (below(random, 2) == 0) w.add(block(random));
        w.add("G98 L" + std::to_string(k));
        for (const std::string& b : bodies[k]) w.add(b);
        w.add("G98 L0");
    }
    return ended(w);
}

struct Outcome {
    std::string stream;      ///< without places and without what says that a label is run
    bool regular = false;    ///< the run came to its end
    bool unread = false;     ///< the reader complained
    bool complains = false;  ///< anybody did
};

Outcome outcome_of(const std::string& text) {
    Session s;
    const Control* control = find_control("heidenhain-itnc530");
    const auto file = s.sources.add("in.I", text, base::BlockNumbers::n_word);
    s.programs = std::make_unique<Programs>(*control, s.sources, s.diagnostics);
    s.job.machine.kind = shop::MachineKind::mill;
    s.main = s.programs->read(file);
    if (s.main == nullptr) return {};
    shop::Tool tool;
    tool.number = 1;
    tool.kind = shop::ToolKind::end_mill;
    tool.radius = 2;
    s.job.tools.push_back(tool);
    Outcome out;
    const auto outcome = interpret(s, [&](const cl::Record& r) {
        const std::string line = cl::to_text(r);
        if (!line.starts_with("label") && !line.starts_with("part-end"))
            out.stream += line.substr(0, line.find(" @")) + "\n";
    });
    out.regular = outcome.ending == interp::Ending::regular;
    for (const base::Diagnostic& d : s.diagnostics.all()) {
        out.unread = out.unread || d.code == base::codes::syntax;
        out.complains = out.complains || d.severity != base::Severity::note;
    }
    return out;
}

/// A block that the reader refuses where it knows the path function is one that the run refuses behind a label: what it
/// then makes of the rest of the block may differ.
TEST(IsoLabels, ACalledLabelIsRunAsIfItStoodThere) {
    constexpr unsigned cases = 4000;
    unsigned to_their_end = 0;
    for (unsigned seed = 0; seed < cases; ++seed) {
        Random random(seed);
        const int labels = 1 + below(random, 3);
        std::vector<Body> bodies;
        for (int k = 0; k <= labels; ++k) bodies.push_back(body(random, labels, k));
        const std::string called = with_labels(random, bodies), placed = in_place(bodies);
        const Outcome a = outcome_of(called), b = outcome_of(placed);
        if (b.unread) {
            ASSERT_TRUE(a.complains) << "seed " << seed << "\n" << called << "\n" << placed;
            continue;
        }
        ASSERT_EQ(a.stream, b.stream) << "seed " << seed << "\n" << called << "\n" << placed;
        ASSERT_EQ(a.regular, b.regular) << "seed " << seed;
        if (a.regular) ++to_their_end;
    }
    EXPECT_GT(to_their_end, cases / 4) << "most programs show nothing, since they stop early";
}

}  // namespace
}  // namespace obrys::driver
