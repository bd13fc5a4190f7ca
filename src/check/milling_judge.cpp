/// What passes met becomes findings; the surface is held to the part.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/milling.hpp"
#include "check/milling_tool.hpp"
#include "check/words.hpp"
#include "sim/milling/surface.hpp"

namespace obrys::check {

namespace codes = base::codes;
namespace milling = sim::milling;

namespace {

std::string place(geom::Vec3 p) {
    return "X " + base::fixed(p.x, 3) + " Y " + base::fixed(p.y, 3) + " Z " + base::fixed(p.z, 3);
}

constexpr std::size_t most_blocks = 8;  ///< that a finding names beside its own

/// What a block cut of a place.
struct BlockShare {
    const MilledMove* move = nullptr;
    double area = 0;  ///< mm2
};

/// Where the material lies, for the block at which the finding stands and so many others.
std::string extent_text(const MilledMove& at, bool cut_there, std::size_t others) {
    const std::string more =
        others == 0 ? "" : " and " + std::to_string(others) + (others == 1 ? " more block" : " more blocks");
    const std::string here = at.along ? "this contour element" : "this block";
    if (!cut_there) return "; no move has cut at that point, " + here + more + " beside it";
    return at.along || others > 0 ? (at.along ? ", along " : ", in the cuts of ") + here + more : "";
}

}  // namespace

/// Places a finding at a move that is over.
void Milling::found(const MilledMove& move, Finding f) {
    f.where = move.where;
    f.stack = out_.stacks().sites(move.stack);
    const cl::Record record{cl::Linear{move.to, {0, 0, 1}, move.rapid}, move.where, move.stack};
    f.move = move.index;
    f.from = move.from;
    f.to = move.to;
    out_.finding(record, std::move(f));
}

/// A move's way may be judged in several parts; what a part of the tool meets is said once.
bool Milling::said_already(const QueuedPass& pass) {
    if (pass.move != said_of_) said_.clear();
    said_of_ = pass.move;
    const std::pair what{pass.kind, pass.clamp};
    if (std::find(said_.begin(), said_.end(), what) != said_.end()) return true;
    said_.push_back(what);
    return false;
}

void Milling::judge_cut(const QueuedPass& pass, MilledMove& move, const milling::Engagement& met) {
    if (!met.touched) return;
    const bool first = move.volume_mm3 == 0 && move.contact_length_mm == 0;
    move.volume_mm3 += met.volume;
    if (move.tool > 0) out_.result().tools[move.tool - 1].volume_mm3 += met.volume;
    if (met.highest > met.lowest) move.axial_depth_mm = std::max(move.axial_depth_mm, met.highest - met.lowest);
    if (met.highest > met.lowest) move.reach_mm = std::max(move.reach_mm, met.highest - pass.low);
    if (met.rightmost <= met.leftmost) {
        move.rightmost_mm = std::min(move.rightmost_mm, met.rightmost);
        move.leftmost_mm = std::max(move.leftmost_mm, met.leftmost);
    }
    if (move.rapid) return;
    move.contact_length_mm += static_cast<double>(pass.length);
    if (!first) return;
    if (move.spindle == 0 && !stopped_reported_) {
        Finding f;
        f.code = codes::spindle_stopped;
        f.text = "the tool cuts while the spindle stands";
        f.remedy = "start the spindle with M3 or M4 and a speed S";
        found(move, std::move(f));
    }
    stopped_reported_ = move.spindle == 0;
    judge_use(move);
    if (!move.plunging || move.tool == 0) return;
    const auto listed = out_.result().tools[move.tool - 1].listed;
    if (!listed || shop::may_plunge(setup_.tools[*listed])) return;
    Finding f;
    f.code = codes::plunging_cut;
    f.text = "the tool plunges into the material, but it does not cut at its centre";
    f.remedy = "enter by a ramp or a helix, or drill before";
    f.amounts = {{"volume_mm3", met.volume}};
    found(move, std::move(f));
}

bool Milling::assumed_body(const MilledMove& move) const {
    const auto listed = out_.result().tools[move.tool - 1].listed;
    return listed && has_assumed_body(setup_.tools[*listed]);
}

void Milling::judge(const QueuedPass& pass, const milling::Engagement& met) {
    using Kind = QueuedPass::Kind;
    MilledMove& move = moves_[pass.move];
    if (pass.clamp == 0 && pass.kind == Kind::cut) return judge_cut(pass, move, met);
    if (!met.touched || !(met.depth > setup_.tolerances.rapid) || said_already(pass)) return;
    Finding f;
    f.amounts = {{"depth_mm", met.depth}, {"x_mm", met.deepest.x}, {"y_mm", met.deepest.y}, {"z_mm", met.deepest.z}};
    f.place = met.deepest;
    const std::string deep = mm(met.depth) + " deep at " + place(met.deepest);
    const std::string part = pass.kind == Kind::shank ? "shank" : pass.kind == Kind::holder ? "holder" : "tool";
    if (pass.clamp > 0) {
        f.code = codes::clamp_collision;
        f.text = "the " + part + " runs into the clamp " + clamps_[pass.clamp - 1].name + ": " + deep;
    } else if (pass.kind == Kind::rapid_probe) {
        f.code = codes::rapid_in_stock;
        f.text = "rapid move goes through the stock: " + deep;
    } else if (pass.kind == Kind::shank && move.tool > 0 && assumed_body(move)) {
        constexpr double up = -1 + 1e-9;
        if (move.rapid && move.sinking <= up) return;  // out of the cut that has said it
        const shop::Tool& tool = setup_.tools[*out_.result().tools[move.tool - 1].listed];
        f.code = codes::edges_too_short;
        f.text = "the cutting edges are " + mm(*tool.cutting_length) + " long, the cut reaches above them, at " +
                 place(met.deepest);
        f.remedy = "take a tool with longer cutting edges, or cut less deep; give the tool's shank if it is thinner";
        f.cause = "tool " + std::to_string(move.tool);
    } else {
        f.code = codes::holder_in_stock;
        f.cause = "tool " + std::to_string(move.tool) + " " + part;
        f.text = "the " + part + " runs into the stock: " + deep;
        if (pass.kind == Kind::shank) f.remedy = "take a tool with longer cutting edges, or cut less deep";
    }
    found(move, std::move(f));
}

void Milling::judge_place(const Milled& milled, const mesh::Place& p, bool gouge) {
    Finding f;
    f.code = gouge ? codes::gouge : codes::rest_material;
    f.severity = gouge ? base::Severity::error : base::Severity::warning;
    f.place = p.at;
    const double amount = std::abs(p.deviation);
    f.text = std::string(gouge ? "cuts into the finished part: " : "material is left on the part: ") + mm(amount) +
             (gouge ? " deep" : " high") + " at " + place(p.at) + ", over " + mm2(p.area);
    f.amounts = {{gouge ? "depth_mm" : "height_mm", amount},
                 {"area_mm2", p.area},
                 {"x_mm", p.at.x},
                 {"y_mm", p.at.y},
                 {"z_mm", p.at.z}};
    found(milled, p, std::move(f));
}

/// Places a finding at the cut where it is worst, or beside that, and names the other blocks of it, those with most of
/// its area first.
void Milling::found(const Milled& milled, const mesh::Place& p, Finding f) {
    const auto move_of = [&](std::uint32_t tag) {
        return tag > 0 && tag <= milled.moves.size() ? &milled.moves[tag - 1] : nullptr;
    };
    std::vector<BlockShare> blocks;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    for (const mesh::TagShare& s : p.shares) {
        const MilledMove* m = move_of(s.tag);
        if (m == nullptr) continue;
        const auto [at, added] = known.try_emplace({m->where.file, m->where.begin}, blocks.size());
        if (added) blocks.push_back({m, 0});
        blocks[at->second].area += s.area;
    }
    if (blocks.empty()) {
        f.text += "; no move has cut there";
        const cl::Record nothing{cl::Stop{}, nowhere, 0};
        return out_.finding(nothing, std::move(f));
    }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const BlockShare& a, const BlockShare& b) { return a.area > b.area; });
    const MilledMove* worst = move_of(p.tag);
    const MilledMove& at = worst != nullptr ? *worst : *blocks.front().move;
    std::erase_if(blocks, [&](const BlockShare& b) { return b.move->where == at.where; });
    f.text += extent_text(at, worst != nullptr, blocks.size());
    for (std::size_t i = 0; i < blocks.size() && i < most_blocks; ++i)
        f.related.push_back({blocks[i].move->where, (blocks[i].move->along ? "along this contour element, too: "
                                                                           : "in the cut of this block, too: ") +
                                                        mm2(blocks[i].area)});
    found(at, std::move(f));
}

