#include "surface.hpp"

#include <numbers>
#include <optional>

namespace exact {

namespace {

constexpr double on = 1e-7;       ///< mm: what counts as on the surface
constexpr std::size_t rims = 10;  ///< places of sharp rings and points to each place of faces: lines, not areas

/// The place near `p` where all of some constraints are 0: steps of least length.
std::optional<V> meet(const Solid& solid, const std::vector<std::size_t>& of, V p) {
    const V start = p;
    for (int step = 0; step < 40; ++step) {
        std::array<Signed, 3> s;
        double worst = 0;
        for (std::size_t i = 0; i < of.size(); ++i) {
            s[i] = solid.constraint(of[i], p);
            worst = std::max(worst, std::abs(s[i].d));
        }
        if (worst < on / 10) return p;
        if (norm(p - start) > 20) return {};
        if (of.size() == 1) {
            p = p - s[0].d * s[0].out;
        } else if (of.size() == 2) {
            const double c = dot(s[0].out, s[1].out), det = 1 - c * c;
            if (det < 1e-6) return {};
            const double a = (s[0].d - c * s[1].d) / det, b = (s[1].d - c * s[0].d) / det;
            p = p - a * s[0].out - b * s[1].out;
        } else {
            const V n = cross(s[1].out, s[2].out);
            const double det = dot(s[0].out, n);
            if (std::abs(det) < 1e-4) return {};
            p = p - (1 / det) * (s[0].d * n + s[1].d * cross(s[2].out, s[0].out) + s[2].d * cross(s[0].out, s[1].out));
        }
    }
    return {};
}

/// The nearest of the places near `p` where one, two or three constraints are 0 and the solid is: at a sharp edge steps out
/// of one cut after the other end far from it.
void nearest_meeting(const Solid& solid, V p, double& found, V& best) {
    constexpr std::size_t most = 8;
    std::vector<std::size_t> near = solid.near(p, found);
    if (near.size() > most) near.resize(most);
    const auto look = [&](const std::vector<std::size_t>& of) {
        const std::optional<V> q = meet(solid, of, p);
        if (q && norm(*q - p) < found && solid.value(*q) <= on) found = norm(*q - p), best = *q;
    };
    for (std::size_t i = 0; i < near.size(); ++i) {
        look({near[i]});
        for (std::size_t j = 0; j < i; ++j) {
            look({near[i], near[j]});
            for (std::size_t k = 0; k < j; ++k) look({near[i], near[j], near[k]});
        }
    }
}

/// Somewhere on a body's surface, with the direction out of it; not even.
V on_body(const Solid& solid, const Move& m, Random& random, V& out) {
    const Tool& tool = solid.tool(m);
    const Body& b = tool[static_cast<std::size_t>(uniform(random, 0, static_cast<double>(tool.size())))];
    const V u = across(m.axis), v = cross(m.axis, u);
    const double turn = uniform(random, 0, 2 * std::numbers::pi);
    const V side = std::cos(turn) * u + std::sin(turn) * v;
    const double where = uniform(random, 0, 3);
    double r = b.r0, z = b.z0, lean = 0;
    if (where < 1) {
        r = b.r0 * std::sqrt(uniform(random, 0, 1)), lean = -1;
    } else if (where < 2) {
        const double t = std::pow(uniform(random, 0, 1), 2);  // the lower end is what cuts as a rule
        r = b.r0 + t * (b.r1 - b.r0), z = b.z0 + t * (b.z1 - b.z0), lean = 0;
    } else {
        lean = -uniform(random, 0, 1);
    }
    out = unit(std::sqrt(std::max(0.0, 1 - lean * lean)) * side + lean * m.axis);
    return at(m, uniform(random, 0, 1)) + r * side + z * m.axis + b.rounding * out;
}

/// On a sharp ring or the point of a tool that moves: anywhere of it where a way begins and ends, else at its sides, which
/// alone may stay. What of it is part of the surface is told by the solid.
V on_rim(const Solid& solid, const Move& m, Random& random) {
    const Tool& tool = solid.tool(m);
    const Body& b = tool[static_cast<std::size_t>(uniform(random, 0, static_cast<double>(tool.size())))];
    const bool low = uniform(random, 0, 1) < 0.8;
    const double r = low ? b.r0 : b.r1, z = low ? b.z0 : b.z1, where = uniform(random, 0, 4);
    const double t = where < 1 ? 0 : where < 2 ? 1 : uniform(random, 0, 1), step = 1e-4;
    const V u = across(m.axis), v = cross(m.axis, u);
    const double turn = uniform(random, 0, 2 * std::numbers::pi);
    V side = std::cos(turn) * u + std::sin(turn) * v;
    const V way = cross(m.axis, at(m, std::min(1.0, t + step)) - at(m, std::max(0.0, t - step)));
    if (where >= 2 && norm(way) > 0) side = (turn < std::numbers::pi ? 1 : -1) * unit(way);
    return at(m, t) + r * side + z * m.axis;
}

/// Where a line enters and leaves the solid: steps as long as nothing can lie in between.
void along(const Solid& solid, V from, V way, double length, std::vector<V>& found) {
    double t = 0;
    while (t < length) {
        const V p = from + t * way;
        const double d = solid.value(p);
        if (std::abs(d) < on) {
            found.push_back(p);
            t += 2e-3;
        } else {
            t += std::max(std::abs(d), 1e-5);
        }
    }
}

/// From a place of one face to the edges and corners that it has with others near by.
void edges_near(const Solid& solid, V p, std::vector<V>& found) {
    constexpr double reach = 1.5;
    constexpr std::size_t most = 4;
    std::vector<std::size_t> near = solid.near(p, reach);
    if (near.size() > most) near.resize(most);
    for (std::size_t i = 0; i < near.size(); ++i)
        for (std::size_t j = i + 1; j < near.size(); ++j) {
            const std::optional<V> edge = meet(solid, {near[i], near[j]}, p);
            if (!edge) continue;
            found.push_back(*edge);
            for (std::size_t k = j + 1; k < near.size(); ++k)
                if (const std::optional<V> corner = meet(solid, {near[i], near[j], near[k]}, *edge))
                    found.push_back(*corner);
        }
}

/// The nearest place of a box.
V within(const Box& box, V p) {
    return {std::clamp(p.x, box.lo.x, box.hi.x), std::clamp(p.y, box.lo.y, box.hi.y), std::clamp(p.z, box.lo.z, box.hi.z)};
}

}  // namespace

double uniform(Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
}

V direction(Random& random) {
    const double z = uniform(random, -1, 1), a = uniform(random, 0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(a), r * std::sin(a), z};
}

Off off_surface(const Solid& solid, V p, double enough, Random& random) {
    const double value = solid.value(p);
    if (value <= on) return {std::max(0.0, -value), p, true};
    // Outside: out of every cut that it lies in, into the stock, until it lies in none.
    V best = p;
    double found = 1e300;
    V q = p;
    for (int step = 0; step < 30; ++step) {
        const Signed s = solid.constraint(solid.foremost(q), q);
        if (s.d <= on) {
            if (norm(q - p) < found) found = norm(q - p), best = q;
            break;
        }
        q = q - (s.d + on / 2) * s.out;
    }
    if (found <= std::max(enough, 1.001 * value)) return {found, best, false};
    // Between several cuts it may have gone the long way round: edges and corners, then by chance, first far, then near.
    nearest_meeting(solid, p, found, best);
    if (found <= std::max(enough, 1.001 * value)) return {found, best, false};
    // Beside a feather edge little of what is near is material: the last ring is searched long, and on the stock's faces.
    double ring = std::min(found, 40 * enough);
    for (int in_vain = 0; in_vain < (found > enough && ring <= 2 * enough ? 3000 : 100);) {
        const V there = within(solid.stock_box(), p + (ring * std::cbrt(uniform(random, 0, 1))) * direction(random));
        if (norm(there - p) < found && solid.value(there) <= on) {
            found = norm(there - p), best = there, ring = 0.9 * found, in_vain = 0;
        } else if (++in_vain == 100 && found > enough && ring > 2 * enough) {
            ring = std::max(ring / 2, 2 * enough), in_vain = 0;
        }
    }
    return {found, best, false};
}

bool has_material(const Solid& solid, V p, double skin) {
    for (int i = 0; i < 27; ++i) {
        const V way{i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
        if (i != 13 && solid.value(p + skin * unit(way)) < -0.05 * skin) return true;
    }
    // Between faces that meet at a sharp angle: straight in from both.
    V in;
    for (const std::size_t i : solid.near(p, skin / 10)) in = in - solid.constraint(i, p).out;
    return norm(in) > 1e-3 && solid.value(p + skin * unit(in)) < -0.02 * skin;
}

std::vector<V> samples(const Solid& solid, std::size_t each, double skin, Random& random) {
    std::vector<V> found;
    for (std::size_t c = 1; c < solid.constraints(); ++c)
        for (std::size_t i = 0; i < each; ++i) {
            V out;
            const V p = on_body(solid, solid.moves()[c - 1], random, out);
            const V q = p + (0.3 * uniform(random, 0, 1)) * out;
            if (solid.stock_box().distance(q) > 0.5) continue;
            const std::optional<V> s = meet(solid, {c}, q);
            if (!s) continue;
            found.push_back(*s);
            if (i % 4 == 0) edges_near(solid, *s, found);
        }
    for (const Move& m : solid.moves())
        for (std::size_t i = 0; i < rims * each; ++i)
            if (const V p = on_rim(solid, m, random); solid.stock_box().distance(p) < 1e-9) found.push_back(p);
    const Box& box = solid.stock_box();
    const V size = box.hi - box.lo;
    for (std::size_t i = 0; i < each * 8; ++i) {
        const V p{uniform(random, box.lo.x, box.hi.x), uniform(random, box.lo.y, box.hi.y),
                  uniform(random, box.lo.z, box.hi.z)};
        const V way = i % 4 == 0   ? V{1, 0, 0}
                      : i % 4 == 1 ? V{0, 1, 0}
                      : i % 4 == 2 ? V{0, 0, 1}
                                   : direction(random);
        const double length = norm(size);
        const std::size_t before = found.size();
        along(solid, p - length * way, way, 2 * length, found);
        const std::size_t after = found.size();
        if (i % 4 == 3)
            for (std::size_t k = before; k < after; ++k) edges_near(solid, found[k], found);
    }
    std::vector<V> kept;
    for (const V& p : found)
        if (std::abs(solid.value(p)) < on && has_material(solid, p, skin)) kept.push_back(p);
    return kept;
}

}  // namespace exact
