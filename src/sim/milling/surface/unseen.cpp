#include "sim/milling/surface/unseen.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double blunt = 0.9;  ///< cosine between two faces' directions from which on planes alone tell of an edge
constexpr std::size_t most_faces = 20,
                      most_pairs = 60;     ///< that are looked at in a part of a cell before it is divided
constexpr std::size_t most_judged = 1200;  ///< pairs, of a part that is not divided any more
constexpr std::size_t most_parts = 200;    ///< of a group of cells
constexpr std::size_t most_more = 4000;    ///< more of them, where pairs would be left out
constexpr double smallest_part = 0.06;     ///< steps: half of one that is not divided any more
constexpr double part_margin = 0.25;       ///< of a part's size: how far around it is looked
constexpr double chords = 0.25;     ///< of that: a helix's chords reach over each other by a twentieth of the tolerance
constexpr double same_face = 0.05;  ///< of what bodies may reach over a place: hidden but for so much

/// Edges and corners near one cell, or some together: part by part where many faces are near.
class CellEdges {
public:
    CellEdges(const Exact& exact, const Place& low, const Place& cell, std::int32_t together, double allowed)
        : exact_(exact), allowed_(allowed) {
        const Lattice& l = exact.lattice();
        step_ = std::min({l.step.x, l.step.y, l.step.z});
        all_.half = (0.5 * together) * l.step;
        all_.middle = l.node(low[0], low[1], low[2]) + all_.half;
        all_.reach = length(all_.half) + 0.5 * step_;
        all_.along = together * step_;
        near_ = exact.near(cell, all_.middle, all_.reach, false);
    }

    void find(Edges& out) {
        if (near_.sweeps.empty()) return;
        convex_.assign(1, nullptr);
        for (std::size_t body = 1; body < Exact::bodies(near_); ++body) convex_.push_back(convex_part(body));
        std::vector<Face> all;
        for (std::size_t body = near_.stock ? 0 : 1; body < Exact::bodies(near_); ++body) all.push_back({body, {}});
        left_ = most_parts, more_ = most_more;
        find(all_, nullptr, all, out);
    }

private:
    struct Face {
        std::size_t body = 0;
        Exact::Side side;
    };
    struct Part {
        Vec3 middle, half;
        double reach = 0;  ///< about the middle
        double along = 0;  ///< how far edges are followed
    };

    /// `before`: of a larger part's middle, where that is not null.
    void find(const Part& part, const Vec3* larger, const std::vector<Face>& before, Edges& out) {
        std::vector<Face> faces;
        for (const Face& f : before) {
            if (larger != nullptr && is_far_off(f, part.middle - *larger, part.reach)) continue;
            const Exact::Side side = exact_.side(near_, f.body, part.middle);
            if (side.outside < -part.reach) return;  // the part lies in it
            if (side.outside < part.reach) faces.push_back({f.body, side});
        }
        std::sort(faces.begin(), faces.end(),
                  [](const Face& a, const Face& b) { return std::abs(a.side.outside) < std::abs(b.side.outside); });
        if (faces.size() > most_faces) drop_hidden(part, faces);
        const std::vector<std::array<std::size_t, 2>> pairs = pairs_of(faces, most_judged + 1);
        const bool many = pairs.size() > most_judged;
        const bool divides = (left_ > 0 || (many && more_ > 0)) && length(part.half) > smallest_part * step_;
        if (divides && !pairs.empty() && (faces.size() > most_faces || pairs.size() > most_pairs))
            return divide(part, std::move(faces), out);
        tried_.clear();
        for (std::size_t n = 0; n < std::min(pairs.size(), most_judged); ++n) edge(part, pairs[n], out.places);
        if (many) out.unjudged.push_back(part.middle);
    }

    /// Faces that may meet in an edge, the nearest first; no more than so many.
    [[nodiscard]] static std::vector<std::array<std::size_t, 2>> pairs_of(const std::vector<Face>& faces,
                                                                          std::size_t most) {
        std::vector<std::array<std::size_t, 2>> pairs;
        for (std::size_t i = 1; i < faces.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                if (dot(faces[i].side.in, faces[k].side.in) > blunt) continue;
                if (pairs.size() == most) return pairs;
                pairs.push_back({faces[i].body, faces[k].body});
            }
        return pairs;
    }

