/// Branches, loops and jumps.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

using program::Statement;
using program::StatementKind;
namespace codes = base::codes;

namespace {

/// Goes to `target`; a missing end of a structure (reported by the reader) ends the program part.
void go(Saying& run, std::uint32_t target) {
    Activation& act = run.top();
    act.pc = target == program::no_target ? static_cast<std::uint32_t>(act.unit->statements.size()) : target;
}

void go_back(Calling& run, std::uint32_t target) {
    count_pass(run, target);
    if (!run.stopped) go(run, target);
}

double loop_variable(Reckoning& run, const program::For& f) { return number(run, f.variable); }

void set_loop_variable(Reckoning& run, const program::For& f, double v) {
    const program::Expr& e = run.unit().exprs[f.variable];
    if (e.kind == program::ExprKind::parameter && e.a < run.parameters.count()) {
        run.parameters.set(e.a, v);
        return;
    }
    if (const Binding* b = find_variable(run, e.a); b != nullptr && e.kind == program::ExprKind::variable) {
        std::size_t index = b->offset;
        if (!b->element && !element_of(run, e, *b->array, index)) return;
        Value value = Value::real(v);
        if (convert(value, b->array->type) == Conversion::ok) {
            b->array->set(index, value);
            return;
        }
    }
    alarm(run, codes::type_mismatch, run.unit().span(f.variable), "FOR needs a number variable that is defined");
}

void say_unknown_passes(Saying& run, const char* then) {
    const std::string text = "how often this loop runs depends on a value that is not known: ";
    unchecked(run, codes::unknown_value, run.here(), text + then);
}

void begin_for(Reckoning& run, const program::For& f, std::uint32_t index) {
    auto& unknown = run.top().unknown_loops;
    std::erase(unknown, index);
    set_loop_variable(run, f, number(run, f.from));
    if (run.stopped) return;
    const double last = number(run, f.to);
    if (std::isnan(last) || std::isnan(loop_variable(run, f))) {
        unknown.push_back(index);
        return say_unknown_passes(run, "it is run once");
    }
    if (loop_variable(run, f) > last) go(run, f.target == program::no_target ? f.target : f.target + 1);
}

void end_for(Calling& run, const program::For& f) {
    if (f.target == program::no_target || std::erase(run.top().unknown_loops, f.target) != 0) return;
    const Unit& unit = run.unit();
    const program::For& head = unit.fors[static_cast<std::size_t>(unit.words[unit.statements[f.target].first].payload)];
    set_loop_variable(run, head, loop_variable(run, head) + 1);
    if (run.stopped) return;
    const double at = loop_variable(run, head), last = number(run, head.to);
    if (std::isnan(at) || std::isnan(last)) return say_unknown_passes(run, "it ends here");
    if (at <= last) go_back(run, f.target + 1);
}

void run_case(Calling& run, const program::Case& c) {
    const Value selector = evaluate(run, c.selector);
    if (selector.is_unknown())
        unchecked(run, codes::unknown_value, run.unit().span(c.selector),
                  "where this CASE goes depends on a value that is not known",
                  "DEFAULT is taken; the run may go another way on the machine");
    for (const program::CaseArm& arm : c.arms) {
        if (run.stopped) return;
        if (arm.value != program::no_expr) {
            const Value v = evaluate(run, arm.value);
            if (v.is_unknown() && !selector.is_unknown())
                unchecked(run, codes::unknown_value, run.unit().span(arm.value),
                          "whether this arm of the CASE is taken depends on a value that is not known",
                          "it is not taken; the run may go another way on the machine");
            if (v.is_unknown() || selector.is_unknown()) continue;
            const bool equal = v.is_text() ? v.as_text() == selector.as_text() : v.number == selector.number;
            if (!equal) continue;
        }
        jump(run, arm.jump);
        return;
    }
}

std::uint32_t nearest(const std::vector<std::uint32_t>& at, std::uint32_t here, program::JumpDirection d) {
    const auto after = std::upper_bound(at.begin(), at.end(), here);
    const bool forward = d != program::JumpDirection::backward;
    if (forward && after != at.end()) return *after;
    if (d == program::JumpDirection::forward) return program::no_target;
    if (d == program::JumpDirection::backward) return after == at.begin() ? program::no_target : *std::prev(after);
    return at.empty() ? program::no_target : at.front();
}

/// Statements that carry block number `n`; the text is gone through when a program first jumps to a computed one.
std::vector<std::uint32_t> numbered_blocks(const Saying& run, std::int64_t n) {
    const auto [unit, added] = run.block_numbers.try_emplace(&run.unit());
    auto& index = unit->second;
    const auto& statements = run.unit().statements;
    for (std::uint32_t i = 0; added && i < statements.size(); ++i) {
        if ((statements[i].flags & program::line_start) == 0) continue;
        if (const auto number = run.env.sources.block_number(run.unit().file, statements[i].begin))
            index[*number].push_back(i);
    }
    const auto found = index.find(n);
    return found == index.end() ? std::vector<std::uint32_t>{} : found->second;
}

}  // namespace

