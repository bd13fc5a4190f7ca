#include "read/rs274/acramatic_read.hpp"

#include <algorithm>

#include "read/rs274/acramatic_state.hpp"

namespace obrys::read::rs274 {

namespace {

/// `:`, `:100`: an alignment block, at which the operator may start the program; it may have words behind it.
void read_alignment(State& s) {
    if (!s.line.take(':')) return;
    while (base::is_digit(s.line.peek())) s.line.step();
}

void read_acramatic_line(AcramaticState& s) {
    s.failed = false;
    begin_words(s);
    if (s.line.at_end() || s.line.rest() == "%") return;
    if (s.part->ended) return say_unreached(s);
    if (s.line.fault() != CommentFault::none)
        return fail(s, s.line.fault_begin(), s.line.fault_begin() + 1, "this bracket is not closed", "add )");
    read_alignment(s);
    if (s.line.peek() == '/')
        return fail_here(s, "/ for blocks that may be skipped is not known of this control", "take it out");
    read_block_head(s);
    if (s.failed || s.line.at_end()) return;
    if (s.line.peek() == '[') return read_table_line(s);
    read_acramatic_block(s);
}

void read_acramatic_lines(AcramaticState& s) {
    const std::size_t size = s.text.size();
    std::size_t aside = 0;
    for (std::size_t at = 0; at < size;) {
        if (at - aside > base::Store::piece) {
            s.sources.lay_aside(s.file, static_cast<std::uint32_t>(at));
            aside = at;
        }
        const std::size_t end = std::min(s.text.find('\n', at), size);
        s.line.load(s.text, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end), s.variant.nested_comments,
                    s.variant.semicolon_comment);
        read_acramatic_line(s);
        at = end + 1;
    }
}

}  // namespace

std::vector<program::Unit> read_acramatic(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                          base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    AcramaticState s(file, dialect::rs274::acramatic, names, diagnostics, sources);
    s.text = base::without_end_signs(source.text);
    s.part = &s.add_part(diagnostics);
    program::Unit& unit = s.part->unit;
    unit.name = base::to_upper(base::stem(source.name));
    unit.end = static_cast<std::uint32_t>(source.text.size());
    unit.reserve(s.text.size());
    read_acramatic_lines(s);
    if (!s.part->ended) unit.unended = "the program ends without M2 or M30";
    sources.lay_aside(file, static_cast<std::uint32_t>(s.text.size()));
    std::vector<program::Unit> units;
    units.push_back(std::move(unit));
    return units;
}

}  // namespace obrys::read::rs274
