/// Labels called like subprograms, and sections repeated up to a call (CALL LBL, REP, LBL 0).

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr double most_label_repeats = 65534;

std::uint32_t target_of(Reckoning& run, const program::LabelCall& c) {
    if (c.target != program::no_target) return c.target;
    const Value v = evaluate(run, c.label);
    if (run.stopped) return program::no_target;
    const auto found = run.unit().labels.find(run.env.names.id(base::to_upper(printed(v))));
    if (found != run.unit().labels.end()) return found->second.front();
    if (v.is_unknown())
        unchecked(run, codes::unknown_value, run.unit().span(c.label),
                  "which label this is is not known: the call is left out");
    else
        alarm(run, codes::missing_label, run.unit().span(c.label),
              "there is no label " + printed(v) + " in this program");
    return program::no_target;
}

/// As the block names it.
std::string label_name(Reckoning& run, const program::LabelCall& c) {
    return c.label != program::no_expr ? printed(evaluate(run, c.label)) : std::string();
}

void too_deep(Saying& run, const std::string& text) {
    unchecked(run, codes::budget, run.here(), text, "the control allows no more");
    run.stopped = true;
    run.ending = Ending::budget;
}

void repeat(Telling& run, std::uint32_t target, const program::LabelCall& c, std::uint32_t index) {
    const double passes = number(run, c.repeats);
    if (std::isnan(passes))
        unchecked(run, codes::unknown_value, run.here(),
                  "how often this section is repeated depends on a value that is not known: it is not repeated");
    if (passes < 0 || passes > most_label_repeats)
        alarm(run, codes::value_range, run.unit().span(c.repeats),
              "REP needs a number from 0 to 65534, this is " + base::shortest(passes));
    if (run.stopped || !(passes >= 1)) return;
    Activation& act = run.top();
    if (target >= index) {
        alarm(run, codes::missing_label, run.unit().span(c.label),
              "a section can only be repeated from a label before this block");
        return;
    }
    if (act.sections.size() >= run.env.budgets.call_depth)
        return too_deep(run, "repeated sections are nested too deep");
    ActiveSection section{target, index - 1, index + 1, times_of(passes)};
    section.name = label_name(run, c);
    begin_repetition(run, std::move(section));
}

}  // namespace

void call_label(Telling& run, const program::LabelCall& c, std::uint32_t index) {
    const std::uint32_t target = target_of(run, c);
    if (target == program::no_target) return;
    if (c.repeats != program::no_expr) return repeat(run, target, c, index);
    Activation& act = run.top();
    const std::uint32_t depth = run.unit().traits->label_depth;
    if (act.labels.size() >= depth)
        return too_deep(run, "labels are called more than " + std::to_string(depth) + " levels deep");
    act.labels.push_back({index + 1, act.stack});
    begin_part(run, cl::PartKind::label, label_name(run, c), 1, 1);
    act.stack = run.stacks->push(act.stack, run.here());
    act.pc = target;
}

void end_label(Telling& run) {
    Activation& act = run.top();
    auto& ended = act.ended_labels;
    const bool known = std::find(ended.begin(), ended.end(), act.pc) != ended.end();
    if (act.labels.empty()) {  // run through in passing: the label's text belongs to the program as well
        if (known)
            assume(run, run.here(), "the program runs on through a section that it has called before, to its end here",
                   "see whether the end of the program (M30) is missing before the section");
        return;
    }
    if (!known) ended.push_back(act.pc);
    end_part(run);
    act.pc = act.labels.back().pc;
    act.stack = act.labels.back().stack;
    act.labels.pop_back();
}

}  // namespace obrys::interp
