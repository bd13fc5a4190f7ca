#include "sim/milling/exact/coarse.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/whole.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

/// Of the tolerance: how far points looked at may be off, for those between them. The lattice's step leaves chords
/// 0.75.
constexpr double coarse_sampled = 0.8;

void add_cells(const Lattice& lattice, const std::array<int, 3>& node, int axis, std::vector<Place>& out) {
    const auto u = static_cast<std::size_t>(first_across(axis)), v = static_cast<std::size_t>(second_across(axis));
    for (const auto& q : Leaves::quadrants) {
        Place cell{node[0], node[1], node[2]};
        cell[u] -= q[0];
        cell[v] -= q[1];
        bool inside = true;
        for (std::size_t a = 0; a < 3; ++a) inside = inside && cell[a] >= 0 && cell[a] + 1 < lattice.count[a];
        if (inside) out.push_back(cell);
    }
}

struct End {
    double at = 0;
    std::uint32_t cut = 0;
};

}  // namespace

double to_tip(Vec3 first, Vec3 second, int axis, double apart) {
    Vec3 aside = first + second;
    set_component(aside, axis, 0);
    const double size = length(aside);
    if (!(size > 0)) return HUGE_VAL;
    aside = (1 / size) * aside;
    const double n1a = component(first, axis), n2a = component(second, axis), n1w = dot(first, aside),
                 n2w = dot(second, aside);
    const double slope = n2w * n1a - n2a * n1w;
    return slope == 0 ? HUGE_VAL : std::abs(n1a * n2a * apart / slope);
}

bool is_worth(Vec3 first, Vec3 second, int axis, double apart, double tolerance) {
    if (apart <= 0.5 * tolerance) return false;
    // Just within a blunt edge: what is lost beyond the line is little, and on its other side the edge is wide.
    return !(dot(first, second) > 0 && to_tip(first, second, axis, apart) < 0.5 * tolerance);
}