    /// So far beside a place a face is farther than so.
    [[nodiscard]] bool is_far_off(const Face& f, Vec3 beside, double reach) const {
        const double least = is_convex(f.body) ? dot(f.side.in, beside) : -length(beside);
        return f.side.outside + least >= reach;
    }

    void divide(const Part& part, std::vector<Face> faces, Edges& out) {
        // What reaches over most of it is asked first.
        std::sort(faces.begin(), faces.end(),
                  [](const Face& a, const Face& b) { return a.side.outside < b.side.outside; });
        for (unsigned c = 0; c < 8; ++c) {
            Part next;
            next.half = 0.5 * part.half;
            const Vec3& h = next.half;
            next.middle =
                part.middle + Vec3{(c & 1U) != 0 ? h.x : -h.x, (c & 2U) != 0 ? h.y : -h.y, (c & 4U) != 0 ? h.z : -h.z};
            next.reach = (1 + part_margin) * length(next.half);
            next.along = 0.5 * part.along;
            if (left_ > 0)
                --left_;
            else if (more_ > 0)
                --more_;
            find(next, &part.middle, faces, out);
        }
    }

    /// Without the faces that lie in other bodies all over a part: of a helix many chords' bodies are near, of which
    /// one or two have a face there. Bodies lie behind their tangent planes, and distances from others are convex, so
    /// corners tell. Swept on a circle they are hollow: such a body neither hides others nor is hidden.
    void drop_hidden(const Part& part, std::vector<Face>& faces) const {
        const Vec3 size = (1 + part_margin) * part.half;
        std::sort(faces.begin(), faces.end(),
                  [](const Face& a, const Face& b) { return a.side.outside < b.side.outside; });
        std::vector<Face> kept, hiding;
        std::vector<std::array<double, 8>> over;  // how far corners lie outside of those; NaN: not asked yet
        std::array<Vec3, 8> corners;
        for (std::size_t c = 0; c < 8; ++c)
            corners[c] = {(c & 1U) != 0 ? size.x : -size.x, (c & 2U) != 0 ? size.y : -size.y,
                          (c & 4U) != 0 ? size.z : -size.z};
        const auto hides = [&](std::size_t n, const Face& f) {
            for (std::size_t c = 0; c < 8; ++c) {
                if (std::isnan(over[n][c]))
                    over[n][c] =
                        exact_.outside_of(near_, hiding[n].body, *convex_[hiding[n].body], part.middle + corners[c]);
                if (over[n][c] > f.side.outside + dot(f.side.in, corners[c]) + same_face * allowed_) return false;
            }
            return true;
        };
        for (const Face& f : faces) {
            const bool convex = is_convex(f.body);
            bool hidden = false;
            for (std::size_t n = 0; convex && n < hiding.size() && !hidden; ++n) hidden = hides(n, f);
            if (hidden) continue;
            kept.push_back(f);
            if (!convex) continue;
            hiding.push_back(f);
            over.emplace_back().fill(std::numeric_limits<double>::quiet_NaN());
        }
        faces = std::move(kept);
        std::sort(faces.begin(), faces.end(),
                  [](const Face& a, const Face& b) { return std::abs(a.side.outside) < std::abs(b.side.outside); });
    }

    [[nodiscard]] bool is_convex(std::size_t body) const { return convex_[body] != nullptr; }

    /// Of a body on a straight way the only convex part that comes near: its distance is that of the body.
    [[nodiscard]] const Shape* convex_part(std::size_t body) const {
        const Air::Sweep& sweep = near_.sweeps[body - 1];
        if (sweep.track.circular) return nullptr;
        const std::vector<const Shape*>& parts = exact_.parts_of(sweep.shape);
        if (parts.size() == 1) return parts.front();
        const Shape* only = nullptr;
        for (const Shape* part : parts) {
            if (exact_.outside_of(near_, body, *part, all_.middle) >= 2 * all_.reach) continue;
            if (only != nullptr) return nullptr;
            only = part;
        }
        return only;
    }

