/// How often loops have run: their limit, and those that nothing can end.

#include <algorithm>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"
#include "interp/calls/endless.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// A loop is looked at after so many passes, and ended after so many more that cannot have been the last.
constexpr std::uint64_t passes_before_look = 100;

void end_by_budget(Saying& run, const base::Span& where, std::string text, std::string remedy) {
    unchecked(run, codes::budget, where, std::move(text), std::move(remedy));
    run.stopped = true;
    run.ending = Ending::budget;
}

/// Watches the loop from now on where nothing in it changes what its conditions ask for.
void watch(Calling& run, const Loop& loop) {
    const WatchedLoop& w = run.watched;
    if (w.depth == run.calls.size() && w.first == loop.first && w.last == loop.last) return;  // it is
    const bool calls_between = run.modal_call.is_on();  // a program that may change anything
    if (!calls_between && why_endless(run.unit(), loop, run.env.names))
        run.watched = {run.calls.size(), loop.first, loop.last, 0};
}

/// True where the loop was watched long enough: the run ends.
bool ends_endless(Calling& run, const Loop& loop, std::uint64_t passes) {
    WatchedLoop& w = run.watched;
    const std::uint64_t most = run.env.budgets.loop_passes;
    if (w.depth == 0 || w.first != loop.first || w.last != loop.last) return false;
    if (++w.passes < passes_between_looks && passes <= most) return false;
    const auto endless = why_endless(run.unit(), loop, run.env.names);
    end_by_budget(run, run.unit().span(run.unit().statements[endless->condition]),
                  "this loop does not end: " + endless->why + "; the run was ended after " +
                      std::to_string(std::min(passes, most)) + " passes",
                  endless->remedy);
    return true;
}

}  // namespace

void count_pass(Calling& run, std::uint32_t target) {
    Activation& act = run.top();
    const auto index = static_cast<std::uint32_t>(run.statement - act.unit->statements.data());
    auto it = std::find_if(act.passes.begin(), act.passes.end(),
                           [&](const auto& p) { return p.statement == index && p.target == target; });
    if (it == act.passes.end()) it = act.passes.insert(act.passes.end(), {index, target, 0});
    ++it->count;
    if (ends_endless(run, {target, index}, it->count)) return;
    if (target <= index && (it->count == passes_before_look || it->count % passes_between_looks == 0))
        watch(run, {target, index});
    const std::uint64_t most = run.env.budgets.loop_passes;
    if (it->count <= most) return;
    end_by_budget(run, run.here(), "this loop ran " + std::to_string(most) + " passes without ending",
                  "check its condition; raise loop_passes in [budget] of the job if it really needs more");
}

}  // namespace obrys::interp
