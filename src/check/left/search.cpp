#include "check/left/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <queue>

#include "check/left/inside.hpp"
#include "sim/milling/track.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double near_enough = 1.1;          ///< times the depth that is reached: no deeper
constexpr std::size_t few_cuts = 12;         ///< that are not sorted out further
constexpr std::size_t parts_refining = 400;  ///< cells, once something is found
constexpr double much_more = 1.3;            ///< times the depth found: what may still be there is looked for longer
constexpr double slim = 8;                   ///< times as long as wide: then it is made shorter
constexpr double longest_counts = 0.1;
constexpr std::size_t quick_cells = 300;  ///< before it is looked at from within
constexpr double much_deeper = 16;        ///< times what is asked for: so deep is known from within
constexpr double thin_share = 0.05;       ///< of what is allowed: half as thick as what is thinner is nothing

using Numbers = std::shared_ptr<const std::vector<std::uint32_t>>;

/// A part of the body: all of its discs between two heights with the tip in a parallelepiped; without a profile just
/// the parallelepiped.
struct LeftPart {
    LeftBody body;
    double bound = 0;  ///< nothing in it is deeper
    Numbers cuts;      ///< that may matter
    std::uint32_t best = 0;
    bool solid() const { return !body.profile.empty(); }
};

class PartSearch {
public:
    PartSearch(const LeftSearch& s, const LeftBody& whole);
    LeftDepth run(bool sample);

private:
    void push(LeftPart cell);
    [[nodiscard]] LeftPart made(LeftBody body, const LeftPart& parent) const;
    void sort_out(LeftPart& cell) const;
    void bound(LeftPart& cell) const;
    [[nodiscard]] double bound_by(const LeftPart& cell, std::uint32_t cut, std::span<const Disc> discs,
                                  double enough) const;
    void split(const LeftPart& cell);
    void look(const LeftPart& cell);
    void look_at(Vec3 p, const LeftPart& cell);
    [[nodiscard]] bool outside(const LeftBody& box) const;
    [[nodiscard]] bool middle_is_clear(const LeftPart& cell) const;
    [[nodiscard]] std::vector<Disc> discs_in_stock(const LeftBody& b) const;
    [[nodiscard]] double threshold() const { return std::max(s_.allowed, near_enough * best_.depth); }

    const LeftSearch& s_;
    const LeftBody& whole_;
    milling::Heights stock_;  ///< along the body's axis
    milling::Shape shape_;
    milling::Air::Sweep sweep_;
    std::optional<LeftCut> own_;  ///< what the body itself takes, where it goes straight
    struct Less {
        bool operator()(const LeftPart& a, const LeftPart& b) const { return a.bound < b.bound; }
    };
    std::priority_queue<LeftPart, std::vector<LeftPart>, Less> open_;
    LeftDepth best_;
    std::size_t cells_ = 0, found_at_ = 0;
};

PartSearch::PartSearch(const LeftSearch& s, const LeftBody& whole)
    : s_(s), whole_(whole), stock_(milling::heights_along(whole.axis, milling::box_of(s.stock))) {
    if (whole.arc || !(whole.edges[1] == Vec3{}) || !(whole.edges[2] == Vec3{})) return;
    std::vector<milling::Piece> pieces;
    for (std::size_t i = 0; i + 1 < whole.profile.size(); ++i) {
        const Vec2 low = whole.profile[i], high = whole.profile[i + 1];
        if (high.y - low.y > thin_piece) pieces.push_back(milling::cone(low.y, high.y, low.x, high.x));
    }
    if (pieces.empty()) return;
    shape_ = milling::make_shape(std::move(pieces));
    sweep_.shape = &shape_;
    sweep_.frame = milling::orientation_of(whole.axis);
    sweep_.track.v = sweep_.frame.to_tool(whole.edges[0]);
    sweep_.from = whole.corner;
    own_.emplace(sweep_, 0, shape_.pieces.size());
}

/// Whether no place of a parallelepiped lies in the body.
bool PartSearch::outside(const LeftBody& box) const {
    double half = 0;  // from its middle to its corners
    for (const double s : {-1.0, 1.0})
        for (const double u : {-1.0, 1.0})
            half = std::max(half, 0.5 * geom::length(box.edges[0] + s * box.edges[1] + u * box.edges[2]));
    return own_ && own_->farthest({middle_of(box), 0}, box.axis) > half;
}

/// Discs around what of it may lie in the stock: beyond the stock's ends nothing is left. A cut that ends where the
/// stock does would else leave cells as thin as what is allowed, all over its end. None: it lies beside the stock.
std::vector<Disc> PartSearch::discs_in_stock(const LeftBody& b) const {
    std::vector<Disc> discs = discs_of(b);
    const auto height = [&](const Disc& d) { return geom::dot(b.axis, d.centre); };
    double low = INFINITY, high = -INFINITY;
    for (const Disc& d : discs) low = std::min(low, height(d)), high = std::max(high, height(d));
    if (low >= stock_.low && high <= stock_.high) return discs;
    low = std::max(low, stock_.low), high = std::min(high, stock_.high);
    std::vector<Disc> within;
    if (!(low <= high)) return within;
    for (const Disc& d : discs)
        for (const double to : {low, high}) within.push_back({d.centre + (to - height(d)) * b.axis, d.radius});
    return within;
}

