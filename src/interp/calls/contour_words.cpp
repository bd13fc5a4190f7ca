/// What blocks that hold a contour cannot have: it is said, for the control makes something else of it than a run.
/// Sources: HEIDENHAIN iTNC 530, cycle programming, "SL cycles, characteristics of the subprograms", from memory: feeds
/// and M functions are passed over, transformations act, there are no coordinates of the tool axis. FANUC series
/// 16i/18i-T and 30i, multiple repetitive cycles: F, S and T within the contour act in G70 alone. LinuxCNC 2.10,
/// interp_g7x.cc: the subprogram is read for its lines and arcs, and nothing else of it acts.

#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleKind;
using program::Statement;
using program::StatementKind;

namespace {

/// The word of the block with this code; the block where it has none.
base::Span place_of(const Reckoning& run, Code code) {
    const Unit& unit = run.unit();
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    if (run.statement->kind == StatementKind::block || run.statement->kind == StatementKind::special)
        for (std::uint32_t i = run.statement->first; i < unit.words_end(index); ++i)
            if (program::code_of(unit.words[i]) == code) return unit.span(*run.statement, unit.words[i]);
    return run.here();
}

std::string text_at(const Saying& run, const base::Span& where) {
    return std::string(base::trim(run.env.sources.text(where)));
}

void foreign(Saying& run, const base::Span& at, const std::string& why) {
    const base::Span where = text_at(run, at).empty() ? run.here() : at;
    unchecked(run, codes::unsupported, where, text_at(run, where) + " has no place in a contour: " + why,
              "take it out of the blocks that hold the contour");
}

void has_no_effect(Saying& run, const std::string& name, const base::Span& where) {
    assume(run, where, name + " has no effect in a contour: the control passes over feeds and M functions");
}

/// M97, M98, M120 …: modes of the path that is made of the contour.
void modes_in_milled(Reckoning& run) {
    const Unit& unit = run.unit();
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    for (std::uint32_t i = run.statement->first; i < unit.words_end(index); ++i) {
        if (program::code_of(unit.words[i]) != Code::modal) continue;
        const base::Span where = unit.span(*run.statement, unit.words[i]);
        const std::string name = text_at(run, where);
        if (name.starts_with('M')) has_no_effect(run, name, where);
    }
}

/// Spindle, coolant and stops: the control passes over them in a contour, and no path depends on it.
bool is_harmless(int m) {
    constexpr std::array known{0, 1, 3, 4, 5, 7, 8, 9, 13, 14};
    return std::find(known.begin(), known.end(), m) != known.end();
}

void functions_in_milled(Moving& run) {
    for (const int m : run.block.m) {
        const std::string name = "M" + std::to_string(m);
        const base::Span where = place_of(run, Code::m);
        if (is_harmless(m))
            has_no_effect(run, name, where);
        else
            foreign(run, where, "what the control makes of " + name + " there is not known");
    }
}

void words_in_milled(Moving& run) {
    const BlockWords& b = run.block;
    const auto say_code = [&](Code c, const std::string& why) {
        if (b.has(c)) foreign(run, place_of(run, c), why);
    };
    say_code(axis_code(plane_axes(run.modal.plane).w), "it lies in the working plane, and this is the tool axis");
    for (const Code c : {Code::a, Code::b, Code::c, Code::u, Code::v, Code::w})
        say_code(c, "its axis is not one of the working plane");
    for (const Code c : {Code::tool, Code::tool_change, Code::tool_definition}) {
        if (!b.has(c)) continue;
        foreign(run, run.here(), "the tool is that of the cycle");
        break;
    }
    for (const Code c : {Code::cycle_call, Code::cycle_call_modal}) say_code(c, "it cannot call cycles");
    if (b.special == Modal::cycle_position || b.special == Modal::cycle_pattern)
        foreign(run, run.here(), "it cannot call cycles");
    else if (b.suppress != Modal::linear || b.retract != 0)
        foreign(run, run.here(), "what the control makes of it there is not known");
    else
        modes_in_milled(run);
    functions_in_milled(run);
}

/// What acts where the contour is finished, and not while a cycle cuts down to it.
void words_in_turned(Moving& run) {
    const std::string only = run.look == Look::turned_blocks ? " acts only where the contour is finished"
                                                             : " has no effect in the contour of a turning cycle";
    if (run.look == Look::turned_blocks)
        for (const Code c : {Code::y, Code::a, Code::b, Code::c})
            if (run.block.has(c)) foreign(run, place_of(run, c), "it lies in the plane of X and Z");
    if (run.block.has(Code::tool))
        assume(run, place_of(run, Code::tool), text_at(run, place_of(run, Code::tool)) + only);
    for (const int m : run.block.m) assume(run, place_of(run, Code::m), "M" + std::to_string(m) + only);
}

bool is_transformation(CycleKind k) {
    return k == CycleKind::datum_shift || k == CycleKind::mirror || k == CycleKind::rotation ||
           k == CycleKind::scaling || k == CycleKind::axis_scaling;
}

}  // namespace

void say_foreign_words(Moving& run) {
    if (run.look == Look::milled_contour) return words_in_milled(run);
    if (run.look == Look::turned_subprogram || run.look == Look::turned_blocks) words_in_turned(run);
}

bool say_foreign_statement(Saying& run, const Statement& s) {
    if (run.look != Look::milled_contour) return false;
    const Unit& unit = run.unit();
    // Of those that have an entry; LBL 0 has no word at all.
    const auto entry = [&] { return static_cast<std::size_t>(unit.words[s.first].payload); };
    switch (s.kind) {
        case StatementKind::cycle_definition:
            if (is_transformation(unit.cycles[entry()].kind)) return false;
            foreign(run, unit.cycles[entry()].where, "of cycles only transformations can stand there");
            return true;
        case StatementKind::special: {
            const program::SpecialKind k = unit.specials[entry()].kind;
            if (k >= program::SpecialKind::free_pole && k <= program::SpecialKind::free_select) return false;
            foreign(run, unit.span(s), "it has only lines, arcs, chamfers and roundings");
            return true;
        }
        case StatementKind::pattern:
        case StatementKind::contour: foreign(run, unit.span(s), "it cannot define others, nor points"); return true;
        default: return false;
    }
}

}  // namespace obrys::interp
