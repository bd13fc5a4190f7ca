/// Blocks behind the end of the program (M2, M30), which nothing can lead to.

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

void say_blocks_behind(Run& run, int m) {
    const Unit& unit = run.unit();
    // Jumps, sections and contours may lead there, or be run from there.
    if (!run.traits->may_end_anywhere || !unit.jumps.empty() || !unit.label_calls.empty() || !unit.cycles.empty())
        return;
    for (const program::Call& call : unit.calls)  // M98 P Q may begin there
        if (call.first_block != program::no_expr) return;
    for (std::uint32_t i = run.top().pc; i < unit.statements.size(); ++i) {
        const program::Statement& s = unit.statements[i];
        const bool block = s.kind == program::StatementKind::block;
        if (block && unit.words_end(i) == s.first) continue;
        if (s.begin <= run.statement->begin) continue;  // the block that ends it, once more
        base::Span where = unit.span(s);
        return unchecked(
            run, base::codes::not_run, where,
            "this block and those behind it are never run: the program ends before them with M" + std::to_string(m),
            "take that end out, or these blocks");
    }
}

}  // namespace obrys::interp
