#include "interp/capture.hpp"

#include <cassert>
#include <utility>

#include "base/text.hpp"
#include "interp/path_stage.hpp"

namespace obrys::interp {

namespace {

constexpr std::size_t most_statements = 100'000;  ///< of a contour, loops counted
constexpr std::size_t most_ahead = 500;           ///< statements looked at for the next element

}  // namespace

// The state is put aside and a copy run, not the other way round: what callers point into is theirs again afterwards.
Rehearsal::Rehearsal(Run& r, Look purpose) : run_(r), saved_(std::move(static_cast<RunState&>(r))) {
    static_cast<RunState&>(run_) = saved_;
    path_ = std::exchange(run_.path, std::make_unique<PathStage>());  // nothing held back may come out
    run_.look = purpose;
    run_.capture = &elements;
    run_.complaints = &complaints;
    run_.cycle.modal = false;  // a cycle makes no elements
    run_.free_contour = {};    // its solver would go on with blocks that are only tried
}

Rehearsal::~Rehearsal() {
    saved_.steps = run_.steps;  // a run in which much is looked at comes to the end of its time, too
    saved_.out_of_time = run_.out_of_time;
    static_cast<RunState&>(run_) = std::move(saved_);
    run_.path = std::move(path_);
}

std::optional<std::vector<Captured>> Looked::said(Run& run, const std::string& of) && {
    say(run, complaints_, of);
    if (run.stopped || !ended_) return std::nullopt;
    return std::move(elements_);
}

std::optional<Captured> next_element(Run& run, const geom::Vec3& from) {
    assert(run.look != Look::next_element);  // looking ahead within looking ahead repeats it 2^n times
    const Rehearsal rehearsal(run, Look::next_element);
    run.programmed_position = from;
    run.position = geom::apply(run.frame, from);
    for (std::size_t n = 0; n < most_ahead && !run.stopped; ++n) {
        step(run);
        for (const Captured& c : rehearsal.elements)
            if (path::moves_in_plane(c.element)) return c;
    }
    return std::nullopt;
}

namespace {

bool reaches_end_of_label(Run& run, std::size_t depth) {
    for (std::size_t n = 0; n < most_statements && !run.stopped; ++n) {
        const bool ended = run.calls.size() == depth + 1 && run.top().labels.empty();
        if (ended || run.calls.size() <= depth) return true;
        step(run);
    }
    return false;
}

bool reaches_end_of_program(Run& run, const Unit& unit) {
    const std::size_t depth = run.calls.size();
    enter(run, unit, nullptr, run.here());
    if (run.calls.size() == depth) return false;
    for (std::size_t n = 0; n < most_statements; ++n) {
        if (run.calls.size() <= depth || (run.stopped && run.ending == Ending::regular)) return true;
        if (run.stopped) return false;
        step(run);
    }
    return false;
}

/// False where the run leaves the stretch elsewhere, too.
bool reaches_end_of_blocks(Run& run, std::uint32_t first, std::uint32_t last) {
    const std::size_t depth = run.calls.size();
    std::uint32_t ran = first;  // a jump to the block behind the last one is no end, either
    for (std::size_t n = 0; n < most_statements && !run.stopped; ++n) {
        if (run.calls.size() != depth) return false;
        if (run.top().pc < first || run.top().pc > last) return run.top().pc == last + 1 && ran == last;
        ran = run.top().pc;
        step(run);
    }
    return false;
}

}  // namespace

Looked elements_of_label(Run& run, const Unit& unit, const std::string& label) {
    const auto found = unit.labels.find(run.env.names.id(base::to_upper(label)));
    if (found == unit.labels.end()) return {};
    Rehearsal rehearsal(run, Look::milled_contour);
    const std::size_t depth = run.calls.size();
    Activation contour;
    contour.unit = &unit;
    contour.stack = run.stacks.push(run.top().stack, run.here());
    contour.pc = found->second.front();
    contour.labels.push_back({static_cast<std::uint32_t>(unit.statements.size()), contour.stack});
    run.calls.push_back(std::move(contour));
    const bool ended = reaches_end_of_label(run, depth);
    return {std::move(rehearsal), ended};
}

Looked elements_of_program(Run& run, const Unit& unit) {
    Rehearsal rehearsal(run, Look::milled_contour);
    const bool ended = reaches_end_of_program(run, unit);
    return {std::move(rehearsal), ended};
}

Looked elements_of_turned_contour(Run& run, const Unit& unit, const geom::Vec3& from) {
    Rehearsal rehearsal(run, Look::turned_subprogram);
    arrive(run, from);
    // The contour of a turning cycle begins with lines, whatever is in force where the cycle stands.
    if (run.modal.motion == Modal::canned_off) run.modal.motion = Modal::linear;
    const bool ended = reaches_end_of_program(run, unit);
    return {std::move(rehearsal), ended};
}

Looked elements_of_blocks(Run& run, std::uint32_t first, std::uint32_t last) {
    Rehearsal rehearsal(run, Look::turned_blocks);
    run.top().pc = first;
    run.top().sections.clear();
    const bool ended = reaches_end_of_blocks(run, first, last);
    return {std::move(rehearsal), ended};
}

void look_ahead_in_vain(Run& run, std::uint32_t statements) {
    const Rehearsal rehearsal(run, Look::next_element);
    for (std::uint32_t n = 0; n < statements && !run.stopped; ++n) step(run);
}

}  // namespace obrys::interp
