#include "sim/certify/closest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr int closest_steps = 48;
constexpr double gain = 1e-9;  ///< of the distance; less is no gain

/// A point of the difference of the two sets, and those that it is the difference of.
struct Corner {
    Vec3 w, body, other;
    double weight = 0;
};

struct Simplex {
    std::array<Corner, 4> c;
    std::size_t n = 0;

    void keep(std::initializer_list<std::pair<std::size_t, double>> which) {
        std::array<Corner, 4> kept;
        std::size_t k = 0;
        for (const auto& [i, weight] : which) {
            kept[k] = c[i];
            kept[k++].weight = weight;
        }
        c = kept;
        n = k;
    }
    [[nodiscard]] Vec3 sum(Vec3 Corner::*of) const {
        Vec3 p;
        for (std::size_t i = 0; i < n; ++i) p = p + c[i].weight * (c[i].*of);
        return p;
    }
};

void nearest_of_two(Simplex& s) {
    const Vec3 a = s.c[0].w, ab = s.c[1].w - a;
    const double size = dot(ab, ab), t = size > 0 ? -dot(a, ab) / size : 0;
    if (t <= 0) return s.keep({{0, 1.0}});
    if (t >= 1) return s.keep({{1, 1.0}});
    s.keep({{0, 1 - t}, {1, t}});
}

/// Ericson, "Real-Time Collision Detection" (2005), chapter 5.1.5, of the origin.
void nearest_of_three(Simplex& s) {
    const Vec3 a = s.c[0].w, b = s.c[1].w, c = s.c[2].w, ab = b - a, ac = c - a;
    const double d1 = -dot(ab, a), d2 = -dot(ac, a);
    if (d1 <= 0 && d2 <= 0) return s.keep({{0, 1.0}});
    const double d3 = -dot(ab, b), d4 = -dot(ac, b);
    if (d3 >= 0 && d4 <= d3) return s.keep({{1, 1.0}});
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 - d3 > 0) return s.keep({{0, 1 - d1 / (d1 - d3)}, {1, d1 / (d1 - d3)}});
    const double d5 = -dot(ab, c), d6 = -dot(ac, c);
    if (d6 >= 0 && d5 <= d6) return s.keep({{2, 1.0}});
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 - d6 > 0) return s.keep({{0, 1 - d2 / (d2 - d6)}, {2, d2 / (d2 - d6)}});
    const double va = d3 * d6 - d5 * d4, e = d4 - d3, f = d5 - d6;
    if (va <= 0 && e >= 0 && f >= 0 && e + f > 0) return s.keep({{1, 1 - e / (e + f)}, {2, e / (e + f)}});
    const double all = va + vb + vc;
    if (!(all > 0)) {
        // No area: one of the sides has it.
        Simplex best;
        double least = INFINITY;
        for (std::size_t i = 0; i < 3; ++i) {
            Simplex side;
            side.c[0] = s.c[i], side.c[1] = s.c[(i + 1) % 3];
            side.n = 2;
            nearest_of_two(side);
            if (const double d = length(side.sum(&Corner::w)); d < least) least = d, best = side;
        }
        s = best;
        return;
    }
    s.keep({{0, va / all}, {1, vb / all}, {2, vc / all}});
}

/// Leaves all four where the origin lies within.
void nearest_of_four(Simplex& s) {
    constexpr std::array<std::array<std::size_t, 4>, 4> faces{{{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
    Simplex best;
    double least = INFINITY;
    for (const auto& f : faces) {
        const Vec3 a = s.c[f[0]].w, normal = cross(s.c[f[1]].w - a, s.c[f[2]].w - a);
        const double there = dot(s.c[f[3]].w - a, normal), here = -dot(a, normal);
        const bool flat = std::abs(there) <= 1e-9 * length(normal);
        if (!flat && (there > 0 ? here >= 0 : here <= 0)) continue;
        Simplex face;
        for (std::size_t i = 0; i < 3; ++i) face.c[i] = s.c[f[i]];
        face.n = 3;
        nearest_of_three(face);
        if (const double d = length(face.sum(&Corner::w)); d < least) least = d, best = face;
    }
    if (least < INFINITY) {
        s = best;
        return;
    }
    double all = 0;
    for (const auto& f : faces) {
        const Vec3 a = s.c[f[0]].w;
        const double volume = std::abs(dot(a, cross(s.c[f[1]].w - a, s.c[f[2]].w - a)));
        s.c[f[3]].weight = volume;
        all += volume;
    }
    for (Corner& c : s.c) c.weight = all > 0 ? c.weight / all : 0.25;
}

void reduce(Simplex& s) {
    switch (s.n) {
        case 1: s.c[0].weight = 1; return;
        case 2: return nearest_of_two(s);
        case 3: return nearest_of_three(s);
        default: return nearest_of_four(s);
    }
}

}  // namespace

Apart closest(const Swept& swept, std::span<const Vec3> others, double reach) {
    Simplex s;
    const auto corner = [&](Vec3 u) {
        const Vec3 body = support(swept, u);
        Vec3 other = others[0];
        for (const Vec3& p : others)
            if (dot(p, u) < dot(other, u)) other = p;
        return Corner{body - other, body, other, 1};
    };
    Apart out{0, INFINITY, {}, {}};
    s.c[0] = corner(others[0] - swept.from);
    s.n = 1;
    for (int step = 0; step < closest_steps; ++step) {
        reduce(s);
        const bool within = s.n == 4;
        const Vec3 v = s.sum(&Corner::w);
        const double far = within ? 0 : length(v);
        if (far < out.upper || step == 0) {
            out.upper = far;
            out.on_body = s.sum(&Corner::body);
            out.on_other = s.sum(&Corner::other);
        }
        if (within || far < 1e-13) {
            out.lower = out.upper = 0;
            return out;
        }
        if (out.upper <= reach) return out;
        const Corner next = corner(-1.0 * v);
        const double bound = dot(v, next.w) / far;
        out.lower = std::max(out.lower, bound);
        if ((reach >= 0 && out.lower > reach) || out.upper - out.lower <= gain * out.upper) return out;
        for (std::size_t i = 0; i < s.n; ++i)
            if (s.c[i].w == next.w) return out;
        if (s.n == 4) return out;
        s.c[s.n++] = next;
    }
    return out;
}

}  // namespace obrys::sim::certify
