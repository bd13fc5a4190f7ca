#include "mesh/topology.hpp"

#include <algorithm>
#include <vector>

namespace obrys::mesh {

namespace {

/// An edge as one triangle sees it.
struct Side {
    std::uint32_t low, high, triangle;
    std::uint8_t corner;  ///< of the triangle, at which the edge begins
    bool forward;         ///< the triangle runs from `low` to `high`
};

std::vector<Side> sides(const Mesh& m) {
    // Sorted by the lower vertex in one counting pass; the few of one vertex are then sorted by themselves.
    std::vector<std::uint32_t> start(m.vertices.size() + 1, 0);
    const auto each = [&](const auto& visit) {
        for (std::uint32_t i = 0; i < m.triangles.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t a = m.triangles[i][c], b = m.triangles[i][(c + 1) % 3];
                visit(Side{std::min(a, b), std::max(a, b), i, static_cast<std::uint8_t>(c), a < b});
            }
    };
    each([&](const Side& s) { ++start[s.low + 1]; });
    for (std::size_t v = 0; v + 1 < start.size(); ++v) start[v + 1] += start[v];
    std::vector<Side> all(3 * m.triangles.size());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    each([&](const Side& s) { all[next[s.low]++] = s; });
    const auto at = [&](std::uint32_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
    for (std::size_t v = 0; v + 1 < start.size(); ++v)
        std::stable_sort(at(start[v]), at(start[v + 1]), [](const Side& a, const Side& b) { return a.high < b.high; });
    return all;
}

void note(EdgeFault& fault, const Mesh& m, const Side& s) {
    if (fault.count++ > 0 && fault.triangle <= s.triangle) return;
    fault.triangle = s.triangle;
    fault.from = m.vertices[s.forward ? s.low : s.high];
    fault.to = m.vertices[s.forward ? s.high : s.low];
}

}  // namespace

Topology topology(const Mesh& m) {
    Topology t;
    const std::vector<Side> all = sides(m);
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
        while (end < all.size() && all[end].low == all[i].low && all[end].high == all[i].high) ++end;
        ++t.edges;
        if (end - i == 1) note(t.open, m, all[i]);
        if (end - i > 2 || all[i].low == all[i].high) note(t.crowded, m, all[i]);
        if (end - i == 2 && all[i].forward == all[i + 1].forward) note(t.turned, m, all[i]);
    }
    return t;
}

std::vector<std::uint32_t> neighbours(const Mesh& m) {
    std::vector<std::uint32_t> beside(3 * m.triangles.size());
    for (std::size_t i = 0; i < beside.size(); ++i) beside[i] = static_cast<std::uint32_t>(i / 3);
    const std::vector<Side> all = sides(m);
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
        while (end < all.size() && all[end].low == all[i].low && all[end].high == all[i].high) ++end;
        if (end - i != 2) continue;
        beside[3 * std::size_t{all[i].triangle} + all[i].corner] = all[i + 1].triangle;
        beside[3 * std::size_t{all[i + 1].triangle} + all[i + 1].corner] = all[i].triangle;
    }
    return beside;
}

}  // namespace obrys::mesh
