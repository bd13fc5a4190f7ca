/// Feed, coolant and machine functions of a block, the order in which its words act before the motion, and what acts
/// behind it: stops and the program's end. Tools: tools.cpp.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// How many teeth the tool in the spindle has; 0: not known.
int teeth_of(const Moving& run) { return run.tool.data != nullptr ? std::max(0, run.tool.data->teeth) : 0; }

/// FZ beside G95: the feed per revolution of whatever tool is in the spindle, until the next F (SINUMERIK ONE, NC
/// programming 12/2019, "Tooth feedrate (G95 FZ)": F = FZ * $TC_DPNT).
void staying_tooth_feed(Moving& run) {
    BlockWords& b = run.block;
    ModalState& m = run.modal;
    if (dwells_by_words(run)) return;
    const bool said = b.has(Code::feed_per_tooth);
    if (said && m.feed_mode != cl::FeedMode::per_rev) {
        assume(run, run.here(),
               "FZ has no effect unless the feed is per revolution: " +
                   printed(Value::real(b.get(Code::feed_per_tooth))) + " is not taken for a feed");
        return;
    }
    if (b.has(Code::feed) && !said) m.tooth_feed.reset();
    if (said) m.tooth_feed = b.get(Code::feed_per_tooth);
    const int teeth = teeth_of(run);
    if (!m.tooth_feed || (!said && teeth == m.tooth_feed_teeth)) return;
    m.tooth_feed_teeth = teeth;
    if (teeth == 0)
        unchecked(run, codes::unknown_value, run.here(),
                  "the feed per tooth FZ needs the number of teeth of the tool, which is not known: so the feed is not",
                  "give teeth of the tool in the job");
    b.put(Code::feed, teeth == 0 ? std::nan("") : *m.tooth_feed * teeth);
    b.put(Code::feed_per_tooth, *m.tooth_feed);  // why the feed is not known has been said
    b.use(Code::feed_per_tooth);
}

/// FU, FZ and F AUTO become a plain feed of their mode, which the next F ends.
void special_feeds(Moving& run) {
    BlockWords& b = run.block;
    if (b.has(Code::feed_per_tooth)) {
        const shop::Tool* t = run.tool.data;
        double teeth = NAN;
        if (t != nullptr && t->teeth > 0) teeth = t->teeth;
        if (std::isnan(teeth))
            unchecked(run, codes::unknown_value, run.here(),
                      "the feed per tooth FZ needs the number of teeth of the tool, which is not known: so the feed is "
                      "not",
                      "give the tool in a tool table with its column CUT.");
        b.put(Code::feed_per_rev, b.get(Code::feed_per_tooth) * teeth);
    }
    const bool per_rev = b.has(Code::feed_per_rev);
    if (b.has(Code::feed_auto)) {
        if (run.tool.feed > 0 || std::isnan(run.tool.feed))
            b.put(Code::feed, run.tool.feed / feed_factor(run));
        else
            unchecked(run, codes::unknown_value, run.here(), "F AUTO: TOOL CALL gives no feed: the last one is kept",
                      "write F in TOOL CALL, or a feed here");
    }
    if (per_rev) b.put(Code::feed, b.get(Code::feed_per_rev));
    if (!b.has(Code::feed) || per_rev == run.modal.feed_by_word) return;
    run.modal.feed_by_word = per_rev;
    run.modal.feed_mode = per_rev ? cl::FeedMode::per_rev : cl::FeedMode::per_minute;
    run.feed_valid = false;
}

void feed_word(Moving& run) {
    if (run.traits->tooth_feed_stays)
        staying_tooth_feed(run);
    else
        special_feeds(run);
    if (!run.block.has(Code::feed) || dwells_by_words(run) || changes_pitch(run.modal.motion)) return;
    double f = run.block.get(Code::feed);
    f *= feed_factor(run);
    run.feed_unknown = std::isnan(f);
    run.modal.feed_said = !run.feed_unknown;
    if (run.feed_unknown && !run.block.has(Code::feed_per_tooth))
        unchecked(run, codes::unknown_value, run.here(),
                  "the feed depends on a value that is not known: it is not judged until the next F");
    if (f < 0) {
        alarm(run, codes::value_range, run.here(), "the feed F is negative");
        return;
    }
    run.feed_number = run.block.get(Code::feed);
    if (run.feed_valid && f == run.feed) return;
    run.feed = f;
    run.feed_valid = f > 0 || run.feed_unknown;  // unknown is not missing
    if (run.feed_unknown) run.feed_dropped = false;
    emit(run, cl::Feed{f, run.modal.feed_mode});
}

