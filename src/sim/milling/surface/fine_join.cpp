// Which crossings belong to one piece of surface within a cell, the vertices, and the triangles.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "sim/milling/surface/fine.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr std::uint32_t none = KeyMap::none;

constexpr std::uint32_t slot_of(std::size_t edge, std::size_t quadrant) {
    return static_cast<std::uint32_t>(4 * edge + quadrant);
}

/// Where a face lies that two leaves about an edge share: normal to `normal`, to one side of the edge along `aside`.
struct Side {
    int normal = 0, aside = 0;
    bool below = false;
};

/// Between quadrants `side` and `side` + 1 (Leaves::quadrants).
Side side_of(int axis, std::size_t side) {
    const int u = first_across(axis), v = second_across(axis);
    switch (side) {
        case 0: return {u, v, true};
        case 1: return {v, u, false};
        case 2: return {u, v, false};
        default: return {v, u, true};
    }
}

}  // namespace

std::uint32_t Fine::root(std::uint32_t slot) {
    while (parent_[slot] != slot) slot = parent_[slot] = parent_[parent_[slot]];
    return slot;
}

void Fine::unite(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

void Fine::join() {
    parent_.resize(4 * edges_.size());
    for (std::uint32_t s = 0; s < parent_.size(); ++s) parent_[s] = s;
    mate_.assign(parent_.size(), none);
    for (std::size_t e = 0; e < edges_.size(); ++e)
        for (std::size_t q = 0; q < 4; ++q)
            if (edges_[e].around[q] == edges_[e].around[(q + 1) % 4]) unite(slot_of(e, q), slot_of(e, (q + 1) % 4));
    Rim rim;
    for (std::size_t e = 0; e < edges_.size(); ++e)
        for (std::size_t side = 0; side < 4; ++side) join_face(e, side, rim);
}

/// Joins this crossing with the other one of its trace on a face between two leaves: around a run of nodes in material,
/// which so are kept apart from others.
void Fine::join_face(std::size_t edge, std::size_t side, Rim& own) {
    const Edge& here = edges_[edge];
    const Leaf &a = here.around[side], &b = here.around[(side + 1) % 4];
    if (a == b || mate_[slot_of(edge, side)] != none || !(is_special(a) || is_special(b))) return;
    const Leaf& small = a.size <= b.size ? a : b;
    const Side where = side_of(here.edge.axis, side);
    const auto n = static_cast<std::size_t>(where.normal), m = static_cast<std::size_t>(where.aside),
               along = static_cast<std::size_t>(here.edge.axis);
    Place low = small.at;
    low[n] = here.edge.at[n];
    // Its rim, one round: along, aside, back, back.
    std::vector<ShortEdge>&rim = own.all, &part = own.part;
    rim.clear();
    const auto add = [&](Place at, std::size_t axis, bool back) {
        part.clear();
        leaves_.pieces(at, small.size, static_cast<int>(axis), part);
        if (back) std::reverse(part.begin(), part.end());
        rim.insert(rim.end(), part.begin(), part.end());
    };
    Place far_along = low, far_aside = low;
    far_along[along] += small.size;
    far_aside[m] += small.size;
    add(low, along, false);
    const std::size_t first_back = [&] {
        add(far_along, m, false);
        return rim.size();
    }();
    add(far_aside, along, true);
    add(low, m, true);
    std::vector<Crossed>& crossed = own.crossed;
    crossed.clear();
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const std::uint32_t e = edge_of_[static_cast<std::size_t>(rim[i].axis)].find(key_of(rim[i].at));
        if (e == none || edges_[e].edge.size != rim[i].size) continue;
        crossed.push_back({e, (i < first_back) != edges_[e].leaves});
    }
    // As CellVertices::describe has it for two cells of the lattice that both join a face's two pieces.
    const bool joined = rim.size() == 4 && crossed.size() == 4 && is_joined(small, low, n);
    const auto quadrant_of = [&](std::uint32_t e, const Leaf& leaf) {
        const auto& q = edges_[e].around;
        return static_cast<std::size_t>(std::find(q.begin(), q.end(), leaf) - q.begin());
    };
    const auto side_between = [&](std::uint32_t e) {
        const auto& q = edges_[e].around;
        for (std::size_t s = 0; s < 4; ++s)
            if ((q[s] == a && q[(s + 1) % 4] == b) || (q[s] == b && q[(s + 1) % 4] == a)) return slot_of(e, s);
        return none;
    };
    for (std::size_t i = 0; i < crossed.size(); ++i) {
        if (crossed[i].enters == joined) continue;
        const std::uint32_t one = crossed[i].edge, other = crossed[(i + 1) % crossed.size()].edge;
        for (const Leaf* leaf : {&a, &b}) {
            const std::size_t q = quadrant_of(one, *leaf), r = quadrant_of(other, *leaf);
            if (q < 4 && r < 4) unite(slot_of(one, q), slot_of(other, r));
        }
        const std::uint32_t s = side_between(one), t = side_between(other);
        if (s == none || t == none) continue;
        mate_[s] = t;
        mate_[t] = s;
    }
}