std::vector<std::uint32_t> numbered_statements(const Saying& run, double n) {
    const auto whole = base::whole<std::int64_t>(n, 0, 1'000'000'000);
    if (!whole) return {};
    const auto found = run.unit().labels.find(run.env.names.id("N" + std::to_string(*whole)));
    return found != run.unit().labels.end() ? found->second : numbered_blocks(run, *whole);
}

namespace {

std::uint32_t find_destination(Saying& run, const std::string& name, program::JumpDirection d) {
    const std::uint32_t here = run.top().pc - 1;
    const std::string upper = base::to_upper(name);
    if (const auto found = run.unit().labels.find(run.env.names.id(upper)); found != run.unit().labels.end())
        return nearest(found->second, here, d);
    const bool numbered = upper.size() > 1 && (upper[0] == 'N' || upper[0] == ':');
    const auto n = numbered ? base::parse_integer(std::string_view(upper).substr(1)) : std::nullopt;
    if (!n || !run.unit().traits->jump_to_block_number) return program::no_target;
    return nearest(numbered_blocks(run, *n), here, d);
}

}  // namespace

namespace {

/// M99 of the main program: it would begin anew, or at an earlier block.
void end_of_pass(Calling& run, const program::Jump& j) {
    assume(run, run.here(),
           std::string(run.traits->repeats_program) + " repeats the main program without end: one pass is run");
    if (j.condition == program::no_expr) say_blocks_behind(run, std::string(run.traits->repeats_program));
    flush_path(run);
    tell_end(run, 2);
    emit(run, cl::Stop{cl::StopKind::end});
    run.stopped = true;
}

}  // namespace

namespace {

/// A global text of that name, where the jump's word is no label: GOTOF NAME with NAME among the user data.
const Binding* named_text(Saying& run, const std::string& name) {
    const Binding* b = find_variable(run, run.env.names.id(base::to_upper(name)));
    return b != nullptr && b->array->type == Type::string && b->array->rank == 0 ? b : nullptr;
}

/// The statement that the jump's text or number names; no_target where there is none, after an alarm.
std::uint32_t computed_target(Reckoning& run, const program::Jump& j) {
    const Value v = evaluate(run, j.destination);
    if (run.stopped) return program::no_target;
    if (v.is_unknown()) {
        unchecked(run, codes::unknown_value, run.unit().span(j.destination),
                  "where this jump goes depends on a value that is not known: it is left out");
        return program::no_target;
    }
    std::string name = v.is_text() ? v.as_text() : "N" + printed(v);
    std::uint32_t target = find_destination(run, name, j.direction);
    if (const Binding* b = target == program::no_target ? named_text(run, name) : nullptr) {
        note_held(run, *b->array, b->offset, run.unit().span(j.destination));
        const Value held = b->array->get(b->offset);
        if (held.is_unknown()) return program::no_target;
        name = held.as_text();
        target = find_destination(run, name, j.direction);
    }
    if (target != program::no_target || j.direction == program::JumpDirection::either_quiet) return target;
    const char* way = j.direction == program::JumpDirection::forward    ? " behind this block"
                      : j.direction == program::JumpDirection::backward ? " before this block"
                                                                        : "";
    alarm(run, codes::missing_label, run.unit().span(j.destination),
          "there is no label " + name + way + " in this program");
    return program::no_target;
}

}  // namespace

void jump(Calling& run, const program::Jump& j) {
    if (j.condition != program::no_expr && !truth(run, j.condition)) return;
    if (run.stopped) return;
    if (j.direction == program::JumpDirection::start && !run.traits->repeats_program.empty())
        return end_of_pass(run, j);
    if (j.direction == program::JumpDirection::start) {
        go_back(run, 0);
        return;
    }
    std::uint32_t target = j.target;
    if (target == program::no_target) target = computed_target(run, j);
    if (run.stopped || target == program::no_target) return;
    if (target >= run.top().pc) return go(run, target);
    if (j.direction == program::JumpDirection::again && run.calls.size() == 1) return end_of_pass(run, j);
    go_back(run, target);
}

namespace {

void repeat_section(Telling& run, const program::Section& s, std::uint32_t index) {
    const Unit& unit = run.unit();
    const auto place = [&](program::NameId label) {
        const auto found = unit.labels.find(label);
        return found == unit.labels.end() ? program::no_target
               : nearest(found->second, index, program::JumpDirection::backward) != program::no_target
                   ? nearest(found->second, index, program::JumpDirection::backward)
                   : nearest(found->second, index, program::JumpDirection::forward);
    };
    const double passes = s.passes == program::no_expr ? 1 : number(run, s.passes);
    if (std::isnan(passes))
        unchecked(run, codes::unknown_value, run.here(),
                  "how often this section is repeated depends on a value that is not known: it is not repeated");
    if (run.stopped || !(passes >= 1)) return;
    ActiveSection active;
    active.first = place(s.first);
    active.last = s.to_here ? index - 1 : s.one_block ? active.first : place(s.last);
    if (active.first == program::no_target || active.last == program::no_target || active.last < active.first) {
        alarm(run, codes::missing_label, run.here(),
              "REPEAT: the label is not in this program, or the last one stands before the first");
        return;
    }
    if (!s.to_here)  // the rest of the label's block, which may be several statements
        while (active.last + 1 < unit.statements.size() &&
               (unit.statements[active.last + 1].flags & program::line_start) == 0)
            ++active.last;
    if (run.top().sections.size() >= run.env.budgets.call_depth) {
        unchecked(run, codes::budget, run.here(), "REPEAT sections are nested too deep");
        run.stopped = true;
        run.ending = Ending::budget;
        return;
    }
    active.back = index + 1;
    active.left = times_of(passes);
    begin_repetition(run, std::move(active));
}

/// The count is taken once, at the start.
void begin_repeat(Reckoning& run, const program::Branch& b, std::uint32_t index) {
    const double n = std::round(number(run, b.condition));
    if (run.stopped) return;
    if (std::isnan(n))
        unchecked(run, codes::unknown_value, run.unit().span(b.condition),
                  "how often this loop runs depends on a value that is not known: it is not run");
    if (!(n >= 1)) return go(run, b.target);
    auto& counters = run.top().counters;
    std::erase_if(counters, [&](const auto& c) { return c.statement == index; });
    counters.push_back({index, times_of(n)});
}

void end_repeat(Calling& run, const program::Branch& b) {
    auto& counters = run.top().counters;
    const auto c =
        std::find_if(counters.begin(), counters.end(), [&](const auto& k) { return k.statement == b.target; });
    if (c == counters.end()) return;
    if (--c->left > 0) return go_back(run, b.target + 1);
    counters.erase(c);
}

/// The cycle, and the words of its block that do not belong to it.
void cycle_definition(Cycling& run, const program::Statement& s, std::uint32_t index) {
    const Unit& unit = run.unit();
    define_cycle(run, unit.cycles[static_cast<std::size_t>(unit.words[s.first].payload)]);
    for (std::uint32_t w = s.first + 1; w < unit.words_end(index) && !run.stopped; ++w) gather(run, s, unit.words[w]);
}

}  // namespace

namespace {

/// What the program has written to end: "M99", "RET", "return" of `o100 return`.
std::string return_word(const Reckoning& run, const Statement& s) {
    const std::string text(run.env.sources.text(run.unit().span(s, run.unit().words[s.first])));
    const std::string word = base::to_upper(text.substr(0, text.find_first_of(" \t(;")));
    return word.starts_with('O') ? "return" : word;
}

/// Kinds that are run elsewhere and have no entry in a table; false where `s` is none of them.
bool run_plain(Cycling& run, const Statement& s, std::uint32_t index) {
    switch (s.kind) {
        case StatementKind::block: run_block(run, s, index); return true;
        case StatementKind::frame: frame_statement(run, s, index); return true;
        case StatementKind::special: run_special(run, s, index); return true;
        case StatementKind::return_: {
            const auto to = static_cast<std::size_t>(run.unit().words[s.first].payload);
            // Often the same one comes again: the program's text is not asked then.
            if (!run.ends_told.contains({run.top().unit, run.top().pc})) say_blocks_behind(run, return_word(run, s));
            if (to == 0) return leave(run), true;
            return return_to_block(run, run.unit().jumps[to - 1]), true;
        }
        case StatementKind::label_end: end_label(run); return true;
        default: return false;
    }
}

}  // namespace

void run_statement(Cycling& run, const Statement& s, std::uint32_t index) {
    settle_motion(run);
    const Unit& unit = run.unit();
    if (run.look > Look::next_element && say_foreign_statement(run, s)) return;
    if (run_plain(run, s, index)) return;
    const auto table = static_cast<std::size_t>(unit.words[s.first].payload);
    switch (s.kind) {
        case StatementKind::if_:
        case StatementKind::while_: {
            const program::Branch& b = unit.branches[table];
            const bool yes = truth(run, b.condition);
            if (!run.stopped && !yes) go(run, b.target);
            return;
        }
        case StatementKind::else_: go(run, unit.branches[table].target); return;
        case StatementKind::endif:
        case StatementKind::repeat_:
        case StatementKind::loop_: return;
        case StatementKind::endwhile:
        case StatementKind::endloop:
            if (unit.branches[table].target != program::no_target) go_back(run, unit.branches[table].target);
            return;
        case StatementKind::until: {
            const program::Branch& b = unit.branches[table];
            const bool done = truth(run, b.condition, true);  // an unknown UNTIL must not loop for ever
            if (!run.stopped && !done && b.target != program::no_target) go_back(run, b.target);
            return;
        }
        case StatementKind::repeat_count: begin_repeat(run, unit.branches[table], index); return;
        case StatementKind::end_repeat_count: end_repeat(run, unit.branches[table]); return;
        case StatementKind::for_: begin_for(run, unit.fors[table], index); return;
        case StatementKind::endfor: end_for(run, unit.fors[table]); return;
        case StatementKind::case_: run_case(run, unit.cases[table]); return;
        case StatementKind::jump: jump(run, unit.jumps[table]); return;
        case StatementKind::repeat_section: repeat_section(run, unit.sections[table], index); return;
        case StatementKind::label_call: return call_label(run, unit.label_calls[table], index);
        case StatementKind::cycle_definition: return cycle_definition(run, s, index);
        case StatementKind::pattern: return define_pattern(run, unit.patterns[table]);
        case StatementKind::contour: return contour_statement(run, unit.contours[table]);
        case StatementKind::call: call_program(run, unit.calls[table]); return;
        case StatementKind::procedure: procedure(run, unit.procedures[table]); return;
        case StatementKind::define:
            if (!run.top().is_text) judge_place_of_definition(run, unit, index);
            return define(run, unit.defines[table], run.top().locals, unit);
        default: return;
    }
}

}  // namespace obrys::interp
