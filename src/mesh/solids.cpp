#include "mesh/solids.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "base/codes.hpp"
#include "mesh/surface_remarks.hpp"
#include "mesh/topology.hpp"
#include "mesh/weld.hpp"

namespace obrys::mesh {

namespace {

/// Two bodies whose boxes meet; in order of their lower x, so that far ones are not compared.
std::optional<std::pair<std::size_t, std::size_t>> meeting(const std::vector<Mesh>& bodies) {
    std::vector<Box> boxes;
    for (const Mesh& m : bodies) boxes.push_back(bounds(m));
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return boxes[a].lo.x < boxes[b].lo.x; });
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size() && boxes[order[k]].lo.x <= boxes[order[i]].hi.x; ++k)
            if (overlap(boxes[order[i]], boxes[order[k]])) return std::minmax(order[i], order[k]);
    return std::nullopt;
}

}  // namespace

Mesh settled(std::uint32_t file, const Mesh& soup, bool& closed, base::Diagnostics& out) {
    Welder welder;
    std::vector<std::uint32_t> vertex;
    vertex.reserve(soup.vertices.size());
    for (const geom::Vec3& v : soup.vertices) vertex.push_back(welder.add(v));
    Mesh m;
    m.triangles.reserve(soup.triangles.size());
    for (const Triangle& t : soup.triangles) {
        const Triangle joined{vertex[t[0]], vertex[t[1]], vertex[t[2]]};
        if (joined[0] != joined[1] && joined[1] != joined[2] && joined[2] != joined[0]) m.triangles.push_back(joined);
    }
    m.vertices = welder.take();
    const Topology t = topology(m);
    if (t.closed()) {
        if (is_inside_out(m)) turn_over(m);
    } else {
        closed = false;
        Remarks(file, out).surface(t, "sew its faces in the CAD system, and export it as a solid again");
    }
    return m;
}

Mesh united(std::uint32_t file, const std::vector<Mesh>& bodies, bool& closed, base::Diagnostics& out) {
    if (const auto pair = meeting(bodies)) {
        closed = false;
        Remarks(file, out).say(base::Severity::warning, base::codes::mesh_not_closed,
                               "the file holds " + std::to_string(bodies.size()) + " bodies, and number " +
                                   std::to_string(pair->first + 1) + " and " + std::to_string(pair->second + 1) +
                                   " may touch or overlap: inside and outside are not known there",
                               "unite them in the CAD system, or export one body");
    }
    Mesh all;
    for (const Mesh& m : bodies) append(all, m);
    return all;
}

}  // namespace obrys::mesh
