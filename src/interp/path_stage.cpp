#include "interp/path_stage.hpp"

#include <cmath>
#include <utility>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/whole.hpp"
#include "interp/complaints.hpp"
#include "path/compensation/preset.hpp"
#include "path/compensation/refusal.hpp"
#include "path/pulled_corner.hpp"

namespace obrys::interp {

namespace codes = base::codes;

int PathStage::keep(const cl::Record& record) {
    events_.push_back(record);
    return static_cast<int>(events_.size()) - 1;
}

int PathStage::feed_event(const Reckoning& run, double feed) {
    return keep({cl::Feed{feed, run.modal.feed_mode}, run.here(), run.calls.back().stack});
}

namespace {

/// A size written with a sign (Reference::incremental) says by it which way the next element goes along the axis of the
/// plane that its block does not name.
path::CornerRequest sized_corner(const Moving& run, path::CornerKind kind, Code code) {
    const BlockWords& b = run.block;
    path::CornerRequest r;
    r.kind = kind;
    r.size = b.get(code) * length_unit(run.modal);
    r.modal = run.traits->corner_may_be_tangential;
    if (b.ref(code) != 1 + static_cast<std::uint8_t>(program::Reference::incremental)) return r;
    const PlaneAxes a = plane_axes(run.modal.plane);
    const bool u = b.has(axis_code(a.u)), v = b.has(axis_code(a.v));
    if (u != v) r.toward = u ? geom::Vec2{0, r.size} : geom::Vec2{r.size, 0};
    r.size = std::abs(r.size);
    return r;
}

}  // namespace

path::CornerRequest corner_of_block(const Moving& run) {
    const BlockWords& b = run.block;
    if (b.has(Code::chamfer_length)) return sized_corner(run, path::CornerKind::chamfer, Code::chamfer_length);
    if (b.has(Code::chamfer_leg)) return sized_corner(run, path::CornerKind::chamfer_leg, Code::chamfer_leg);
    if (b.has(Code::round)) return sized_corner(run, path::CornerKind::rounding, Code::round);
    path::CornerRequest modal;
    if (run.modal.round_modal > 0 && run.modal.motion != Modal::rapid) {
        modal.kind = path::CornerKind::rounding;
        modal.size = run.modal.round_modal;
        modal.modal = true;
    }
    return modal;
}

namespace {

/// Of the block's corner alone; 0: none of its own.
double corner_feed(const Moving& run) {
    const BlockWords& b = run.block;
    const double feed = b.has(Code::corner_feed) ? b.peek(Code::corner_feed) : run.modal.corner_feed_modal;
    return feed > 0 ? feed * feed_factor(run) : 0;
}

}  // namespace

path::CornerRequest PathStage::corner_request(Moving& run) {
    const BlockWords& b = run.block;
    path::CornerRequest r = corner_of_block(run);
    const geom::Vec3& at = run.programmed_position;
    const PlaneAxes a = plane_axes(run.modal.plane);
    if (r.kind != path::CornerKind::none && !std::isfinite(coordinate(at, a.u) + coordinate(at, a.v))) {
        unchecked(run, codes::unknown_value, run.here(),
                  "where the move before this chamfer or rounding comes from is not known: it is left out",
                  "move to a known place before");
        return {};
    }
    if (std::isnan(r.size)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "the size of this chamfer or rounding depends on a value that is not known: it is left out");
        return {};
    }
    if (b.has(Code::corner_feed)) b.use(Code::corner_feed);
    if (const double feed = corner_feed(run); r.kind != path::CornerKind::none && feed > 0 && run.feed_valid) {
        r.before.push_back(feed_event(run, feed));
        r.after.push_back(feed_event(run, run.feed));
    }
    return r;
}

namespace {

/// DISC, 0 … 1; it acts with G450 alone.
double pulled_out(const Reckoning& run) {
    return run.modal.corner == Modal::corner_intersection ? 0 : run.modal.corner_overshoot / 100;
}

}  // namespace

void PathStage::push(Moving& run, path::Element e, bool rapid) {
    const path::Setting s = compensation_setting(run);
    tell_begin(run, s);
    tell_programmed(run, e, rapid);
    take(run, std::move(e), s, rapid);
}

void PathStage::push(Moving& run, path::Element e, const path::Setting& s) {
    tell_begin(run, s);
    take(run, std::move(e), s, false);
}

