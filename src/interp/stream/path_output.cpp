/// Out of the path stage into the stream.

#include <cmath>
#include <utility>

#include "base/codes.hpp"
#include "interp/stream/path_stage.hpp"
#include "interp/stream/stream.hpp"
#include "path/pulled_corner.hpp"

namespace obrys::interp {

namespace codes = base::codes;

cl::Record& PathStage::next_event() {
    if (event_count_ == events_.size()) events_.emplace_back();
    return events_[event_count_];
}

int PathStage::keep(cl::Record&& record) {
    next_event() = std::move(record);
    return static_cast<int>(event_count_++);
}

namespace {

/// Marks in the number of an event: a corner's own feed, and the end of it.
constexpr int corner_feed_begins = 1 << 29, corner_feed_ends = 1 << 30;

}  // namespace

void PathStage::put_corner_feed(const Reckoning& run, double feed, path::CornerRequest& corner) {
    const int event = keep({cl::Feed{feed, run.modal.feed_mode}, run.here(), run.calls.back().stack});
    corner.before.push_back(event | corner_feed_begins);
    corner.after.push_back(event | corner_feed_ends);
}

void PathStage::tell_end(Telling& run) {
    if (!told_ || run.capture != nullptr) return;
    told_.reset();
    const cl::Record end{cl::CompensationEnd{}, run.here(), run.top().stack};
    if (holds_)
        hold(end);
    else
        send_event(run, end);
}

void PathStage::tell_lead(Reckoning& run, const cl::LeadBegin& begin) {
    if (run.capture != nullptr) return;
    lead_told_ = true;
    hold({begin, run.here(), run.top().stack});
}

void PathStage::tell_lead_end(Telling& run) {
    if (run.capture != nullptr || !std::exchange(lead_told_, false)) return;
    const cl::Record end{cl::LeadEnd{}, run.here(), run.top().stack};
    if (holds_ || !waiting_.empty())
        hold(end);
    else
        send_event(run, end);
}

/// An element that an alarm refuses takes its events with it: compensation ends only where it has begun.
void PathStage::send_event(Telling& run, const cl::Record& record) {
    if (std::holds_alternative<cl::CompensationBegin>(record.step)) begun_ = true;
    if (std::holds_alternative<cl::CompensationEnd>(record.step) && !std::exchange(begun_, false)) return;
    if (std::holds_alternative<cl::LeadBegin>(record.step)) lead_begun_ = true;
    if (std::holds_alternative<cl::LeadEnd>(record.step) && !std::exchange(lead_begun_, false)) return;
    send(run, record);
}

void PathStage::send_kept(Telling& run, int event) {
    constexpr int marks = corner_feed_begins | corner_feed_ends;
    if (event >= 0) {
        cl::Record& record = events_[static_cast<std::size_t>(event & ~marks)];
        const cl::Feed outside = run.told.feed;
        if (const auto* own = std::get_if<cl::Feed>(&record.step); (event & marks) != 0 && *own == outside) return;
        if ((event & corner_feed_ends) != 0) record.step = outside;
        send_event(run, record);
        if ((event & corner_feed_begins) != 0) run.told.feed = outside;
        return;
    }
    const HeardThere& there = heard_[static_cast<std::size_t>(-1 - event)];
    if (run.listener) (*run.listener)(there.what, there.from);
}

void say_no_corner(Reckoning& run, const base::Span& where, const char* text, const char* remedy) {
    if (run.capture != nullptr) return;
    if (run.traits->corner_may_be_tangential) return assume(run, where, text, remedy);
    unchecked(run, codes::unsupported, where, text, remedy);
}

/// The path's radius by that of the contour, where the feed is to hold at the cutting edge; else 1.
double PathStage::arc_feed(const Origin& origin, const path::Output& out) {
    if (origin.feed_reference == Modal::feed_at_tool || out.kind != path::Kind::contour || !path::is_arc(out.element))
        return 1;
    const double path = geom::distance(out.element.from, out.element.centre);
    const double contour = path + std::copysign(origin.offset, origin.offset * out.element.sweep);
    if (contour <= path::same_point || (origin.feed_reference == Modal::feed_at_inside && path > contour)) return 1;
    return path / contour;
}

void PathStage::output(Telling& run, const path::Output& out) {
    for (const int event : out.element.before) send_kept(run, event);
    // A zero move only brings its events, but for controls that run it.
    if (!path::moves(out.element) && (!run.traits->compensation_holds_move || out.kind == path::Kind::events)) return;
    Origin& origin = origins_[out.element.tag];
    const bool takes_along = !run.ends.empty() || !origin.ends.empty();
    cl::AxisEnds later;
    if (takes_along) later = std::exchange(run.ends, std::exchange(origin.ends, {}));
    run.record.from = origin.from;
    run.record.stack = origin.stack;
    run.feed_shape.plunge = origin.plunge_part;
    if (run.feed_shape.on) run.feed_shape.arc = arc_feed(origin, out);
    const auto emit_one = [&](const path::Element& e) { emit_element(run, e, origin.rapid, origin.fixed_plane); };
    last_ = out.element.to;
    if (out.kind == path::Kind::transition && !run.traits->outer_corner_setting.empty() &&
        !std::exchange(said_outer_corner_, true))
        assume(run, origin.from,
               "outer corners under radius compensation are run as arcs about the corner (" +
                   std::string(run.traits->outer_corner_setting) +
                   "); otherwise the control goes farther out, to where the parallels cross");
    if (out.kind != path::Kind::transition || !(origin.pulled_out > 0))
        emit_one(out.element);
    else
        for (const path::Element& e : path::pulled_corner(out.element, origin.pulled_out)) emit_one(e);
    if (takes_along) run.ends = std::move(later);
}

void PathStage::hold(cl::Record record) { waiting_.push_back(keep(std::move(record))); }

void PathStage::hold(Heard what, const base::Span& from) {
    heard_.push_back({std::move(what), from});
    waiting_.push_back(-static_cast<int>(heard_.size()));
}

void PathStage::say_open_corner(Reckoning& run) {
    const auto tag = path_.open_corner();
    if (!tag || !std::exchange(origins_[*tag].asks_corner, false)) return;
    say_no_corner(
        run, origins_[*tag].from,
        "no corner follows this chamfer or rounding, which is left out: what comes behind it is no move in the plane",
        "write the next element of the contour behind it");
}

void PathStage::flush(Telling& run) {
    if (!active_ || flushing_) return;
    flushing_ = true;
    say_open_corner(run);
    report(run, path_.flush([&](const path::Output& o) { output(run, o); }));
    for (const int event : waiting_) send_kept(run, event);
    waiting_.clear();
    holds_ = false;
    forget();
    flushing_ = false;
    if (run.modal.compensation == Modal::compensation_off) tell_end(run);
}

void PathStage::stop(Telling& run) {
    if (!active_) return;
    flush(run);
    if (!last_) return;
    const PlaneAxes a = plane_axes(run.modal.plane);
    geom::Vec3 to = run.programmed_position;
    coordinate(to, a.u) = last_->x;
    coordinate(to, a.v) = last_->y;
    arrive(run, to);
}

void PathStage::end_compensation(Telling& run) {
    stop(run);
    path_ = path::ContourPath();
    holds_ = false;
    forget();
    tell_end(run);
}

void PathStage::switch_off(Telling& run) {
    if (!active_) return;
    report(run, path_.switch_off([&](const path::Output& o) { output(run, o); }));
}

/// Nothing is held back any more: places and events of what is done are let go.
void PathStage::forget() {
    active_ = !path_.idle();
    if (active_ || !waiting_.empty()) return;
    constexpr std::size_t many = 1024;  // events: so many are kept to be filled again, and no more
    origins_.clear();
    heard_.clear();
    event_count_ = 0;
    if (events_.size() > many) events_.clear();
}

}  // namespace obrys::interp