std::vector<Place> cells_with_narrow_edges(const Simulation& simulation) {
    const Dexels& dexels = simulation.dexels();
    const Lattice& l = dexels.lattice();
    std::vector<Place> all;
    for (int axis = 0; axis < 3; ++axis) {
        const auto u = static_cast<std::size_t>(first_across(axis)), v = static_cast<std::size_t>(second_across(axis)),
                   own = static_cast<std::size_t>(axis);
        const double origin = component(l.origin, axis), step = component(l.step, axis);
        std::vector<std::vector<Place>> found(static_cast<std::size_t>(dexels.rays_b(axis)));
        const auto look = [&](int a, int b) {
            End last{NAN, 0};
            double last_edge = NAN;
            for (const Interval& m : dexels.ray(axis, a, b))
                for (const End end : {End{m.begin, m.begin_cut}, End{m.end, m.end_cut}}) {
                    const double edge = std::floor((end.at - origin) / step);
                    const auto whole = base::whole<int>(edge, 0);
                    if (edge == last_edge && whole && edge + 1 < l.count[own]) {
                        std::array<int, 3> node{};
                        node[u] = a, node[v] = b, node[own] = *whole;
                        Vec3 p = l.node(node[0], node[1], node[2]), q = p;
                        set_component(p, axis, last.at);
                        set_component(q, axis, end.at);
                        if (is_worth(simulation.normal_at(last.cut, p), simulation.normal_at(end.cut, q), axis,
                                     end.at - last.at, simulation.tolerance()))
                            add_cells(l, node, axis, found[static_cast<std::size_t>(b)]);
                    }
                    last = end, last_edge = edge;
                }
        };
        base::for_all(found.size(), [&](std::size_t b) {
            for (int a = 0; a < dexels.rays_a(axis); ++a) look(a, static_cast<int>(b));
        });
        for (const std::vector<Place>& some : found) all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

std::vector<Place> cells_with_points(const Simulation& simulation, Exact& exact) {
    const Lattice& l = exact.lattice();
    const double tolerance = simulation.tolerance();
    const double apart = 0.5 * std::min({l.step.x, l.step.y, l.step.z});
    std::vector<Place> cells;
    std::vector<std::vector<Vec3>> points;
    KeyMap number;
    const auto add = [&](Vec3 p) {
        const std::optional<Place> cell = cell_at(l, p);
        if (!cell) return;
        const std::uint32_t n = number.add(key_of(*cell), static_cast<std::uint32_t>(cells.size()));
        if (n == cells.size()) {
            cells.push_back(*cell);
            points.emplace_back();
        }
        points[n].push_back(p);
    };
    const auto along = [&](const Air::Sweep& s, double height) {
        const double way = length(s.track.v);
        const double count = std::ceil(way / apart);
        for (double i = 0; i <= count; ++i)
            add(s.from + s.frame.to_stock(point_on(s.track, i / count) + Vec3{0, 0, height}));
    };
    for (const Simulation::Whole& whole : exact.wholes()) {
        const Piece& end = simulation.cutting_of(whole.first)->pieces.front();
        if (end.kind == PieceKind::cone && end.r0 < tolerance && end.r1 > end.r0 && end.z1 > end.z0)
            along(simulation.body_of(whole), end.z0);
    }
    exact.prepare(cells);
    std::vector<std::uint8_t> found(cells.size());
    base::for_all(cells.size(), [&](std::size_t n) {
        const Exact::Near near = exact.near(cells[n], false);
        found[n] = std::any_of(points[n].begin(), points[n].end(),
                               [&](Vec3 p) { return exact.is_on_surface(near, p, 0.5 * tolerance); })
                       ? 1
                       : 0;
    });
    std::vector<Place> all;
    for (std::size_t n = 0; n < cells.size(); ++n)
        if (found[n] != 0) all.push_back(cells[n]);
    return all;
}

std::vector<Place> cells_off(const mesh::Mesh& mesh, const std::vector<CoarseQuad>& quads, Exact& exact,
                             double tolerance) {
    const Lattice& lattice = exact.lattice();
    // Quads of one cell after the other.
    std::vector<Place> cells;
    std::vector<std::vector<std::uint32_t>> of_cell;
    KeyMap number;
    for (std::uint32_t q = 0; q < quads.size(); ++q) {
        const Place cell{quads[q].node[0], quads[q].node[1], quads[q].node[2]};
        const std::uint32_t n = number.add(key_of(cell), static_cast<std::uint32_t>(cells.size()));
        if (n == cells.size()) {
            cells.push_back(cell);
            of_cell.emplace_back();
        }
        of_cell[n].push_back(q);
    }
    exact.prepare(cells);
    std::vector<std::vector<Place>> found(cells.size());
    base::for_all(cells.size(), [&](std::size_t n) {
        const auto triangle_off = [&](const Exact::Near& here, const mesh::Triangle& t) {
            const auto off = [&](Vec3 p) { return !exact.is_on_surface(here, p, coarse_sampled * tolerance); };
            const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
            return off(a) || off(b) || off(c) || off((1.0 / 3) * (a + b + c)) || off(0.5 * (a + b)) ||
                   off(0.5 * (b + c)) || off(0.5 * (c + a)) ||
                   !exact.is_beside_material(here, {a, b, c}, beside_share * tolerance, most_beside_parts);
        };
        for (const std::uint32_t q : of_cell[n]) {
            const mesh::Triangle &one = mesh.triangles[quads[q].triangle], &two = mesh.triangles[quads[q].triangle + 1];
            const Vec3 centre = 0.5 * (mesh.vertices[one[1]] + mesh.vertices[one[2]]);
            double radius = 0;
            for (const mesh::Triangle* t : {&one, &two})
                for (const std::uint32_t v : *t) radius = std::max(radius, geom::distance(centre, mesh.vertices[v]));
            const std::optional<Exact::Near> here = exact.about(cells[n], centre, radius + tolerance);
            if (!here || triangle_off(*here, one) || triangle_off(*here, two))
                add_cells(lattice, quads[q].node, quads[q].axis, found[n]);
        }
    });
    std::vector<Place> all;
    for (const std::vector<Place>& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace obrys::sim::milling