    void edge(const Part& part, const std::array<std::size_t, 2>& two, std::vector<Vec3>& out) {
        Vec3 p = part.middle;
        if (!exact_.meet(near_, two, p) || !is_in(part, p) || was_tried(p)) return;
        const Exact::Side one = exact_.side(near_, two[0], p), other = exact_.side(near_, two[1], p);
        if (!is_edge(two, p, one.in, other.in)) return;
        if (!is_bare(p)) {
            // Another body ends the edge not far from here, or takes all of it.
            if (over_ < step_) corner(part, {two[0], two[1], last_}, p, out);
            return;
        }
        add(p, out);
        const Vec3 along = cross(one.in, other.in);
        const double size = length(along);
        for (const double share : {-0.6, -0.4, -0.2, 0.2, 0.4, 0.6})
            if (Vec3 q = p + (share * part.along / size) * along; size > 0 && exact_.meet(near_, two, q)) {
                if (!is_in(part, q)) continue;
                if (is_bare(q))
                    add(q, out);
                else if (over_ < step_)
                    corner(part, {two[0], two[1], last_}, q, out);
            }
    }

    void corner(const Part& part, const std::array<std::size_t, 3>& three, Vec3 p, std::vector<Vec3>& out) {
        if (three[2] == three[0] || three[2] == three[1] || !exact_.meet(near_, three, p)) return;
        if (is_in(part, p) && is_bare(p)) add(p, out);
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

    /// A place that `is_bare` was asked for last: where a body reaches over it a little, what is left beside it.
    void add(Vec3 p, std::vector<Vec3>& out) const {
        out.push_back(a_little_ > chords * allowed_ ? exact_.out_of_air(near_, p, allowed_) : p);
    }

    /// No body reaches over a place; the one that does is asked first the next time.
    [[nodiscard]] bool is_bare(Vec3 p) {
        over_ = a_little_ = -exact_.side(near_, last_, p).outside;
        if (over_ > allowed_) return false;
        for (std::size_t body = near_.stock ? 0 : 1; body < Exact::bodies(near_); ++body) {
            const double over = -exact_.side(near_, body, p).outside;
            a_little_ = std::max(a_little_, over);
            if (over <= allowed_) continue;
            last_ = body, over_ = over;
            return false;
        }
        // At a feather edge a body that reaches over it a little has taken it back by many times that.
        return exact_.is_on_surface(near_, p, allowed_) && !exact_.is_touch(near_, p, allowed_);
    }

    [[nodiscard]] static bool is_in(const Part& part, Vec3 p) {
        return geom::distance(p, part.middle) < 0.99 * part.reach;
    }

    const Exact& exact_;
    Exact::Near near_;
    std::vector<const Shape*> convex_;  ///< by body: none, or the only part that comes near
    double allowed_ = 0, step_ = 0;
    Part all_;
    std::size_t left_ = 0;     ///< parts that may still be looked at
    std::size_t more_ = 0;     ///< the same, where too many faces meet
    std::vector<Vec3> tried_;  ///< of this part
    std::size_t last_ = 1;     ///< the body that was found over a place last, and how far
    double over_ = 0;
    double a_little_ = 0;  ///< how far any reaches over it
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

Edges edges_in(const std::vector<Place>& cells, Exact& exact, double tolerance, std::int32_t together, bool follow) {
    static_assert(Exact::block % 4 == 0);
    struct Some {
        Place low, cell;
    };
    KeyMap known;
    std::vector<Some> groups;
    const auto add = [&](const Place& c) {
        const Place low{c[0] - c[0] % together, c[1] - c[1] % together, c[2] - c[2] % together};
        const std::size_t before = known.size();
        known.add(key_of(low), 1);
        if (known.size() > before) groups.push_back({low, c});
    };
    for (const Place& c : cells) add(c);
    Edges all;
    while (!groups.empty()) {
        std::vector<Place> asked;
        for (const Some& some : groups) asked.push_back(some.cell);
        exact.prepare(asked);
        std::vector<Edges> found(groups.size());
        base::in_pieces(groups.size(), 16, [&](const base::Piece& some) {
            for (std::size_t n = some.begin(); n < some.end(); ++n)
                CellEdges(exact, groups[n].low, groups[n].cell, together, bare_share * tolerance).find(found[n]);
        });
        groups.clear();
        for (const Edges& f : found) {
            all.places.insert(all.places.end(), f.places.begin(), f.places.end());
            all.unjudged.insert(all.unjudged.end(), f.unjudged.begin(), f.unjudged.end());
            if (!follow) continue;
            for (const Vec3& p : f.places)
                if (const auto cell = cell_at(exact.lattice(), p)) add(*cell);
        }
    }
    return all;
}

}  // namespace obrys::sim::milling
