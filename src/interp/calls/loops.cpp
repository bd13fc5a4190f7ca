/// FOR, REPEAT, CASE and sections that are repeated.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

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

}  // namespace

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
    if (loop_variable(run, f) > last) go_on_at(run, f.target == program::no_target ? f.target : f.target + 1);
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

void begin_repeat(Calling& run, const program::Branch& b, std::uint32_t index) {
    if (run.unit().traits->loops_remember) return begin_remembered_repeat(run, b, index);
    const double n = std::round(number(run, b.condition));
    if (run.stopped) return;
    if (std::isnan(n))
        unchecked(run, codes::unknown_value, run.unit().span(b.condition),
                  "how often this loop runs depends on a value that is not known: it is not run");
    if (!(n >= 1)) return go_on_at(run, b.target);
    auto& counters = run.top().counters;
    std::erase_if(counters, [&](const auto& c) { return c.statement == index; });
    counters.push_back({index, times_of(n)});
}

void end_repeat(Calling& run, const program::Branch& b) {
    if (run.unit().traits->loops_remember) return end_remembered_repeat(run, b);
    auto& counters = run.top().counters;
    const auto c =
        std::find_if(counters.begin(), counters.end(), [&](const auto& k) { return k.statement == b.target; });
    if (c == counters.end()) return;
    if (--c->left > 0) return go_back(run, b.target + 1);
    counters.erase(c);
}

}  // namespace obrys::interp
