/// What passes met becomes findings; the surface is held to the part.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/milling.hpp"
#include "check/milling_confirm.hpp"
#include "check/milling_tool.hpp"
#include "check/words.hpp"
#include "sim/milling/surface.hpp"

namespace obrys::check {

namespace codes = base::codes;
namespace milling = sim::milling;

namespace {

constexpr double doubtful_from = 0.6;  ///< of what is allowed

std::string place(geom::Vec3 p) {
    return "X " + base::fixed(p.x, 3) + " Y " + base::fixed(p.y, 3) + " Z " + base::fixed(p.z, 3);
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
    judge_plunge(pass, move, met);
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
}

/// What the end meets beside the part of it that does not cut is no plunge: a hole made before, a rim, a chamfer.
void Milling::judge_plunge(const QueuedPass& pass, const MilledMove& move, const milling::Engagement& met) {
    if (!move.plunging || move.tool == 0 || plunged_ == pass.move + 1) return;
    const auto listed = out_.result().tools[move.tool - 1].listed;
    const double blind = listed ? blind_radius(setup_.tools[*listed]) : 0;
    if (!(blind > 0) || !(met.rightmost < blind)) return;  // what cuts at its centre may plunge
    plunged_ = pass.move + 1;
    const bool tap = shop::assumed_kind(setup_.tools[*listed]) == shop::ToolKind::tap;
    Finding f;
    f.code = codes::plunging_cut;
    f.text = tap ? "the core of the tap meets material: its hole is too narrow, not deep enough or missing"
                 : "the tool plunges into the material, but it does not cut at its centre";
    f.remedy = tap ? "drill before, wide and deep enough" : "enter by a ramp or a helix, or drill before";
    f.amounts = {{"volume_mm3", met.volume}};
    found(move, std::move(f));
}

/// What the end that does not cut comes down upon, in passes of its own ahead of those that cut.
void Milling::queue_core(const geom::PathElement& element, bool feed, bool straight_down) {
    CorePiece piece;
    piece.move = static_cast<std::uint32_t>(moves_.size() - 1);
    piece.tool = tool_parts_.core;
    piece.radius = tool_parts_.core_radius;
    piece.leaves = !feed;
    if (piece.leaves && !core_pieces_.empty() && core_pieces_.back().leaves) return;
    const milling::Orientation frame = milling::orientation_of(axis_);
    bool down = false;
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
        piece.points[i] = frame.to_tool(geom::point_at(element, static_cast<double>(i) / 4));
        down = down || (i > 0 && piece.points[i].z < piece.points[i - 1].z);
    }
    if (feed && down && !straight_down) {  // straight down: judge_plunge
        require(simulation_->add({element, axis_, tool_parts_.core, milling::Part::cutting, false}));
        piece.probe = passes_++;
        move_of_pass_.push_back(piece.move);
    }
    piece.pass = passes_;
    piece.axis = axis_;
    core_pieces_.push_back(piece);
}

/// Whether what stayed under the core all the way was material before that: at points, from what was cut before.
bool Milling::meets_core(const CoreDescent::Steep& steep, geom::Vec3 axis) const {
    const milling::Orientation frame = milling::orientation_of(axis);
    const auto place = [&](double x, double y, double z) { return x * frame.x + y * frame.y + z * frame.z; };
    constexpr int levels = 5, round = 8;
    for (int level = 0; level < levels; ++level)
        for (int i = 0; i <= 2 * round; ++i) {
            const double r = i == 0 ? 0 : (i <= round ? 0.45 : 0.9) * steep.radius, turn = 2 * geom::pi * i / round;
            const geom::Vec3 p = place(steep.middle.x + r * std::cos(turn), steep.middle.y + r * std::sin(turn),
                                       steep.bottom + (steep.top - steep.bottom) * (level + 0.5) / levels);
            const geom::Vec3 around{1e-6, 1e-6, 1e-6};
            const milling::Air air = simulation_->air_in({p - around, p + around});
            bool taken = false;
            for (std::size_t body = 0; body < air.bodies() && !taken; ++body)
                taken = (body == 0 || simulation_->pass_of(air.cut(body)) < steep.first) && air.outside(body, p) < 0;
            if (!taken) return true;
        }
    return false;
}

void Milling::judge_cores() {
    for (const CorePiece& piece : core_pieces_) {
        if (piece.tool != core_tool_) core_descent_.begin(piece.radius, setup_.milling->tolerance);
        core_tool_ = piece.tool;
        if (piece.leaves) core_descent_.leave();
        if (piece.leaves) continue;
        const bool met = piece.probe && simulation_->engagements()[*piece.probe].touched;
        if (!core_descent_.take(piece.points, met, piece.pass) || core_found_ == piece.move + 1) continue;
        const CoreDescent::Steep steep = core_descent_.steep();
        if (!meets_core(steep, piece.axis)) continue;
        core_found_ = piece.move + 1;
        Finding f;
        f.code = codes::plunging_cut;
        f.text = "the tool goes down " + mm(steep.down) + " in the material while it moves " + mm(steep.aside) +
                 " aside: it does not cut at its centre";
        f.remedy = "enter by a flatter ramp or a wider helix, or drill before";
        f.amounts = {{"down_mm", steep.down}, {"aside_mm", steep.aside}};
        found(moves_[piece.move], std::move(f));
    }
    core_pieces_.clear();
}

bool Milling::assumed_body(const MilledMove& move) const {
    const auto listed = out_.result().tools[move.tool - 1].listed;
    return listed && has_assumed_body(setup_.tools[*listed]);
}

bool Milling::is_tap(const MilledMove& move) const {
    const auto listed = move.tool > 0 ? out_.result().tools[move.tool - 1].listed : std::nullopt;
    return listed && shop::assumed_kind(setup_.tools[*listed]) == shop::ToolKind::tap;
}

const milling::Engagement& Milling::met_by(const QueuedPass& pass) const {
    return (pass.clamp == 0 ? *simulation_ : clamps_[pass.clamp - 1].simulation).engagements()[pass.pass];
}

/// As far as the material reaches into the swept part; of a way straight down into which the part's axis dips, as far
/// as it stands above the lower end. Of rapids as high as material stands above the lower side of the tool, but for its
/// rim. Clamps by geometry, too, and what of rapids lies between the rays.
Milling::Reach Milling::reach_of(const QueuedPass& pass) const {
    const Reach rays = ray_reach_of(pass);
    if (pass.clamp == 0) {
        if (pass.kind != QueuedPass::Kind::rapid_probe || !rapid_guard_) return rays;
        const RapidGuard::Hit hit = rapid_guard_->hit_by(pass.pass);
        return hit.depth > rays.depth ? Reach{hit.depth, hit.at} : rays;
    }
    const ClampGuard::Hit hit = clamps_[pass.clamp - 1].guard->hit_by(pass.pass);
    return hit.depth > rays.depth ? Reach{hit.depth, hit.at} : rays;
}

Milling::Reach Milling::ray_reach_of(const QueuedPass& pass) const {
    const milling::Engagement& met = met_by(pass);
    if (!met.touched) return {};
    const Reach reach{met.depth, met.deepest};
    if (pass.kind == QueuedPass::Kind::rapid_probe)
        return met.stack > reach.depth ? Reach{met.stack, met.stack_foot} : reach;
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
        if (queued_[i].kind != pass.kind || queued_[i].clamp != pass.clamp) continue;
        const Reach reach = reach_of(queued_[i]);
        if (reach.depth > deepest.depth) deepest = reach;
    }
    return deepest;
}