/// Both cells of the lattice beside a whole face take its two pieces of surface as one.
bool Fine::is_joined(const Leaf& small, const Place& low, std::size_t normal) const {
    const std::int32_t unit = leaves_.unit();
    if (small.size != unit) return false;
    const Place cell = leaves_.cell_of(low);
    Place before = cell;
    --before[normal];
    const int face = 2 * static_cast<int>(normal);
    return doubtful_face(nodes_.corners(cell[0], cell[1], cell[2])) == face &&
           doubtful_face(nodes_.corners(before[0], before[1], before[2])) == face + 1;
}

bool Fine::is_placed(const Leaf& leaf) const {
    return placed_.size() == 0 || placed_.find(key_of(leaves_.cell_of(leaf.at))) != KeyMap::none;
}

void Fine::place_vertices() {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t s = 0; s < parent_.size(); ++s) {
        const Edge& e = edges_[s / 4];
        if (!is_special(e.around[s % 4]) || !is_placed(e.around[s % 4])) continue;
        static_cast<void>(root(s));
        slots.push_back(s);
    }
    std::stable_sort(slots.begin(), slots.end(), [&](std::uint32_t x, std::uint32_t y) { return root(x) < root(y); });
    vertex_.assign(parent_.size(), none);
    std::vector<std::size_t> first;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (i == 0 || root(slots[i]) != root(slots[i - 1])) first.push_back(i);
        vertex_[slots[i]] = static_cast<std::uint32_t>(first.size() - 1);
    }
    first.push_back(slots.size());
    vertices_.resize(first.size() - 1);
    base::in_pieces(vertices_.size(), 64, [&](const base::Piece& some) {
        NearCell near;
        for (std::size_t v = some.begin(); v < some.end(); ++v) {
            const Leaf& leaf = edges_[slots[first[v]] / 4].around[slots[first[v]] % 4];
            vertices_[v] = vertex_of({slots, first[v], first[v + 1], leaf}, near);
        }
    });
}

/// Of all vertices, those of the lattice's own cells first.
std::uint32_t Fine::vertex(std::size_t edge, std::size_t quadrant) const {
    const std::uint32_t own = vertex_[slot_of(edge, quadrant)];
    if (own != none) return static_cast<std::uint32_t>(coarse_.size()) + own;
    const Edge& e = edges_[edge];
    const Place cell = leaves_.cell_of(e.around[quadrant].at);
    return cells_.vertex(cell[0], cell[1], cell[2],
                         cell_edge(e.edge.axis, Leaves::quadrants[quadrant][0], Leaves::quadrants[quadrant][1]));
}

Vec3 Fine::position(std::uint32_t vertex) const {
    return vertex < coarse_.size() ? coarse_[vertex] : vertices_[vertex - coarse_.size()];
}

mesh::Mesh Fine::mesh() const {
    mesh::Mesh mesh;
    mesh.vertices = vertices_;
    const auto next = [&] { return static_cast<std::uint32_t>(coarse_.size() + mesh.vertices.size()); };
    // Traces that join the same two vertices get one of their own each between them: no side has four triangles.
    struct Trace {
        std::uint32_t a = 0, b = 0, slot = 0;
    };
    std::vector<Trace> traces;
    for (std::size_t e = 0; e < edges_.size(); ++e)
        for (std::size_t s = 0; s < 4; ++s) {
            const std::uint32_t slot = slot_of(e, s), mate = mate_[slot];
            if (mate == none || mate < slot) continue;
            const std::uint32_t a = vertex(e, s), b = vertex(e, (s + 1) % 4);
            traces.push_back({std::min(a, b), std::max(a, b), slot});
        }
    std::sort(traces.begin(), traces.end(), [](const Trace& x, const Trace& y) {
        return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.slot < y.slot;
    });
    KeyMap between;
    for (std::size_t i = 0; i < traces.size(); ++i) {
        const auto same = [&](std::size_t k) {
            return k < traces.size() && traces[k].a == traces[i].a && traces[k].b == traces[i].b;
        };
        if (!same(i + 1) && !(i > 0 && same(i - 1))) continue;
        between.add(traces[i].slot, next());
        between.add(mate_[traces[i].slot], next());
        mesh.vertices.push_back(0.5 * (position(traces[i].a) + position(traces[i].b)));
    }
    std::vector<std::uint32_t> ring;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        ring.clear();
        for (std::size_t q = 0; q < 4; ++q) {
            if (edges_[e].around[q] != edges_[e].around[(q + 3) % 4]) ring.push_back(vertex(e, q));
            if (const std::uint32_t m = between.find(slot_of(e, q)); m != none) ring.push_back(m);
        }
        const std::uint32_t centre = next();
        mesh.vertices.push_back(point_of(edges_[e]));
        // Seen against the axis, counter-clockwise is so for x and z; y has its neighbours the other way round.
        const bool turned = edges_[e].leaves == (edges_[e].edge.axis == 1);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::uint32_t one = ring[i], two = ring[(i + 1) % ring.size()];
            mesh.triangles.push_back({centre, turned ? two : one, turned ? one : two});
            mesh.tags.push_back(edges_[e].crossing.cut);
        }
    }
    return mesh;
}

}  // namespace obrys::sim::milling
