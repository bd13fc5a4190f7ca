#include "path/compensation/held_move.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace obrys::path {

using geom::Vec2;

namespace {

double known_offset(const Setting& s) {
    if (s.side == Side::off || !(std::abs(s.radius) > 0)) return 0;
    return s.side == Side::left ? s.radius : -s.radius;
}

double turn_of(const Element& e) { return e.sweep > 0 ? 1 : -1; }

/// Whole and begun turns of a sweep, less one.
double turns_more(double sweep) {
    if (std::abs(sweep) <= 2 * geom::pi) return 0;
    return std::max(0.0, std::ceil(std::abs(sweep) / (2 * geom::pi) - 1e-9) - 1);
}

/// The sweep from one point to another about a centre in the direction of `programmed` and with its number of turns;
/// no way at all is a full turn.
double turned_sweep(Vec2 from, Vec2 centre, Vec2 to, double programmed) {
    const double turn = programmed > 0 ? 1 : -1;
    double angle = turn * turn_between(from - centre, to - centre);
    if (angle <= 0) angle += 2 * geom::pi;
    return turn * (angle + 2 * geom::pi * turns_more(programmed));
}

/// As above for an arc that is run: rounding does not make nothing of a full turn. An arc that moved ends have left
/// nothing of becomes one: so do LinuxCNC's motion controller and its interpreter's ARC_FEED.
double sweep_run(const Element& e, double programmed) {
    constexpr double nothing = 1e-6;
    const double sweep = turned_sweep(e.from, e.centre, e.to, programmed);
    const double part = std::abs(sweep) - 2 * geom::pi * turns_more(programmed);
    return part < nothing ? std::copysign(2 * geom::pi * (turns_more(programmed) + 1), programmed) : sweep;
}

}  // namespace

std::vector<Fault> HeldMove::push(Element&& e, const Setting& s, OutputSink out) {
    tag_ = e.tag;
    point_ = e.from;
    if (known_offset(s) != 0)
        take(std::move(e), s, out);
    else
        pass(std::move(e), out);
    return std::exchange(faults_, {});
}

std::vector<Fault> HeldMove::flush(OutputSink out) {
    if (active_ && !stopped_ && move_end(centre_, out)) release(out);
    emit_events(out);
    return std::exchange(faults_, {});
}

std::vector<Fault> HeldMove::switch_off(OutputSink out) {
    if (active_ || stopped_) exit_ = true;
    if (active_ && !stopped_ && move_end(centre_, out)) release(out);
    if (stopped_) emit_events(out);
    active_ = stopped_ = false;
    return std::exchange(faults_, {});
}

/// Compensation is not selected, or by a radius of 0.
void HeldMove::pass(Element&& e, OutputSink out) {
    if (active_ || stopped_) faults_ = switch_off(out);
    if (exit_ && is_arc(e)) {
        refuse(Refusal::arc_after_off);
        carry(e);
        return emit_events(out);
    }
    if (!exit_) at_ = e.from;
    Queued q(std::move(e), exit_ ? Kind::retract : Kind::passed);
    emit(q, out);
    exit_ = false;
    at_.reset();
}

void HeldMove::take(Element&& e, const Setting& s, OutputSink out) {
    if (stopped_) return;
    if (queue_.empty()) carry(e);
    const double offset = known_offset(s);
    if (active_ && offset != offset_) {
        refuse(Refusal::already_on);
    } else if (exit_ && is_arc(e)) {
        refuse(Refusal::arc_after_off);
    } else if (!active_) {
        offset_ = offset;
        tip_ = s.tip;
        limits_ = s.limits;
        bend_ = std::tan(limits_.straight_on);
        if (!at_) at_ = e.from;
        if (is_arc(e))
            enter_arc(std::move(e), s);
        else
            enter_line(std::move(e), s);
    } else if (is_arc(e)) {
        follow_arc(std::move(e), s, out);
    } else {
        follow_line(std::move(e), s, out);
    }
    if (stopped_) emit_events(out);
}