void Milling::judge(std::size_t queued) {
    const QueuedPass& pass = queued_[queued];
    if (pass.clamp == 0 && pass.kind == QueuedPass::Kind::cut) return judge_cut(pass, moves_[pass.move], met_by(pass));
    // Said once for a move, at the first of its parts.
    for (std::size_t i = queued; i > 0 && queued_[i - 1].move == pass.move; --i)
        if (queued_[i - 1].kind == pass.kind && queued_[i - 1].clamp == pass.clamp) return;
    const Reach reach = deepest_reach(queued);
    if (reach.depth > setup_.tolerances.rapid) judge_reach(pass, reach);
}

void Milling::judge_reach(const QueuedPass& pass, const Reach& reach) {
    using Kind = QueuedPass::Kind;
    const MilledMove& move = moves_[pass.move];
    Finding f;
    f.amounts = {{"depth_mm", reach.depth}, {"x_mm", reach.at.x}, {"y_mm", reach.at.y}, {"z_mm", reach.at.z}};
    f.place = reach.at;
    const std::string deep = mm(reach.depth) + " deep at " + place(reach.at);
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
                 place(reach.at);
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

/// By geometry, to a tenth of the tolerance; the area is that which the rays saw.
void Milling::judge_gouge(const Milled& milled, const Gouge& gouge) {
    const mesh::Place& p = gouge.place;
    if (p.area > 0 && !gouge.edge) return judge_place(milled, p, true);
    Finding f;
    f.code = codes::gouge;
    f.place = p.at;
    f.text = std::string("cuts into ") + (gouge.edge ? "an edge of " : "") + "the finished part: " + mm(-p.deviation) +
             " deep at " + place(p.at);
    f.amounts = {{"depth_mm", -p.deviation}};
    if (p.area > 0) {
        f.text += ", over " + mm2(p.area);
        f.amounts.push_back({"area_mm2", p.area});
    } else if (gouge.width > 0 && !gouge.edge) {
        f.text += ", " + mm(gouge.width) + " wide";
        f.amounts.push_back({"width_mm", gouge.width});
    }
    for (const auto& [key, value] : {std::pair{"x_mm", p.at.x}, std::pair{"y_mm", p.at.y}, std::pair{"z_mm", p.at.z}})
        f.amounts.push_back({key, value});
    found(milled, p, std::move(f));
}

/// A program that cuts air has another zero point than its stock, unless a rapid, a shank or a holder was found in the
/// stock.
void Milling::judge_no_contact(const Milled& milled) {
    const std::vector<Finding>& found = out_.result().findings;
    const bool contact_found = std::any_of(found.begin(), found.end(), [](const Finding& f) {
        return f.code == codes::rapid_in_stock || f.code == codes::holder_in_stock || f.code == codes::edges_too_short;
    });
    if (contact_found) return;
    const bool rapid = std::any_of(milled.moves.begin(), milled.moves.end(),
                                   [](const MilledMove& m) { return m.rapid && m.volume_mm3 > 0; });
    out_.unchecked(rapid ? "no move at feed met the stock, rapid moves alone did: nothing was checked against it"
                         : "not one move met the stock: nothing was checked against it",
                   "see whether stock, part and program use the same zero point (docs/job-file.md)");
}

void Milling::judge_surface(Milled& milled) {
    const MillingSetup& m = *setup_.milling;
    if (out_.result().stats.feed_moves > 0 && figures_.contact_length_mm == 0 && complete_) judge_no_contact(milled);
    const bool judged = m.part != nullptr && judges_part(setup_.scope);
    if (m.part == nullptr && judges_part(setup_.scope))
        out_.unchecked("no part: gouges and rest material not checked", "give the finished part in the job file");
    if (!judged && !m.surface) return;
    milling::Surface surface = milling::extract_surface(*simulation_);
    const auto tag_of = [&](std::uint32_t cut) { return cut == 0 ? 0 : move_of_pass_[simulation_->pass_of(cut)] + 1; };
    for (std::uint32_t& tag : surface.mesh.tags) tag = tag_of(tag);
    milled.surface = std::move(surface.mesh);
    milled.thin = surface.thin;
    if (!judged) return;
    mesh::CompareOptions options;
    options.gouge = std::max(setup_.tolerances.gouge, m.tolerance);
    options.excess = std::max(setup_.tolerances.rest_material, m.tolerance);
    options.doubt = doubtful_from;
    if (!thread_bands_.empty()) {
        thread_bands_.fit(milled.surface, *m.part, std::max(options.gouge, options.excess), [&](std::uint32_t tag) {
            return tag > 0 && tag <= milled.moves.size() && is_tap(milled.moves[tag - 1]);
        });
        options.judged = [&](geom::Vec3 p, double deviation) { return thread_bands_.judged(p, deviation); };
    }
    milled.comparison = mesh::compare(milled.surface, *m.part, options);
    confirm(*milled.comparison, {milled.surface, *simulation_, *m.part, thread_bands_, tag_of}, options);
    const std::vector<Gouge> gouges = certificate_->gouges(milled.moves, milled.comparison->gouges, thread_bands_);
    milled.comparison->largest_gouge = 0;
    for (const Gouge& g : gouges) {
        milled.comparison->largest_gouge = std::max(milled.comparison->largest_gouge, -g.place.deviation);
        judge_gouge(milled, g);
    }
    if (!complete_) return out_.unchecked("rest material not judged, since not every move was simulated");
    for (const mesh::Place& p : milled.comparison->excesses) judge_place(milled, p, false);
}

}  // namespace obrys::check
