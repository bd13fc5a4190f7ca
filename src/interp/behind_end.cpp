/// Blocks behind the end of the program (M2, M30), which nothing can lead to.

#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

namespace {

using program::StatementKind;

/// What closes something that was opened before the end: on its other way the run may come here.
bool closes(StatementKind kind) {
    switch (kind) {
        case StatementKind::else_:
        case StatementKind::endif:
        case StatementKind::endwhile:
        case StatementKind::until:
        case StatementKind::endloop:
        case StatementKind::endfor:
        case StatementKind::label_end: return true;
        default: return false;
    }
}

/// Whether jumps, sections and contours may lead behind the end, or be run from there, where no label tells it.
bool may_be_reached(const Run& run) {
    const Unit& unit = run.unit();
    for (const program::Call& call : unit.calls)  // M98 P Q may begin there
        if (call.first_block != program::no_expr) return true;
    if (run.traits->may_end_anywhere) return !unit.jumps.empty() || !unit.label_calls.empty() || !unit.cycles.empty();
    // A jump may name a block's number; one whose place is known already names a label.
    return std::any_of(unit.jumps.begin(), unit.jumps.end(), [](const program::Jump& j) {
        return j.target == program::no_target && j.destination != program::no_expr;
    });
}

/// A label, or where a jump leads.
bool leads_here(const Unit& unit, std::uint32_t i) {
    const auto at = [i](std::uint32_t statement) { return statement == i; };
    return std::any_of(unit.labels.begin(), unit.labels.end(),
                       [&](const auto& l) { return std::any_of(l.second.begin(), l.second.end(), at); }) ||
           std::any_of(unit.jumps.begin(), unit.jumps.end(), [&](const program::Jump& j) { return at(j.target); });
}

}  // namespace

void say_blocks_behind(Run& run, int m) {
    const Unit& unit = run.unit();
    if (may_be_reached(run)) return;
    for (std::uint32_t i = run.top().pc; i < unit.statements.size(); ++i) {
        const program::Statement& s = unit.statements[i];
        if (closes(s.kind) || leads_here(unit, i)) return;
        const bool block = s.kind == StatementKind::block;
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
