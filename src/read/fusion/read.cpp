#include "read/fusion/read.hpp"

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "dialect/fusion/records.hpp"
#include "dialect/fusion/traits.hpp"
#include "read/fusion/state.hpp"

namespace obrys::read::fusion {

using dialect::fusion::RecordKind;

namespace {

/// Another work offset than the first stands in the file: all of them are told.
bool has_offsets(std::string_view text) {
    constexpr std::string_view word = " work-offset ";
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const char digit = text.substr(at + word.size(), 2).empty() ? '0' : text[at + word.size()];
        const std::string_view rest = text.substr(at + word.size());
        const bool first = (digit == '0' || digit == '1') && rest.size() > 1 && !base::is_digit(rest[1]);
        if (!first) return true;
    }
    return false;
}

void read_known(State& s, RecordKind kind) {
    switch (kind) {
        case RecordKind::parameter: return read_parameter(s);
        case RecordKind::context: return read_context(s);
        case RecordKind::tool_mill: return read_tool(s);
        case RecordKind::tool_turn: return read_turning_tool(s);
        case RecordKind::section: return begin_section(s);
        case RecordKind::section_end: return end_section(s);
        case RecordKind::linear: return read_linear(s, false, false);
        case RecordKind::rapid: return read_linear(s, true, false);
        case RecordKind::linear_5axis: return read_linear(s, false, true);
        case RecordKind::rapid_5axis: return read_linear(s, true, true);
        case RecordKind::arc_ccw: return read_arc(s, false);
        case RecordKind::arc_cw: return read_arc(s, true);
        case RecordKind::command: return read_command(s);
        case RecordKind::cycle: return read_cycle(s);
        case RecordKind::cycle_end: return end_cycle(s);
        case RecordKind::stock:
        case RecordKind::frame:
        case RecordKind::tool_assembly: return s.build.ignored(s.line.name, s.line.begin, s.line.end);
    }
}

/// Lines that are no record; true: the text ends here.
bool read_other(State& s) {
    const Place where = place_of(s.line);
    if (s.line.name == "cut-off") {
        refuse(s, where, "the file ends within this record");
        return true;
    }
    if (s.line.name == "unknown-record") {
        refuse(s, where,
               "nothing is known of this kind of record, nor how long it is: the rest of the file is not read");
        return true;
    }
    if (s.line.name != "compact-nci") fail(s, "this is no record of the listing of an intermediate file");
    return false;
}

void tell_end(State& s) {
    const Place where = place_of(s.line);
    begin_block(s, where);
    s.build.literal(program::Code::m, 30, where.begin, where.end);
    end_block(s, where);
}

/// All lines; false where the file does not go to its end.
bool read_lines(State& s, const base::Sources& sources) {
    std::uint32_t aside = 0;
    while (s.scanner.next(s.line)) {
        const dialect::fusion::Record* r = dialect::fusion::find_record(s.line.name);
        if (r != nullptr)
            read_known(s, r->kind);
        else if (read_other(s))
            return false;
        if (s.scanner.at() - aside > base::Store::piece) sources.lay_aside(s.file, aside = s.scanner.at());
    }
    return true;
}

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
    s.uses_offsets = has_offsets(s.text);
    if (!read_lines(s, sources)) {
        unit.unended = "the intermediate file is not read to its end";
    } else if (s.in_section) {
        unit.unended = "the intermediate file ends within an operation: its section has no end";
    } else {
        tell_end(s);
    }
    unit.traits = s.turns ? &dialect::fusion::turning_traits : &dialect::fusion::traits;
    sources.lay_aside(file, unit.end);
    return unit;
}

}  // namespace obrys::read::fusion
