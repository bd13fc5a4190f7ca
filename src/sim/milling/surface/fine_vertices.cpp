// The vertices of leaves, and which of them are found again.

#include <algorithm>
#include <cmath>

#include "sim/milling/nearest.hpp"
#include "sim/milling/surface/fine.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double sharp_cosine = 0.5;  ///< cosine between normals from which on a vertex is looked for beyond its leaf
constexpr double like = 0.85;         ///< cosine between normals of one face of a body
constexpr double leaves_beyond = 4;   ///< how far beyond, in leaves: the tip of an edge of 15 degrees
constexpr double exactly = 0.125;     ///< of the tolerance

Vec3 normal_of(const Crossing& c) { return {c.normal[0], c.normal[1], c.normal[2]}; }

Vec3 onto_edge(Vec3 p, const Crossing& c, int axis, Vec3 lo, Vec3 hi) {
    set_component(p, axis, std::clamp(c.at, component(lo, axis), component(hi, axis)));
    return p;
}

}  // namespace

PlaneFit Fine::planes_of(const Piece& piece) const {
    const std::int32_t s = piece.leaf.size;
    const Place& at = piece.leaf.at;
    const Vec3 lo = leaves_.node(at), hi = leaves_.node({at[0] + s, at[1] + s, at[2] + s});
    PlaneFit fit;
    for (std::size_t i = piece.first; i < piece.last; ++i) {
        if (i > piece.first && piece.slots[i] / 4 == piece.slots[i - 1] / 4) continue;
        const Edge& e = edges_[piece.slots[i] / 4];
        const Vec3 p = point_of(e), within = onto_edge(p, e.crossing, e.edge.axis, lo, hi), n = normal_of(e.crossing);
        if (n == Vec3{})
            fit.add(within);
        else
            fit.add(p, within, n);
    }
    return fit;
}

/// The planes of the same faces where these are nearest to a point: faces are curved.
PlaneFit Fine::planes_at(const Piece& piece, Vec3 p) const {
    PlaneFit fit;
    for (std::size_t i = piece.first; i < piece.last; ++i) {
        if (i > piece.first && piece.slots[i] / 4 == piece.slots[i - 1] / 4) continue;
        const Edge& e = edges_[piece.slots[i] / 4];
        const Vec3 n = normal_of(e.crossing);
        if (n == Vec3{}) continue;
        Vec3 on = point_of(e), normal = n;
        if (e.crossing.cut != 0) {
            const Air::Sweep s = exact_.body(e.crossing.cut);
            const Foot foot = foot_on(*s.shape, s.track, s.frame.to_tool(p - s.from));
            const double size = length(foot.gradient);
            const Vec3 there = size > 0 ? (-1 / size) * s.frame.to_stock(foot.gradient) : n;
            if (dot(there, n) > like) on = p + (foot.outside / size) * there, normal = there;
        }
        fit.add(on, p, normal);
    }
    return fit;
}

/// The tip of a sharp edge may lie far beyond the leaf that holds its two faces, where no node tells of it. The point
/// that their planes meet in is taken where the exact surface is there, too.
Vec3 Fine::vertex_of(const Piece& piece, NearCell& near) const {
    const std::int32_t s = piece.leaf.size;
    const Place& at = piece.leaf.at;
    const Vec3 lo = leaves_.node(at), hi = leaves_.node({at[0] + s, at[1] + s, at[2] + s});
    const PlaneFit fit = planes_of(piece);
    const Vec3 held = fit.vertex(lo, hi);
    if (fit.sharpest() > sharp_cosine) return held;
    const Vec3 more{std::min(leaves_beyond * (hi.x - lo.x), lattice_.step.x),
                    std::min(leaves_beyond * (hi.y - lo.y), lattice_.step.y),
                    std::min(leaves_beyond * (hi.z - lo.z), lattice_.step.z)};
    Vec3 wide = fit.vertex(lo - more, hi + more);
    for (int i = 0; i < 3; ++i) wide = planes_at(piece, wide).vertex(lo - more, hi + more);
    if (planes_at(piece, wide).miss(wide) > exactly * tolerance_) return held;
    const Place cell = leaves_.cell_of(at);
    if (!exact_.reaches(cell, wide)) return held;
    if (near.cell != cell) near.cell = cell, near.near = exact_.near(cell, false);
    return exact_.is_on_surface(near.near, wide, exactly * tolerance_) ? wide : held;
}

void Fine::find_surface(const std::vector<Place>& cells) {
    find_edges(cells);
    join();
    place_vertices();
}

namespace {

/// Cells and those about them.
std::vector<Place> grown(const std::vector<Place>& cells) {
    std::vector<Place> all;
    KeyMap known;
    for (const Place& c : cells)
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const Place p{c[0] + dx, c[1] + dy, c[2] + dz};
                    const std::size_t before = known.size();
                    if (p[0] < 0 || p[1] < 0 || p[2] < 0) continue;
                    known.add(key_of(p), 1);
                    if (known.size() > before) all.push_back(p);
                }
    return all;
}

}  // namespace

/// What halving goes on from: it runs along edges of the part cell by cell, and to find all of the surface each time
/// would cost the square of their length. Edges are tested that have a leaf in a cell beside the halved ones; their
/// vertices lie one cell farther, and what these are made of one more: found in the same order as in all cells, so that
/// they are the same.
void Fine::find_changed() {
    constexpr std::size_t most_of_them = 8;  // so many times as many cells: then most are about them
    placed_ = {};
    changed_ = all_;
    if (most_of_them * dirty_.size() >= all_.size()) return;
    const std::vector<Place> asked = grown(grown(dirty_));
    for (const Place& c : asked) placed_.add(key_of(c), 1);
    KeyMap about;
    for (const Place& c : grown(asked)) about.add(key_of(c), 1);
    std::erase_if(changed_, [&](const Place& c) { return about.find(key_of(c)) == KeyMap::none; });
}

}  // namespace obrys::sim::milling