void HeldMove::enter_line(Element&& e, const Setting& s) {
    const double radius = std::abs(offset_);
    if (geom::distance(e.from, e.to) <= radius) {
        refuse(Refusal::entry_line_short);
        return;
    }
    const Vec2 normal = std::copysign(1.0, offset_) * geom::left_of(unit(e.to - e.from));
    start_ = e.from;
    start_known_ = true;
    centre_ = e.to + radius * normal;
    queue(std::move(e), Kind::approach, s.rapid, normal);  // not its own direction: so no moved end turns it round
    active_ = true;
    exit_ = false;
}

void HeldMove::enter_arc(Element&& e, const Setting& s) {
    const double radius = std::abs(offset_), turn = turn_of(e);
    const bool inside = runs_inside(offset_, turn);
    if (geom::distance(e.from, e.to) <= radius) {
        refuse(Refusal::entry_arc_short);
        return;
    }
    if (inside && geom::distance(e.from, e.centre) <= radius) {
        refuse(Refusal::arc_too_tight);
        return;
    }
    const Vec2 end = e.to + (inside ? radius : -radius) * unit(e.centre - e.to);
    const Vec2 towards = unit(e.centre - end);
    const double cosine = geom::dot(unit(e.from - end), towards);
    if (std::abs(cosine) < s.limits.flat_entry) {
        refuse(Refusal::arc_too_tight);
        return;
    }
    e.centre = end + (0.5 * geom::distance(e.from, end) / cosine) * towards;
    if (tip_ != Vec2{}) {
        Element shift = line(e.from, e.from, e.w_from);
        shift.tag = e.tag;
        start_ = centre_ = e.from;
        start_known_ = true;
        queue(std::move(shift), Kind::approach, s.rapid, {});
    }
    centre_ = end;
    const double programmed = turned_sweep(e.from, e.centre, end, e.sweep);
    queue(std::move(e), Kind::approach, s.rapid, {});
    queue_.back().programmed = programmed;
    active_ = true;
    exit_ = false;
}

void HeldMove::follow_line(Element&& e, const Setting& s, OutputSink out) {
    if (e.from == e.to) return queue(std::move(e), Kind::contour, s.rapid, {});
    const double radius = std::abs(offset_);
    const Vec2 direction = unit(e.to - e.from);
    const Vec2 normal = std::copysign(1.0, offset_) * geom::left_of(direction);
    const HeldTurn t = turn_at(e.from, centre_, direction, offset_);
    const bool bent = t.outer(bend_);
    const bool over_arc = !bent && !t.forwards() && !queue_.empty() && front_.arc && !runs_inside(offset_, front_.turn);
    if (t.inner(bend_) || over_arc) {
        if (!meet(front_.arc ? arc_meets_line(t, front_) : line_meets_line(t), out)) return;
    } else if (bent || !t.forwards()) {
        if (!move_end(centre_, out)) return;
        round(e, e.from + radius * normal, s.rapid, out);
    } else {
        release(out);
        start_ = centre_;
        start_known_ = true;
    }
    centre_ = e.to + radius * normal;
    const Vec2 way = e.to - e.from;
    queue(std::move(e), Kind::contour, s.rapid, way);
}

void HeldMove::follow_arc(Element&& e, const Setting& s, OutputSink out) {
    const double tool = std::abs(offset_), turn = turn_of(e);
    const double radius = quick_length(e.to - e.centre);
    const bool inside = runs_inside(offset_, turn);
    if (inside && radius <= tool) {
        refuse(Refusal::arc_too_tight);
        return;
    }
    const HeldTurn t = turn_at(e.from, centre_, leaving(e.from, e.centre, turn), offset_);
    const double reach = inside ? tool : -tool;
    const bool bent = t.outer(bend_);
    const bool over_arc = !bent && !t.forwards() && !inside;
    if (t.inner(bend_) || over_arc) {
        if (!meet(front_.arc ? arc_meets_arc(offset_, front_, e.centre, radius, turn)
                             : line_meets_arc(t, e.centre, radius, turn),
                  out))
            return;
    } else {
        release(out);
        start_ = centre_;
        if (bent || !t.forwards()) round(e, e.from + reach * unit(e.centre - e.from), false, out);
        start_known_ = true;
    }
    centre_ = e.to + reach * unit(e.centre - e.to);
    queue(std::move(e), Kind::contour, s.rapid, {});
}

