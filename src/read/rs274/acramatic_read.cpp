#include "read/rs274/acramatic_read.hpp"


#include "read/rs274/acramatic_state.hpp"
#include "read/rs274/one_part.hpp"

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

}  // namespace

std::vector<program::Unit> read_acramatic(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                          base::Diagnostics& diagnostics) {
    AcramaticState s(file, dialect::rs274::acramatic, names, diagnostics, sources);
    return read_one_part(s, diagnostics, read_acramatic_line);
}

}  // namespace obrys::read::rs274