void Milling::judge_surface(Milled& milled) {
    const MillingSetup& m = *setup_.milling;
    if (out_.result().stats.feed_moves > 0 && figures_.contact_length_mm == 0 && complete_)
        out_.unchecked("not one move met the stock: nothing was checked against it",
                       "see whether stock, part and program use the same zero point (docs/job-file.md)");
    const bool judged = m.part != nullptr && judges_part(setup_.scope);
    if (m.part == nullptr && judges_part(setup_.scope))
        out_.unchecked("no part: gouges and rest material not checked", "give the finished part in the job file");
    if (!judged && !m.surface) return;
    const auto normal = [&](std::uint32_t cut, geom::Vec3 p, int, double) { return simulation_->normal_at(cut, p); };
    milling::Surface surface = milling::extract_surface(simulation_->dexels(), normal);
    for (std::uint32_t& tag : surface.mesh.tags)
        if (tag != 0) tag = move_of_pass_[simulation_->pass_of(tag)] + 1;
    milled.surface = std::move(surface.mesh);
    milled.thin = surface.thin;
    if (!judged) return;
    mesh::CompareOptions options;
    options.gouge = std::max(setup_.tolerances.gouge, m.tolerance);
    options.excess = std::max(setup_.tolerances.rest_material, m.tolerance);
    milled.comparison = mesh::compare(milled.surface, *m.part, options);
    for (const mesh::Place& p : milled.comparison->gouges) judge_place(milled, p, true);
    if (!complete_) return out_.unchecked("rest material not judged, since not every move was simulated");
    for (const mesh::Place& p : milled.comparison->excesses) judge_place(milled, p, false);
}

}  // namespace obrys::check
