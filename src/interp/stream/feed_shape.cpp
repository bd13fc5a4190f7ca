/// The feed of the stream where it is not F itself: M103 slows the part along the tool axis down, M109 and M110 hold F
/// at the cutting edge of arcs. Source: iTNC 530 User's Manual, "Miscellaneous functions for contouring behavior".

#include <algorithm>
#include <cmath>

#include "interp/stream/stream.hpp"

namespace obrys::interp {

namespace {

/// Part of F at which a move is run so that its part into the material is at most `plunge` of F.
double plunging(const Telling& run, const geom::Vec3& to, double length) {
    const FeedShape& f = run.feed_shape;
    const double down = -geom::dot(to - f.at, run.tool_axis);
    return f.plunge < 1 && down > 0 ? std::min(1.0, f.plunge * length / down) : 1;
}

void tell_feed(Telling& run, double feed, const cl::Record& before) {
    FeedShape& f = run.feed_shape;
    if (!(f.programmed > 0) || std::abs(feed - f.told) <= 1e-9 * f.programmed) return;
    f.told = feed;
    run.sink({cl::Feed{feed, run.modal.feed_mode}, before.from, before.stack});
}

void before_line(Telling& run, const cl::Linear& line, const cl::Record& record) {
    FeedShape& f = run.feed_shape;
    if (!line.rapid && !f.in_cycle)
        tell_feed(run, f.programmed * plunging(run, line.to, geom::distance(f.at, line.to)), record);
    f.at = line.to;
}

void before_arc(Telling& run, const cl::Arc& arc, const cl::Record& record) {
    FeedShape& f = run.feed_shape;
    if (f.in_cycle) {
        if (run.modal.feed_reference != Modal::feed_at_tool)
            assume(run, run.here(), "M109 and M110 also act on arcs of cycles: their feed is left as the cycle says");
    } else if (!arc.rapid) {
        const double rise = geom::dot(arc.to - f.at, run.tool_axis);
        const double length = std::hypot(arc.sweep * geom::distance(arc.to, arc.centre), rise);
        tell_feed(run, f.programmed * f.arc * plunging(run, arc.to, length), record);
    }
    f.at = arc.to;
}

}  // namespace

void shape_feed_from_here(Telling& run) {
    FeedShape& f = run.feed_shape;
    if (f.on || !run.traits->feed_at_tool_first) return;
    f.on = true;
    f.programmed = f.told = run.feed_valid ? run.feed : 0;
    f.at = run.position;
}

void shape_feed(Telling& run, const cl::Record& record) {
    FeedShape& f = run.feed_shape;
    if (const auto* feed = std::get_if<cl::Feed>(&record.step)) f.programmed = f.told = feed->value;
    if (std::holds_alternative<cl::CycleBegin>(record.step)) f.in_cycle = true;
    if (std::holds_alternative<cl::CycleEnd>(record.step)) f.in_cycle = false;
    if (const auto* line = std::get_if<cl::Linear>(&record.step)) before_line(run, *line, record);
    if (const auto* arc = std::get_if<cl::Arc>(&record.step)) before_arc(run, *arc, record);
}

}  // namespace obrys::interp