/// FB: the path of this block is run at another feed.
void begin_feed_alone(Moving& run) {
    double f = *run.block.feed_alone * feed_factor(run);
    if (run.modal.tooth_feed)
        f *= teeth_of(run) > 0 ? static_cast<double>(teeth_of(run)) : std::nan("");  // it is one per tooth, too
    if (f < 0 || run.modal.motion == Modal::rapid) run.block.feed_alone.reset();
    if (std::isnan(f))
        unchecked(run, codes::unknown_value, run.here(),
                  "the feed FB depends on a value that is not known: it is not judged in this block");
    if (f < 0) return alarm(run, codes::value_range, run.here(), "the feed FB is negative");
    if (!run.block.feed_alone) return assume(run, run.here(), "FB= beside a rapid does nothing");
    run.feed_dropped = false;
    emit(run, cl::Feed{f, run.modal.feed_mode});
}

}  // namespace

void end_feed_alone(Moving& run) {
    run.block.feed_alone.reset();
    run.feed_dropped = !run.feed_valid;
    if (run.feed_valid) emit(run, cl::Feed{run.feed, run.modal.feed_mode});
}

namespace {

void machine_functions(Moving& run) {
    for (const int m : run.block.m) {
        if (m == 7 || m == 8) coolant(run, m);
        const auto passed = run.traits->passed_functions;
        if (std::find(passed.begin(), passed.end(), m) != passed.end()) emit(run, cl::Auxiliary{'M', m});
        if (is_standard_function(run, m)) continue;
        emit(run, cl::Auxiliary{'M', m});
        assume(
            run, run.here(),
            "M" + std::to_string(m) + " is a function of the machine builder: taken as having no effect on the path");
    }
    for (const cl::Auxiliary& h : run.block.h) emit(run, h);
}

/// RNDM, FRCM and FRC.
void corner_words(Moving& run) {
    const BlockWords& b = run.block;
    if (b.has(Code::round_modal)) {
        const double size = b.get(Code::round_modal) * length_unit(run.modal);
        if (size < 0)
            return alarm(run, codes::value_range, run.here(), "a rounding needs a size above 0, or 0 to end RNDM");
        if (std::isnan(size))
            unchecked(run, codes::unknown_value, run.here(),
                      "the size of this rounding depends on a value that is not known: the last one is kept");
        else
            run.modal.round_modal = size;
    }
    for (const Code c : {Code::corner_feed, Code::corner_feed_modal}) {
        if (!b.has(c)) continue;
        const double feed = b.value[static_cast<std::size_t>(c)];  // looked at; what acts on it says that it is used
        if (feed < 0)
            return alarm(run, codes::value_range, run.here(), "the feed of a chamfer or rounding is negative");
        if (std::isnan(feed))
            unchecked(run, codes::unknown_value, run.here(),
                      "the feed of a chamfer or rounding depends on a value that is not known: it is run at F");
    }
    if (b.has(Code::corner_feed_modal)) run.modal.corner_feed_modal = b.get(Code::corner_feed_modal);
}

}  // namespace

void technology(Moving& run) {
    BlockWords& b = run.block;
    constexpr std::uint64_t words = bit(Code::feed) | bit(Code::spindle) | bit(Code::speed_limit) | bit(Code::tool) |
                                    bit(Code::edge) | bit(Code::spindle_position) | bit(Code::round_modal) |
                                    bit(Code::corner_feed) | bit(Code::corner_feed_modal) | bit(Code::tool_change) |
                                    bit(Code::feed_auto) | bit(Code::feed_per_rev) | bit(Code::feed_per_tooth);
    if ((b.present & words) == 0 && b.m.empty() && b.h.empty() && !run.spindle.mode_changed && b.surface_word == 0 &&
        !b.feed_alone)
        return;
    tell_technology(run);
    corner_words(run);
    if (run.stopped) return;
    select_tool(run);
    if (run.stopped) return;
    if (spindle_words(run)) emit_spindle(run);
    feed_word(run);
    if (!run.stopped && b.feed_alone) begin_feed_alone(run);
    if (!run.stopped) machine_functions(run);
    for (const int m : b.m) stop_function(run, m, true);
}

}  // namespace obrys::interp
