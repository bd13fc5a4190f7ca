// Where faces of several bodies meet, and how far material is from a point that lies in more than one of them.

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/milling/exact/exact.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double on_plane = 1e-7;  ///< mm
constexpr int most_plane_steps = 12;
constexpr double no_material = 1e-5;  ///< mm: material thinner than that is none
constexpr double opposite = 0.9998;   ///< cosine of 1.1 degrees

/// The shortest way onto two or three planes, each given by how far it is along its gradient.
bool step_onto(std::span<const Exact::Side> sides, Vec3& way) {
    const Exact::Side &a = sides[0], &b = sides[1];
    if (sides.size() == 2) {
        const double aa = dot(a.in, a.in), ab = dot(a.in, b.in), bb = dot(b.in, b.in), det = aa * bb - ab * ab;
        if (!(det > 1e-3 * aa * bb)) return false;
        way = ((ab * b.outside - bb * a.outside) / det) * a.in + ((ab * a.outside - aa * b.outside) / det) * b.in;
        return true;
    }
    const Exact::Side& c = sides[2];
    const Vec3 bc = cross(b.in, c.in);
    const double det = dot(a.in, bc);
    if (!(std::abs(det) > 0.02)) return false;
    way = (-1 / det) * (a.outside * bc + b.outside * cross(c.in, a.in) + c.outside * cross(a.in, b.in));
    return true;
}

}  // namespace

Exact::Side Exact::side(const Near& near, std::size_t body, Vec3 p) const {
    if (body == 0) return {stock_.within(p), -1.0 * simulation_.normal_at(0, p)};
    const Air::Sweep& s = near.sweeps[body - 1];
    const Foot foot = foot_on(*s.shape, s.track, s.frame.to_tool(p - s.from));
    return {foot.outside, s.frame.to_stock(foot.gradient)};
}

double Exact::outside_of(const Near& near, std::size_t body, const Shape& part, Vec3 p) {
    const Air::Sweep& s = near.sweeps[body - 1];
    return foot_on(part, s.track, s.frame.to_tool(p - s.from)).outside;
}

bool Exact::meet(const Near& near, std::span<const std::size_t> of, Vec3& p) const {
    const double far = 4 * length(lattice_.step);
    const Vec3 start = p;
    std::array<Side, 3> sides;
    for (int i = 0; i < most_plane_steps; ++i) {
        double worst = 0;
        for (std::size_t n = 0; n < of.size(); ++n) {
            sides[n] = side(near, of[n], p);
            worst = std::max(worst, std::abs(sides[n].outside));
        }
        if (worst < on_plane) return true;
        Vec3 way;
        if (!step_onto({sides.data(), of.size()}, way)) return false;
        p = p + way;
        if (!(geom::distance(p, start) < far)) return false;
    }
    return false;
}

bool Exact::is_touch(const Near& near, Vec3 p, double allowed) const {
    std::vector<Side> close;  // with directions of length 1: of fine moves many
    const auto touches = [&](Side s) {
        const double size = length(s.in);
        if (!(size > 0) || !(std::abs(s.outside) <= allowed * size)) return false;
        s = {s.outside / size, (1 / size) * s.in};
        for (const Side& other : close)
            if (s.outside + other.outside < no_material && dot(s.in, other.in) < -opposite) return true;
        close.push_back(s);
        return false;
    };
    if (near.stock) {
        touches(side(near, 0, p));
        // On an edge of the stock each of its faces may be the one that a cut is flush with.
        for (const StockBody::Face& f : stock_.faces_at(p, allowed)) touches({f.within, f.in});
    }
    for (std::size_t body = 1; body < bodies(near); ++body)
        if (touches(side(near, body, p))) return true;
    return false;
}

/// From a point in air with these bodies around it there is a way out of all of them no longer than so. Distances are
/// convex, so what their tangents leave is outside of them. The way: of least length to all planes, by corrections of
/// one after the other (C. Hildreth, "A quadratic programming procedure", 1957).
std::optional<Vec3> Exact::way_out(std::span<const Side> around, double allowed) {
    constexpr int rounds = 40;
    const double fine = 0.02 * allowed;
    std::array<double, 24> few{};
    std::vector<double> many(around.size() > few.size() ? around.size() : 0);
    double* const pull = many.empty() ? few.data() : many.data();
    Vec3 way;
    for (int i = 0; i < rounds; ++i) {
        double most_missing = 0;
        for (std::size_t n = 0; n < around.size(); ++n) {
            const double square = dot(around[n].in, around[n].in);
            if (!(square > 1e-12)) {  // halfway between two faces no way is told
                if (around[n].outside < -fine) return std::nullopt;
                continue;
            }
            const double missing = -(around[n].outside + dot(around[n].in, way));
            const double more = std::max(missing / square, -pull[n]);
            pull[n] += more;
            way = way + more * around[n].in;
            most_missing = std::max(most_missing, missing);
        }
        if (most_missing <= fine) return length(way) <= allowed ? std::optional(way) : std::nullopt;
    }
    return std::nullopt;
}

Vec3 Exact::out_of_air(const Near& near, Vec3 p, double allowed) const {
    constexpr int steps = 3;  // faces are curved
    const Vec3 start = p;
    std::vector<Side> around;
    for (int i = 0; i < steps; ++i) {
        around.clear();
        const auto add = [&](const Side& s) {
            if (s.outside < allowed) around.push_back(s);
        };
        for (std::size_t body = near.stock ? 0 : 1; body < bodies(near); ++body) add(side(near, body, p));
        if (near.stock)
            for (const StockBody::Face& f : stock_.faces_at(p, allowed)) add({f.within, f.in});
        const std::optional<Vec3> way = way_out(around, allowed);
        if (!way || !(geom::distance(p + *way, start) <= allowed)) return start;
        p = p + *way;
    }
    return p;
}

}  // namespace obrys::sim::milling
