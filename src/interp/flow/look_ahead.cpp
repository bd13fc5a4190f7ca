#include "interp/flow/look_ahead.hpp"

#include <cassert>
#include <utility>

#include "base/text.hpp"
#include "interp/capture.hpp"
#include "interp/flow/flow.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace {

constexpr std::size_t most_statements = 100'000;  ///< of a contour, loops counted
constexpr std::size_t most_ahead = 500;           ///< statements looked at for the next element

/// While it lives, the run emits nothing and collects its elements and complaints; at its end the run stands where it
/// stood, with every value as it was.
class Rehearsal {
public:
    Rehearsal(Run& run, Look purpose);
    ~Rehearsal();
    Rehearsal(const Rehearsal&) = delete;
    Rehearsal& operator=(const Rehearsal&) = delete;

    std::vector<Captured> elements;
    Complaints complaints;

private:
    Run& run_;
    RunState saved_;
    std::unique_ptr<PathStage> path_;
};

// The state is put aside and a copy run, not the other way round: what callers point into is theirs again afterwards.
Rehearsal::Rehearsal(Run& r, Look purpose) : run_(r), saved_(std::move(static_cast<RunState&>(r))) {
    static_cast<RunState&>(run_) = saved_;
    path_.swap(run_.path);  // nothing held back may come out
    run_.path = std::make_unique<PathStage>();
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

bool reaches_end_of_label(Calling& run, std::size_t depth) {
    for (std::size_t n = 0; n < most_statements && !run.stopped; ++n) {
        const bool ended = run.calls.size() == depth + 1 && run.top().labels.empty();
        if (ended || run.calls.size() <= depth) return true;
        run.onward->step();
    }
    return false;
}

bool reaches_end_of_program(Calling& run, const Unit& unit) {
    const std::size_t depth = run.calls.size();
    enter(run, unit, nullptr, run.here());
    if (run.calls.size() == depth) return false;
    for (std::size_t n = 0; n < most_statements; ++n) {
        if (run.calls.size() <= depth || (run.stopped && run.ending == Ending::regular)) return true;
        if (run.stopped) return false;
        run.onward->step();
    }
    return false;
}

/// False where the run leaves the stretch elsewhere, too.
bool reaches_end_of_blocks(Calling& run, std::uint32_t first, std::uint32_t last) {
    const std::size_t depth = run.calls.size();
    std::uint32_t ran = first;  // a jump to the block behind the last one is no end, either
    for (std::size_t n = 0; n < most_statements && !run.stopped; ++n) {
        if (run.calls.size() != depth) return false;
        if (run.top().pc < first || run.top().pc > last) return run.top().pc == last + 1 && ran == last;
        ran = run.top().pc;
        run.onward->step();
    }
    return false;
}

class LookAhead final : public Onward {
public:
    explicit LookAhead(Run& run) : run_(run) {}
    void step() override { interp::step(run_); }

    std::optional<Captured> next_element(const geom::Vec3& from) override {
        assert(run_.look != Look::next_element);  // looking ahead within looking ahead repeats it 2^n times
        const Rehearsal rehearsal(run_, Look::next_element);
        run_.programmed_position = from;
        run_.position = geom::apply(run_.frame, from);
        for (std::size_t n = 0; n < most_ahead && !run_.stopped; ++n) {
            step();
            for (const Captured& c : rehearsal.elements)
                if (path::moves_in_plane(c.element)) return c;
        }
        return std::nullopt;
    }

    Looked label(const Unit& unit, const std::string& label) override {
        const auto found = unit.labels.find(run_.env.names.id(base::to_upper(label)));
        if (found == unit.labels.end()) return {};
        Rehearsal rehearsal(run_, Look::milled_contour);
        const std::size_t depth = run_.calls.size();
        Activation contour;
        contour.unit = &unit;
        contour.stack = run_.stacks->push(run_.top().stack, run_.here());
        contour.pc = found->second.front();
        contour.labels.push_back({static_cast<std::uint32_t>(unit.statements.size()), contour.stack});
        run_.calls.push_back(std::move(contour));
        const bool ended = reaches_end_of_label(run_, depth);
        return {std::move(rehearsal.elements), std::move(rehearsal.complaints), ended};
    }

    Looked program(const Unit& unit) override {
        Rehearsal rehearsal(run_, Look::milled_contour);
        const bool ended = reaches_end_of_program(run_, unit);
        return {std::move(rehearsal.elements), std::move(rehearsal.complaints), ended};
    }

    Looked turned_contour(const Unit& unit, const geom::Vec3& from) override {
        Rehearsal rehearsal(run_, Look::turned_subprogram);
        arrive(run_, from);
        // The contour of a turning cycle begins with lines, whatever is in force where the cycle stands.
        if (run_.modal.motion == Modal::canned_off) run_.modal.motion = Modal::linear;
        const bool ended = reaches_end_of_program(run_, unit);
        return {std::move(rehearsal.elements), std::move(rehearsal.complaints), ended};
    }

    Looked blocks(std::uint32_t first, std::uint32_t last) override {
        Rehearsal rehearsal(run_, Look::turned_blocks);
        run_.top().pc = first;
        run_.top().sections.clear();
        const bool ended = reaches_end_of_blocks(run_, first, last);
        return {std::move(rehearsal.elements), std::move(rehearsal.complaints), ended};
    }

private:
    Run& run_;
};

}  // namespace

std::unique_ptr<Onward> look_ahead(Run& run) { return std::make_unique<LookAhead>(run); }

void look_ahead_in_vain(Run& run, std::uint32_t statements) {
    const Rehearsal rehearsal(run, Look::next_element);
    for (std::uint32_t n = 0; n < statements && !run.stopped; ++n) step(run);
}

}  // namespace obrys::interp
