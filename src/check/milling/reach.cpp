/// How far parts of a tool reached into what they may not meet: stock, clamps, the finished part.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "check/milling/milling.hpp"
#include "check/milling_tool.hpp"
#include "check/touching/rapid_way.hpp"
#include "check/words.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace codes = base::codes;
namespace milling = sim::milling;

namespace {

/// The same part of a tool along the same of the move's ways, against the same thing.
bool is_alike(const QueuedPass& a, const QueuedPass& b) {
    return a.kind == b.kind && a.clamp == b.clamp && a.if_bent == b.if_bent;
}

}  // namespace

bool Milling::assumed_body(const MilledMove& move) const {
    const auto listed = out_.result().tools[move.tool - 1].listed;
    return listed && has_assumed_body(setup_.tools[*listed]);
}

const milling::Engagement& Milling::met_by(const QueuedPass& pass) const {
    return (pass.clamp == 0 ? *simulation_ : clamps_[pass.clamp - 1].simulation).engagements()[pass.pass];
}

/// As far as the material reaches into the swept part; of a way straight down into which the part's axis dips, as far
/// as it stands above the lower end. Of rapids as high as material stands above the lower side of the tool, but for its
/// rim. By geometry, too: clamps, and what of the stock lies between the rays.
Milling::Reach Milling::reach_of(const QueuedPass& pass) const {
    const Reach rays = ray_reach_of(pass);
    const auto deeper = [&](double depth, geom::Vec3 at) { return depth > rays.depth ? Reach{depth, at} : rays; };
    if (pass.clamp > 0) {
        const auto hit = clamps_[pass.clamp - 1].guard->hit_by(pass.pass);
        return hit ? deeper(hit->depth, hit->at) : rays;
    }
    if (!stock_guard_) return rays;
    const StockHit hit = stock_guard_->hit_by(pass.pass);
    return deeper(hit.depth, hit.at);
}

Milling::Reach Milling::ray_reach_of(const QueuedPass& pass) const {
    const milling::Engagement& met = met_by(pass);
    if (!met.touched) return {};
    const Reach reach{met.depth, met.deepest};
    if (pass.kind == QueuedPass::Kind::rapid_probe) {
        const milling::Simulation& in = pass.clamp == 0 ? *simulation_ : clamps_[pass.clamp - 1].simulation;
        const milling::Stacks on_rays = in.stacks_of(pass.pass);
        const std::optional<TipStack> tip =
            pass.clamp == 0 && stock_guard_ ? stock_guard_->over_tip(pass.pass) : std::nullopt;
        Reach stack{on_rays.to_tip.height, on_rays.to_tip.foot};
        if (tip)
            stack = tip->height > on_rays.seen.height ? Reach{tip->height, tip->foot}
                                                      : Reach{on_rays.seen.height, on_rays.seen.foot};
        return stack.depth > reach.depth ? stack : reach;
    }
    const geom::Vec3 step =
        (pass.clamp == 0 ? *simulation_ : clamps_[pass.clamp - 1].simulation).dexels().lattice().step;
    const double wide = std::max({step.x, step.y, step.z});
    if (!pass.down || !(met.rightmost <= wide)) return reach;
    // The rays stand beside the axis, so a point reaches lower than they say.
    const bool tip = pass.kind != QueuedPass::Kind::shank && pass.kind != QueuedPass::Kind::holder;
    const double low = tip && met.lowest - pass.low < 2 * wide ? pass.low : met.lowest;
    if (!(met.highest - low > reach.depth)) return reach;
    return {met.highest - low, reach.at + (low - geom::dot(reach.at, pass.axis)) * pass.axis};
}

/// Of all parts of a move's way in which the same part of the tool meets the same thing.
Milling::Reach Milling::deepest_reach(std::size_t queued) const {
    const QueuedPass& pass = queued_[queued];
    Reach deepest;
    for (std::size_t i = queued; i < queued_.size() && queued_[i].move == pass.move; ++i) {
        if (!is_alike(queued_[i], pass)) continue;
        const Reach reach = reach_of(queued_[i]);
        if (reach.depth > deepest.depth) deepest = reach;
    }
    return deepest;
}

