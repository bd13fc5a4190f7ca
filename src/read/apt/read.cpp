#include "read/apt/read.hpp"

#include "base/codes.hpp"
#include "base/text.hpp"
#include "dialect/apt/traits.hpp"
#include "read/apt/state.hpp"

namespace obrys::read::apt {

namespace {

void say_behind_end(State& s) {
    if (s.told_behind || s.line.tokens.empty()) return;
    s.told_behind = true;
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = base::codes::not_run;
    d.where = {s.file, s.line.begin, s.line.end};
    d.text = "this statement stands behind the end of the cutter locations and is never run";
    d.remedy = "take the END or FINI before it out, or what stands behind it";
    s.diagnostics.add(std::move(d));
}

bool is_fini(const State& s) { return s.line.tokens.size() == 1 && upper_of(s.line.tokens.front()) == "FINI"; }

}  // namespace

program::Unit read(std::uint32_t file, const base::Sources& sources, program::Names& names,
                   base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    program::Unit unit;
    unit.name = base::to_upper(base::stem(source.name));
    unit.file = file;
    unit.end = static_cast<std::uint32_t>(source.text.size());
    unit.reserve(source.text.size());
    State s(file, sources, unit, names, diagnostics);
    std::uint32_t aside = 0;
    while (s.scanner.next(s.line)) {
        if (s.ended) {
            if (!is_fini(s)) say_behind_end(s);
            continue;
        }
        if (!s.line.tokens.empty()) read_statement(s);
        if (!s.line.comment.empty()) read_comment(s);
        if (s.scanner.at() - aside > base::Store::piece) sources.lay_aside(file, aside = s.scanner.at());
    }
    if (!s.ended) drop_circle(s);
    // A file of NX is a row of tool paths, each with an end of its own.
    if (!s.ended && !s.path_closed) unit.unended = "the cutter locations end without END or FINI";
    unit.traits = s.turns ? &dialect::apt::turning_traits : &dialect::apt::traits;
    sources.lay_aside(file, unit.end);
    return unit;
}

}  // namespace obrys::read::apt
