#include "check/left/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double same_place = 1e-9;     ///< mm
constexpr double one_axis = 1 - 1e-15;  ///< cosine of axes that are one

double from_segment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 v = b - a, q = p - a;
    const double square = geom::dot(v, v), t = square > 0 ? std::clamp(geom::dot(q, v) / square, 0.0, 1.0) : 0;
    return geom::length(q - t * v);
}

/// Of a place in the half section from a convex piece; 0 within. It does not become less with the radius.
double from_section(const milling::Piece& p, Vec2 at) {
    if (p.kind == milling::PieceKind::cone && p.r0 == p.r1) {
        const double out = std::max(0.0, at.x - p.r0), off = std::max({0.0, p.z0 - at.y, at.y - p.z1});
        return out == 0 ? off : off == 0 ? out : std::sqrt(out * out + off * off);
    }
    if (at.y >= p.z0 && at.y <= p.z1 && at.x <= radius_at(p, at.y)) return 0;
    double side = 0;
    if (p.kind == milling::PieceKind::cone) {
        side = from_segment({p.r0, p.z0}, {p.r1, p.z1}, at);
    } else {
        const Vec2 out = at - Vec2{p.ring, p.centre};
        const double far = geom::length(out), there = p.centre + (far > 0 ? out.y / far : 0) * p.arc;
        side = out.x >= 0 && there >= p.z0 && there <= p.z1
                   ? std::abs(far - p.arc)
                   : std::min(geom::length(at - Vec2{p.r0, p.z0}), geom::length(at - Vec2{p.r1, p.z1}));
    }
    return std::min({side, from_segment({0, p.z0}, {p.r0, p.z0}, at), from_segment({0, p.z1}, {p.r1, p.z1}, at)});
}

/// Least value of a convex function on 0 … 1, or 0 as soon as it is met.
template <class F>
double least_on_way(F&& f) {
    constexpr double share = 0.6180339887498949;
    double a = 0, b = 1, best = std::min(f(0.0), f(1.0));
    double s = b - share * (b - a), t = a + share * (b - a), at_s = f(s), at_t = f(t);
    constexpr int steps = 30;  // to a millionth of the way
    for (int i = 0; i < steps && best > 0; ++i) {
        best = std::min({best, at_s, at_t});
        if (at_s <= at_t)
            b = t, t = s, at_t = at_s, at_s = f(s = b - share * (b - a));
        else
            a = s, s = t, at_s = at_t, at_t = f(t = a + share * (b - a));
    }
    return best;
}

}  // namespace

LeftCut::LeftCut(const milling::Air::Sweep& sweep, std::size_t first, std::size_t end)
    : sweep_(&sweep), pieces_(std::span(sweep.shape->pieces).subspan(first, end - first)) {
    for (const milling::Piece& p : pieces_) widest_ = std::max(widest_, widest_between(p, p.z0, p.z1));
    const milling::Track& track = sweep.track;
    const Vec3 to = sweep.from + sweep.frame.to_stock(track.v), axis = sweep.frame.z;
    // Less than half a circle stands off its chord by less than half of that.
    const double bulge = track.circular ? 0.5 * geom::distance(sweep.from, to) : 0;
    const auto reach = [&](double along) { return (widest_ + bulge) * std::sqrt(std::max(0.0, 1 - along * along)); };
    const Vec3 around{reach(axis.x), reach(axis.y), reach(axis.z)};
    for (const Vec3& tip : {sweep.from, to})
        for (const double z : {pieces_.front().z0, pieces_.back().z1}) {
            box_.add(tip + z * axis - around);
            box_.add(tip + z * axis + around);
        }
}

double LeftCut::beside(double radial, double height) const {
    double least = std::numeric_limits<double>::infinity();
    for (const milling::Piece& p : pieces_) {
        least = std::min(least, from_section(p, {radial, height}));
        if (least == 0) break;
    }
    return least;
}