namespace {

std::string_view name_of(QueuedPass::Kind kind) {
    return kind == QueuedPass::Kind::shank ? "shank" : kind == QueuedPass::Kind::holder ? "holder" : "tool";
}

}  // namespace

std::string Milling::name_of(const QueuedPass& pass, const MilledMove& move) const {
    const auto listed = move.tool > 0 ? out_.result().tools[move.tool - 1].listed : std::nullopt;
    const bool none = listed && setup_.tools[*listed].holder.empty();
    return pass.kind == QueuedPass::Kind::holder && none ? "spindle nose" : std::string(check::name_of(pass.kind));
}

/// The deepest place in the finished part, of the same ones.
std::optional<certify::Depth> Milling::deepest_in_part(std::size_t queued) const {
    const QueuedPass& pass = queued_[queued];
    std::optional<certify::Depth> deepest;
    if (!part_guard_ || pass.clamp > 0 || pass.kind == QueuedPass::Kind::rapid_probe) return deepest;
    for (std::size_t i = queued; i < queued_.size() && queued_[i].move == pass.move; ++i) {
        if (!is_alike(queued_[i], pass)) continue;
        const auto hit = part_guard_->hit_by(queued_[i].pass);
        if (hit && (!deepest || hit->depth > deepest->depth)) deepest = hit;
    }
    return deepest;
}

void Milling::judge(std::size_t queued) {
    const QueuedPass& pass = queued_[queued];
    if (pass.clamp == 0 && pass.kind == QueuedPass::Kind::cut) return judge_cut(pass, moves_[pass.move], met_by(pass));
    // Said once for a move, at the first of its parts.
    for (std::size_t i = queued; i > 0 && queued_[i - 1].move == pass.move; --i)
        if (is_alike(queued_[i - 1], pass)) return;
    if (pass.if_bent) return judge_if_bent(queued);
    const Reach reach = deepest_reach(queued);
    const std::optional<certify::Depth> in_part = deepest_in_part(queued);
    if (!(reach.depth > setup_.tolerances.rapid) && !in_part) say_undecided(queued);
    // Whether a thread that the part shows excuses it is known at the end.
    if (in_part) return entered_part_.push_back({pass, reach, *in_part});
    if (reach.depth > setup_.tolerances.rapid) judge_reach(pass, moves_[pass.move], reach, {});
}

/// Of what the move meets only where its rapid bends nobody knows whether it does.
void Milling::judge_if_bent(std::size_t queued) {
    const QueuedPass& pass = queued_[queued];
    const Reach reach = deepest_reach(queued);
    if (!(reach.depth > setup_.tolerances.rapid)) return say_undecided(queued);
    for (std::size_t i = queued; i < queued_.size() && queued_[i].move == pass.move; ++i) {
        const QueuedPass& q = queued_[i];
        const bool same_part = q.kind == pass.kind && q.clamp == pass.clamp && !q.if_bent;
        if (same_part && deepest_reach(i).depth > setup_.tolerances.rapid) return;  // it is found anyhow
        if (same_part) break;
    }
    const MilledMove& move = moves_[pass.move];
    const cl::Record record{cl::Linear{move.to, {0, 0, 1}, move.rapid}, move.where, move.stack};
    const std::string into = pass.clamp > 0 ? "the clamp " + clamps_[pass.clamp - 1].name : "the stock";
    out_.unchecked(record,
                   met_if_bent(setup_, name_of(pass, move) + " runs into " + into + ": " + mm(reach.depth) +
                                           " deep at " + point(reach.at)),
                   say_rapid_way);
}

/// What was looked for without an end is no "clear".
void Milling::say_undecided(std::size_t queued) {
    const QueuedPass& pass = queued_[queued];
    for (std::size_t i = queued; i < queued_.size() && queued_[i].move == pass.move; ++i) {
        const QueuedPass& q = queued_[i];
        if (!is_alike(q, pass)) continue;
        const std::string what = open_of(q);
        if (what.empty()) continue;
        const MilledMove& move = moves_[pass.move];
        const cl::Record record{cl::Linear{move.to, {0, 0, 1}, move.rapid}, move.where, move.stack};
        return out_.unchecked(record, "whether the " + name_of(pass, move) + " touches " + what + " was not decided",
                              "look at this move, or give the check more time ([budget] seconds)");
    }
}

