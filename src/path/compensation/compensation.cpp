#include "path/compensation/compensation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

#include "path/compensation/clearance.hpp"

namespace obrys::path {

using geom::Vec2;
using Role = Item::Role;

namespace {

double side_offset(const Setting& s) {
    if (s.side == Side::off) return 0;
    return s.side == Side::left ? s.radius : -s.radius;
}

Element still_at(Element e, Vec2 p) {
    e.from = e.to = p;
    e.sweep = 0;
    return e;
}

Element moved_by(Element e, Vec2 shift) {
    e.from = e.from + shift;
    e.to = e.to + shift;
    if (is_arc(e)) e.centre = e.centre + shift;
    return e;
}

Kind kind_of(Role r) {
    switch (r) {
        case Role::approach: return Kind::approach;
        case Role::retract: return Kind::retract;
        case Role::transition: return Kind::transition;
        case Role::contour:
        case Role::absent: return Kind::contour;
    }
    return Kind::contour;
}

}  // namespace

Element without_plane(const Element& e) { return still_at(e, e.to); }

const Item& shorter(const Item& a, const Item& b) {
    const double rest = (extent(a.curve) - a.begin) * scale(a.curve);
    return rest <= extent(b.curve) * scale(b.curve) ? a : b;
}

std::vector<Fault> Compensation::push(Element&& e, const Setting& s, OutputSink out) {
    if (s.method == Method::held_move || !held_.idle()) {
        e.before.put_before(carried_);
        return held_.push(std::move(e), s, out);
    }
    const bool starts = !active_ && s.side != Side::off && s.approach == Approach::ready;
    if (moves_in_plane(e) || starts)
        take_plane(std::move(e), s, out);
    else
        take_still(std::move(e), out);
    return std::exchange(faults_, {});
}

std::vector<Fault> Compensation::switch_off(OutputSink out) { return held_.switch_off(out); }

std::vector<Fault> Compensation::flush(OutputSink out) {
    if (!held_.idle()) return held_.flush(out);
    advance(true, out);
    if (!carried_.empty()) {
        Element events;
        if (at_) events.from = events.to = active_ ? *at_ + tip_ : *at_;
        events.before = std::exchange(carried_, {});
        out(Output{std::move(events), active_ ? Kind::contour : Kind::passed});
    }
    return std::exchange(faults_, {});
}

void Compensation::take_plane(Element e, const Setting& s, OutputSink out) {
    const bool selected = s.side != Side::off;
    const bool pending = window_.size() == 1 && window_.front().role == Role::approach;
    if (active_ && !selected && pending) drop_selection(e, out);
    if (!active_ && !selected) return emit(std::move(e), Kind::passed, out);
    const bool free = s.approach == Approach::ready;
    if (active_ != selected && is_arc(e) && !free) {
        faults_.push_back({Reason::arc_needs_line_at_start, e.tag, e.tag, e.from, false});
        if (!active_) return emit(std::move(e), Kind::passed, out);
    }
    if (!active_) return add_approach(std::move(e), s);
    if (selected || (is_arc(e) && !free))
        add_contour(std::move(e), s, out);
    else
        add_retract(std::move(e), s);
    advance(!active_, out);
}

void Compensation::take_still(Element e, OutputSink out) {
    if (!window_.empty()) return window_.back().after.push_back(std::move(e));
    if (active_ && at_) e = still_at(std::move(e), *at_);
    emit(std::move(e), active_ ? Kind::contour : Kind::passed, out);
}

void Compensation::add_approach(Element e, const Setting& s) {
    Item item;
    tip_ = s.tip;
    item.start = e.from - tip_;
    item.e = s.approach == Approach::ready ? moved_by(std::move(e), -1.0 * tip_) : std::move(e);
    item.s = s;
    item.role = Role::approach;
    window_.push_back(std::move(item));
    past_.clear();
    active_ = true;
    at_ = window_.front().start;
}

void Compensation::add_contour(Element e, const Setting& s, OutputSink out) {
    const bool first = !window_.empty() && window_.back().role == Role::approach;
    Item item;
    item.s = s;
    item.d1 = s.side == Side::off ? offset_ : side_offset(s);
    item.d0 = first ? item.d1 : offset_;
    if (is_arc(e) && std::abs(item.d1 - item.d0) > same_point) {
        faults_.push_back({Reason::arc_needs_line_at_start, e.tag, e.tag, e.from, false});
        item.d0 = item.d1;
    }
    item.curve = parallel(e, item.d0, item.d1);
    item.zone = zone_of(item);
    const bool kept = has_zone(item) && !window_.empty() && has_zone(window_.back());
    if (!exists(item.curve) && kept) {
        item.role = Role::absent;
    } else if (!exists(item.curve)) {
        faults_.push_back({Reason::tool_radius_too_large, e.tag, e.tag, e.from, false});
        return take_still(without_plane(e), out);
    }
    item.start = item.curve.from;
    item.e = std::move(e);
    offset_ = item.d1;
    append(std::move(item));
}

void Compensation::add_retract(Element e, const Setting& s) {
    active_ = false;
    Item item;
    item.start = at_.value_or(e.from);
    item.e = moved_by(std::move(e), -1.0 * tip_);
    item.s = s;
    item.role = Role::retract;
    window_.push_back(std::move(item));
}

/// Deselected before the first contour element: nothing was ever selected. A first element that was too tight is
/// missing.
void Compensation::drop_selection(const Element& next, OutputSink out) {
    Item item = std::move(window_.front());
    window_.clear();
    active_ = false;
    if (item.s.approach == Approach::ready) item.e = moved_by(std::move(item.e), tip_);
    tip_ = {};
    emit(std::move(item.e), Kind::passed, out);
    for (Element& e : item.after) emit(std::move(e), Kind::passed, out);
    if (geom::distance(*at_, next.from) > same_point) emit(line(*at_, next.from, next.w_from), Kind::link, out);
}

void Compensation::advance(bool last, OutputSink out) {
    while (step(last, out)) {
    }
}

/// Settles the end of the front element if it can be known already. True when something was emitted or left out.
bool Compensation::step(bool last, OutputSink out) {
    if (window_.empty()) return false;
    if (window_.size() == 1) {
        if (last) finish_last(out);
        return last;
    }
    const Item &a = window_[0], &b = window_[1];
    if (same_zone(a, b)) return step_clear(last, out);
    const Join j = join(a, b);
    const bool may_wait = !last && window_.size() <= look_ahead_;
    if (!settled(j, may_wait)) {
        if (bridge()) return true;
        if (may_wait) return false;
        if (j.fault) {
            const bool first = *j.fault == Reason::element_vanishes && &shorter(a, b) == &a;
            const Item &lost = first ? a : b, &other = first ? b : a;
            faults_.push_back({*j.fault, lost.e.tag, other.e.tag, a.e.to, false});
        }
    }
    commit(j, out);
    return true;
}

/// True where the join is sound and leaves something of the second element.
bool Compensation::settled(const Join& j, bool may_wait) {
    if (j.fault) return false;
    if (!j.trims) return true;
    if (window_.size() == 2) return !may_wait;
    Item b = window_[1];
    b.begin = j.b_place;
    return !join(b, window_[2]).fault;
}

/// Nothing follows the front element: it ends at its normal.
void Compensation::finish_last(OutputSink out) {
    const Item& a = window_.front();
    if (a.role == Role::approach) {
        offset_ = side_offset(a.s);
        if (a.s.approach == Approach::ready)
            finish_front(a.e.to, std::abs(a.e.sweep), out);
        else
            finish_front(a.e.to + offset_ * geom::left_of(end_direction(a.e)), 0, out);
    } else {
        watch(extent(a.curve));
        if (a.role == Role::retract)
            finish_front(a.e.to, std::abs(a.e.sweep), out);
        else
            finish_front(a.curve.to, extent(a.curve), out);
    }
}

/// Leaves out elements after the front one so that its parallel crosses that of a later one.
bool Compensation::bridge() {
    Item& a = window_.front();
    if (a.role != Role::contour) return false;
    for (std::size_t m = 2; m < window_.size() && m <= look_ahead_; ++m) {
        const Item& b = window_[m];
        if (b.role != Role::contour || std::abs(b.d0 - a.d1) > same_point) return false;
        if (!crossing_within(a.curve, a.begin, b.curve)) continue;
        for (std::size_t i = 1; i < m; ++i) {
            Item& lost = window_[i];
            faults_.push_back({Reason::element_vanishes, lost.e.tag, a.e.tag, lost.e.from, true});
            a.after.push_back(without_plane(lost.e));
            std::move(lost.after.begin(), lost.after.end(), std::back_inserter(a.after));
        }
        window_.erase(window_.begin() + 1, window_.begin() + static_cast<std::ptrdiff_t>(m));
        return true;
    }
    return false;
}

void Compensation::commit(const Join& j, OutputSink out) {
    assert(window_.size() >= 2);
    watch(j.a_place);
    finish_front(j.a_end, j.a_place, out);
    Item& b = window_.front();
    if (j.inserted) {
        Element e = *j.inserted;
        e.before = std::exchange(b.e.before, {});
        emit(std::move(e), j.link ? Kind::link : Kind::transition, out);
    }
    b.start = j.b_start;
    b.begin = j.b_place;
}

/// Emits the front element up to `end` and what follows it there, and drops it from the window.
void Compensation::finish_front(Vec2 end, double place, OutputSink out) {
    keep_behind(window_.front());
    Item item = std::move(window_.front());
    window_.pop_front();
    Element e = std::move(item.e);
    // An arc that was given as the centre's path keeps its circle, wherever the contour has ended: emit() leads there.
    const bool own = is_arc(e) && (item.role == Role::approach || item.role == Role::retract);
    if (!own) e.from = item.start;
    e.to = end;
    if (is_arc(e)) {
        e.sweep = std::copysign(place - item.begin, e.sweep);
        if (geom::distance(e.from, e.centre) <= same_point) e.sweep = 0;
    }
    const Kind kind = kind_of(item.role);
    emit(std::move(e), kind, out);
    for (Element& still : item.after) emit(still_at(std::move(still), end), kind, out);
}

/// Hands an element on, with the events that are due; nothing for one that does not move. Bridges what is not joined.
void Compensation::emit(Element e, Kind kind, OutputSink out) {
    e.before.put_before(carried_);
    if (!moves(e)) {
        carried_ = std::move(e.before);
        return;
    }
    if (at_ && kind != Kind::passed && geom::distance(*at_, e.from) > same_point) {
        Element link = line(*at_, e.from, e.w_from);
        link.tag = e.tag;
        link.before = std::exchange(e.before, {});
        out(Output{moved_by(std::move(link), tip_), Kind::link});
    }
    at_ = e.to;
    out(Output{kind == Kind::passed ? std::move(e) : moved_by(std::move(e), tip_), kind});
}

}  // namespace obrys::path
