#include "path/fk/state.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::path {

using geom::Vec2;

namespace {

constexpr double same_solution = fk_tolerance;  // mm: solutions nearer to each other are one

double sweep_of(Vec2 from, Vec2 to, Vec2 centre, double sense) {
    const double full = 2 * geom::pi;
    if (geom::distance(from, to) < fk_tolerance) return std::copysign(full, sense);
    const double a = turn_between(from - centre, to - centre);
    return sense > 0 ? (a > 0 ? a : a + full) : (a < 0 ? a : a - full);
}

}  // namespace

const FkHandle* FkState::find(std::uint64_t tag) const {
    for (auto s = pending.rbegin(); s != pending.rend(); ++s)
        if (s->e.tag == tag) return &s->handle;
    for (auto h = history.rbegin(); h != history.rend(); ++h)
        if (h->tag == tag) return &*h;
    return nullptr;
}

/// The size of the contour as far as it can be seen: what a coordinate is compared with.
void FkState::grow(const FkElement& e) {
    const auto see = [this](double v) { scale = std::max(scale, std::abs(v)); };
    const auto value = [&](const std::optional<FkValue>& v, double zero) {
        if (v) see(v->base == FkBase::absolute ? v->value - zero : v->value);
    };
    const auto point = [&](const FkPoint& p) {
        if (p.x) see(*p.x - origin.x);
        if (p.y) see(*p.y - origin.y);
    };
    value(e.x, origin.x);
    value(e.y, origin.y);
    value(e.ccx, origin.x);
    value(e.ccy, origin.y);
    value(e.pr, 0);
    value(e.ccpr, 0);
    for (const FkPoint& p : e.on) point(p);
    point(e.beside);
    if (e.pole && (e.pr || e.pa || e.ccpr || e.ccpa)) point({e.pole->x, e.pole->y});
    for (const auto& v : {e.length, e.radius, e.distance, e.parallel_distance})
        if (v) see(*v);
}

FkSolver FkState::solver() const {
    std::vector<FkChord> chords;
    std::vector<FkGuide> guides;
    for (const FkSlot& s : pending) {
        const FkHandle& h = s.handle;
        chords.push_back({s.e.tag, h.end_x - h.start_x, h.end_y - h.start_y});
        FkGuide g;
        g.end = s.first_id / 4;
        g.carrier = g.end + 1;
        g.arc = s.e.arc;
        g.from_x = h.start_x;
        g.from_y = h.start_y;
        g.normal_x = h.na_x;
        g.normal_y = h.na_y;
        if (s.e.on[0].x) g.on = Vec2{*s.e.on[0].x, *s.e.on[0].y} - origin;
        if (s.e.beside.x) g.beside = Vec2{*s.e.beside.x, *s.e.beside.y} - origin;
        if (s.e.pole && (s.e.pr || s.e.pa || s.e.ccpr || s.e.ccpa)) g.pole = *s.e.pole - origin;
        guides.push_back(std::move(g));
    }
    return {scale, std::move(chords), std::move(guides)};
}

/// Every branch with every combination of alternatives; false if that is too much.
bool FkState::branch_out(const std::vector<FkChoice>& choices) {
    const FkSolver s = solver();
    for (const FkChoice& c : choices) {
        std::vector<FkBranch> next;
        for (const FkBranch& b : branches)
            for (std::size_t i = 0; i < c.size(); ++i) {
                next.push_back(b);
                if (c.size() > 1) next.back().path.push_back(static_cast<int>(i));
                s.add(next.back(), c[i]);
            }
        if (next.size() > 4 * fk_most_solutions) return false;
        branches = std::move(next);
    }
    return true;
}

std::optional<FkFault> FkState::extend(const FkElement& e) {
    FkFault fault;
    fault.tag = e.tag;
    const FkLookup lookup = [this](std::uint64_t tag) { return find(tag); };
    if (auto f = fault_in(e, last(), lookup)) return f;
    if (pending.size() >= fk_most_pending) {
        fault.reason = FkReason::too_many_pending;
        return fault;
    }
    if (e.closed == FkClosed::ends && !closing) {
        fault.reason = FkReason::unknown_block;
        fault.datum = FkDatum::clsd;
        return fault;
    }
    grow(e);
    const FkHandle before = last();
    const FkHandle self = unknown_handle(e, next_id, before);
    const auto choices = equations_of(e, {self, before, lookup, origin, closing.value_or(std::array<FkPoly, 2>{})});
    for (FkBranch& b : branches) {
        if (b.values.empty()) b.base = next_id;
        for (int i = 0; i < unknowns_of(e); ++i) b.values.push_back(FkPoly::unknown(next_id + i));
    }
    pending.push_back({e, next_id, self});
    next_id += unknowns_of(e);
    const bool fits = branch_out(choices);
    FkSolver s = solver();
    if (fits)
        for (FkBranch& b : branches) s.solve(std::move(b));
    s.put_in_order();
    branches = std::move(s.found);
    if (!fits || s.exhausted) {
        fault.reason = FkReason::too_many_solutions;
        return fault;
    }
    if (branches.empty()) {
        fault.reason = FkReason::contradictory;
        if (s.nearest) {
            fault.tag = s.nearest->tag;
            fault.datum = s.nearest->datum;
            fault.miss = s.nearest->miss;
        }
        return fault;
    }
    unite();
    return {};
}