/// What it is not decided of whether a pass enters it; empty: nothing.
std::string Milling::open_of(const QueuedPass& pass) const {
    if (pass.clamp > 0) {
        const Clamp& clamp = clamps_[pass.clamp - 1];
        return clamp.guard->is_open(pass.pass) ? "the clamp " + clamp.name : "";
    }
    if (stock_guard_ && stock_guard_->is_open(pass.pass)) return "what is left of the stock between the rays";
    return part_guard_ && part_guard_->is_open(pass.pass) ? "the finished part" : "";
}

void Milling::judge_entered_part(const std::vector<MilledMove>& moves) {
    for (Entered& e : entered_part_) {
        certify::Depth& d = e.part;
        if (thread_bands_.holds(d.at)) {
            d.depth = std::abs(thread_bands_.judged(d.at, -geom::distance(d.at, d.surface)));
            d.edge = false;
        }
        const bool in_part = d.depth > std::max(setup_.tolerances.gouge, setup_.milling->tolerance);
        if (in_part || e.stock.depth > setup_.tolerances.rapid)
            judge_reach(e.pass, moves[e.pass.move], e.stock, in_part ? std::optional{d} : std::nullopt);
    }
    entered_part_.clear();
}

namespace {

std::string deep_at(double depth, geom::Vec3 at) { return mm(depth) + " deep at " + point(at); }

/// What a shank or a holder runs into: the finished part by geometry, if the stock says no more.
std::string into_text(double stock, geom::Vec3 at, const std::optional<certify::Depth>& part, double same) {
    if (!part) return "the stock: " + deep_at(stock, at);
    const std::string in_part = std::string(part->edge ? "an edge of " : "") + "the finished part";
    if (stock <= part->depth + same) return in_part + ": " + deep_at(part->depth, part->at);
    return "the stock: " + deep_at(stock, at) + ", " + mm(part->depth) + " of it in " + in_part;
}

}  // namespace

void Milling::judge_reach(const QueuedPass& pass, const MilledMove& move, Reach reach,
                          const std::optional<certify::Depth>& in_part) {
    using Kind = QueuedPass::Kind;
    Finding f;
    const std::string part = name_of(pass, move);
    const std::string into = into_text(reach.depth, reach.at, in_part, setup_.milling->tolerance);
    if (in_part && in_part->depth + setup_.milling->tolerance >= reach.depth) reach = {in_part->depth, in_part->at};
    f.amounts = {{"depth_mm", reach.depth}, {"x_mm", reach.at.x}, {"y_mm", reach.at.y}, {"z_mm", reach.at.z}};
    f.place = reach.at;
    const std::string deep = deep_at(reach.depth, reach.at);
    if (pass.clamp > 0) {
        f.code = codes::clamp_collision;
        f.text = "the " + part + " runs into the clamp " + clamps_[pass.clamp - 1].name + ": " + deep;
    } else if (pass.kind == Kind::rapid_probe) {
        f.code = codes::rapid_in_stock;
        f.text = (move.rapid ? "rapid move goes through the stock: "
                             : "the tool is moved through the stock while the spindle stands: ") +
                 deep;
    } else if (pass.kind == Kind::shank && move.tool > 0 && assumed_body(move)) {
        constexpr double up = -1 + 1e-9;
        if (move.rapid && move.sinking <= up) return;  // out of the cut that has said it
        const shop::Tool& tool = setup_.tools[*out_.result().tools[move.tool - 1].listed];
        f.code = codes::edges_too_short;
        f.text = "the cutting edges are " + mm(*tool.cutting_length) + " long, the cut reaches above them, at " +
                 point(reach.at);
        f.remedy = "take a tool with longer cutting edges, or cut less deep; give the tool's shank if it is thinner";
        f.cause = tool_name(out_.result().tools[move.tool - 1]);
    } else {
        f.code = codes::holder_in_stock;
        f.cause = (move.tool > 0 ? tool_name(out_.result().tools[move.tool - 1]) + " " : "") + part;
        f.text = "the " + part + " runs into " + into;
        if (pass.kind == Kind::shank) f.remedy = "take a tool with longer cutting edges, or cut less deep";
    }
    found(move, std::move(f));
}

}  // namespace obrys::check
