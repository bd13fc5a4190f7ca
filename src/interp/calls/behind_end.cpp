/// Blocks behind the end of a program (M2, M30, M99, RET), which nothing can lead to.

#include <algorithm>
#include <string>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"

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

bool is_text(const Unit& unit, program::ExprId id) {
    return id == program::no_expr || unit.exprs[id].kind == program::ExprKind::text;
}

/// Where a jump leads whose word stands in the text: a label, or a block by its number.
bool is_written(const Saying& run, const Unit& unit, const program::Jump& j) {
    if (j.target != program::no_target || j.destination == program::no_expr) return true;
    if (!is_text(unit, j.destination)) return false;
    return unit.labels.contains(run.env.names.id(base::to_upper(unit.texts[unit.exprs[j.destination].a])));
}

/// Whether jumps, sections and contours may lead behind the end, or be run from there, where no label tells it.
bool may_be_reached(const Saying& run, const Unit& unit) {
    for (const program::Call& call : unit.calls)  // M98 P Q may begin there
        if (call.first_block != program::no_expr) return true;
    return !std::all_of(unit.jumps.begin(), unit.jumps.end(),
                        [&](const program::Jump& j) { return is_written(run, unit, j); });
}

/// Something names a label by a value that only running it would tell.
bool names_labels_by_value(const Unit& unit) {
    for (const program::LabelCall& c : unit.label_calls)
        if (c.target == program::no_target && !is_text(unit, c.label)) return true;
    for (const program::CycleDefinition& c : unit.cycles)
        for (const program::ExprId text : c.texts)
            if (!is_text(unit, text)) return true;
    for (const program::ContourStatement& c : unit.contours)
        for (const program::ContourPart& p : c.parts)
            if (!is_text(unit, p.label)) return true;
    return false;
}

bool is_of_name(char c) { return base::is_letter(c) || base::is_digit(c) || c == '_'; }

/// `name` stands in the text as a whole: alone, or as in "BEGIN:END".
bool names(std::string_view text, std::string_view name) {
    const std::string upper = base::to_upper(text);
    for (std::size_t at = upper.find(name); at != upper.npos; at = upper.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !is_of_name(upper[at - 1])) && (end == upper.size() || !is_of_name(upper[end]))) return true;
    }
    return false;
}

/// Any text of the program outside of the label's own block `at` may name it to a call, a jump or a cycle.
bool is_named(const Saying& run, const Unit& unit, program::NameId label, const program::Statement& at) {
    const auto stands_there = [&](const program::Expr& e) {
        return e.begin >= at.begin && e.begin < at.begin + at.length;
    };
    const std::string name = base::to_upper(run.env.names.text(label));
    const auto is_label = [&](program::NameId n) { return n == label; };
    return std::any_of(unit.exprs.begin(), unit.exprs.end(),
                       [&](const program::Expr& e) {
                           return e.kind == program::ExprKind::text && !stands_there(e) && names(unit.texts[e.a], name);
                       }) ||
           std::any_of(unit.sections.begin(), unit.sections.end(),
                       [&](const program::Section& s) { return is_label(s.first) || is_label(s.last); });
}

/// The labels of a statement, and whether something leads to one of them.
struct Labels {
    bool any = false, named = false;
};
Labels labels_at(const Saying& run, const Unit& unit, std::uint32_t i) {
    Labels l;
    for (const auto& [name, places] : unit.labels) {
        if (std::find(places.begin(), places.end(), i) == places.end()) continue;
        l.any = true;
        l.named = l.named || is_named(run, unit, name, unit.statements[i]);
    }
    return l;
}

/// Where a jump leads.
bool is_jumped_to(const Unit& unit, std::uint32_t i) {
    const auto leads_there = [&](const program::Jump& j) { return j.target == i; };
    return std::any_of(unit.jumps.begin(), unit.jumps.end(), leads_there) ||
           std::any_of(unit.cases.begin(), unit.cases.end(), [&](const program::Case& c) {
               return std::any_of(c.arms.begin(), c.arms.end(),
                                  [&](const program::CaseArm& arm) { return leads_there(arm.jump); });
           });
}

/// Where the call of a section leads that names its block (M97).
bool is_called(const Unit& unit, std::uint32_t i) {
    return std::any_of(unit.label_calls.begin(), unit.label_calls.end(),
                       [&](const program::LabelCall& c) { return c.target == i; });
}

