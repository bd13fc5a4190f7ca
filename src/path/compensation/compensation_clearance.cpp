/// The members of Compensation that look beyond the next element (clearance.hpp).

#include <algorithm>
#include <iterator>
#include <utility>

#include "path/compensation/clearance.hpp"
#include "path/compensation/compensation.hpp"

namespace obrys::path {

using Role = Item::Role;

namespace {

constexpr std::size_t most_past = 2000;  ///< items kept behind the path at most: elements and the arcs between them

/// What is kept of an item that the path has left behind.
Item left_behind(const Item& item) {
    Item past = item;
    past.e.before.clear();
    past.after.clear();
    return past;
}

}  // namespace

/// Appends an item with its corner to the one before.
void Compensation::append(Item item) {
    item.box = box_of(item.curve);
    if (!window_.empty() && window_.back().role != Role::approach)
        if (auto corner = make_corner(window_.back(), item)) {
            corner->serial = ++items_;
            window_.push_back(std::move(*corner));
        }
    item.serial = ++items_;
    window_.push_back(std::move(item));
}

/// As step(), for a front item that has a zone and is followed by another.
bool Compensation::step_clear(bool last, OutputSink out) {
    const Item& a = window_.front();
    const Reach r = reach(window_);
    if (!last && !r.complete) return false;
    const bool avoids = a.s.clearance == Clearance::avoided;
    const auto exit = avoids ? first_exit(window_, r.count) : exit_to_next(a, window_[1]);
    if (!exit) {
        no_exit(out);
        return true;
    }
    if (exit->item > 1) leave_out(exit->item);
    if (exit->straight) {
        commit(join_straight(window_[0], window_[1]), out);
        return true;
    }
    Join j;
    j.a_end = j.b_start = exit->at.point;
    j.a_place = exit->at.on_a;
    j.b_place = exit->at.on_b;
    commit(j, out);
    return true;
}

/// The next item cannot be reached: said, and bridged by a straight link so that the path holds together.
void Compensation::no_exit(OutputSink out) {
    Item &a = window_[0], &b = window_[1];
    if (b.role == Role::absent) {
        faults_.push_back({Reason::tool_radius_too_large, b.e.tag, b.e.tag, b.e.from, false});
        a.loose = true;
        drop(1);
        return;
    }
    const bool meet = carriers_meet(a.curve, b.curve);
    const Item& lost = meet && &shorter(a, b) == &a ? a : b;
    const Item& other = &lost == &a ? b : a;
    faults_.push_back(
        {meet ? Reason::element_vanishes : Reason::no_intersection, lost.e.tag, other.e.tag, a.e.to, false});
    commit(join_straight(a, b), out);
}

/// Takes the item at `index` out of the window; its events and its motion along w follow the front item.
void Compensation::drop(std::size_t index) {
    Item& lost = window_[index];
    Item& a = window_.front();
    keep_behind(lost);
    a.after.push_back(without_plane(lost.e));
    std::move(lost.after.begin(), lost.after.end(), std::back_inserter(a.after));
    window_.erase(window_.begin() + static_cast<std::ptrdiff_t>(index));
}

/// Leaves out what lies between the front item and the one at `index`.
void Compensation::leave_out(std::size_t index) {
    for (; index > 1; --index) {
        const Item& lost = window_[1];
        if (lost.role != Role::transition) {
            const Reason why = lost.role == Role::absent ? Reason::tool_radius_too_large : Reason::element_vanishes;
            faults_.push_back({why, lost.e.tag, window_.front().e.tag, lost.e.from, true});
        }
        drop(1);
    }
}

/// The items from one behind the path to the front one, in contour order.
Chain Compensation::chain_back(const Item& past) const {
    Chain chain;
    for (const Item& item : past_)
        if (item.serial >= past.serial && item.serial < window_.front().serial) chain.push_back(&item);
    std::sort(chain.begin(), chain.end(), [](const Item* a, const Item* b) { return a->serial < b->serial; });
    chain.push_back(&window_.front());
    return chain;
}

/// Looks for zones that the front item, run up to `end`, cuts into: earlier ones, and later ones where they are not
/// avoided and no other fault at a neighbour tells of them. A contour that meets itself, as one that runs on past its
/// own start, is meant so.
void Compensation::watch(double end) {
    const Item& a = window_.front();
    if (!has_zone(a)) return;
    const Item* found = nullptr;
    Crossing where;
    const auto cuts = [&](const Item& zone, const auto& chain) {
        const auto c = entry(a, zone);
        if (!c || c->on_a >= end || (found != nullptr && c->on_a >= where.on_a)) return false;
        if (!cuts_into(zone, a, c->on_a, end)) return false;
        if (const Chain items = chain(); !is_pocket(items, c->point) && meets_itself(items)) return false;
        where = *c;
        return true;
    };
    for (const Item& zone : past_)
        if (same_zone(a, zone) && cuts(zone, [&] { return chain_back(zone); })) found = &zone;
    if (a.s.clearance == Clearance::reported && window_.size() > 2) {
        const std::size_t count = reach(window_).count;
        for (std::size_t m = 2; m < count; ++m) {
            const Crossing before = where;
            if (!cuts(window_[m], [&] { return chain_to(window_, m); })) continue;
            if (!leads_to(window_, m)) {
                where = before;
                break;  // nor do they lead any farther
            }
            found = &window_[m];
        }
    }
    if (found != nullptr) faults_.push_back({Reason::interference, a.e.tag, found->e.tag, where.point, false});
}

void Compensation::keep_behind(const Item& item) {
    if (!has_zone(item)) return;
    past_.push_back(left_behind(item));
    const std::size_t most = std::min(most_past, 2 * item.s.window);
    while (past_.size() > most) past_.pop_front();
}

}  // namespace obrys::path