bool LeftCut::in_wedge(Vec2 q) const {
    const milling::Track& t = sweep_->track;
    const double least = -same_place * geom::length(q);
    return t.turn * geom::cross(t.first, q) >= least && t.turn * geom::cross(q, t.last) >= least;
}

double LeftCut::from_arc(Vec2 p) const {
    const milling::Track& t = sweep_->track;
    const Vec2 q = p - t.centre;
    if (in_wedge(q)) return std::abs(geom::length(q) - t.radius);
    return std::min(geom::length(p), geom::length(p - Vec2{t.v.x, t.v.y}));
}

/// `p` in the tool's frame, from where the sweep begins.
double LeftCut::on_way(Vec3 p, double radius) const {
    const milling::Track& t = sweep_->track;
    if (t.circular) return beside(from_arc({p.x, p.y}) + radius, p.z);
    const Vec2 flat{t.v.x, t.v.y}, at{p.x, p.y};
    const double square = geom::dot(flat, flat);
    if (t.v.z == 0) {
        const double u = square > 0 ? std::clamp(geom::dot(at, flat) / square, 0.0, 1.0) : 0;
        return beside(geom::length(at - u * flat) + radius, p.z);
    }
    if (square == 0 && pieces_.size() == 1 && pieces_[0].r0 == pieces_[0].r1 &&
        pieces_[0].kind == milling::PieceKind::cone) {
        milling::Piece whole = pieces_[0];
        (t.v.z < 0 ? whole.z0 : whole.z1) += t.v.z;
        return from_section(whole, {geom::length(at) + radius, p.z});
    }
    return least_on_way([&](double u) { return beside(geom::length(at - u * flat) + radius, p.z - u * t.v.z); });
}

double LeftCut::farthest(const Disc& disc, Vec3 axis) const {
    const Vec3 p = sweep_->frame.to_tool(disc.centre - sweep_->from);
    if (disc.radius == 0) return on_way(p, 0);
    const double along = std::abs(geom::dot(axis, sweep_->frame.z));
    return along > one_axis ? on_way(p, disc.radius) : on_way(p, 0) + disc.radius;
}