/// Behind the label_end that the label called at `i` runs to.
std::uint32_t behind_label(const Unit& unit, std::uint32_t i) {
    while (i < unit.statements.size() && unit.statements[i].kind != StatementKind::label_end) ++i;
    return i + 1;
}

/// What it is no loss not to run: nothing, or another end.
bool is_idle(const Unit& unit, std::uint32_t i) {
    const program::Statement& s = unit.statements[i];
    if (s.kind == StatementKind::return_) return true;
    for (std::uint32_t k = i + 1; k < unit.statements.size() && (unit.statements[k].flags & program::line_start) == 0;)
        if (unit.statements[k++].kind == StatementKind::return_) return true;  // what it hands back
    if (s.kind != StatementKind::block) return false;
    for (std::uint32_t w = s.first; w < unit.words_end(i); ++w) {
        const program::Word& word = unit.words[w];
        if (program::code_of(word) != Code::m || !program::is_literal(word)) return false;
        if (const double m = unit.literal(word); m != 2 && m != 30 && m != 99) return false;
    }
    return true;
}

/// Where a program will not go on.
struct Rest {
    const Unit* unit = nullptr;
    std::uint32_t first = 0;   ///< statement
    std::uint32_t behind = 0;  ///< in the text: the block that ends it comes once more
    std::string why;           ///< "the program ends before it with M30"
};

/// The first block of it that nothing leads to.
void say_rest(Saying& run, const Rest& rest) {
    const Unit& unit = *rest.unit;
    if (may_be_reached(run, unit)) return;
    const bool by_value = names_labels_by_value(unit);
    for (std::uint32_t i = rest.first; i < unit.statements.size();) {
        const program::Statement& s = unit.statements[i];
        const Labels labels = labels_at(run, unit, i);
        if (closes(s.kind) || is_jumped_to(unit, i)) return;
        if (is_called(unit, i) || (labels.any && (labels.named || by_value))) {
            if (run.traits->may_end_anywhere) return;  // no block marks where what is run from here ends
            i = behind_label(unit, i);
            continue;
        }
        const bool same_block = i == rest.first && (s.flags & program::line_start) == 0;
        if ((is_idle(unit, i) && !labels.any) || same_block || s.begin <= rest.behind) {
            ++i;
            continue;
        }
        if (labels.any)
            return unchecked(run, base::codes::not_run, unit.span(s),
                             "nothing calls this label, and " + rest.why + ": its blocks are never run",
                             "call it, or take it out");
        return unchecked(run, base::codes::not_run, unit.span(s),
                         "this block and those behind it are never run: " + rest.why,
                         "take that end out, or these blocks");
    }
}

/// A block that is skipped where the switch says so ends nothing then; and what is run often ends as often.
bool is_told(Calling& run, const Unit& unit, std::uint32_t first) {
    const bool skipped = run.statement != nullptr && (run.statement->flags & program::skip_mask) != 0;
    return skipped || !run.ends_told.emplace(&unit, first).second;
}

/// Of the program that is run, not of a piece that was read anew.
std::size_t program_at(const Saying& run) {
    std::size_t at = run.calls.size() - 1;
    while (at > 0 && run.calls[at].is_piece) --at;
    return at;
}

}  // namespace

void say_blocks_behind(Calling& run, const std::string& end) {
    const Activation& act = run.calls[program_at(run)];
    if (is_told(run, *act.unit, act.pc)) return;
    say_rest(run, {act.unit, act.pc, run.statement->begin, "the program ends before it with " + end});
}

void say_callers_rest(Calling& run, const std::string& end) {
    const std::size_t ending = program_at(run);
    for (std::size_t k = ending + 1; k-- > 0;) {
        const Activation& act = run.calls[k];
        const std::string why =
            (k < ending ? "a called program ends the run before it with " : "the program ends before it with ") + end;
        if (k < ending && !act.is_piece && !is_told(run, *act.unit, act.pc)) say_rest(run, {act.unit, act.pc, 0, why});
        for (const LabelReturn& back : act.labels)
            if (!is_told(run, *act.unit, back.pc)) say_rest(run, {act.unit, back.pc, 0, why});
    }
}

}  // namespace obrys::interp
