/// What LinuxCNC remembers of a break, a continue and a repeat past the loop they belong to (Traits::loops_remember).
/// Its interpreter (interp_o_word.cc of 2.9 and 2.10) holds one mark of each kind for all loops. A break sets the
/// first, and so does a line of break that is passed over on the way to the end of its loop; the end of a do takes it,
/// that of a while does not. A continue sets the second; the ends of a while and of a repeat take it, that of a do does
/// not. The passes left of a repeat belong to its label: a return leaves them as they are.

#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr const char* no_do = "write that do as while and endwhile";

void say(Saying& run, const std::string& text, const char* remedy) {
    unchecked(run, codes::unsupported, run.here(), text + ": a fault of the control's own, which is followed here",
              remedy);
}

const program::Branch& branch_of(const Unit& unit, std::uint32_t statement) {
    return unit.branches[static_cast<std::size_t>(unit.words[unit.statements[statement].first].payload)];
}

/// The repeat has no pass left: its end may take a continue of another loop for one of its own.
void end_passes(Calling& run, std::uint32_t opener, std::uint32_t behind) {
    run.marks.left.erase({&run.unit(), opener});
    if (!std::exchange(run.marks.passed, false)) return go_on_at(run, behind);
    say(run, "the control counts the passes of this repeat once more, as it remembers a continue of a do before it",
        no_do);
    go_back(run, opener);
}

double passes_of(Reckoning& run, const program::Branch& b) {
    const double n = std::round(number(run, b.condition));
    if (!run.stopped && std::isnan(n))
        unchecked(run, codes::unknown_value, run.unit().span(b.condition),
                  "how often this loop runs depends on a value that is not known: it is not run");
    return n >= 1 ? n : 0;
}

}  // namespace

void leave_loop(Calling& run, const program::Jump& j) {
    LoopMarks& marks = run.marks;
    marks.broke =
        j.leaves == program::Leaves::while_ || (j.leaves != program::Leaves::do_ && (marks.broke || j.has_break));
    if (j.leaves == program::Leaves::do_pass) marks.passed = true;
    if (j.leaves == program::Leaves::do_ || j.leaves == program::Leaves::do_pass) return go_on_at(run, j.target);
    const bool remembered = std::exchange(marks.passed, false);
    if (j.leaves == program::Leaves::while_pass || !remembered) return go_on_at(run, j.target);
    say(run,
        "the control does not leave the while with this break but asks its condition again, as it remembers a continue "
        "of a do before it",
        no_do);
    go_back(run, branch_of(run.unit(), j.target - 1).target);
}

void pass_over(Calling& run, const program::Branch& b) {
    run.marks.broke = run.marks.broke || b.has_break;
    run.marks.passed = false;
}

bool ends_do(Calling& run, bool done) {
    if (!std::exchange(run.marks.broke, false) || done) return done;
    say(run,
        "the control does not repeat this do though its condition holds, as it remembers a break before it, or passed "
        "over one on the way to the end of a loop",
        no_do);
    return true;
}

void begin_remembered_repeat(Calling& run, const program::Branch& b, std::uint32_t index) {
    if (!owns_label(run, b, index)) return;
    const auto [at, is_new] = run.marks.left.try_emplace({&run.unit(), index}, 0);
    const double passes = is_new ? passes_of(run, b) : static_cast<double>(at->second);
    if (run.stopped) return;
    if (!is_new)
        unchecked(run, codes::unsupported, run.here(),
                  "the control goes on counting this repeat where a return or an outer call has left it, and so does "
                  "obrys: passes left here: " +
                      std::to_string(at->second),
                  "let it come to its end, or write while and endwhile with a counter");
    if (!(passes >= 1)) return end_passes(run, index, b.target);
    at->second = times_of(passes) - 1;
}

void end_remembered_repeat(Calling& run, const program::Branch& b) {
    const auto at = run.marks.left.find({&run.unit(), b.target});
    if (at == run.marks.left.end()) return go_back(run, b.target);
    if (at->second == 0) return end_passes(run, b.target, run.top().pc);
    --at->second;
    go_back(run, b.target + 1);
}

bool owns_label(Calling& run, const program::Branch& opener, std::uint32_t index) {
    if (opener.same_label == 0) return true;
    const auto [at, is_new] = run.marks.labels.try_emplace({&run.unit(), opener.same_label}, index);
    if (is_new || at->second == index) return true;
    const Unit& unit = run.unit();
    const base::Span first = unit.span(unit.statements[at->second], unit.words[unit.statements[at->second].first]);
    alarm(run, codes::syntax, run.here(),
          "the label of this line belongs to the structure of line " +
              std::to_string(run.env.sources.position(first).line) + ", where this run has come by",
          "give this one a label of its own");
    return false;
}

}  // namespace obrys::interp
