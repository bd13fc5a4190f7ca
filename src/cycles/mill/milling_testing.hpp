#pragma once
/// For tests of milling cycles: the steps of an expansion as moves in the plane with heights, and what must hold of
/// them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cycles/cycle.hpp"
#include "geom/region.hpp"

namespace obrys::cycles::testing {

using geom::Vec2;
using geom::Vec3;

/// A value added later counts.
inline Demand with(Demand d, cl::CycleRole role, double value) {
    d.values.push_back({role, value});
    return d;
}

struct Move {
    geom::Edge way;  ///< in the plane; a == b for a vertical move
    std::vector<Vec2> samples;
    double from = 0, to = 0;  ///< heights
    bool rapid = false;
    double feed = 0;
    [[nodiscard]] bool vertical() const { return samples.size() == 1; }
};

inline std::vector<Move> moves_of(const Expansion& e, Vec3 at) {
    std::vector<Move> out;
    double feed = 0;
    for (const cl::Step& step : e.steps) {
        if (const auto* f = std::get_if<cl::Feed>(&step)) feed = f->value;
        Move m;
        m.from = at.z;
        m.feed = feed;
        const auto sample = [&](auto point, double length) {
            const int n = std::clamp(static_cast<int>(std::ceil(length / 0.4)), 1, 2000);
            for (int i = 0; i <= n; ++i) m.samples.push_back(point(static_cast<double>(i) / n));
        };
        if (const auto* l = std::get_if<cl::Linear>(&step)) {
            const Vec2 a{at.x, at.y}, b{l->to.x, l->to.y};
            m.rapid = l->rapid;
            m.to = l->to.z;
            m.way = {a, b, 0};
            if (geom::distance(a, b) > 1e-9)
                sample([&](double t) { return a + t * (b - a); }, geom::distance(a, b));
            else
                m.samples = {a};
            at = l->to;
        } else if (const auto* arc = std::get_if<cl::Arc>(&step)) {
            const Vec2 centre{arc->centre.x, arc->centre.y}, r = Vec2{at.x, at.y} - centre;
            m.to = arc->to.z;
            m.way = {{at.x, at.y}, {arc->to.x, arc->to.y}, 0};
            const auto point = [&](double t) {
                const double c = std::cos(t * arc->sweep), s = std::sin(t * arc->sweep);
                return centre + Vec2{c * r.x - s * r.y, s * r.x + c * r.y};
            };
            EXPECT_LT(geom::distance(point(1), {arc->to.x, arc->to.y}), 1e-7) << "end of an arc";
            sample(point, std::min(geom::length(r) * std::abs(arc->sweep), 400.0));
            at = arc->to;
        } else {
            continue;
        }
        out.push_back(std::move(m));
    }
    return out;
}

/// Heights at which something is milled in the plane.
inline std::set<double> milled_levels(const std::vector<Move>& moves) {
    std::set<double> out;
    for (const Move& m : moves)
        if (!m.rapid && !m.vertical() && m.from == m.to) out.insert(m.to);
    return out;
}

/// Whether the tool has cut about here, at this height or below, before the move.
inline bool cut_before(const std::vector<Move>& moves, const Move& until, Vec2 p, double height) {
    for (const Move& m : moves) {
        if (&m == &until) return false;
        if (m.rapid || std::max(m.from, m.to) > height + 1e-9) continue;
        for (const Vec2 q : m.samples)
            if (geom::distance(p, q) < (until.vertical() ? 0.5 : 3)) return true;
    }
    return false;
}

struct Limits {
    double surface = 0, bottom = 0;
    double plunge = 0, mill = 0;  ///< feeds; 0: of more than one kind
    /// Distance of the tool's centre from the contour at least; region left to be milled.
    double away = 0;
};

/// No gouge, no rapid move in the material, feeds by direction, nothing below the bottom.
inline void expect_sound(const std::vector<Move>& moves, const geom::Region& region, const Limits& l) {
    const std::vector<geom::Edge> contour = geom::edges(region);
    for (const Move& m : moves) {
        EXPECT_GE(std::min(m.from, m.to), l.bottom - 1e-9);
        if (std::min(m.from, m.to) >= l.surface) continue;
        for (const Vec2 p : m.samples) {
            double d = 1e300;
            for (const geom::Edge& e : contour) d = std::min(d, geom::distance(e, p));
            EXPECT_GE(d, l.away - 2e-6) << p.x << ' ' << p.y;
            EXPECT_TRUE(geom::winding(contour, p) > 0 || d < 1e-6) << p.x << ' ' << p.y;
        }
        if (m.rapid && m.to <= m.from) {
            for (const Vec2 p : m.samples)
                EXPECT_TRUE(cut_before(moves, m, p, m.to))
                    << "rapid in the material at " << p.x << ' ' << p.y << ' ' << m.to;
        } else if (m.vertical() && m.to < m.from) {
            EXPECT_EQ(m.feed, l.plunge);
        } else if (!m.rapid && !m.vertical() && m.from == m.to && l.mill > 0) {
            EXPECT_EQ(m.feed, l.mill);
        }
    }
}

/// Whether the tool passed over the point at the height or below it.
inline bool covered(const std::vector<Move>& moves, Vec2 p, double radius, double height) {
    for (const Move& m : moves) {
        if (m.rapid || m.from != m.to || m.to > height + 1e-9) continue;
        for (const Vec2 q : m.samples)
            if (geom::distance(p, q) <= radius + 0.03)
                return true;  // samples lie 0.4 apart: 0.02 between them at radius 1
    }
    return false;
}

}  // namespace obrys::cycles::testing
