// Places where a tool's sharp rim or point is part of the surface.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "sim/milling/surface/unseen.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

/// A sharp ring of a tool's outline, convex, with the directions out of the faces that meet there: along the radius and
/// along the axis.
struct Rim {
    double r = 0, z = 0;
    geom::Vec2 below, above;
};

geom::Vec2 out_of(const Piece& p, double z) {
    if (p.kind == PieceKind::cone) {
        const geom::Vec2 out{p.z1 - p.z0, p.r0 - p.r1};
        return (1 / geom::length(out)) * out;
    }
    const geom::Vec2 out{radius_at(p, z) - p.ring, z - p.centre};
    const double size = geom::length(out);
    return size > 0 ? (1 / size) * out : geom::Vec2{0, -1};
}

std::vector<Rim> rims_of(const Shape& shape, double tolerance) {
    std::vector<Rim> all;
    constexpr double smooth = 0.95;  // cosine of the turn
    const auto add = [&](double r, double z, geom::Vec2 below, geom::Vec2 above) {
        if (r > tolerance && cross(below, above) > 0 && dot(below, above) < smooth) all.push_back({r, z, below, above});
    };
    const std::vector<Piece>& p = shape.pieces;
    if (!p.empty() && p[0].kind == PieceKind::cone && p[0].r0 <= tolerance && p[0].r1 > p[0].r0)
        all.push_back({0, p[0].z0, {0, -1}, out_of(p[0], p[0].z0)});  // the point
    for (std::size_t i = 0; i < p.size(); ++i) {
        const bool first = i == 0, last = i + 1 == p.size();
        const geom::Vec2 low = out_of(p[i], p[i].z0), high = out_of(p[i], p[i].z1);
        if (first || p[i - 1].r1 < p[i].r0 - 1e-9) add(p[i].r0, p[i].z0, {0, -1}, low);
        if (last || p[i + 1].r0 < p[i].r1 - 1e-9) add(p[i].r1, p[i].z1, high, {0, 1});
        if (!last && std::abs(p[i + 1].r0 - p[i].r1) <= 1e-9)
            add(p[i].r1, p[i].z1, high, out_of(p[i + 1], p[i + 1].z0));
    }
    return all;
}

/// Lines, as places along them in cells with nodes in material.
class Lines {
public:
    Lines(const Lattice& lattice, const NodeBits& nodes) : lattice_(lattice), nodes_(nodes) {}
    struct At {
        Vec3 p, centre;
        double radius = 0;
        Place cell{};
        bool joined = false;  ///< to the one before it
    };
    void begin() { open_ = false; }
    void add(Vec3 p, Vec3 centre, double radius) {
        const std::optional<Place> cell = cell_at(lattice_, p);
        if (!cell || nodes_.corners((*cell)[0], (*cell)[1], (*cell)[2]) == 0) return begin();
        places.push_back({p, centre, radius, *cell, open_});
        open_ = true;
    }
    std::vector<At> places;

private:
    const Lattice& lattice_;
    const NodeBits& nodes_;
    bool open_ = false;
};

/// The way's direction at its beginning or end.
Vec3 way_at(const Track& track, bool end) {
    if (!track.circular) return track.v;
    const geom::Vec2 out = end ? track.last : track.first;
    return {-track.turn * out.y, track.turn * out.x, 0};
}

/// A tool that goes on as `way` says comes away from this place of its rim.
bool is_left_behind(const Rim& rim, geom::Vec2 out, Vec3 way) {
    const double aside = out.x * way.x + out.y * way.y, least = 1e-9 * length(way);
    return rim.below.x * aside + rim.below.y * way.z < least && rim.above.x * aside + rim.above.y * way.z < least;
}

class RimPlaces {
public:
    RimPlaces(Lines& places, const Lattice& lattice, double apart) : places_(places), apart_(apart) {
        box_.min = lattice.origin;
        box_.max = lattice.node(lattice.count[0] - 1, lattice.count[1] - 1, lattice.count[2] - 1);
    }

