// Branch and bound. Distances grow no faster than the way: what holds at a box's centre with some room holds in all of
// it. Near a surface that would take boxes as small as the tolerance; there two balls that nearly touch do more, one in
// the part and one in the air (or, for what may be left, both the other way round): between them is no room for more
// than is allowed. With distances d from the part and f from a body of air, both negative inside, and a point b:
// d(p) <= d(b) + |p - b|, f(p) <= f(a) + |p - a|, which are convex, so a box's corners tell what they are at most. A
// point of material outside the part has d > allowed and f > 0 for every body; one body whose sum stays below is
// enough. Gouges are the same with both signs turned, and no body may do it.

#include "check/gouge/proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace obrys::check {

namespace {

using geom::Vec3;
using sim::milling::component;
using sim::milling::set_component;

constexpr double finest_box = 1.0 / 64;       ///< half a box's diagonal, of what is allowed: smaller ones are left open
constexpr double thinnest_proved = 1e-9;      ///< mm; as in the simulation: thinner material or cuts are none
constexpr std::size_t boxes_refining = 3000;  ///< boxes to look at for the worst once one is found
constexpr double worst_known_to = 1.0 / 20;   ///< of what is allowed: how well the worst is known
constexpr std::array<double, 3> balls{24, 8, 3};  ///< radii, in half a box's diagonal

using Bodies = std::vector<std::uint32_t>;

struct ProofBox {
    Vec3 centre, half;
    double bound = 0;  ///< no point of it deviates more
    std::shared_ptr<const Bodies> bodies;
};

class ProofSearch {
public:
    explicit ProofSearch(const Claim& claim) : claim_(claim) {}

    Proof run(const sim::milling::Box3& box, std::size_t cells) {
        auto all = std::make_shared<Bodies>(claim_.air.bodies());
        for (std::uint32_t k = 0; k < all->size(); ++k) (*all)[k] = k;
        take({0.5 * (box.min + box.max), 0.5 * (box.max - box.min), 0, std::move(all)});
        bool refined = false;
        while (!cells_.empty()) {
            const ProofBox c = std::move(cells_.back());
            cells_.pop_back();
            if (found() && c.bound <= best_.deviation + worst_known_to * claim_.allowed) continue;
            if (found() && !refined) cells = std::min(cells, boxes_refining), refined = true;
            constexpr std::size_t some = 64;
            if (claim_.stop && cells % some == 0 && claim_.stop()) cells = 0;
            if (cells == 0) return found() ? best_ : Proof{};
            --cells;
            split(c);
        }
        if (!found() && !left_open_) best_.outcome = Proof::Outcome::absent;
        return best_;
    }

private:
    [[nodiscard]] bool found() const { return best_.outcome == Proof::Outcome::present; }

    /// Depth first, where more can be found: what is there is found after few cells, and what is not takes all of them
    /// in any order.
    void split(const ProofBox& c) {
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (component(c.half, k) > component(c.half, axis)) axis = k;
        ProofBox part = c;
        set_component(part.half, axis, component(c.half, axis) / 2);
        const std::size_t before = cells_.size();
        for (const double sign : {-1.0, 1.0}) {
            set_component(part.centre, axis, component(c.centre, axis) + sign * component(part.half, axis));
            take(part);
        }
        if (cells_.size() == before + 2 && cells_[before].bound > cells_[before + 1].bound)
            std::swap(cells_[before], cells_[before + 1]);
    }

    /// Puts a cell back in if it is not decided.
    void take(ProofBox c) {
        const double h = length(c.half);
        const double more = claim_.more ? claim_.more(c.centre, h) : 0;
        const double off = deviation(c.centre), allowed = claim_.allowed + more;
        if (off + h <= allowed) return;
        auto near = std::make_shared<Bodies>();
        double nearest = INFINITY;
        std::uint32_t first = 0;
        bool inside = false;
        for (const std::uint32_t k : *c.bodies) {
            const double f = claim_.air.outside(k, c.centre, h);
            if (f >= h) continue;
            near->push_back(k);
            if (f < (claim_.gouge ? -thinnest_proved : thinnest_proved) && !inside) inside = true, first = k;
            nearest = std::min(nearest, f);
        }
        if (claim_.gouge ? near->empty() : nearest <= -h) return;
        if (inside == claim_.gouge) note(c.centre, off, first);
        if (between_balls(c, h, *near, allowed)) return;
        if (h < finest_box * claim_.allowed) {
            left_open_ = true;
            return;
        }
        c.bodies = std::move(near);
        c.bound = off + h - more;
        cells_.push_back(std::move(c));
    }

    /// Into the part for gouges, out of it for material.
    [[nodiscard]] double deviation(Vec3 p) const {
        const double d = claim_.part.signed_distance(p);
        return claim_.gouge ? -d : d;
    }

    void note(Vec3 p, double off, std::uint32_t body) {
        const double beyond = off - (claim_.more ? claim_.more(p, 0) : 0);
        if (!(beyond > claim_.allowed) || beyond <= best_.deviation) return;
        best_ = {Proof::Outcome::present, p, beyond, claim_.gouge ? claim_.air.cut(body) : 0};
    }

    [[nodiscard]] bool between_balls(const ProofBox& c, double h, const Bodies& bodies, double allowed) const {
        const mesh::Nearest q = claim_.part.nearest(c.centre);
        if (!(q.distance < 3 * h)) return false;
        Vec3 out = c.centre - q.at;
        const double size = length(out);
        if (size > 1e-6 * h)
            out = (claim_.part.is_inside(c.centre, q) ? -1 / size : 1 / size) * out;
        else
            out = mesh::area_vector(claim_.part.mesh(), q.triangle);
        out = (1 / length(out)) * out;
        return std::any_of(balls.begin(), balls.end(), [&](double r) {
            return is_between(c, q.at - r * h * out, q.at + r * h * out, bodies, allowed);
        });
    }

    /// `in` is to lie in the part, `out` in the air.
    [[nodiscard]] bool is_between(const ProofBox& c, Vec3 in, Vec3 out, const Bodies& bodies, double allowed) const {
        double sum = 0;
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0}) {
                    const Vec3 p = c.centre + Vec3{x * c.half.x, y * c.half.y, z * c.half.z};
                    sum = std::max(sum, distance(p, in) + distance(p, out));
                }
        const double room = allowed - sum;  // the distances must bring so much
        const double part = claim_.gouge ? -claim_.part.signed_distance(out) : claim_.part.signed_distance(in);
        if (!(part < 0 && part <= room + distance(in, out))) return false;
        if (claim_.gouge)
            return std::all_of(bodies.begin(), bodies.end(), [&](std::uint32_t k) {
                const double f = claim_.air.outside(k, in, std::max(thinnest_proved, part - room));
                return f > 0 && part - f <= room;
            });
        return std::any_of(bodies.begin(), bodies.end(), [&](std::uint32_t k) {
            const double f = claim_.air.outside(k, out, 0);
            return f < 0 && part + f <= room;
        });
    }

    const Claim& claim_;
    std::vector<ProofBox> cells_;  ///< the last one is the next one
    Proof best_;
    bool left_open_ = false;
};

}  // namespace

Proof decide(const Claim& claim, const sim::milling::Box3& box, std::size_t cells) {
    if (!claim.air.known()) return {};
    return ProofSearch(claim).run(box, cells);
}

}  // namespace obrys::check