/// A distance from a circle is not convex within it: what it may be more between two places is said of the chord.
double LeftCut::farthest(std::span<const Disc> discs, Vec3 axis, double enough) const {
    for (const Disc& d : discs) {  // as far from the box as that: cheap, and true of most
        const Vec3 &p = d.centre, &lo = box_.lo, &hi = box_.hi;
        const double off = std::max({lo.x - p.x, p.x - hi.x, lo.y - p.y, p.y - hi.y, lo.z - p.z, p.z - hi.z});
        if (off >= enough) return off;
    }
    double most = 0, chord = 0, inner = std::numeric_limits<double>::infinity();
    const milling::Track& track = sweep_->track;
    if (track.circular) {
        bool all = true;
        Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
        for (const Disc& d : discs) {
            const Vec3 p = sweep_->frame.to_tool(d.centre - sweep_->from);
            const Vec2 q = Vec2{p.x, p.y} - track.centre;
            all = all && in_wedge(q);
            inner = std::min(inner, geom::length(q));
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        chord = geom::length(high - low);
        if (!all && chord > same_place) {  // beside the wedge: from one of its ends
            double least = std::numeric_limits<double>::infinity();
            for (const Vec2 end : {Vec2{}, Vec2{track.v.x, track.v.y}}) {
                double far = 0;
                for (const Disc& d : discs) {
                    const Vec3 p = sweep_->frame.to_tool(d.centre - sweep_->from);
                    far = std::max(far, beside(geom::length(Vec2{p.x, p.y} - end) + d.radius, p.z));
                }
                least = std::min(least, far);
            }
            if (std::abs(geom::dot(axis, sweep_->frame.z)) > one_axis) return least;
            return std::numeric_limits<double>::infinity();
        }
    }
    // What is no farther from one of the discs than the chord, or by the circle's bend (over a triangle of that size).
    const double clear = inner - chord;
    const double bend = chord > same_place ? std::min(chord, clear > 0 ? chord * chord / (6 * clear) : INFINITY) : 0;
    for (const Disc& d : discs) {
        most = std::max(most, farthest(d, axis));
        if (most + bend >= enough) return most + bend;
    }
    return most + bend;
}

double LeftCut::farthest(const Disc& disc, const ArcWay& way, Vec3 axis) const {
    constexpr double no = std::numeric_limits<double>::infinity();
    const milling::Track& t = sweep_->track;
    if (!t.circular || std::abs(geom::dot(axis, sweep_->frame.z)) <= one_axis) return no;
    const auto flat = [&](Vec3 p) {
        const Vec3 q = sweep_->frame.to_tool(p - sweep_->from);
        return Vec2{q.x, q.y} - t.centre;
    };
    if (!in_wedge(flat(way.from)) || !in_wedge(flat(way.to))) return no;
    const double off = geom::length(flat(way.centre));
    if (off > 0.01 * t.radius) return no;
    const Vec3 p = sweep_->frame.to_tool(disc.centre - sweep_->from);
    return beside(std::abs(way.radius - t.radius) + off + disc.radius, p.z);
}

/// Along a circle it lies as far from that as its farthest and its nearest place do.
bool LeftCut::holds(const std::array<Vec3, 8>& corners, double off) const {
    std::array<Vec3, 8> at;
    std::array<Vec2, 8> from_centre;
    const milling::Track& t = sweep_->track;
    bool beside_ends = t.circular;
    double farthest_off = 0, low = INFINITY, high = -INFINITY;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        at[i] = sweep_->frame.to_tool(corners[i] - sweep_->from);
        from_centre[i] = Vec2{at[i].x, at[i].y} - t.centre;
        beside_ends = beside_ends && in_wedge(from_centre[i]);
        farthest_off = std::max(farthest_off, geom::length(from_centre[i]) - t.radius);
        low = std::min(low, at[i].z), high = std::max(high, at[i].z);
    }
    if (beside_ends) {
        for (const Vec2& a : from_centre)
            for (const Vec2& b : from_centre) farthest_off = std::max(farthest_off, t.radius - from_segment(a, b, {}));
        return beside(farthest_off, low) <= off && beside(farthest_off, high) <= off;
    }
    const Vec2 end{t.v.x, t.v.y};
    const auto all = [&](auto&& f) { return std::all_of(at.begin(), at.end(), f); };
    if (t.circular)
        return all([&](Vec3 p) {
                   return beside(geom::length(Vec2{p.x, p.y}), p.z) <= off;
               }) ||
               all([&](Vec3 p) {
                   return beside(geom::length(Vec2{p.x, p.y} - end), p.z) <= off;
               });
    return all([&](Vec3 p) { return on_way(p, 0) <= off; });
}

Vec3 LeftCut::outwards(const Disc& disc) const {
    const Vec3 p = sweep_->frame.to_tool(disc.centre - sweep_->from);
    const milling::Track& t = sweep_->track;
    Vec2 off;
    if (t.circular) {
        const Vec2 q = Vec2{p.x, p.y} - t.centre;
        const double far = geom::length(q);
        off = far > t.radius ? q : -1.0 * q;
    } else {
        const Vec2 flat{t.v.x, t.v.y}, at{p.x, p.y};
        const double square = geom::dot(flat, flat);
        const double u = square > 0 ? std::clamp(geom::dot(at, flat) / square, 0.0, 1.0) : 0;
        off = at - u * flat;
    }
    const double size = geom::length(off);
    return size > same_place ? sweep_->frame.to_stock({off.x / size, off.y / size, 0}) : Vec3{};
}