    /// Where the tool stands, between two moves; either way may be zero.
    void standing(const Air::Sweep& s, const Rim& rim, Vec3 at, Vec3 came, Vec3 goes) {
        if (is_far(s, rim, at)) return;
        const Vec3 centre = s.from + s.frame.to_stock(at + Vec3{0, 0, rim.z});
        const double count = rim.r > 0 ? std::max(8.0, std::ceil(2 * geom::pi * rim.r / apart_)) : 1;
        places_.begin();
        for (double i = 0; i < count + (rim.r > 0 ? 1 : 0); ++i) {
            const double turn = 2 * geom::pi * i / count;
            const geom::Vec2 out{std::cos(turn), std::sin(turn)};
            // Moving on or having come, the tool covers the place.
            if ((came != Vec3{} && is_left_behind(rim, out, came)) ||
                (goes != Vec3{} && is_left_behind(rim, out, -1.0 * goes)))
                places_.begin();
            else
                places_.add(place_of(s, rim, at, out), centre, rim.r);
        }
    }
    void along(const Air::Sweep& s, const Rim& rim) {
        const Vec3 v = way_at(s.track, false);
        const double way = s.track.circular
                               ? s.track.radius * std::acos(std::clamp(dot(s.track.first, s.track.last), -1.0, 1.0))
                               : length(s.track.v);
        if (s.track.upright() || !(v.x * v.x + v.y * v.y > 0)) return;
        const double count = std::ceil(way / (rim.r > 0 ? apart_ : 0.2 * apart_));
        for (const double hand : {1.0, -1.0}) {
            if (hand < 0 && !(rim.r > 0)) return;
            places_.begin();
            for (double i = 0; i <= count; ++i) {
                const Vec3 at = point_on(s.track, i / count);
                geom::Vec2 side{-v.y, v.x};
                if (s.track.circular) side = geom::Vec2{at.x, at.y} - s.track.centre;
                side = (hand / geom::length(side)) * side;
                const Vec3 centre = s.from + s.frame.to_stock({s.track.centre.x, s.track.centre.y, at.z + rim.z});
                places_.add(place_of(s, rim, at, side), centre,
                            s.track.circular ? std::abs(s.track.radius + hand * rim.r) : 0);
            }
        }
    }

private:
    /// The rim of a tool that stands there lies beside the lattice.
    [[nodiscard]] bool is_far(const Air::Sweep& s, const Rim& rim, Vec3 at) const {
        const Vec3 p = s.from + s.frame.to_stock(at + Vec3{0, 0, rim.z}), axis = s.frame.z;
        for (int a = 0; a < 3; ++a) {
            const double along = component(axis, a), half = rim.r * std::sqrt(std::max(0.0, 1 - along * along));
            if (component(p, a) + half < component(box_.min, a) || component(p, a) - half > component(box_.max, a))
                return true;
        }
        return false;
    }
    [[nodiscard]] static Vec3 place_of(const Air::Sweep& s, const Rim& rim, Vec3 at, geom::Vec2 out) {
        return s.from + s.frame.to_stock(at + Vec3{rim.r * out.x, rim.r * out.y, rim.z});
    }
    Lines& places_;
    double apart_;
    Box3 box_;
};

/// A move of the same tool begins where another ends.
bool goes_on(const Air::Sweep& a, const Air::Sweep& b) {
    return a.shape == b.shape && a.frame.z == b.frame.z && a.frame.x == b.frame.x &&
           geom::distance(a.from + a.frame.to_stock(a.track.v), b.from) < 1e-9;
}

