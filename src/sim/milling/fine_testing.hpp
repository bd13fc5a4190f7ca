#pragma once
/// An exact reference for milled blocks that shares no code with the simulation: tools as convex distance functions,
/// the nearest moment of a move by golden section, ends of material on lines by bisection. Upright tools, straight
/// moves, millimetres.

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/milling/cutter.hpp"
#include "sim/milling/lattice.hpp"

namespace obrys::sim::milling::testing {

struct RoundTool {
    enum class Kind { flat, ball, bull, cone } kind = Kind::flat;
    double radius = 3, corner = 0.5, half_angle = 0.7853981633974483, length = 40;
};

/// Convex; 0 on the tool; of points inside the distance from its faces, of points outside at most the distance.
inline double outside_of(const RoundTool& t, geom::Vec3 p) {
    const double r = std::hypot(p.x, p.y);
    const double upper = std::max(r - t.radius, p.z - t.length);
    switch (t.kind) {
        case RoundTool::Kind::flat: return std::max(upper, -p.z);
        case RoundTool::Kind::ball: return p.z < t.radius ? std::hypot(r, p.z - t.radius) - t.radius : upper;
        case RoundTool::Kind::bull: {
            const double ring = t.radius - t.corner;
            if (p.z >= t.corner) return upper;
            return r > ring ? std::hypot(r - ring, p.z - t.corner) - t.corner : -p.z;
        }
        case RoundTool::Kind::cone:
            return std::max(upper, r * std::cos(t.half_angle) - p.z * std::sin(t.half_angle));
    }
    return 0;
}

struct Move {
    RoundTool tool;
    geom::Vec3 from, to;
};

/// A block from which moves have taken what they sweep.
struct Reference {
    Box3 block;
    std::vector<Move> moves;

    [[nodiscard]] static double outside_move(const Move& m, geom::Vec3 p) {
        const geom::Vec3 way = m.to - m.from;
        const auto at = [&](double t) { return outside_of(m.tool, p - m.from - t * way); };
        constexpr double golden = 0.6180339887498949;
        double a = 0, b = 1, s = 1 - golden, t = golden, at_s = at(s), at_t = at(t);
        for (int i = 0; i < 60; ++i) {
            if (at_s < at_t) {
                b = t, t = s, at_t = at_s, s = b - golden * (b - a), at_s = at(s);
            } else {
                a = s, s = t, at_s = at_t, t = a + golden * (b - a), at_t = at(t);
            }
        }
        return std::min({at_s, at_t, at(0), at(1)});
    }
    [[nodiscard]] double in_block(geom::Vec3 p) const {
        return std::min({p.x - block.min.x, block.max.x - p.x, p.y - block.min.y, block.max.y - p.y,
                         p.z - block.min.z, block.max.z - p.z});
    }
    /// How deep a point lies in material, at least; in air negative, how far from material at least.
    [[nodiscard]] double depth(geom::Vec3 p) const {
        double least = in_block(p);
        for (const Move& m : moves) least = std::min(least, outside_move(m, p));
        return least;
    }
    /// Coordinates at which material begins or ends on the line along `axis` through p.
    [[nodiscard]] std::vector<double> ends(geom::Vec3 p, int axis) const {
        std::vector<double> cuts{component(block.min, axis), component(block.max, axis)};
        const auto on = [&](const Move& m, double s) {
            geom::Vec3 q = p;
            set_component(q, axis, s);
            return outside_move(m, q);
        };
        for (const Move& m : moves) {
            constexpr double golden = 0.6180339887498949;
            double a = cuts[0] - 1, b = cuts[1] + 1;
            for (int i = 0; i < 70; ++i) {
                const double s = b - golden * (b - a), t = a + golden * (b - a);
                if (on(m, s) < on(m, t))
                    b = t;
                else
                    a = s;
            }
            const double middle = 0.5 * (a + b);
            if (!(on(m, middle) < 0)) continue;
            for (const double end : {cuts[0] - 1, cuts[1] + 1}) {
                if (on(m, end) < 0) continue;
                double in = middle, out = end;
                for (int i = 0; i < 60; ++i) (on(m, 0.5 * (in + out)) < 0 ? in : out) = 0.5 * (in + out);
                cuts.push_back(in);
            }
        }
        // Those between material and air.
        std::vector<double> kept;
        constexpr double aside = 1e-6;
        for (const double c : cuts) {
            geom::Vec3 below = p, above = p;
            set_component(below, axis, c - aside);
            set_component(above, axis, c + aside);
            if ((depth(below) > 0) != (depth(above) > 0)) kept.push_back(c);
        }
        return kept;
    }
};

inline ToolShape shape_of(const RoundTool& t) {
    Cutter c;
    c.kind = t.kind == RoundTool::Kind::flat   ? CutterKind::end_mill
             : t.kind == RoundTool::Kind::ball ? CutterKind::ball
             : t.kind == RoundTool::Kind::bull ? CutterKind::bull_nose
                                               : CutterKind::chamfer;
    c.diameter = 2 * t.radius;
    c.corner_radius = t.corner;
    c.cutting_length = t.length;
    c.point_angle = 2 * t.half_angle;
    return milling::shape_of(c).shape;
}

}  // namespace obrys::sim::milling::testing
