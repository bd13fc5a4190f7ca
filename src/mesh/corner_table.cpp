#include "mesh/corner_table.hpp"

#include <algorithm>

namespace obrys::mesh {

CornerTable::CornerTable(const Mesh& m)
    : vertex_(3 * m.triangles.size()), opposite_(vertex_.size(), none), at_(m.vertices.size(), none) {
    std::vector<std::uint32_t> start(m.vertices.size() + 1, 0);
    for (std::uint32_t c = 0; c < vertex_.size(); ++c) {
        const std::uint32_t v = m.triangles[c / 3][c % 3];
        vertex_[c] = v;
        at_[v] = std::min(at_[v], c);
        ++start[v + 1];
    }
    for (std::size_t v = 0; v + 1 < start.size(); ++v) start[v + 1] += start[v];
    // The corners at each vertex; the edge that leaves it there, to the next corner, faces the corner before.
    std::vector<std::uint32_t> corners(vertex_.size()), end(start.begin(), start.end() - 1);
    for (std::uint32_t c = 0; c < vertex_.size(); ++c) corners[end[vertex_[c]]++] = c;
    const auto leaving = [&](std::uint32_t from, std::uint32_t to, std::uint32_t& found) {
        int count = 0;
        for (std::uint32_t i = start[from]; i < start[from + 1]; ++i)
            if (vertex_[next(corners[i])] == to) found = corners[i], ++count;
        return count;
    };
    for (std::uint32_t c = 0; c < vertex_.size(); ++c) {
        const std::uint32_t from = vertex_[c], to = vertex_[next(c)];
        std::uint32_t back = none, same = none;
        if (from < to && leaving(to, from, back) == 1 && leaving(from, to, same) == 1) glue(before(c), before(back));
    }
    whole_.assign(m.vertices.size(), 1);
    std::vector<std::uint32_t> ring_of;
    for (std::uint32_t v = 0; v < whole_.size(); ++v) {
        ring(v, ring_of);
        whole_[v] = ring_of.size() == start[v + 1] - start[v];
    }
}

void CornerTable::glue(std::uint32_t one, std::uint32_t other) {
    opposite_[one] = other;
    opposite_[other] = one;
}

void CornerTable::ring(std::uint32_t vertex, std::vector<std::uint32_t>& corners) const {
    corners.clear();
    const std::uint32_t first = at_[vertex];
    if (first == none || whole_[vertex] == 0) return;
    for (std::uint32_t c = first;;) {
        corners.push_back(c);
        const std::uint32_t beyond = opposite_[next(c)];
        if (beyond == none || corners.size() > vertex_.size()) {
            corners.clear();
            return;
        }
        c = next(beyond);
        if (c == first) return;
    }
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
    for (const std::uint32_t c : {behind, ahead})
        for (const std::uint32_t corner : {c, next(c), before(c)}) vertex_[corner] = none;
}

}  // namespace obrys::mesh