/// Branches that found the same in different ways become one; only where nothing is left open in either, since what is
/// still to be checked may differ.
void FkState::unite() {
    const auto same = [this](const FkBranch& a, const FkBranch& b) {
        for (const FkBranch* x : {&a, &b})
            if (!x->open.empty() || !x->checks.empty() || !x->limits.empty() || !x->polar.empty()) return false;
        for (std::size_t i = 0; i < a.values.size(); ++i) {
            const double limit = is_direction(a.base + static_cast<int>(i)) ? same_solution / scale : same_solution;
            const FkPoly apart = a.values[i] - b.values[i];
            if (!apart.is_constant() || std::abs(apart.constant()) > limit) return false;
        }
        return true;
    };
    std::vector<FkBranch> kept;
    for (FkBranch& b : branches)
        if (std::none_of(kept.begin(), kept.end(), [&](const FkBranch& k) { return same(k, b); }))
            kept.push_back(std::move(b));
    branches = std::move(kept);
}

std::optional<Element> FkState::element(const FkBranch& b, const FkSlot& s) const {
    const FkHandle& h = s.handle;
    const auto fx = b.known(h.start_x), fy = b.known(h.start_y), tx = b.known(h.end_x), ty = b.known(h.end_y);
    if (!fx || !fy || !tx || !ty) return {};
    Element e;
    e.tag = s.e.tag;
    e.from = origin + Vec2{*fx, *fy};
    e.to = origin + Vec2{*tx, *ty};
    e.w_from = e.w_to = w;
    const auto nx = b.known(h.na_x), ny = b.known(h.na_y);
    if (!nx || !ny) return {};
    if (!s.e.arc) return e;
    const auto cx = b.known(h.centre_x), cy = b.known(h.centre_y), r = b.known(h.radius);
    if (!cx || !cy || !r) return {};
    e.centre = origin + Vec2{*cx, *cy};
    e.sweep = sweep_of(e.from, e.to, e.centre, *r);
    return e;
}

/// True where all branches have the same for this pending element.
bool FkState::agreed(std::size_t index, Element& out) const {
    for (std::size_t i = 0; i < branches.size(); ++i) {
        const auto e = element(branches[i], pending[index]);
        if (!e) return false;
        if (i == 0) {
            out = *e;
        } else if (geom::distance(e->from, out.from) > 1e-9 || geom::distance(e->to, out.to) > 1e-9 ||
                   geom::distance(e->centre, out.centre) > 1e-9 || std::abs(e->sweep - out.sweep) > 1e-9) {
            return false;
        }
    }
    return true;
}

/// The first pending element has its values: what the others say of it becomes constant.
void FkState::forget_first(const Element& e) {
    const FkSlot first = std::move(pending.front());
    pending.pop_front();
    const auto n = static_cast<std::size_t>(unknowns_of(first.e));
    const auto settle = [&](FkPoly& p, const FkBranch& b) {
        FkSum s;
        for (const FkTerm& t : p.terms) {
            double factor = t.factor;
            int a = t.a, c = t.b;
            for (int* id : {&a, &c})
                if (*id >= 0 && *id < first.first_id + static_cast<int>(n)) {
                    factor *= b.values[static_cast<std::size_t>(*id - b.base)].constant();
                    *id = -1;
                }
            s.add(a, c, factor);
        }
        p = s.take();
    };
    for (FkBranch& b : branches) {
        for (FkEquation& q : b.checks) settle(q.poly, b);
        for (FkEquation& q : b.stated) settle(q.poly, b);
        std::erase_if(b.stated, [](const FkEquation& q) { return q.poly.is_constant(); });
        for (FkLimit& q : b.limits) settle(q.poly, b);
        for (FkPolar& q : b.polar)
            for (FkPoly* p : {&q.x, &q.y, &q.radius_from[0], &q.radius_from[1], &q.angle_from[0], &q.angle_from[1]})
                settle(*p, b);
    }
    for (FkSlot& s : pending)
        for (FkPoly* p : {&s.handle.start_x, &s.handle.start_y}) settle(*p, branches.front());
    if (closing)
        for (FkPoly& p : *closing) settle(p, branches.front());
    for (FkBranch& b : branches) {
        b.values.erase(b.values.begin(), b.values.begin() + static_cast<std::ptrdiff_t>(n));
        b.base += static_cast<int>(n);
    }
    start = constant_handle(e, origin);
    history.push_back(start);
    if (history.size() > fk_history) history.pop_front();
    if (pending.empty()) next_id = 0;
}

std::vector<Element> FkState::release() {
    std::vector<Element> out;
    Element e;
    if (branches.size() == 1 && !pending.empty() && agreed(0, e)) polish(branches.front(), scale);
    while (!pending.empty() && agreed(0, e)) {
        forget_first(e);
        out.push_back(e);
    }
    return out;
}

/// The data not given of which the solution so far does not fix what they would say.
std::vector<FkDatum> FkState::missing(const FkBranch& b, const FkSlot& s) const {
    const FkElement& e = s.e;
    const FkHandle& h = s.handle;
    std::vector<FkDatum> out;
    const auto open = [&](const FkPoly& p) { return !b.known(p).has_value(); };
    const auto say = [&](FkDatum d, bool given, bool is_open) {
        if (!given && is_open) out.push_back(d);
    };
    say(FkDatum::x, e.x.has_value(), open(h.end_x));
    say(FkDatum::y, e.y.has_value(), open(h.end_y));
    say(FkDatum::len, e.length.has_value(), open(h.end_x) || open(h.end_y));
    say(FkDatum::an, e.an.has_value() || e.tangential, open(h.nb_x) || open(h.nb_y));
    if (!e.arc) return out;
    say(FkDatum::r, e.radius.has_value(), open(h.radius));
    say(FkDatum::ccx, e.ccx.has_value(), open(h.centre_x));
    say(FkDatum::ccy, e.ccy.has_value(), open(h.centre_y));
    say(FkDatum::cca, e.cca.has_value(), open(h.na_x) || open(h.na_y));
    return out;
}

}  // namespace obrys::path