/// Compensation that begins or becomes another one.
void PathStage::tell_begin(Moving& run, const path::Setting& s) {
    if (s.side == path::Side::off) return tell_end(run);
    const double number = run.block.has(Code::offset_d) ? run.block.peek(Code::offset_d) : run.modal.offset_d;
    cl::CompensationBegin begin;
    begin.side = s.side == path::Side::left ? cl::CompensationSide::left : cl::CompensationSide::right;
    begin.radius = radius_in_stream(run, s.radius);
    begin.offset = base::whole<std::uint32_t>(number, 0).value_or(0);
    begin.approach = static_cast<cl::Approach>(s.approach);
    begin.sharp = s.corner == path::OuterCorner::intersection;
    begin.normal = plane_normal(run);
    const bool goes_on = told_ && told_->side == begin.side && told_->radius == begin.radius &&
                         told_->sharp == begin.sharp && told_->normal == begin.normal;
    if (goes_on) return;
    tell_end(run);
    told_ = begin;
    hold({begin, run.here(), run.top().stack});
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

void PathStage::tell_programmed(Moving& run, const path::Element& e, bool rapid) {
    std::optional<cl::Programmed> p = programmed_element(run, e, rapid, fixed_plane_);
    if (!p) return;
    if (const path::CornerRequest corner = corner_of_block(run);
        corner.kind != path::CornerKind::none && std::isfinite(corner.size))
        p->corner = static_cast<cl::Corner>(corner.kind), p->size = corner.size, p->corner_feed = corner_feed(run);
    hold({*p, run.here(), run.top().stack});
}

namespace {

bool asks_corner(const BlockWords& b) {
    return b.has(Code::chamfer_length) || b.has(Code::chamfer_leg) || b.has(Code::round);
}

/// A chamfer or rounding that no corner was found for. SINUMERIK leaves it out without an alarm.
void say_no_corner(Reckoning& run, const base::Span& where, const char* text, const char* remedy) {
    if (run.capture != nullptr) return;
    if (run.traits->corner_may_be_tangential) return assume(run, where, text, remedy);
    unchecked(run, codes::unsupported, where, text, remedy);
}

}  // namespace

void PathStage::end_block(const Reckoning& run) {
    if (run.modal.compensation == Modal::compensation_off)
        idle_blocks_ = 0;
    else if (!block_moved_)
        ++idle_blocks_;
    block_moved_ = false;
}

void PathStage::judge_idle_blocks(Saying& run, const path::Element& e, const path::Setting& s) {
    if (!path::moves_in_plane(e)) return;
    constexpr double straight_on = 1e-3;  // rad
    const program::IdleBlocks& limit = run.traits->compensation_idle_blocks;
    const bool joined = active_ && direction_ && s.side != path::Side::off && s.side == side_;
    if (joined && limit.seen_past != 0 && idle_blocks_ > limit.seen_past &&
        std::abs(path::turn_between(*direction_, path::start_direction(e))) > straight_on)
        unchecked(
            run, codes::unsupported, run.here(),
            std::to_string(idle_blocks_) +
                " blocks without motion in the plane stand before this corner under radius compensation, which is " +
                "run as if the control saw past them; by " + std::string(limit.setting) + " it sees past " +
                std::to_string(limit.seen_past) + ", and behind more " + std::string(limit.beyond),
            "write them beside a move, before the compensation or behind it");
    idle_blocks_ = 0;
    block_moved_ = true;
    side_ = s.side;
    direction_ = path::end_direction(e);
}

void PathStage::take(Moving& run, path::Element e, const path::Setting& s, bool rapid) {
    judge_idle_blocks(run, e, s);
    e.tag = origins_.size();
    e.before = std::move(waiting_);
    waiting_.clear();
    const double offset = s.side == path::Side::off ? 0 : s.side == path::Side::left ? s.radius : -s.radius;
    origins_.push_back({run.here(), run.top().stack, rapid || run.block.rapid, s.radius, offset, run.modal.plunge_part,
                        run.modal.feed_reference, s.clearance == path::Clearance::avoided, fixed_plane_,
                        pulled_out(run), asks_corner(run.block)});
    if (!active_) last_.reset();
    active_ = true;
    if (path::moves(e) && !path::moves_in_plane(e)) say_open_corner(run);
    const path::CornerRequest corner = corner_request(run);
    if (asks_corner(run.block) && corner.kind != path::CornerKind::none && !path::moves_in_plane(e))
        say_no_corner(run, run.here(),
                      "there is no corner for this chamfer or rounding, which is left out: the block that it belongs "
                      "to does not move in the plane",
                      "write it behind an element of the contour");
    report(run, path_.push(std::move(e), s, corner, [&](const path::Output& out) { output(run, out); }));
    holds_ = !path_.idle();
    if (path_.idle())
        forget();
    else if (s.side == path::Side::off && corner.kind == path::CornerKind::none)
        flush(run);
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
    for (const int event : out.element.before) send_event(run, events_[static_cast<std::size_t>(event)]);
    // A zero move only brings its events, but for controls that run it.
    if (!path::moves(out.element) && (!run.traits->compensation_holds_move || out.kind == path::Kind::events)) return;
    const Origin& origin = origins_[out.element.tag];
    run.record.from = origin.from;
    run.record.stack = origin.stack;
    run.feed_shape.plunge = origin.plunge_part;
    run.feed_shape.arc = arc_feed(origin, out);
    const auto emit_one = [&](const path::Element& e) { emit_element(run, e, origin.rapid, origin.fixed_plane); };
    last_ = out.element.to;
    if (out.kind == path::Kind::transition && !run.traits->outer_corner_setting.empty() &&
        !std::exchange(said_outer_corner_, true))
        assume(run, origin.from,
               "outer corners under radius compensation are run as arcs about the corner (" +
                   std::string(run.traits->outer_corner_setting) +
                   "); otherwise the control goes farther out, to where the parallels cross");
    if (out.kind != path::Kind::transition || !(origin.pulled_out > 0)) return emit_one(out.element);
    for (const path::Element& e : path::pulled_corner(out.element, origin.pulled_out)) emit_one(e);
}

void PathStage::hold(const cl::Record& record) { waiting_.push_back(keep(record)); }

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
    for (const int event : waiting_) send_event(run, events_[static_cast<std::size_t>(event)]);
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
    origins_.clear();
    events_.clear();
}