bool HeldMove::meet(const Meeting& m, OutputSink out) {
    return m.refusal == Refusal::none ? move_end(m.at, out) : refuse(m.refusal);
}

/// The way round an outer corner, which comes with the events of the element behind it.
void HeldMove::round(Element& e, Vec2 to, bool rapid, OutputSink out) {
    release(out);
    Element way = line(e.from, to, e.w_from);
    way.tag = e.tag;
    way.before = std::exchange(e.before, {});
    if (!rapid) {
        way.centre = e.from;
        way.sweep = offset_ > 0 ? -1 : 1;
    }
    Queued q(std::move(way), Kind::transition);
    emit(q, out);
    start_ = to;
    start_known_ = true;
}

/// Lets the queue go with its points at `to`; nothing where there is none.
bool HeldMove::move_end(Vec2 to, OutputSink out) {
    if (queue_.empty()) return true;
    for (Queued& q : queue_)
        if (!move_end(q, to)) return false;
    front_.to = to;
    release(out);
    start_ = to;
    start_known_ = true;
    return true;
}

bool HeldMove::move_end(Queued& q, Vec2 to) {
    Element& e = q.out.element;
    if (is_arc(e)) {
        const double was = geom::distance(e.to, e.centre), is = geom::distance(to, e.centre);
        if (std::abs(was - is) > limits_.radius_change) {
            refuse(Refusal::radii_differ);
            faults_.back().radius_was = was;
            faults_.back().radius_is = is;
            return false;
        }
        const auto sweep = [&] { return turned_sweep(start_, e.centre, to, q.programmed); };
        if (start_known_ && std::abs(sweep()) > std::abs(q.programmed) + limits_.sweep_growth)
            return refuse(Refusal::arc_unreachable);
    } else if (start_known_ && geom::dot(q.direction, to - start_) < 0) {
        return refuse(q.rapid ? Refusal::rapid_reversed : Refusal::feed_reversed);
    }
    e.to = to;
    return true;
}

/// Holds a move back; its end is where the tool's centre is to be.
void HeldMove::queue(Element&& e, Kind kind, bool rapid, Vec2 direction) {
    e.to = centre_;
    if (queue_.empty()) {
        front_ = {is_arc(e), e.to, e.centre, turn_of(e)};
        carry(e);
    }
    queue_.emplace_back(std::move(e), kind, rapid, direction);
}

void HeldMove::release(OutputSink out) {
    for (Queued& q : queue_) emit(q, out);
    queue_.clear();
    start_known_ = false;
}

void HeldMove::emit(Queued& q, OutputSink out) {
    Element& e = q.out.element;
    e.from = at_.value_or(e.from);
    const bool own = q.out.kind == Kind::passed || q.out.kind == Kind::retract;
    if (!own) {
        e.to = e.to + tip_;
        e.centre = e.centre + tip_;
        if (is_arc(e)) e.sweep = sweep_run(e, q.programmed);
    }
    e.before.put_before(carried_);
    at_ = e.to;
    out(q.out);
}

/// Events behind which nothing is held are as good as out.
void HeldMove::carry(Element& e) {
    if (e.before.empty()) return;
    carried_.append(e.before);
    e.before.clear();
}

void HeldMove::emit_events(OutputSink out) {
    if (carried_.empty()) return;
    Element events;
    if (at_) events.from = events.to = *at_;
    events.before = std::exchange(carried_, {});
    out(Output{std::move(events), Kind::events});
}

bool HeldMove::refuse(Refusal why) {
    Fault f;
    f.reason = Reason::refused;
    f.tag = f.other = tag_;
    f.at = point_;
    f.refusal = why;
    faults_.push_back(f);
    stopped_ = true;
    queue_.clear();
    start_known_ = false;
    return false;
}

}  // namespace obrys::path