double PartSearch::bound_by(const LeftPart& cell, std::uint32_t cut, std::span<const Disc> discs, double enough) const {
    const LeftCut& c = s_.cuts[cut];
    if (cell.solid() && cell.body.arc) {
        double far = 0;
        for (const Vec2& at : cell.body.profile)
            far = std::max(
                far, c.farthest({cell.body.corner + at.y * cell.body.axis, at.x}, *cell.body.arc, cell.body.axis));
        if (far < enough) return far;
    }
    return c.farthest(discs, cell.body.axis, enough);
}

void PartSearch::bound(LeftPart& cell) const {
    const std::vector<Disc> discs = discs_of(cell.body);
    cell.bound = std::min(s_.enough, deepest_in(s_.stock, s_.air, discs, cell.body.axis, middle_of(cell.body)));
    const std::vector<Disc> within = discs_in_stock(cell.body);
    if (within.empty()) cell.bound = 0;
    const auto attempt = [&](std::uint32_t cut) {
        const double far = bound_by(cell, cut, within, cell.bound);
        if (far < cell.bound) cell.bound = far, cell.best = cut + 1;
        return cell.bound <= s_.allowed;
    };
    if (cell.bound <= s_.allowed) return;
    const std::uint32_t first = cell.best > 0 ? cell.best - 1 : s_.hint != nullptr ? *s_.hint : 0;
    if (first < s_.cuts.size() && attempt(first)) return;
    for (const std::uint32_t cut : *cell.cuts)
        if (cut != first && attempt(cut)) return;
}

/// Leaves out cuts that are too far off to matter.
void PartSearch::sort_out(LeftPart& cell) const {
    if (cell.cuts->size() <= few_cuts) return;
    mesh::Box own;
    const Vec3 a = cell.body.axis;
    for (const Disc& d : discs_of(cell.body)) {
        const auto reach = [&](double along) {
            return d.radius * std::sqrt(std::max(0.0, 1 - along * along)) + s_.enough;
        };
        const Vec3 more{reach(a.x), reach(a.y), reach(a.z)};
        own.add(d.centre - more);
        own.add(d.centre + more);
    }
    auto some = std::make_shared<std::vector<std::uint32_t>>();
    for (const std::uint32_t c : *cell.cuts) {
        const mesh::Box& b = s_.cuts[c].box();
        if (b.lo.x <= own.hi.x && b.hi.x >= own.lo.x && b.lo.y <= own.hi.y && b.hi.y >= own.lo.y &&
            b.lo.z <= own.hi.z && b.hi.z >= own.lo.z)
            some->push_back(c);
    }
    cell.cuts = std::move(some);
}

LeftPart PartSearch::made(LeftBody body, const LeftPart& parent) const {
    LeftPart cell;
    cell.body = std::move(body);
    cell.cuts = parent.cuts;
    cell.best = parent.best;
    if (!cell.solid() && outside(cell.body)) return cell;
    sort_out(cell);
    bound(cell);
    return cell;
}

void PartSearch::push(LeftPart cell) {
    ++cells_;
    if (s_.hint != nullptr && cell.best > 0) *s_.hint = cell.best - 1;
    if (cell.bound > threshold()) open_.push(std::move(cell));
}

void PartSearch::look_at(Vec3 p, const LeftPart& cell) {
    double depth = std::min(s_.enough, s_.air.outside(0, p));
    const double least = std::max(s_.allowed, best_.depth);
    const auto deeper = [&](std::uint32_t cut) {
        depth = std::min(depth, s_.cuts[cut].farthest({p, 0}, cell.body.axis));
        return depth > least;
    };
    if (!(depth > least) || (cell.best > 0 && !deeper(cell.best - 1))) return;
    for (const std::uint32_t cut : *cell.cuts)
        if (!deeper(cut)) return;
    best_.depth = depth, best_.at = p;
}

/// Places of the body in a cell: where the cut that takes most of it leaves most.
void PartSearch::look(const LeftPart& cell) {
    if (!cell.solid()) {
        const Vec3 p = middle_of(cell.body);
        const double off = own_ ? own_->farthest({p, 0}, cell.body.axis) : thin_piece;
        const Vec3 within = off > thin_piece ? p - (off + thin_piece) * own_->outwards({p, 0}) : p;
        if (own_ && own_->farthest({within, 0}, cell.body.axis) <= thin_piece) look_at(within, cell);
        return;
    }
    const LeftBody& b = cell.body;
    const Vec3 middle = b.corner + 0.5 * (b.edges[0] + b.edges[1] + b.edges[2]);
    // Beyond the stock's ends there is nothing to be found.
    const double tip = geom::dot(b.axis, middle), low = stock_.low - tip, high = stock_.high - tip;
    for (const double height : {b.profile.front().y, b.profile.back().y}) {
        const double at = std::clamp(std::clamp(height, low, high), b.profile.front().y, b.profile.back().y);
        const double radius = radius_of(b, at);
        const Disc disc{middle + at * b.axis, radius};
        look_at(disc.centre, cell);
        if (cell.best == 0 || radius == 0) continue;
        const Vec3 out = s_.cuts[cell.best - 1].outwards(disc);
        look_at(disc.centre + radius * out, cell);
        look_at(disc.centre - radius * out, cell);
    }
}

