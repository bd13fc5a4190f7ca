#include "sim/milling/cut/air.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/topology.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec2;
using geom::Vec3;

double from_segment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 v = b - a, q = p - a;
    const double square = dot(v, v), t = square > 0 ? std::clamp(dot(q, v) / square, 0.0, 1.0) : 0;
    return geom::length(q - t * v);
}

/// Of a point (distance from the axis, height) from the piece's outer side.
double from_side(const Piece& piece, Vec2 p) {
    if (piece.kind == PieceKind::cone) return from_segment({piece.r0, piece.z0}, {piece.r1, piece.z1}, p);
    const Vec2 out = p - Vec2{piece.ring, piece.centre};
    const double far = geom::length(out), there = piece.centre + (far > 0 ? out.y / far : 0) * piece.arc;
    if (out.x >= 0 && there >= piece.z0 && there <= piece.z1) return std::abs(far - piece.arc);
    return std::min(geom::length(p - Vec2{piece.r0, piece.z0}), geom::length(p - Vec2{piece.r1, piece.z1}));
}

/// Distance from a piece, exact; 0 inside.
double from_piece(const Piece& piece, Vec3 p) {
    const Vec2 at{std::sqrt(p.x * p.x + p.y * p.y), p.z};
    if (piece.whole) {
        const Vec2 round{std::max(0.0, at.x - piece.ring), at.y - piece.centre};
        return std::max(0.0, geom::length(round) - piece.arc);
    }
    if (at.y >= piece.z0 && at.y <= piece.z1 && at.x <= radius_at(piece, at.y)) return 0;
    return std::min({from_side(piece, at), from_segment({0, piece.z0}, {piece.r0, piece.z0}, at),
                     from_segment({0, piece.z1}, {piece.r1, piece.z1}, at)});
}

/// How near a piece comes on its way: the least that was met, and how long the part of the way is that may hold less.
struct Approach {
    double least = 0, open = 0;  ///< mm
};

/// Golden section: convex in time. Ends where `enough(approach)` says so.
template <class Enough>
Approach approach_on_way(const Piece& piece, Vec3 v, Vec3 p, Enough&& enough) {
    constexpr double golden = 0.6180339887498949;
    constexpr double fine = 1e-7;  // mm of way
    const double way = length(v);
    double a = 0, b = 1, s = 1 - golden, t = golden;
    double at_s = from_piece(piece, p - s * v), at_t = from_piece(piece, p - t * v);
    while (true) {
        const Approach now{std::min(at_s, at_t), (b - a) * way};
        if (now.open <= fine || enough(now)) return now;
        if (at_s < at_t) {
            b = t, t = s, at_t = at_s, s = b - golden * (b - a);
            at_s = from_piece(piece, p - s * v);
        } else {
            a = s, s = t, at_s = at_t, t = a + golden * (b - a);
            at_t = from_piece(piece, p - t * v);
        }
    }
}

/// The least on its way, less the error of the search: it changes no faster than the way goes.
double from_way(const Piece& piece, Vec3 v, Vec3 p) {
    const Approach a = approach_on_way(piece, v, p, [](const Approach& now) { return !(now.least > 0); });
    return std::max(0.0, a.least - a.open);
}

/// Whether it comes as near as that on its way.
bool comes_within(const Piece& piece, Vec3 v, Vec3 p, double allowed) {
    const auto enough = [&](const Approach& now) { return now.least <= allowed || now.least - now.open > allowed; };
    return approach_on_way(piece, v, p, enough).least <= allowed;
}

double within_box(const Box3& box, Vec3 p) {
    Vec3 beyond;
    double nearest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double in =
            std::min(component(p, axis) - component(box.min, axis), component(box.max, axis) - component(p, axis));
        nearest = std::min(nearest, in);
        set_component(beyond, axis, std::max(0.0, -in));
    }
    return nearest >= 0 ? nearest : -length(beyond);
}

double within_cylinder(const CylinderStock& c, Vec3 p) {
    Vec3 out = p - c.centre;
    const double height = component(out, c.axis);
    set_component(out, c.axis, 0);
    const double side = c.radius - length(out), ends = std::min(height, c.length - height);
    if (side >= 0 && ends >= 0) return std::min(side, ends);
    return -geom::length(Vec2{std::max(0.0, -side), std::max(0.0, -ends)});
}

}  // namespace

double depth_in(const Shape& shape, Vec3 p) {
    const Vec2 at{std::sqrt(p.x * p.x + p.y * p.y), p.z};
    bool inside = false;
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shape.pieces.size(); ++i) {
        const Piece& piece = shape.pieces[i];
        inside = inside || (at.y >= piece.z0 && at.y <= piece.z1 && at.x <= radius_at(piece, at.y));
        depth = std::min(depth, from_side(piece, at));
        const bool first = i == 0, last = i + 1 == shape.pieces.size();
        if (first) depth = std::min(depth, from_segment({0, piece.z0}, {piece.r0, piece.z0}, at));
        const double next = last ? 0 : shape.pieces[i + 1].r0;
        depth = std::min(depth, from_segment({next, piece.z1}, {piece.r1, piece.z1}, at));
    }
    return inside ? depth : 0;
}