void PathStage::report(Reckoning& run, const path::PathFaults& faults) {
    if (faults.corner) report(run, *faults.corner);
    for (const path::Fault& f : faults.compensation) report(run, f);
}

void PathStage::report(Reckoning& run, const path::Fault& f) {
    if (f.reason == path::Reason::refused)
        return alarm(run, codes::compensation, run.here(), path::message(f, length_unit(run.modal)));
    const Origin& at = origins_[f.tag];
    const std::string radius = base::fixed(at.radius, 3) + " mm";
    std::string text;
    switch (f.reason) {
        case path::Reason::tool_radius_too_large:
            text = "the tool radius " + radius + " is larger than this arc: the arc is left out";
            break;
        case path::Reason::arc_needs_line_at_start:
            text = "compensation must be switched on and off by a straight move, this is an arc";
            break;
        case path::Reason::no_intersection:
            text = "with tool radius " + radius +
                   " this inner corner has no point where both contour elements can be reached";
            break;
        case path::Reason::interference:
            text = "tool radius too large: with " + radius +
                   " the path cuts into another contour element, which the control does not see: it runs on";
            break;
        case path::Reason::refused: break;
        case path::Reason::element_vanishes:
            text = f.bridged ? "with tool radius " + radius +
                                   " the tool does not fit into this contour element: it is left out and material stays"
                             : "with tool radius " + radius + " this contour element cannot be reached";
            break;
    }
    const bool runs_on = f.reason == path::Reason::interference || at.avoids;  // as the control does
    base::Diagnostic d{runs_on ? base::Severity::warning : base::Severity::error,
                       codes::compensation,
                       at.from,
                       std::move(text),
                       "use a smaller tool or widen the contour",
                       run.stacks->sites(at.stack),
                       {}};
    if (origins_[f.other].from != at.from) d.related.push_back({origins_[f.other].from, "the neighbouring element"});
    raise(run, std::move(d));
}

void PathStage::report(Reckoning& run, const path::CornerFault& f) {
    const Origin& at = origins_[f.tag];
    std::string text;
    switch (f.failure) {
        case path::CornerFailure::none: return;
        case path::CornerFailure::bad_size: text = "a chamfer or rounding needs a size above 0"; break;
        case path::CornerFailure::not_joined: text = "no corner follows: the next element does not start here"; break;
        case path::CornerFailure::tangential:
            text = "there is no corner to chamfer or round: the next element goes straight on";
            break;
        case path::CornerFailure::reversal:
            text = "the next element runs back along this one: there is no corner to chamfer or round";
            break;
        case path::CornerFailure::wrong_way:
            text = "the next element goes the other way than the sign of this chamfer or rounding says";
            break;
        case path::CornerFailure::too_short:
            text = "a chamfer or rounding of " + base::fixed(f.size, 3) + " mm is too large for the elements beside it";
            break;
    }
    raise(run,
          {base::Severity::error, codes::value_range, at.from, std::move(text), {}, run.stacks->sites(at.stack), {}});
}

}  // namespace obrys::interp
