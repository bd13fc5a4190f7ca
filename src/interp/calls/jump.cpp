/// Jumps: to labels, block numbers and texts that name one.

#include <algorithm>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

void go_back(Calling& run, std::uint32_t target) {
    count_pass(run, target);
    if (!run.stopped) go_on_at(run, target);
}

std::uint32_t nearest(const std::vector<std::uint32_t>& at, std::uint32_t here, program::JumpDirection d) {
    const auto after = std::upper_bound(at.begin(), at.end(), here);
    const bool forward = d != program::JumpDirection::backward;
    if (forward && after != at.end()) return *after;
    if (d == program::JumpDirection::forward) return program::no_target;
    if (d == program::JumpDirection::backward) return after == at.begin() ? program::no_target : *std::prev(after);
    return at.empty() ? program::no_target : at.front();
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

/// M99 of the main program: it would begin anew, or at an earlier block, `target`.
void end_of_pass(Calling& run, const program::Jump& j, std::uint32_t target) {
    assume(run, run.here(),
           std::string(run.traits->repeats_program) + " repeats the main program without end: one pass is run");
    if (j.condition == program::no_expr) say_blocks_behind(run, std::string(run.traits->repeats_program));
    flush_path(run);
    hear_end(run, 2);
    emit(run, cl::Stop{cl::StopKind::end});
    run.repeats = true;
    run.repeats_from = target == 0 ? 0 : run.unit().statements[target].begin;
    run.stopped = true;
}

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
    if (j.leaves != program::Leaves::nothing) return leave_loop(run, j);
    if (j.direction == program::JumpDirection::start && !run.traits->repeats_program.empty())
        return end_of_pass(run, j, 0);
    if (j.direction == program::JumpDirection::start) {
        go_back(run, 0);
        return;
    }
    std::uint32_t target = j.target;
    if (target == program::no_target) target = computed_target(run, j);
    if (run.stopped || target == program::no_target) return;
    if (target >= run.top().pc) return go_on_at(run, target);
    if (j.direction == program::JumpDirection::again && run.calls.size() == 1) return end_of_pass(run, j, target);
    go_back(run, target);
}

}  // namespace obrys::interp
