#include "mesh/corner_table.hpp"

#include <algorithm>
#include <array>

namespace obrys::mesh {

CornerTable::CornerTable(const Mesh& m)
    : vertex_(3 * m.triangles.size()),
      opposite_(vertex_.size(), none),
      at_(m.vertices.size(), none),
      count_(m.vertices.size(), 0) {
    for (std::uint32_t c = 0; c < vertex_.size(); ++c) {
        const std::uint32_t v = m.triangles[c / 3][c % 3];
        vertex_[c] = v;
        at_[v] = std::min(at_[v], c);
        ++count_[v];
    }
    join();
}

/// Joins edges to higher vertices, one vertex after the other.
void CornerTable::join() {
    std::vector<std::uint32_t> start(count_.size() + 1, 0), corners(vertex_.size());
    for (std::size_t v = 0; v < count_.size(); ++v) start[v + 1] = start[v] + count_[v];
    std::vector<std::uint32_t> end(start.begin(), start.end() - 1);
    for (std::uint32_t c = 0; c < vertex_.size(); ++c) corners[end[vertex_[c]]++] = c;
    /// The corners that face the edges of a triangle each way, to and from a neighbour, and how many they are.
    struct Edge {
        std::uint32_t of = none;
        std::array<std::uint32_t, 2> facing{none, none}, count{0, 0};
    };
    std::vector<Edge> edges(count_.size());
    for (std::uint32_t v = 0; v < count_.size(); ++v) {
        const auto each = [&](const auto& visit) {
            for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
                const std::uint32_t to = vertex_[next(corners[i])], from = vertex_[before(corners[i])];
                if (to > v) visit(edges[to], 0, before(corners[i]));
                if (from > v) visit(edges[from], 1, next(corners[i]));
            }
        };
        each([&](Edge& edge, std::size_t way, std::uint32_t facing) {
            if (edge.of != v) edge = Edge{v, {none, none}, {0, 0}};
            edge.facing[way] = facing;
            ++edge.count[way];
        });
        each([&](const Edge& edge, std::size_t way, std::uint32_t) {
            if (way == 0 && edge.count[0] == 1 && edge.count[1] == 1) glue(edge.facing[0], edge.facing[1]);
        });
    }
}

void CornerTable::glue(std::uint32_t one, std::uint32_t other) {
    opposite_[one] = other;
    opposite_[other] = one;
}

void CornerTable::ring(std::uint32_t vertex, std::vector<std::uint32_t>& corners, std::size_t most) const {
    corners.clear();
    const std::uint32_t first = at_[vertex], count = count_[vertex];
    if (first == none || count > most) return;
    std::uint32_t c = first;
    do {
        corners.push_back(c);
        const std::uint32_t beyond = opposite_[next(c)];
        if (beyond == none || corners.size() > count) break;
        c = next(beyond);
    } while (c != first);
    if (c != first || corners.size() != count) corners.clear();
}

void CornerTable::draw(const std::vector<std::uint32_t>& ring, std::size_t k) {
    const std::uint32_t behind = ring[k], ahead = ring[k == 0 ? ring.size() - 1 : k - 1];
    const std::uint32_t gone = vertex_[behind], to = vertex_[next(behind)];
    const std::uint32_t left = vertex_[before(behind)], right = vertex_[next(ahead)];
    for (const std::uint32_t c : ring) vertex_[c] = to;
    const std::uint32_t l0 = opposite_[behind], l1 = opposite_[next(behind)];
    const std::uint32_t r0 = opposite_[ahead], r1 = opposite_[before(ahead)];
    glue(l0, l1);
    glue(r0, r1);
    // Corners of triangles that stay: beside the edges that were drawn together.
    at_[left] = vertex_[next(l0)] == left ? next(l0) : before(l0);
    at_[right] = vertex_[next(r0)] == right ? next(r0) : before(r0);
    at_[to] = vertex_[next(l0)] == left ? before(l0) : next(l0);
    at_[gone] = none;
    count_[to] += count_[gone] - 4;
    --count_[left];
    --count_[right];
    for (const std::uint32_t c : {behind, ahead})
        for (const std::uint32_t corner : {c, next(c), before(c)}) vertex_[corner] = none;
}

}  // namespace obrys::mesh
