#include "check/touching/stock_guard.hpp"

#include <algorithm>
#include <cmath>

#include "check/certify_shapes.hpp"
#include "check/touching/touch.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double hidden = 4;                ///< times the rays' distance: what is deeper they see
constexpr double seen = 0.5;                ///< times that: a depth of a shank or holder that they have found
constexpr double chords = 0.1;              ///< of the tolerance: curves were cut as chords
constexpr double columns = 4;               ///< times the rays' distance: the least of emptied columns
constexpr int most_halvings = 3;            ///< of a profile that is no cylinder
constexpr std::size_t most_deep = 200;      ///< rapids deep in the stock that are searched all the same
constexpr std::size_t most_searched = 600;  ///< rapids; and as many moves of shanks and holders
constexpr std::size_t most_touching = 300;  ///< rapids that touch whose whole depth is searched for
constexpr std::size_t deepest_each = 4;     ///< of shanks and holders that touch, of each batch
constexpr std::size_t deepest_in_all = 32;  ///< of them
constexpr std::size_t most_refined = 1000;  ///< depths of clipped edges
constexpr std::size_t most_tips = 1000;     ///< rapids whose tips are looked at

}  // namespace

StockGuard::StockGuard(const milling::Stock& stock, double allowed, double apart, double tolerance, int threads)
    : stock_(mesh_of(stock, round_share * allowed)),
      apart_(apart),
      least_(std::max(allowed, chords * tolerance)),
      allowed_(allowed),
      threads_(threads),
      judge_(stock_, allowed),
      box_(milling::box_of(stock)),
      cleared_(stock, least_, columns * apart),
      search_(stock, {least_, hidden * apart, tolerance}, threads) {}

void StockGuard::add_tool(const milling::ToolShape& tool) {
    const auto made = [&](const milling::Shape& shape) {
        return stock_part_of(shape, round_share * least_, round_share * allowed_);
    };
    tools_.push_back({made(tool.cutting), made(tool.shank), made(tool.holder)});
}

void StockGuard::add(std::uint32_t number, const milling::Pass& pass) {
    if (pass.tool >= tools_.size()) return;
    const StockPart& part = tools_[pass.tool][static_cast<std::size_t>(pass.part)];
    const double size = geom::length(pass.axis);
    if (!part.profiles.empty() && size > 0)
        queued_.push_back(
            {number, pass.path, (1 / size) * pass.axis, &part, pass.tool, pass.part != milling::Part::cutting});
}

/// Whether cuts before have emptied all that the part of a tool comes through, as cylinders around its profiles.
bool StockGuard::profile_is_clear(const StockPass& q, const Upright& way, const std::vector<Vec2>& profile,
                                  int halvings) {
    Upright body = way;
    double narrowest = INFINITY;
    for (const Vec2& at : profile) {
        body.radius = std::max(body.radius, at.x);
        narrowest = std::min(narrowest, at.x);
    }
    body.bottom = profile.front().y;
    body.top = profile.back().y;
    if (cleared_.is_clear(body, q.axis)) return true;
    const double middle = 0.5 * (body.bottom + body.top);
    if (halvings == 0 || narrowest == body.radius || !(body.bottom < middle && middle < body.top)) return false;
    for (const std::vector<Vec2>& half : {clipped(profile, body.bottom, middle), clipped(profile, middle, body.top)})
        if (half.size() > 1 && !profile_is_clear(q, way, half, halvings - 1)) return false;
    return true;
}

bool StockGuard::in_emptied(const StockPass& q, const milling::Simulation& simulation) {
    cleared_.advance(simulation, q.number);
    const milling::Shape* cutting = q.body ? nullptr : &simulation.tool(q.tool).cutting;
    const std::size_t n = chords_of(q.path, round_share * least_);
    for (std::size_t i = 0; i < n; ++i) {
        Upright way;
        way.from = geom::point_at(q.path, static_cast<double>(i) / static_cast<double>(n));
        way.to = geom::point_at(q.path, static_cast<double>(i + 1) / static_cast<double>(n));
        way.shape = cutting;
        const bool clear = std::all_of(q.part->profiles.begin(), q.part->profiles.end(), [&](const auto& profile) {
            return profile_is_clear(q, way, profile, most_halvings);
        });
        if (!clear) return false;
    }
    return true;
}

/// Where a ray stands beside a point that goes into the material, on a slant it says more or less than there is.
void StockGuard::look_over_tips(const milling::Simulation& simulation) {
    std::vector<const StockPass*> looked;
    for (const StockPass& q : queued_) {
        const milling::Stacks met = simulation.stacks_of(q.number);
        if (!q.body && met.to_tip.height > met.seen.height + least_ && over_tips_.size() + looked.size() < most_tips)
            looked.push_back(&q);
    }
    if (looked.empty() || !simulation.stock_body().closed()) return;
    std::vector<TipStack> found(looked.size());
    for_all(looked.size(), threads_, [&](std::size_t i) {
        const StockPass& q = *looked[i];
        const milling::Shape& tool = simulation.tool(q.tool).cutting;
        found[i] = highest_over_tip(simulation, {q.number, q.path, q.axis, {tool.bottom, tool.top}});
    });
    for (std::size_t i = 0; i < looked.size(); ++i) over_tips_[looked[i]->number] = found[i];
}

