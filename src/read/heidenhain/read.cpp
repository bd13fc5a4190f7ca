#include "read/heidenhain/read.hpp"

#include "base/codes.hpp"
#include "dialect/heidenhain/traits.hpp"
#include "read/heidenhain/literal_block.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

void skip_preface(State& s, std::size_t begin, std::string_view mark, base::Diagnostics& diagnostics) {
    const std::string_view text(s.in.here());
    if (begin == std::string_view::npos) return;
    std::size_t line = text.find_last_of('\n', begin);
    line = line == std::string_view::npos ? 0 : line + 1;
    if (base::trim(text.substr(0, line)).empty()) return;
    base::Diagnostic d;
    d.severity = base::Severity::note;
    d.code = base::codes::no_effect;
    d.where = s.build.span(0, static_cast<std::uint32_t>(line));
    d.text = "the text in front of " + std::string(mark) + " is left out";
    diagnostics.add(std::move(d));
    s.in.go_to(static_cast<std::uint32_t>(line));
}

void check_end(State& s, std::string_view first, std::string_view last, base::Diagnostics& diagnostics) {
    base::Diagnostic d;
    if (s.ended && s.in.next_line()) {
        const std::uint32_t begin = s.in.at();
        s.in.rest_of_line();
        d.severity = base::Severity::warning;
        d.code = base::codes::not_run;
        d.where = s.build.span(begin, s.in.at());
        d.text = "the text behind " + std::string(last) + " is no part of the program and is not run";
        d.remedy = "keep it in a file of its own, or take the first " + std::string(last) + " out";
    } else if (s.begun && !s.ended) {
        d.severity = base::Severity::warning;
        d.code = base::codes::unclosed;
        d.where = s.build.span(s.block, s.in.at());
        d.text = std::string(last) + " is missing: the program may be cut off here";
    } else if (!s.begun) {
        s.build.unit().unbegun = std::string(first) +
                                 " is missing: whether millimetres or inches are meant is not said, and the "
                                 "beginning of the program may be cut off";
        return;
    } else {
        return;
    }
    diagnostics.add(std::move(d));
}

std::uint32_t lay_aside(State& s, const base::Sources& sources) {
    sources.lay_aside(s.build.unit().file, s.in.at());
    return s.in.at();
}

program::Unit begin_unit(std::uint32_t file, const base::Source& source) {
    program::Unit unit;
    unit.name = program_name(source.name);
    unit.file = file;
    unit.end = static_cast<std::uint32_t>(source.text.size());
    unit.traits = &dialect::heidenhain::traits;
    unit.reserve(source.text.size());
    return unit;
}

program::Unit read(std::uint32_t file, const base::Sources& sources, program::Names& names,
                   base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    program::Unit unit = begin_unit(file, source);
    State s{.build = {unit, names, diagnostics, source.text}, .in = Scanner(source.text), .iso = {}};
    skip_preface(s, base::to_upper(source.text.substr(0, 16384)).find("BEGIN PGM"), "BEGIN PGM", diagnostics);
    bool first = true;
    std::uint32_t aside = 0;
    while (!s.ended && s.in.next_line()) {
        if (s.in.at() - aside > base::Store::piece) aside = lay_aside(s, sources);
        if (read_literal_block(s)) continue;
        read_block(s);
        if (first) s.first_numbered = s.numbered;
        first = false;
    }
    end_cycle(s);
    check_end(s, "BEGIN PGM", "END PGM", diagnostics);
    resolve_labels(s);
    lay_aside(s, sources);
    return unit;
}

}  // namespace obrys::read::heidenhain