/// Which of the places are of the surface.
std::vector<std::uint8_t> on_surface(const Lines& lines, Exact& exact, double tolerance) {
    std::vector<Place> cells;
    std::vector<std::vector<std::uint32_t>> of_cell;
    KeyMap number;
    for (std::uint32_t i = 0; i < lines.places.size(); ++i) {
        const Place& cell = lines.places[i].cell;
        const std::uint32_t n = number.add(key_of(cell), static_cast<std::uint32_t>(cells.size()));
        if (n == cells.size()) {
            cells.push_back(cell);
            of_cell.emplace_back();
        }
        of_cell[n].push_back(i);
    }
    exact.prepare(cells);
    const double allowed = bare_share * tolerance;
    std::vector<std::uint8_t> on(lines.places.size());
    base::for_all(cells.size(), [&](std::size_t n) {
        const Exact::Near near = exact.near(cells[n], false);
        for (const std::uint32_t i : of_cell[n]) {
            const Vec3 p = lines.places[i].p;
            on[i] = exact.is_on_surface(near, p, allowed) && !exact.is_touch(near, p, allowed) ? 1 : 0;
        }
    });
    return on;
}

}  // namespace

Vec3 SharpPart::middle(Vec3 a, Vec3 b) const {
    const Vec3 half = 0.5 * (a + b), out = half - centre;
    const double size = length(out);
    return radius > 0 && size > 0 ? centre + (radius / size) * out : half;
}

double SharpPart::bend(Vec3 a, Vec3 b) const {
    // Up to a quarter of a circle: at most 1.18 times what its parabola says.
    const Vec3 chord = b - a;
    return radius > 0 ? dot(chord, chord) / (6.5 * radius) : 0;
}

bool is_sharp_place(const Exact& exact, const Place& cell, Vec3 p, double tolerance) {
    const double allowed = bare_share * tolerance;
    const Exact::Near near = exact.near(cell, p, 2 * tolerance, false);
    return exact.is_on_surface(near, p, allowed) && !exact.is_touch(near, p, allowed);
}

std::vector<SharpPart> rims(const Simulation& simulation, Exact& exact, const NodeBits& nodes, Sharp sharp) {
    const Lattice& l = exact.lattice();
    Lines lines(l, nodes);
    RimPlaces places(lines, l, 0.5 * std::min({l.step.x, l.step.y, l.step.z}));
    const Shape* last_shape = nullptr;
    std::vector<Rim> rims;
    bool joined = false;  // to the sweep before
    Vec3 came;
    const std::vector<Simulation::Whole>& wholes = exact.wholes();
    for (std::size_t n = 0; n < wholes.size(); ++n) {
        const Shape* shape = simulation.cutting_of(wholes[n].first);
        if (shape != last_shape) rims = rims_of(*shape, simulation.tolerance()), last_shape = shape;
        if (rims.empty()) {
            joined = false;
            continue;
        }
        const Air::Sweep s = simulation.body_of(wholes[n]);
        const bool goes = n + 1 < wholes.size() && goes_on(s, simulation.body_of(wholes[n + 1]));
        for (const Rim& rim : rims) {
            if ((rim.r > 0) != (sharp == Sharp::rims)) continue;
            places.standing(s, rim, {}, joined ? came : Vec3{}, way_at(s.track, false));
            places.along(s, rim);
            if (!goes) places.standing(s, rim, s.track.v, way_at(s.track, true), {});
        }
        joined = goes, came = way_at(s.track, true);
    }
    const std::vector<std::uint8_t> on = on_surface(lines, exact, simulation.tolerance());
    std::vector<SharpPart> all;
    const std::vector<Lines::At>& at = lines.places;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const bool goes_on = i + 1 < at.size() && at[i + 1].joined;
        if (goes_on && (on[i] != 0 || on[i + 1] != 0)) {
            const bool shared = at[i].joined && !all.empty() && all.back().to.at == at[i].p;
            all.push_back(
                {{at[i].p, on[i] != 0}, {at[i + 1].p, on[i + 1] != 0}, at[i].centre, at[i].radius, at[i].cell, shared});
        } else if (!goes_on && !at[i].joined && on[i] != 0) {
            all.push_back({{at[i].p, true}, {at[i].p, true}, {}, 0, at[i].cell, false});
        }
    }
    return all;
}

}  // namespace obrys::sim::milling