std::optional<TipStack> StockGuard::over_tip(std::uint32_t number) const {
    const auto at = over_tips_.find(number);
    return at == over_tips_.end() ? std::nullopt : std::optional(at->second);
}

/// Leaves what is neither clear nor touches, and the deepest of those that do.
void StockGuard::sort_out(const milling::Simulation& simulation) {
    std::vector<char> clear(queued_.size());
    const auto& met = simulation.engagements();
    for (std::size_t i = 0; i < queued_.size(); ++i) {
        // What the rays see so deep they measure well enough; of rapids the first ones better.
        const bool deep = met[queued_[i].number].depth > (queued_[i].body ? seen : hidden) * apart_;
        clear[i] = deep && (queued_[i].body || deep_rapids_++ >= most_deep) ? 1 : 0;
    }
    for_all(queued_.size(), threads_, [&](std::size_t i) {
        clear[i] =
            clear[i] != 0 || judge_.is_clear({queued_[i].path, queued_[i].axis, &queued_[i].part->shape}) ? 1 : 0;
    });
    std::vector<double> depths;  // of what is left in the queue
    std::size_t kept = 0;
    for (std::size_t i = 0; i < queued_.size(); ++i) {
        const StockPass& q = queued_[i];
        if (clear[i] != 0) continue;
        // What is thinner than the columns' walls only rays meet.
        const bool emptied = in_emptied(q, simulation), met_by_rays = !q.body && met[q.number].depth > least_;
        if (emptied && !met_by_rays) continue;
        const Touched t =
            touch(cleared_, {q.path, q.axis, q.part->profiles, milling::heights_along(q.axis, box_), hidden * apart_});
        const bool touches = t.depth > least_;
        if (touches) hits_[q.number] = {t.depth, t.at};
        depths.push_back(touches ? t.depth : 0);
        if (kept != i) queued_[kept] = std::move(queued_[i]);
        ++kept;
    }
    queued_.resize(kept);
    keep_deepest(std::move(depths));
}

/// Of shanks and holders that touch, which go on rubbing where they began, the deepest few; rapids one by one.
void StockGuard::keep_deepest(std::vector<double> depths) {
    std::vector<double> deepest;
    for (std::size_t i = 0; i < queued_.size(); ++i)
        if (queued_[i].body) deepest.push_back(depths[i]);
    std::sort(deepest.begin(), deepest.end(), std::greater<>());
    const std::size_t few = std::min({deepest_each, deepest_in_all - deepest_searched_, deepest.size()});
    const double least = few == 0 ? INFINITY : std::max(deepest[few - 1], least_);
    std::size_t kept = 0, taken = 0;
    for (std::size_t i = 0; i < queued_.size(); ++i) {
        if (depths[i] > 0 && !queued_[i].body) {
            if (touching_rapids_++ >= most_touching) continue;
        } else if (depths[i] > 0) {
            if (!(depths[i] >= least) || taken == few) continue;
            ++taken;
        } else if ((queued_[i].body ? searched_bodies_ : searched_rapids_)++ >= most_searched) {
            undecided_.insert(queued_[i].number);
            continue;
        }
        if (kept != i) queued_[kept] = std::move(queued_[i]);
        ++kept;
    }
    deepest_searched_ += taken;
    queued_.resize(kept);
}

/// Beside an edge of the stock that no cut has come near, its own depth in the tool counts.
StockHit StockGuard::refined(const StockPass& q, StockHit hit, const milling::Simulation& simulation) const {
    const double most = hidden * apart_;
    const certify::Move move{q.path, q.axis, &q.part->shape};
    if (const auto about = judge_.rough(move); about && about->depth > most) return hit;
    const std::optional<certify::Depth> found = judge_.deepest(move);
    if (!found || !(found->depth > hit.depth) || !(2 * found->depth < most)) return hit;
    const certify::Depth& d = *found;
    const Vec3 around{most, most, most};
    const milling::Air air = simulation.air_in({d.at - around, d.at + around});
    const LeftCuts cuts(air, simulation, q.number);
    const bool alone = std::none_of(cuts.all().begin(), cuts.all().end(), [&](const LeftCut& c) {
        return c.farthest({d.at, 0}, q.axis) <= 2 * d.depth;
    });
    return alone ? StockHit{d.depth, d.at} : hit;
}

void StockGuard::carry_out(const milling::Simulation& simulation, const std::function<bool()>& stop) {
    look_over_tips(simulation);
    sort_out(simulation);
    // Shank and holder of one move after the other are queued in turn.
    std::stable_sort(queued_.begin(), queued_.end(),
                     [](const StockPass& a, const StockPass& b) { return std::less<>{}(a.part, b.part); });
    for (const auto& [number, verdict] : search_.search(queued_, simulation, stop)) {
        StockHit& hit = hits_[number];
        if (verdict.hit.depth > hit.depth) hit = verdict.hit;
        if (hit.depth > 0) continue;
        hits_.erase(number);
        undecided_.insert(number);
    }
    for (const StockPass& q : queued_) {
        const auto hit = hits_.find(q.number);
        if (hit == hits_.end() || refined_ >= most_refined || (stop && stop())) continue;
        ++refined_;
        hit->second = refined(q, hit->second, simulation);
    }
    queued_.clear();
}

StockHit StockGuard::hit_by(std::uint32_t number) const {
    const auto at = hits_.find(number);
    return at == hits_.end() ? StockHit{} : at->second;
}

}  // namespace obrys::check
