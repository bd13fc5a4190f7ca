#pragma once
/// Bodies whose rays are known by formula, for tests of the surface.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "geom/frame.hpp"
#include "sim/milling/surface/surface.hpp"

namespace obrys::sim::milling::testing {

using geom::Vec3;

/// Material on the line through a point along an axis, in ascending order.
using Solid = std::function<std::vector<Interval>(Vec3 through, int axis)>;

inline Vec3 axis_vector(int axis) { return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}; }

/// Faces get numbers from 1; the normals of all of them.
class Faces {
public:
    std::uint32_t add(std::function<Vec3(Vec3)> normal) {
        normals_.push_back(std::move(normal));
        return static_cast<std::uint32_t>(normals_.size());
    }
    [[nodiscard]] Vec3 normal(std::uint32_t cut, Vec3 at, int axis, double sign) const {
        const Vec3 n = normals_.at(cut - 1)(at);
        return component(n, axis) * sign < 0 ? -1.0 * n : n;
    }

    Solid ball(Vec3 centre, double radius) {
        const auto face = add([=](Vec3 p) { return (1 / length(p - centre)) * (p - centre); });
        return [=](Vec3 through, int axis) {
            Vec3 off = through - centre;
            set_component(off, axis, 0);
            const double half2 = radius * radius - dot(off, off), middle = component(centre, axis);
            std::vector<Interval> material;
            if (half2 > 0) material.push_back({middle - std::sqrt(half2), middle + std::sqrt(half2), face, face});
            return material;
        };
    }

    struct Plane {
        Vec3 point, normal;
    };
    /// What lies behind all planes.
    Solid polytope(std::vector<Plane> planes) {
        std::vector<std::uint32_t> faces;
        for (const Plane& p : planes) faces.push_back(add([n = p.normal](Vec3) { return n; }));
        return [=](Vec3 through, int axis) {
            set_component(through, axis, 0);
            Interval m{-1e9, 1e9, 0, 0};
            for (std::size_t i = 0; i < planes.size(); ++i) {
                const double slope = component(planes[i].normal, axis),
                             inside = dot(planes[i].normal, planes[i].point - through);
                if (slope == 0) {
                    if (inside < 0) return std::vector<Interval>{};
                    continue;
                }
                const double at = inside / slope;
                if (slope > 0 && at < m.end) m.end = at, m.end_cut = faces[i];
                if (slope < 0 && at > m.begin) m.begin = at, m.begin_cut = faces[i];
            }
            return m.begin < m.end ? std::vector<Interval>{m} : std::vector<Interval>{};
        };
    }
    Solid box(Vec3 centre, Vec3 half, const geom::Frame& turn = {}) {
        std::vector<Plane> planes;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 n = apply_direction(turn, axis_vector(axis));
            planes.push_back({centre + component(half, axis) * n, n});
            planes.push_back({centre - component(half, axis) * n, -1.0 * n});
        }
        return polytope(planes);
    }
    /// Without ends: along `direction`, unit length.
    Solid rod(Vec3 through_point, Vec3 direction, double radius) {
        const auto across = [=](Vec3 v) { return v - dot(v, direction) * direction; };
        const auto face = add([=](Vec3 p) {
            const Vec3 r = across(p - through_point);
            return (1 / length(r)) * r;
        });
        return [=](Vec3 through, int axis) {
            set_component(through, axis, 0);
            const Vec3 o = across(through - through_point), d = across(axis_vector(axis));
            const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - radius * radius;
            if (a < 1e-18) return c < 0 ? std::vector<Interval>{{-1e9, 1e9, face, face}} : std::vector<Interval>{};
            const double root = b * b - a * c;
            if (root <= 0) return std::vector<Interval>{};
            return std::vector<Interval>{{(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a, face, face}};
        };
    }

private:
    std::vector<std::function<Vec3(Vec3)>> normals_;
};

/// What is in the first and not in the second; or what is in both.
inline std::vector<Interval> combine(const std::vector<Interval>& a, const std::vector<Interval>& b, bool both) {
    std::vector<Interval> gaps;
    Interval gap{-1e9, 1e9, 0, 0};
    for (const Interval& m : b) {
        gap.end = m.begin, gap.end_cut = m.begin_cut;
        gaps.push_back(gap);
        gap = {m.end, 1e9, m.end_cut, 0};
    }
    gaps.push_back(gap);
    std::vector<Interval> result;
    for (const Interval& m : a)
        for (const Interval& g : both ? b : gaps) {
            Interval cut = m;
            if (g.begin > cut.begin) cut.begin = g.begin, cut.begin_cut = g.begin_cut;
            if (g.end < cut.end) cut.end = g.end, cut.end_cut = g.end_cut;
            if (cut.begin < cut.end) result.push_back(cut);
        }
    return result;
}
inline Solid subtract(Solid a, Solid b) {
    return [=](Vec3 p, int axis) { return combine(a(p, axis), b(p, axis), false); };
}
inline Solid intersect(Solid a, Solid b) {
    return [=](Vec3 p, int axis) { return combine(a(p, axis), b(p, axis), true); };
}
/// Of bodies that do not overlap.
inline Solid join(Solid a, Solid b) {
    return [=](Vec3 p, int axis) {
        std::vector<Interval> all = a(p, axis);
        for (const Interval& m : b(p, axis)) all.push_back(m);
        std::sort(all.begin(), all.end(), [](const Interval& x, const Interval& y) { return x.begin < y.begin; });
        return all;
    };
}

/// The rays of a body in a lattice.
class Sampled {
public:
    Sampled(const Lattice& lattice, const Solid& solid) : lattice_(lattice) {
        for (int axis = 0; axis < 3; ++axis)
            for (int b = 0; b < count(second_across(axis)); ++b)
                for (int a = 0; a < count(first_across(axis)); ++a) {
                    std::array<int, 3> node{};
                    node[static_cast<std::size_t>(first_across(axis))] = a;
                    node[static_cast<std::size_t>(second_across(axis))] = b;
                    rays_[static_cast<std::size_t>(axis)].push_back(
                        solid(lattice.node(node[0], node[1], node[2]), axis));
                }
    }
    [[nodiscard]] std::span<const Interval> ray(int axis, int a, int b) const {
        return rays_[static_cast<std::size_t>(axis)]
                    [static_cast<std::size_t>(b) * static_cast<std::size_t>(count(first_across(axis))) +
                     static_cast<std::size_t>(a)];
    }
    [[nodiscard]] Surface surface(const Faces& faces) const {
        return extract_surface(
            lattice_, [this](int axis, int a, int b) { return ray(axis, a, b); },
            [&](std::uint32_t cut, Vec3 at, int axis, double sign) { return faces.normal(cut, at, axis, sign); });
    }

private:
    [[nodiscard]] int count(int axis) const { return lattice_.count[static_cast<std::size_t>(axis)]; }
    Lattice lattice_;
    std::array<std::vector<std::vector<Interval>>, 3> rays_;
};

/// A lattice around a box, its outermost nodes at least half a step outside.
inline Lattice around(Vec3 lo, Vec3 hi, double step) {
    Lattice l;
    l.step = {step, step, step};
    l.origin = lo - Vec3{0.5 * step, 0.5 * step, 0.5 * step};
    for (int axis = 0; axis < 3; ++axis)
        l.count[static_cast<std::size_t>(axis)] =
            static_cast<int>(std::ceil((component(hi, axis) - component(lo, axis)) / step)) + 2;
    return l;
}

}  // namespace obrys::sim::milling::testing
