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
    // A jump may name a block's number; one whose place is known already names a label.
    return std::any_of(unit.jumps.begin(), unit.jumps.end(), [](const program::Jump& j) {
        return j.target == program::no_target && j.destination != program::no_expr;
    });
}

bool is_text(const Unit& unit, program::ExprId id) {
    return id == program::no_expr || unit.exprs[id].kind == program::ExprKind::text;
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
bool is_named(const Run& run, program::NameId label, const program::Statement& at) {
    const Unit& unit = run.unit();
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
Labels labels_at(const Run& run, std::uint32_t i) {
    Labels l;
    for (const auto& [name, places] : run.unit().labels) {
        if (std::find(places.begin(), places.end(), i) == places.end()) continue;
        l.any = true;
        l.named = l.named || is_named(run, name, run.unit().statements[i]);
    }
    return l;
}

/// Where a jump leads.
bool is_jumped_to(const Unit& unit, std::uint32_t i) {
    return std::any_of(unit.jumps.begin(), unit.jumps.end(), [&](const program::Jump& j) { return j.target == i; });
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

}  // namespace

void say_blocks_behind(Run& run, int m) {
    if (run.top().is_piece) {  // of the program below, in which the blocks stand
        Activation piece = std::move(run.calls.back());
        run.calls.pop_back();
        say_blocks_behind(run, m);
        run.calls.push_back(std::move(piece));
        return;
    }
    const Unit& unit = run.unit();
    if (may_be_reached(run)) return;
    const bool by_value = names_labels_by_value(unit);
    for (std::uint32_t i = run.top().pc; i < unit.statements.size();) {
        const program::Statement& s = unit.statements[i];
        const Labels labels = labels_at(run, i);
        if (closes(s.kind) || is_jumped_to(unit, i)) return;
        if (is_called(unit, i) || (labels.any && (labels.named || by_value))) {
            if (run.traits->may_end_anywhere) return;  // no block marks where what is run from here ends
            i = behind_label(unit, i);
            continue;
        }
        const bool empty = s.kind == StatementKind::block && unit.words_end(i) == s.first;
        // The block that ends it comes once more.
        if ((empty && !labels.any) || s.begin <= run.statement->begin) {
            ++i;
            continue;
        }
        const std::string end = "the program ends before it with M" + std::to_string(m);
        if (labels.any)
            return unchecked(run, base::codes::not_run, unit.span(s),
                             "nothing calls this label, and " + end + ": its blocks are never run",
                             "call it, or take it out");
        return unchecked(
            run, base::codes::not_run, unit.span(s),
            "this block and those behind it are never run: the program ends before them with M" + std::to_string(m),
            "take that end out, or these blocks");
    }
}

}  // namespace obrys::interp