namespace {

/// Makes one way of two, where the second goes on as the first one.
bool goes_on(milling::Air::Sweep& a, const milling::Air::Sweep& b) {
    const Vec3 way = a.frame.to_stock(a.track.v), end = a.from + way;
    if (a.shape != b.shape || a.track.circular != b.track.circular || geom::distance(a.frame.z, b.frame.z) > 0 ||
        geom::distance(end, b.from) > same_place)
        return false;
    if (!a.track.circular) {
        const double size = geom::length(a.track.v);
        if (geom::length(geom::cross(a.track.v, b.track.v)) > same_place * size || geom::dot(a.track.v, b.track.v) < 0)
            return false;
        a.track.v = a.track.v + b.track.v;
        return true;
    }
    const Vec2 over{a.track.v.x, a.track.v.y};
    constexpr double half = 0.1;  // of a sine: nearly half a turn
    const double sine = a.track.turn * geom::cross(a.track.first, b.track.last);
    const bool whole = geom::length(a.track.centre - over - b.track.centre) <= same_place &&
                       a.track.turn == b.track.turn && std::abs(a.track.radius - b.track.radius) <= same_place &&
                       (sine > half || (sine > 0 && geom::dot(a.track.first, b.track.last) > 0));
    if (!whole) return false;
    a.track.v = a.track.v + b.track.v;
    a.track.last = b.track.last;
    return true;
}

}  // namespace

LeftCuts::LeftCuts(const milling::Air& air, const milling::Simulation& simulation, std::uint32_t before) {
    for (std::size_t body = 1; body < air.bodies(); ++body) {
        const milling::Air::Sweep& sweep = air.sweep(body);
        if (simulation.pass_of(sweep.cut) >= before) break;
        if (sweeps_.empty() || !goes_on(sweeps_.back(), sweep)) sweeps_.push_back(sweep);
    }
    // First what holds most.
    turns_ = turns_of(sweeps_);
    for (const auto* sweeps : {&turns_.sweeps, &sweeps_})
        for (const milling::Air::Sweep& sweep : *sweeps) {
            const auto& pieces = sweep.shape->pieces;
            for (std::size_t first = 0; first < pieces.size();) {
                const std::size_t end = milling::convex_end(pieces, first);
                all_.emplace_back(sweep, first, end);
                first = end;
            }
        }
}

double deepest_in(const milling::Stock& stock, const milling::Air& air, std::span<const Disc> discs, Vec3 axis,
                  Vec3 middle) {
    const auto along = [&](Vec3 u) {  // the largest dot(u, p)
        const double up = geom::dot(u, axis), across = std::sqrt(std::max(0.0, 1 - up * up));
        double most = -std::numeric_limits<double>::infinity();
        for (const Disc& d : discs) most = std::max(most, geom::dot(u, d.centre) + d.radius * across);
        return most;
    };
    const auto unit = [](int k, double sign) {
        Vec3 u;
        milling::set_component(u, k, sign);
        return u;
    };
    double least = std::numeric_limits<double>::infinity();
    if (const auto* box = std::get_if<milling::Box3>(&stock)) {
        for (int k = 0; k < 3; ++k)
            least = std::min({least, milling::component(box->max, k) + along(unit(k, -1)),
                              along(unit(k, 1)) - milling::component(box->min, k)});
        return least;
    }
    if (const auto* bar = std::get_if<milling::CylinderStock>(&stock)) {
        const double low = milling::component(bar->centre, bar->axis);
        least = std::min(low + bar->length + along(unit(bar->axis, -1)), along(unit(bar->axis, 1)) - low);
        Vec3 out = middle - bar->centre;
        milling::set_component(out, bar->axis, 0);
        const double far = geom::length(out);
        if (!(far > same_place)) return std::min(least, bar->radius);
        const Vec3 inwards = (-1 / far) * out;
        return std::min(least, bar->radius + along(inwards) - geom::dot(inwards, bar->centre));
    }
    double around = 0;
    for (const Disc& d : discs) around = std::max(around, geom::distance(d.centre, middle) + d.radius);
    return air.outside(0, middle) + around;
}

}  // namespace obrys::check
