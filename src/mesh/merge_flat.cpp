// A vertex inside a plane, or on a straight border, is drawn along an edge to one of its neighbours, where all
// triangles that hang on it keep their side. All vertices of a region lie within a third of what is allowed of its
// plane, those of a straight border within a third of a line; since vertices only vanish, errors do not add up: new and
// old surface both lie that near to the plane, and their borders to the line, so that they are at most 2 / 3 sqrt 2
// apart.

#include "mesh/merge_flat.hpp"

#include <algorithm>

#include "mesh/flat_regions.hpp"

namespace obrys::mesh {

namespace {

using geom::Vec3;
using Corner = std::uint32_t;

constexpr double good_shape =
    0.2;  ///< height to longest side (of an equilateral triangle 0.87): nothing better is looked for
constexpr std::size_t most_around = 64, most_around_target = 512;  ///< triangles at a vertex: so that time stays linear

class Merger {
public:
    Merger(const Mesh& m, double deviation)
        : m_(m),
          thinnest_(deviation),
          corners_(m),
          regions_(flat_regions(m, corners_, deviation / 3)),
          roles_(roles_of(m, corners_, regions_, deviation / 3)) {}

    Mesh run() {
        std::vector<std::uint32_t> waiting, later;
        for (std::uint32_t v = 0; v < roles_.size(); ++v)
            if (roles_[v] != Role::fixed) waiting.push_back(v);
        // In rounds in which no two neighbours vanish, so that triangles grow evenly.
        queued_.assign(roles_.size(), 0);
        marks_.assign(roles_.size(), 0);
        for (std::uint32_t round = 1; !waiting.empty(); ++round) {
            later.clear();
            for (const std::uint32_t v : waiting) {
                if (corners_.at(v) == CornerTable::none || queued_[v] == round) continue;
                if (vanish(v)) wake(round, later);
            }
            std::swap(waiting, later);
        }
        return rest();
    }

private:
    /// Draws a vertex to the neighbour that leaves the best triangles, or good ones; false where there is none.
    bool vanish(std::uint32_t v) {
        corners_.ring(v, ring_, most_around);
        const std::size_t n = ring_.size();
        if (n < 3) return false;
        around_.clear();
        for (const Corner c : ring_) around_.push_back(corners_.vertex(CornerTable::next(c)));
        std::size_t best = n;
        double most = 0;
        for (std::size_t k = 0; k < n && most < good_shape; ++k) {
            if (roles_[v] == Role::border && region(k) == region(k == 0 ? n - 1 : k - 1)) continue;
            if (const double shape = worst_shape(k, most); shape > most) {
                // A bad link is rare: looked for last.
                if (!linked_once(k)) continue;
                most = shape;
                best = k;
            }
        }
        if (best == n) return false;
        corners_.draw(ring_, best);
        return true;
    }

    [[nodiscard]] std::uint32_t region(std::size_t k) const { return regions_.of[ring_[k] / 3]; }

    /// Of the triangles that drawing to neighbour k makes: the smallest ratio of height to longest side; 0 where one is
    /// turned over or too thin. Not above `enough` where it is not worth more.
    [[nodiscard]] double worst_shape(std::size_t k, double enough) const {
        const std::size_t n = ring_.size();
        const Vec3 to = m_.vertices[around_[k]];
        double worst = 1;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k || i + 1 == k || (k == 0 && i + 1 == n)) continue;
            const Vec3 a = m_.vertices[around_[i]] - to, b = m_.vertices[around_[i + 1 == n ? 0 : i + 1]] - to;
            const double twice = dot(cross(a, b), regions_.normal[region(i)]);
            const Vec3 across = b - a;
            const double longest = std::max({dot(a, a), dot(b, b), dot(across, across)});
            if (!(twice > 0 && twice * twice > thinnest_ * thinnest_ * longest)) return 0;
            worst = std::min(worst, twice / longest);
            if (worst <= enough) return worst;
        }
        return worst;
    }

    /// The neighbours that v and neighbour k share are the two of their common triangles: nothing folds up.
    bool linked_once(std::size_t k) {
        const std::size_t n = ring_.size();
        corners_.ring(around_[k], far_, most_around_target);
        if (far_.size() < 3) return false;
        ++looks_;
        for (const std::uint32_t w : around_) marks_[w] = looks_;
        std::size_t shared = 0;
        for (const Corner c : far_) shared += marks_[corners_.vertex(CornerTable::next(c))] == looks_ ? 1 : 0;
        return shared == 2 && n + far_.size() > 6;
    }

    /// What lay around a vertex that vanished is worth another look, next time.
    void wake(std::uint32_t round, std::vector<std::uint32_t>& later) {
        for (const std::uint32_t w : around_) {
            if (queued_[w] == round || roles_[w] == Role::fixed) continue;
            queued_[w] = round;
            later.push_back(w);
        }
    }

    [[nodiscard]] Mesh rest() const {
        Mesh out;
        std::vector<std::uint32_t> number(m_.vertices.size(), CornerTable::none);
        for (std::uint32_t t = 0; t < m_.triangles.size(); ++t) {
            if (!corners_.alive(t)) continue;
            Triangle corners{};
            for (std::uint32_t c = 0; c < 3; ++c) {
                std::uint32_t& v = number[corners_.vertex(3 * t + c)];
                if (v == CornerTable::none) {
                    v = static_cast<std::uint32_t>(out.vertices.size());
                    out.vertices.push_back(m_.vertices[corners_.vertex(3 * t + c)]);
                }
                corners[c] = v;
            }
            out.triangles.push_back(corners);
            if (!m_.tags.empty()) out.tags.push_back(m_.tags[t]);
        }
        return out;
    }

    const Mesh& m_;
    double thinnest_;
    CornerTable corners_;
    FlatRegions regions_;
    std::vector<Role> roles_;
    std::vector<std::uint32_t> queued_;  ///< the round in which a vertex was put off
    std::vector<std::uint32_t> marks_;   ///< neighbours of the vertex looked at
    std::uint32_t looks_ = 0;
    std::vector<Corner> ring_, far_;
    std::vector<std::uint32_t> around_;
};

}  // namespace

Mesh merge_flat(const Mesh& m, double deviation) {
    if (!(deviation > 0) || m.triangles.empty()) return m;
    return Merger(m, deviation).run();
}

}  // namespace obrys::mesh
