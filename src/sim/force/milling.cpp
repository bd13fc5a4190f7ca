#include "sim/force/milling.hpp"

#include <algorithm>

namespace obrys::sim::force {

namespace {

using geom::pi;

/// An angle as 0 … 2 pi.
double turned(double angle) {
    const double rest = std::fmod(angle, 2 * pi);
    return rest < 0 ? rest + 2 * pi : rest;
}

bool engaged(const Ring& r, double angle) {
    return std::any_of(r.arcs.begin(), r.arcs.end(), [&](const Arc& a) { return angle >= a.from && angle <= a.to; });
}

/// What acts on the tool at one place of a tooth.
struct Load {
    geom::Vec3 force;
    double torque = 0, edge_torque = 0;
    bool engaged = false;
};

/// Sine and cosine of an angle.
struct Turn {
    double s = 0, c = 1;
};

/// A ring as the sums need it.
struct Edge {
    const Ring* ring = nullptr;
    Turn lag;
    double side = 0, down = 0;  ///< the chip is side sin(angle) + down
    double up = 0, out = 0;     ///< sine and cosine of its lean
};

void add(Load& load, const Edge& e, const Turn& angle, double thickness, const cutting::Law& law) {
    const Ring& r = *e.ring;
    const cutting::EdgeForce f = cutting::force(law, thickness);
    const double t = f.tangential * r.length, n = f.radial * r.length, a = f.axial * r.length;
    const double inward = n * e.up + a * e.out;
    load.force =
        load.force + geom::Vec3{-t * angle.c - inward * angle.s, t * angle.s - inward * angle.c, n * e.out - a * e.up};
    load.torque += t * r.radius;
    load.edge_torque += law.edge.tangential * cutting::edge_share(law, thickness) * r.length * r.radius;
    load.engaged = true;
}

struct Chips {
    double largest = 0, sum = 0, weight = 0;
};

/// Of one tooth whose tip stands at this angle.
Load load_at(std::span<const Edge> edges, const cutting::Law& law, double tip, Chips& chips) {
    Load load;
    const Turn here{std::sin(tip), std::cos(tip)};
    for (const Edge& e : edges) {
        const Turn turn{here.s * e.lag.c - here.c * e.lag.s, here.c * e.lag.c + here.s * e.lag.s};
        const double thickness = e.side * turn.s + e.down;
        if (!(thickness > 0) || !engaged(*e.ring, e.ring->lag == 0 ? tip : turned(tip - e.ring->lag))) continue;
        add(load, e, turn, thickness, law);
        chips.largest = std::max(chips.largest, thickness);
        chips.sum += thickness * e.ring->length;
        chips.weight += e.ring->length;
    }
    return load;
}

std::vector<Edge> edges_of(std::span<const Ring> rings, const Feed& feed) {
    std::vector<Edge> all;
    for (const Ring& r : rings) {
        if (r.arcs.empty()) continue;
        const double up = std::sin(r.lean), out = std::cos(r.lean);
        all.push_back({&r, {std::sin(r.lag), std::cos(r.lag)}, feed.side * up, feed.down * out, up, out});
    }
    return all;
}

void add(Forces& f, const Load& all) {
    const double size = geom::length(all.force);
    f.mean = f.mean + all.force;
    f.mean_resultant += size;
    f.rms += size * size;
    f.peak = std::max(f.peak, size);
    f.peak_side = std::max(f.peak_side, std::hypot(all.force.x, all.force.y));
    f.mean_torque += all.torque;
    f.peak_torque = std::max(f.peak_torque, all.torque);
    f.edge_part += all.edge_torque;
    f.engaged += all.engaged ? 1 : 0;
}

}  // namespace

double chip(const Ring& ring, const Feed& feed, double angle) {
    return feed.side * std::sin(angle) * std::sin(ring.lean) + feed.down * std::cos(ring.lean);
}

Forces forces(std::span<const Ring> rings, int teeth, const Feed& feed, const cutting::Law& law, int steps) {
    Forces f;
    if (teeth <= 0) return f;
    const int in_pitch = std::max(1, (steps + teeth - 1) / teeth);
    std::vector<Load> tooth(static_cast<std::size_t>(in_pitch) * static_cast<std::size_t>(teeth));
    const double step = 2 * pi / static_cast<double>(tooth.size());
    const std::vector<Edge> edges = edges_of(rings, feed);
    Chips chips;
    for (std::size_t i = 0; i < tooth.size(); ++i)
        tooth[i] = load_at(edges, law, (static_cast<double>(i) + 0.5) * step, chips);
    for (std::size_t i = 0; i < static_cast<std::size_t>(in_pitch); ++i) {
        Load all;
        for (std::size_t k = i; k < tooth.size(); k += static_cast<std::size_t>(in_pitch)) {
            all.force = all.force + tooth[k].force;
            all.torque += tooth[k].torque;
            all.edge_torque += tooth[k].edge_torque;
            all.engaged = all.engaged || tooth[k].engaged;
        }
        add(f, all);
    }
    const double part = 1.0 / in_pitch;
    f.mean = part * f.mean;
    f.mean_resultant *= part;
    f.rms = std::sqrt(f.rms * part);
    f.mean_torque *= part;
    f.edge_part = f.mean_torque > 0 ? f.edge_part * part / f.mean_torque : 0;
    const auto in_material = std::count_if(tooth.begin(), tooth.end(), [](const Load& l) { return l.engaged; });
    f.engaged = static_cast<double>(in_material) / static_cast<double>(tooth.size());
    f.largest_chip = chips.largest;
    f.mean_chip = chips.weight > 0 ? chips.sum / chips.weight : 0;
    return f;
}

namespace {

/// Of side sin(angle) + down over an arc, where it is above 0; side is not below 0.
double positive_part(double side, double down, const Arc& arc) {
    const auto whole = [&](double from, double to) {
        return from < to ? side * (std::cos(from) - std::cos(to)) + down * (to - from) : 0.0;
    };
    if (down >= side) return whole(arc.from, arc.to);
    if (down <= -side) return 0;
    const double begin = std::asin(std::clamp(-down / side, -1.0, 1.0)), end = pi - begin;  // above 0 between them
    double sum = 0;
    for (const double turn : {-2 * pi, 0.0, 2 * pi})
        sum += whole(std::max(arc.from, begin + turn), std::min(arc.to, end + turn));
    return sum;
}

}  // namespace

double section(std::span<const Ring> rings, const Feed& way) {
    double sum = 0;
    for (const Ring& r : rings)
        for (const Arc& arc : r.arcs)
            sum += r.length * r.radius * positive_part(way.side * std::sin(r.lean), way.down * std::cos(r.lean), arc);
    return sum;
}

std::vector<Ring> flank(double diameter, double low, double high, double helix, int rings, Arc arc) {
    std::vector<Ring> all;
    const double length = (high - low) / rings;
    for (int i = 0; i < rings; ++i) {
        const double height = low + (i + 0.5) * length;
        all.push_back({diameter / 2, pi / 2, length, height, 2 * height * std::tan(helix) / diameter, {arc}});
    }
    return all;
}

std::vector<Ring> round_edge(double ring, double radius, double low_lean, double high_lean, double helix, int rings) {
    std::vector<Ring> all;
    const double step = (high_lean - low_lean) / rings;
    for (int i = 0; i < rings; ++i) {
        const double lean = low_lean + (i + 0.5) * step, height = radius * (1 - std::cos(lean));
        // A helix of constant lead goes round by its height, whatever the radius there.
        all.push_back({ring + radius * std::sin(lean),
                       lean,
                       radius * step,
                       height,
                       height * std::tan(helix) / (ring + radius),
                       {}});
    }
    return all;
}

ClosedMeans closed_means(const cutting::Law& law, int teeth, double diameter, double depth, double feed, Arc arc) {
    const auto at = [&](double p) {
        const double c2 = std::cos(2 * p), s2 = std::sin(2 * p), c = std::cos(p), s = std::sin(p);
        const double cut = teeth * depth * feed / (8 * pi), edge = teeth * depth / (2 * pi);
        ClosedMeans m;
        m.x = cut * (law.cut.tangential * c2 - law.cut.radial * (2 * p - s2)) +
              edge * (-law.edge.tangential * s + law.edge.radial * c);
        m.y = cut * (law.cut.tangential * (2 * p - s2) + law.cut.radial * c2) -
              edge * (law.edge.tangential * c + law.edge.radial * s);
        m.axial = edge * (-law.cut.axial * feed * c + law.edge.axial * p);
        m.torque = diameter / 2 * edge * (-law.cut.tangential * feed * c + law.edge.tangential * p);
        return m;
    };
    const ClosedMeans a = at(arc.from), b = at(arc.to);
    return {b.x - a.x, b.y - a.y, b.axial - a.axial, b.torque - a.torque};
}

}  // namespace obrys::sim::force
