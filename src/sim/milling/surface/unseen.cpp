#include "sim/milling/surface/unseen.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/parallel.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double blunt = 0.9;  ///< cosine between two faces' directions from which on planes alone tell of an edge
constexpr std::size_t most_faces = 20, most_pairs = 60;  ///< that are looked at in a cell

/// Edges and corners near one cell, or some together.
class CellEdges {
public:
    CellEdges(const Exact& exact, const Place& low, const Place& cell, std::int32_t together, double allowed)
        : exact_(exact), allowed_(allowed) {
        const Lattice& l = exact.lattice();
        middle_ = l.node(low[0], low[1], low[2]) + (0.5 * together) * l.step;
        step_ = std::min({l.step.x, l.step.y, l.step.z});
        steps_ = together;
        const double reach = 0.5 * together * length(l.step) + 0.5 * step_;
        reach_ = 0.99 * reach;
        near_ = exact.near(cell, middle_, reach, false);
        for (std::size_t body = near_.stock ? 0 : 1; body < Exact::bodies(near_); ++body) {
            const Exact::Side side = exact.side(near_, body, middle_);
            if (side.outside < -reach) {
                faces_.clear();  // the cell lies in it
                return;
            }
            if (side.outside < reach) faces_.push_back({body, side});
        }
        std::sort(faces_.begin(), faces_.end(),
                  [](const Face& a, const Face& b) { return std::abs(a.side.outside) < std::abs(b.side.outside); });
        if (faces_.size() > most_faces) faces_.resize(most_faces);
    }

    void find(std::vector<Vec3>& out) {
        if (near_.sweeps.empty()) return;
        std::size_t pairs = 0;
        for (std::size_t i = 1; i < faces_.size(); ++i)
            for (std::size_t k = 0; k < i && pairs < most_pairs; ++k) {
                if (dot(faces_[i].side.in, faces_[k].side.in) > blunt) continue;
                ++pairs;
                edge(i, k, out);
            }
    }

private:
    struct Face {
        std::size_t body = 0;
        Exact::Side side;
    };

    void edge(std::size_t i, std::size_t k, std::vector<Vec3>& out) {
        const std::array<std::size_t, 2> two{faces_[i].body, faces_[k].body};
        Vec3 p = middle_;
        if (!exact_.meet(near_, two, p) || !is_here(p) || was_tried(p)) return;
        const Exact::Side one = exact_.side(near_, two[0], p), other = exact_.side(near_, two[1], p);
        if (!is_edge(two, p, one.in, other.in)) return;
        if (!is_bare(p)) {
            // Another body ends the edge not far from here, or takes all of it.
            if (over_ < step_) corner({two[0], two[1], last_}, p, out);
            return;
        }
        out.push_back(p);
        const Vec3 along = cross(one.in, other.in);
        const double size = length(along);
        for (const double share : {-0.6, -0.4, -0.2, 0.2, 0.4, 0.6})
            if (Vec3 q = p + (share * steps_ * step_ / size) * along; size > 0 && exact_.meet(near_, two, q)) {
                if (!is_here(q)) continue;
                if (is_bare(q))
                    out.push_back(q);
                else if (over_ < step_)
                    corner({two[0], two[1], last_}, q, out);
            }
    }

    void corner(const std::array<std::size_t, 3>& three, Vec3 p, std::vector<Vec3>& out) {
        if (three[2] == three[0] || three[2] == three[1] || !exact_.meet(near_, three, p)) return;
        if (is_here(p) && is_bare(p)) out.push_back(p);
    }

    /// Both bodies end there, none of them in the other's face: a little beside the edge each alone takes the material.
    [[nodiscard]] bool is_edge(const std::array<std::size_t, 2>& two, Vec3 p, Vec3 one, Vec3 other) const {
        const Vec3 aside = (0.02 * step_) * (one - other);
        return exact_.side(near_, two[0], p - aside).outside < 0 && exact_.side(near_, two[1], p + aside).outside < 0;
    }

    [[nodiscard]] bool was_tried(Vec3 p) {
        for (const Vec3& t : tried_)
            if (geom::distance(t, p) < 0.02 * step_) return true;
        tried_.push_back(p);
        return false;
    }

    /// No body reaches over a place; the one that does is asked first the next time.
    [[nodiscard]] bool is_bare(Vec3 p) {
        over_ = -exact_.side(near_, last_, p).outside;
        if (over_ > allowed_) return false;
        for (std::size_t body = near_.stock ? 0 : 1; body < Exact::bodies(near_); ++body) {
            const double over = -exact_.side(near_, body, p).outside;
            if (over <= allowed_) continue;
            last_ = body, over_ = over;
            return false;
        }
        // At a feather edge a body that reaches over it a little has taken it back by many times that.
        return exact_.is_on_surface(near_, p, allowed_) && !exact_.is_touch(near_, p, allowed_);
    }

    [[nodiscard]] bool is_here(Vec3 p) const { return geom::distance(p, middle_) < reach_; }

    const Exact& exact_;
    Exact::Near near_;
    double allowed_ = 0, step_ = 0, steps_ = 1, reach_ = 0;
    Vec3 middle_;
    std::vector<Face> faces_;
    std::vector<Vec3> tried_;
    std::size_t last_ = 1;  ///< the body that was found over a place last, and how far
    double over_ = 0;
};

}  // namespace

std::vector<Place> mixed_cells(const NodeBits& nodes) {
    std::vector<Place> all;
    for (std::size_t row = 0; row < nodes.rows(); ++row)
        for (std::size_t w = 0; w < nodes.words(); ++w)
            for (std::uint64_t mask = nodes.mixed(row, w); mask != 0; mask &= mask - 1)
                all.push_back({static_cast<std::int32_t>(64 * w) + std::countr_zero(mask), nodes.j(row), nodes.k(row)});
    return all;
}

std::vector<Vec3> edges_in(const std::vector<Place>& cells, Exact& exact, double tolerance, std::int32_t together) {
    static_assert(Exact::block % 4 == 0);
    exact.prepare(cells);
    struct Some {
        Place low, cell;
    };
    std::vector<Some> groups;
    KeyMap known;
    for (const Place& c : cells) {
        const Place low{c[0] - c[0] % together, c[1] - c[1] % together, c[2] - c[2] % together};
        const std::size_t before = known.size();
        known.add(key_of(low), 1);
        if (known.size() > before) groups.push_back({low, c});
    }
    std::vector<std::vector<Vec3>> found(groups.size());
    base::in_pieces(groups.size(), 16, [&](const base::Piece& some) {
        for (std::size_t n = some.begin(); n < some.end(); ++n)
            CellEdges(exact, groups[n].low, groups[n].cell, together, bare_share * tolerance).find(found[n]);
    });
    std::vector<Vec3> all;
    for (const std::vector<Vec3>& f : found) all.insert(all.end(), f.begin(), f.end());
    return all;
}

}  // namespace obrys::sim::milling