double outside_sweep(const Shape& shape, const Track& track, Vec3 p, double enough) {
    const Foot foot = foot_on(shape, track, p);
    if (!(foot.outside > 0)) return std::min(foot.outside, -depth_in(shape, p - foot.place));
    if (foot.outside >= enough) return foot.outside;
    // The largest distance from one of the faces is far too little beside a moving cone.
    double nearest = std::numeric_limits<double>::infinity();
    for (const Piece& piece : shape.pieces)
        nearest = std::min(
            nearest, track.circular || track.level() ? from_piece(piece, p - foot.place) : from_way(piece, track.v, p));
    return std::max(foot.outside, nearest);
}

bool sweeps_within(const Shape& shape, const Track& track, Vec3 p, double allowed) {
    const Foot foot = foot_on(shape, track, p);
    if (foot.outside > allowed) return false;
    if (!(foot.outside > 0) || distance_from(shape, p - foot.place) <= allowed) return true;
    return !track.circular && !track.level() &&
           std::any_of(shape.pieces.begin(), shape.pieces.end(),
                       [&](const Piece& piece) { return comes_within(piece, track.v, p, allowed); });
}

double distance_from(const Shape& shape, Vec3 p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Piece& piece : shape.pieces) nearest = std::min(nearest, from_piece(piece, p));
    return nearest;
}

StockBody::StockBody(const Stock& stock) {
    if (const auto* box = std::get_if<Box3>(&stock)) {
        body_ = *box;
        return;
    }
    if (const auto* bar = std::get_if<CylinderStock>(&stock)) {
        body_ = *bar;
        return;
    }
    const auto& given = std::get<MeshStock>(stock);
    mesh::Mesh copy;
    copy.vertices = given.vertices;
    copy.triangles.assign(given.triangles.begin(), given.triangles.end());
    const mesh::Topology t = mesh::topology(copy);
    closed_ = t.open.count + t.crowded.count + t.turned.count == 0;
    const double sign = mesh::volume(copy) < 0 ? -1 : 1;
    body_ = std::make_shared<const Mesh>(Mesh{mesh::Distance(std::move(copy)), sign});
}

double StockBody::within(Vec3 p) const {
    if (const auto* box = std::get_if<Box3>(&body_)) return within_box(*box, p);
    if (const auto* bar = std::get_if<CylinderStock>(&body_)) return within_cylinder(*bar, p);
    const Mesh& m = *std::get<std::shared_ptr<const Mesh>>(body_);
    return -m.outwards * m.distance.signed_distance(p);
}

double StockBody::most_within(std::span<const Vec3> corners) const {
    double least = std::numeric_limits<double>::infinity();
    const auto beside = [&](auto&& depth) {  // a plane's side: the depth grows evenly
        double most = -std::numeric_limits<double>::infinity();
        for (const Vec3& p : corners) most = std::max(most, depth(p));
        least = std::min(least, most);
    };
    if (const auto* box = std::get_if<Box3>(&body_)) {
        for (int axis = 0; axis < 3; ++axis) {
            beside([&](Vec3 p) { return component(p, axis) - component(box->min, axis); });
            beside([&](Vec3 p) { return component(box->max, axis) - component(p, axis); });
        }
        return least;
    }
    Vec3 middle;
    for (const Vec3& p : corners) middle = middle + (1.0 / static_cast<double>(corners.size())) * p;
    if (const auto* bar = std::get_if<CylinderStock>(&body_)) {
        const double low = component(bar->centre, bar->axis), high = low + bar->length;
        beside([&](Vec3 p) { return component(p, bar->axis) - low; });
        beside([&](Vec3 p) { return high - component(p, bar->axis); });
        Vec3 out = middle - bar->centre;
        set_component(out, bar->axis, 0);
        const double far = length(out);
        // The plane that touches the bar where the middle lies.
        beside([&](Vec3 p) { return bar->radius - (far > 0 ? dot(p - bar->centre, out) / far : 0); });
        return least;
    }
    beside([&](Vec3 p) { return within(p); });
    return std::max(least, within(middle));
}

std::vector<StockBody::Face> StockBody::faces_at(Vec3 p, double deep) const {
    std::vector<Face> faces;
    const auto add = [&](double within, Vec3 in) {
        if (within <= deep) faces.push_back({within, in});
    };
    const auto along = [](int axis, double sign) {
        Vec3 v;
        set_component(v, axis, sign);
        return v;
    };
    if (const auto* box = std::get_if<Box3>(&body_))
        for (int axis = 0; axis < 3; ++axis) {
            add(component(p, axis) - component(box->min, axis), along(axis, 1));
            add(component(box->max, axis) - component(p, axis), along(axis, -1));
        }
    if (const auto* bar = std::get_if<CylinderStock>(&body_)) {
        Vec3 out = p - bar->centre;
        const double height = component(out, bar->axis);
        set_component(out, bar->axis, 0);
        const double far = length(out);
        add(height, along(bar->axis, 1));
        add(bar->length - height, along(bar->axis, -1));
        if (far > 0) add(bar->radius - far, (-1 / far) * out);
    }
    return faces;
}

double Air::outside(std::size_t body, Vec3 p, double enough) const {
    if (body == 0) return stock_->within(p);
    const Sweep& s = sweeps_[body - 1];
    return outside_sweep(*s.shape, s.track, s.frame.to_tool(p - s.from), enough);
}

Vec3 Air::normal(std::size_t body, Vec3 p) const {
    const Sweep& s = sweeps_[body - 1];
    return s.frame.to_stock(foot_on(*s.shape, s.track, s.frame.to_tool(p - s.from)).normal);
}

}  // namespace obrys::sim::milling
