/// What passes met becomes findings; the surface is held to the part.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/gouge/confirm.hpp"
#include "check/gouge/filled.hpp"
#include "check/gouge/thin.hpp"
#include "check/gouge/unshown.hpp"
#include "check/milling/milling.hpp"
#include "check/milling_tool.hpp"
#include "check/use_findings.hpp"
#include "check/words.hpp"
#include "mesh/crossing.hpp"
#include "sim/milling/surface/surface.hpp"

namespace obrys::check {

namespace codes = base::codes;
namespace milling = sim::milling;

namespace {

constexpr double doubtful_from = 0.6;  ///< of what is allowed

/// Rest material beside what the surface has shown; of all so many, the worst.
void add_places(mesh::Comparison& found, std::vector<mesh::Place> places, std::size_t most) {
    found.excess_count += places.size();
    std::move(places.begin(), places.end(), std::back_inserter(found.excesses));
    std::stable_sort(found.excesses.begin(), found.excesses.end(),
                     [](const mesh::Place& a, const mesh::Place& b) { return a.deviation > b.deviation; });
    if (!found.excesses.empty())
        found.largest_excess = std::max(found.largest_excess, found.excesses.front().deviation);
    if (found.excesses.size() > most) found.excesses.resize(most);
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
    if (move.spindle == 0 && !stopped_reported_) say_stopped(move);
    stopped_reported_ = move.spindle == 0;
    judge_use(move);
}

void Milling::say_stopped(const MilledMove& move) {
    Finding f;
    f.code = codes::spindle_stopped;
    f.text = "the tool cuts while the spindle stands";
    f.remedy = "start the spindle with M3 or M4 and a speed S";
    found(move, std::move(f));
}

/// What the end meets beside the part of it that does not cut is no plunge: a hole made before, a rim, a chamfer.
void Milling::judge_plunge(const QueuedPass& pass, const MilledMove& move, const milling::Engagement& met) {
    if (!move.plunging || move.tool == 0 || plunged_ == pass.move + 1) return;
    const auto listed = out_.result().tools[move.tool - 1].listed;
    const double blind = listed ? blind_radius(setup_.tools[*listed]) : 0;
    if (!(blind > 0) || !(met.rightmost < blind)) return;  // what cuts at its centre may plunge
    plunged_ = pass.move + 1;
    const bool tap = shop::assumed_kind(setup_.tools[*listed]) == shop::ToolKind::tap;
    found(move, plunges(tap, met.volume));
}

bool Milling::is_tap(const MilledMove& move) const {
    const auto listed = move.tool > 0 ? out_.result().tools[move.tool - 1].listed : std::nullopt;
    return listed && shop::assumed_kind(setup_.tools[*listed]) == shop::ToolKind::tap;
}

void Milling::judge_place(const Milled& milled, const mesh::Place& p, bool gouge) {
    Finding f;
    f.code = gouge ? codes::gouge : codes::rest_material;
    f.severity = gouge ? base::Severity::error : base::Severity::warning;
    f.place = p.at;
    const double amount = std::abs(p.deviation);
    f.text = std::string(gouge ? "cuts into the finished part: " : "material is left on the part: ") + mm(amount) +
             (gouge ? " deep" : " high") + " at " + point(p.at) + ", over " + mm2(p.area);
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
    if (p.area > 0 && !gouge.edge && !gouge.lacks) return judge_place(milled, p, true);
    Finding f;
    f.code = codes::gouge;
    f.place = p.at;
    if (gouge.lacks)
        f.text = "the stock lacks " + mm(-p.deviation) + " of the finished part at " + point(p.at);
    else
        f.text = std::string("cuts into ") + (gouge.edge ? "an edge of " : "") +
                 "the finished part: " + mm(-p.deviation) + " deep at " + point(p.at);
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
    if (contact_found || !entered_part_.empty()) return;
    const bool rapid = std::any_of(milled.moves.begin(), milled.moves.end(),
                                   [](const MilledMove& m) { return m.rapid && m.volume_mm3 > 0; });
    out_.unchecked(rapid ? "no move at feed met the stock, rapid moves alone did: nothing was checked against it"
                         : "not one move met the stock: nothing was checked against it",
                   "see whether stock, part and program use the same zero point (docs/job-file.md)");
}

namespace {

milling::Box3 box_of(const std::vector<milling::Box3>& boxes) {
    milling::Box3 box = boxes.front();
    for (const milling::Box3& b : boxes)
        for (int k = 0; k < 3; ++k) {
            milling::set_component(box.min, k, std::min(milling::component(box.min, k), milling::component(b.min, k)));
            milling::set_component(box.max, k, std::max(milling::component(box.max, k), milling::component(b.max, k)));
        }
    return box;
}

}  // namespace

/// Where the surface is not known to be within the tolerance.
void Milling::judge_open(const milling::Refined& refined) {
    if (!refined.filled.empty()) {
        const milling::Box3 box = box_of(refined.filled);
        out_.assumption("the surface leaves up to " + mm(2 * figures_.tolerance_mm) +
                        " at the bottom of grooves that the points of tools have cut, in " +
                        std::to_string(refined.filled.size()) + " places between " + point(box.min) + " and " +
                        point(box.max) + ": it is no rest material, and gouges are found by the tool itself");
    }
    if (refined.open.empty()) return;
    const milling::Box3 box = box_of(refined.open);
    out_.unchecked("the surface is too fine in itself to be followed within " + mm(figures_.tolerance_mm) +
                       " everywhere: in " + std::to_string(refined.open.size()) + " places between " + point(box.min) +
                       " and " + point(box.max) + " narrow rest material may not be seen",
                   "try another tolerance, smaller or larger (--tolerance), or look at these places (--html)");
}

/// What is thinner than the surface's cells.
void Milling::add_thin(mesh::Comparison& found, const Machined& machined, const mesh::CompareOptions& options) {
    ThinRest thin = thin_rest(machined, options, found.excesses);
    add_places(found, std::move(thin.places), options.places);
    if (thin.open.empty()) return;
    const milling::Box3& first = thin.open.front();
    out_.unchecked("in " + std::to_string(thin.open.size()) + (thin.open.size() == 1 ? " place" : " places") +
                       ", the first between " + point(first.min) + " and " + point(first.max) +
                       ", material stands so thin that it is not known whether it is left at all",
                   "let the cuts overlap by more, or take a smaller tolerance (--tolerance)");
}

/// Moves that are neither proved to be clear of the part nor found in it.
void Milling::judge_undecided(const Milled& milled) {
    const std::vector<Certificate::Open>& open = certificate_->open();
    if (open.empty()) return;
    const MilledMove& move = milled.moves[open.front().move];
    const cl::Record record{cl::Linear{move.to, {0, 0, 1}, move.rapid}, move.where, move.stack};
    out_.unchecked(record,
                   "whether the tool cuts into the finished part was not decided in " + std::to_string(open.size()) +
                       (open.size() == 1 ? " place, at " : " places, the first at ") + point(open.front().at),
                   "look at this place (--html), or try another tolerance (--tolerance)");
}

/// What stands in features of the part that are narrower than the surface's cells.
void Milling::add_filled(mesh::Comparison& found, const Machined& machined, const mesh::CompareOptions& options) {
    FilledRest rest = filled_rest(found, machined, options, found.excesses);
    add_places(found, std::move(rest.places), options.places);
    if (!rest.whole)
        out_.unchecked(
            "the part has too many narrow places for its size: whether material is left in them is not known",
            "try a smaller tolerance (--tolerance), or check a smaller part of it");
}

/// Of a stock that goes through itself rays tell by parity what is within, and distances tell another thing: what is
/// looked for between the rays would never come to an end.
void Milling::judge_crossing() {
    const auto* stock = std::get_if<milling::MeshStock>(&setup_.milling->stock);
    if (stock == nullptr) return;
    const auto found =
        mesh::self_crossing(mesh::Distance({stock->vertices, stock->triangles, {}}), setup_.milling->tolerance);
    if (!found) return;
    crossed_ = true;
    out_.unchecked("the stock's surface goes through itself, first at " + point(*found) +
                       ": it is not known what is material there, and rapids in it are not looked for between the rays",
                   "unite its bodies in the CAD system, and export one solid");
}

std::function<bool()> Milling::surface_ends() const {
    return crossed_ ? [] { return true; } : setup_.out_of_time;
}

/// What was left when one of the moves had been made.
void Milling::keep_at_move(Milled& milled, std::uint64_t index) {
    std::size_t passes = 0;
    while (passes < move_of_pass_.size() && milled.moves[move_of_pass_[passes]].index <= index) ++passes;
    const milling::Simulation then = simulation_->at(passes);
    milled.at_move = milling::extract_surface(then, surface_ends()).mesh;
    for (std::uint32_t& tag : milled.at_move->tags) tag = tag_of(tag);
}

milling::Refined Milling::make_surface(Milled& milled) const {
    milling::Surface surface = milling::extract_surface(*simulation_, surface_ends());
    for (std::uint32_t& tag : surface.mesh.tags) tag = tag_of(tag);
    milled.surface = std::move(surface.mesh);
    milled.thin = surface.thin;
    return surface.refined;
}

void Milling::judge_surface(Milled& milled) {
    const MillingSetup& m = *setup_.milling;
    std::optional<milling::Refined> refined;
    if (asks_for_narrow_cuts(milled.moves)) {
        refined = make_surface(milled);
        if (time_up_.now())
            out_.unchecked("the time for the check is up: whether moves that no ray has met cut is not known",
                           TimeUp::remedy);
        else
            judge_narrow_cuts(milled);
    }
    const bool judged = m.part != nullptr && judges_part(setup_.scope);
    if (m.part == nullptr && judges_part(setup_.scope))
        out_.unchecked("no part: gouges and rest material not checked", "give the finished part in the job file");
    if (judged && time_up_.now()) {
        out_.unchecked(std::string(time_up_.text().empty() ? "the time for the check is up with the last move"
                                                           : "the time for the check is up") +
                           ": the part was not held to what was cut, gouges and rest material are not judged",
                       TimeUp::remedy);
        judge_entered_part(milled.moves);
    }
    if ((!judged || time_up_.up()) && !m.surface) {
        milled.surface = {};
        return;
    }
    if (!refined) refined = make_surface(milled);
    milled.figures.refined_cells = refined->cells;
    milled.figures.finest_mm = refined->finest;
    judge_open(*refined);
    if (time_up_.now()) {
        out_.unchecked(
            "the time for the check is up while the surface was made: it may be off by more than the tolerance" +
                std::string(judged ? ", and was not held to the part" : ""),
            TimeUp::remedy);
        judge_entered_part(milled.moves);
    }
    if (!judged || time_up_.up()) return;
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
    certificate_->measure(thread_bands_, setup_.out_of_time);
    std::erase_if(milled.comparison->doubtful_gouges, [&](const mesh::Place& p) { return !certificate_->may_be(p); });
    Machined machined{
        milled.surface,    *simulation_, *m.part, thread_bands_, [this](std::uint32_t cut) { return tag_of(cut); },
        setup_.out_of_time};
    machined.is_none = [&](const mesh::Place& p) { return certificate_->is_none(p); };
    confirm(*milled.comparison, machined, options);
    drop_unfollowed(milled.comparison->excesses, refined->open, machined);
    add_thin(*milled.comparison, machined, options);
    if (whole_ && complete_) add_filled(*milled.comparison, machined, options);
    const std::vector<Gouge> gouges = certificate_->gouges(milled.moves, milled.comparison->gouges);
    if (time_up_.now())
        out_.unchecked(
            "the time for the check is up while what was cut is held to the part: not all places were looked at",
            TimeUp::remedy);
    milled.comparison->largest_gouge = 0;
    for (const Gouge& g : gouges) {
        milled.comparison->largest_gouge = std::max(milled.comparison->largest_gouge, -g.place.deviation);
        judge_gouge(milled, g);
    }
    judge_undecided(milled);
    judge_entered_part(milled.moves);
    if (!whole_) return out_.assumption(rest_of_a_part_run);
    if (!complete_) return out_.unchecked("rest material not judged, since not every move was simulated");
    for (const mesh::Place& p : milled.comparison->excesses) judge_place(milled, p, false);
}

}  // namespace obrys::check
