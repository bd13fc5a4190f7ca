#pragma once
/// A small result made by hand for the tests of the reports: a main program that calls a subprogram, whose one move
/// gouges a bar with a round end; one thing not checked, one assumed.

#include "base/codes.hpp"
#include "report/report.hpp"

namespace obrys::report::sample {

struct Sample {
    base::Sources sources;
    check::Result result;
    check::Setup setup;
    cl::CallStacks stacks;
    [[nodiscard]] Subject subject() const {
        return {sources, result, setup, stacks, "MAIN.MPF", "sinumerik-840d", "0.1.0", ""};
    }
};

inline const std::string main_text = "N10 G0 X30 Z5\nN20 SUB\nN30 FOO <x> & M30\n";
inline const std::string sub_text = "PROC SUB\nN5 G1 X=18 Z2 ; \xF6\nM17\n";  // the comment is CP1252

/// The bytes of a word in a file.
inline base::Span span(const Sample& s, std::uint32_t file, const std::string& word) {
    const auto at = static_cast<std::uint32_t>(s.sources[file].text.find(word));
    return {file, at, at + static_cast<std::uint32_t>(word.size())};
}

/// A bar of radius 20 from Z 0 to Z 40 whose right end is a half circle.
inline geom::Region bar(double radius) {
    return {{{{{{0, 0}, 0}, {{40, 0}, std::tan(geom::pi / 8)}, {{40 - radius, radius}, 0}, {{0, radius}, 0}}, true}}};
}

inline check::Finding gouge(const Sample& s, const std::vector<base::Span>& stack) {
    check::Finding f;
    f.code = base::codes::gouge;
    f.text = "cuts into the finished part: 1.250 mm deep along X";
    f.where = span(s, 1, "N5 G1 X=18 Z2");
    f.stack = stack;
    f.move = 1;
    f.from = geom::Vec3{30, NAN, 5};
    f.to = geom::Vec3{18, NAN, 2};
    f.amounts = {{"depth_mm", 1}, {"depth_x_mm", 1.25}, {"area_mm2", 3.5}, {"volume_mm3", 400}};
    f.region = {{{{{{2, 18}, 0}, {{4, 18}, 0}, {{4, 19.25}, 0}, {{2, 19.25}, 0}}, true}}};
    f.at = geom::Vec2{2, 18};
    return f;
}

inline Sample make() {
    Sample s;
    s.sources.add("MAIN.MPF", main_text, base::BlockNumbers::n_word);
    s.sources.add("with blank/SUB.SPF", sub_text, base::BlockNumbers::n_word);
    const base::Span call = span(s, 0, "SUB");
    const cl::StackId stack = s.stacks.push(0, call);
    s.setup.machine.kind = shop::MachineKind::lathe;
    s.setup.machine.name = "lathe-generic";
    s.setup.stock = bar(20);
    s.setup.part = bar(19.25);
    check::Result& r = s.result;
    r.findings = {gouge(s, {call})};
    r.unchecked = {{base::codes::unknown_word, "unknown word FOO", "", span(s, 0, "FOO"), {}, 2}};
    r.assumptions = {{base::codes::assumption, "R3 = 150 is set from outside", "", check::nowhere, {}, 1}};
    r.stats = {2, 1, 1, 0, 12.369, 7};
    r.before = check::StockFigures{800, 50000};
    r.after = check::StockFigures{796.5, 49600};
    r.stock_after = bar(20);
    r.moves.resize(2);
    r.moves[0].from = {NAN, NAN};
    r.moves[0].to = {5, 30};
    r.moves[0].rapid = true;
    r.moves[0].where = span(s, 0, "N10 G0 X30 Z5");
    r.moves[1].from = {5, 30};
    r.moves[1].to = {2, 18};
    r.moves[1].where = r.findings[0].where;
    r.moves[1].stack = stack;
    r.moves[1].removed = r.findings[0].region;
    r.verdict = check::verdict_of(r);
    return s;
}

}  // namespace obrys::report::sample
