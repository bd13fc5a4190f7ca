/// Blocks: the words are gathered from left to right, then act together.

#include "interp/flow/flow.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace {

/// CYCL CALL POS and CYCL CALL PAT. Their feed is that of the way to the points and ends with the block.
void call_at_places(Cycling& run) {
    if (run.block.twice != 0) repeated_words(run);
    if (run.stopped) return;
    const double feed = run.feed;
    const bool valid = run.feed_valid;
    run.cycle.modal = false;
    technology(run);
    if (run.stopped) return;
    if (run.block.special == Modal::cycle_position)
        call_cycle_at_position(run);
    else
        call_cycle_at_pattern(run);
    if (run.stopped) return;
    if (valid && (feed != run.feed || !run.feed_valid)) {
        run.feed = feed;
        run.feed_valid = true;
        emit(run, cl::Feed{feed, run.modal.feed_mode});
    }
    report_unused(run);
    after_motion(run);
}

/// SINUMERIK, NC programming 12/2019, MCALL: it acts as well where F or S is programmed, or G0 or G1 stands in a block
/// without motion.
bool calls_without_motion(const Moving& run) {
    if (!run.traits->modal_call_without_motion || run.block.special == Modal::dwell) return false;
    if (run.modal.motion != Modal::rapid && run.modal.motion != Modal::linear) return false;
    return run.block.says_straight || run.block.has(Code::feed) || run.block.has(Code::spindle);
}

}  // namespace

bool run_block(Cycling& run, const program::Statement& s, std::uint32_t index) {
    const Unit& unit = run.unit();
    const std::uint32_t end = unit.words_end(index);
    run.block.clear();
    run.complained = false;
    bool assigns_only = true, says_only = true;
    for (std::uint32_t i = s.first; i < end; ++i) {
        says_only = says_only && program::code_of(unit.words[i]) == Code::comment;
        assigns_only = assigns_only && program::code_of(unit.words[i]) == Code::assign;
        gather(run, s, unit.words[i]);
        if (run.stopped) return false;
    }
    if (run.look > Look::next_element) say_foreign_words(run);
    if (run.block.special == Modal::cycle_position || run.block.special == Modal::cycle_pattern)
        return call_at_places(run), false;
    if (!run.block.pending.empty()) take_effect(run);
    if (run.stopped || assigns_only) return false;  // loops are full of blocks in which nothing else is to be done
    if (run.block.twice != 0) repeated_words(run);
    if (run.stopped) return false;
    if (run.traits->refuses_unready) refuse_block(run);
    if (run.stopped) return false;
    if (!run.block.acted) technology(run);
    if (run.stopped) return false;
    if (run.traits->offset_numbers_stay) keep_offset_numbers(run);
    if (run.stopped) return false;
    if (run.block.changes_plane) hold_plane(run);
    const bool moved = !run.stopped && motion(run);
    if (!says_only) run.path->end_block(run);
    if (run.block.feed_alone) end_feed_alone(run);
    if (!run.stopped && !run.underway.empty()) judge_underway(run, moved);
    if (!run.stopped && !run.block.positioned.empty()) position_axes(run, moved);
    if (run.stopped) return false;
    if (run.block.has(Code::cycle_call) || run.block.has(Code::cycle_call_modal) || (moved && run.cycle.modal)) {
        run.cycle.modal =
            run.block.has(Code::cycle_call_modal) || (run.cycle.modal && !run.block.has(Code::cycle_call));
        call_cycle(run);
        if (run.stopped) return false;
    }
    report_unused(run);
    after_motion(run);
    if (run.modal_call.is_on() && (moved || calls_without_motion(run))) run_modal_call(run);
    return moved;
}

}  // namespace obrys::interp