/// Whether one cut alone has taken the disc in the middle: then it took those beside it, too, as far as it went.
bool PartSearch::middle_is_clear(const LeftPart& cell) const {
    const Disc disc{middle_of(cell.body), widest(cell.body)};
    const double most = threshold(), height = geom::dot(cell.body.axis, disc.centre);
    if (height - most > stock_.high || height + most < stock_.low) return true;  // beside the stock
    return std::any_of(cell.cuts->begin(), cell.cuts->end(),
                       [&](std::uint32_t cut) { return s_.cuts[cut].farthest(disc, cell.body.axis) <= most; });
}

/// In two so that a half is done with; else so that it becomes less deep or shorter; discs as boxes where neither half
/// is.
void PartSearch::split(const LeftPart& cell) {
    const std::vector<std::array<LeftBody, 2>> choices = halves_of(cell.body);
    const auto length_of = [](const std::array<LeftBody, 2>& two) {
        return geom::distance(middle_of(two[0]), middle_of(two[1]));
    };
    double longest = 0, least = std::numeric_limits<double>::infinity();
    for (const auto& two : choices) longest = std::max(longest, length_of(two));
    std::optional<std::array<LeftPart, 2>> chosen;
    bool done = false;
    for (const auto& two : choices) {
        std::array<LeftPart, 2> cells{made(two[0], cell), made(two[1], cell)};
        double score = longest_counts * (1 - length_of(two) / longest);
        bool one = false;
        for (const LeftPart& half : cells) {
            if (half.bound <= threshold())
                one = true;
            else
                score += half.bound / cell.bound;
        }
        if (!one && length_of(two) * slim < longest) score += 1;
        if (score >= least) continue;
        least = score;
        chosen = std::move(cells);
        done = one;
    }
    if (cell.solid() && own_ && !done && longest <= 2 * widest(cell.body) && !middle_is_clear(cell))
        return push(made(boxed(cell.body), cell));
    if (!chosen) return;
    for (LeftPart& half : *chosen) push(std::move(half));
}

LeftDepth PartSearch::run(bool sample) {
    LeftPart first;
    first.body = whole_;
    auto all = std::make_shared<std::vector<std::uint32_t>>(s_.cuts.size());
    for (std::uint32_t i = 0; i < all->size(); ++i) (*all)[i] = i;
    first.cuts = std::move(all);
    sort_out(first);
    bound(first);
    push(std::move(first));
    while (!open_.empty()) {
        if (open_.top().bound <= threshold() || best_.depth >= s_.enough / near_enough) break;
        if (best_.depth > 0 && found_at_ == 0) found_at_ = cells_;
        const bool far_apart = open_.top().bound > much_more * best_.depth;
        const std::size_t refining = far_apart ? 20 * parts_refining : parts_refining;
        if (cells_ >= s_.most_cells || (found_at_ > 0 && cells_ >= found_at_ + refining)) {
            best_.decided = best_.depth > 0;
            best_.bound = open_.top().bound;
            return best_;
        }
        const LeftPart cell = open_.top();
        open_.pop();
        if (sample) look(cell);
        if (cell.bound > threshold()) split(cell);
    }
    best_.decided = true;
    return best_;
}

}  // namespace

LeftDepth deepest_left(const LeftBody& body, const LeftSearch& search) {
    const bool straight = !body.arc && body.edges[1] == Vec3{} && body.edges[2] == Vec3{};
    if (search.planes == nullptr || !straight) return PartSearch(search, body).run(true);
    LeftSearch quick = search;
    quick.most_cells = std::min(search.most_cells, quick_cells);
    LeftDepth d = PartSearch(quick, body).run(true);
    if (d.decided && d.depth == 0 && !search.met) return d;
    const LeftDepth in =
        deepest_inside(body, {search.stock, *search.planes, search.air, search.cuts, search.allowed,
                              much_deeper * search.enough, thin_share * search.allowed, search.most_inside});
    if (!in.decided && in.depth == 0 && !(d.decided && d.depth > 0)) {
        d = PartSearch(search, body).run(true);
        if (d.depth == 0 && search.met) d.decided = false, d.bound = search.enough;
        return d;
    }
    // One is how deep the body lies in what is left, the other how deep that lies in the body.
    LeftDepth deepest = in.depth > d.depth || d.depth == 0 ? in : d;
    deepest.decided = in.decided || deepest.depth > 0;
    return deepest;
}

bool surely_clear(const LeftBody& body, const LeftSearch& search) {
    return PartSearch(search, body).run(false).decided;
}

}  // namespace obrys::check
