// What the removal of a move means: gouges, rapids in stock, holders, threads.
#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "check/turning/removal.hpp"
#include "check/turning/turning_tool.hpp"
#include "geom/boolean.hpp"

namespace obrys::check {

using sim::turning::Cut;
using sim::turning::Depth;

namespace {

constexpr double beyond_gouge = 1e-6;  ///< mm2 an allowance cut must have besides the gouge to be told apart
constexpr double rapid_run_out = 2;    ///< pitches along which a rapid may lead out of a thread

/// Not of work on the far side of the axis.
bool from_above(const Move& move) { return move.from.x > 0 || move.to.x > 0; }
constexpr const char* by_far_side = ", where the insert reaches past the axis into the opposite wall";

Finding into(const Depth& d, bool part) {
    Finding f;
    f.code = part ? base::codes::gouge : base::codes::allowance_cut;
    f.severity = part ? base::Severity::error : base::Severity::warning;
    f.text = std::string(part ? "cuts into the finished part" : "cuts into the allowance that must stay") + ": " +
             mm(d.along_x) + " deep along X, " + mm(d.normal) + " normal to the contour, " + mm2(d.area) +
             ", deepest at " + point(d.deepest);
    f.amounts = {{"depth_mm", d.normal},   {"depth_x_mm", d.along_x}, {"area_mm2", d.area},
                 {"volume_mm3", d.volume}, {"z_mm", d.deepest.x},     {"x_mm", d.deepest.y}};
    f.region = d.region;
    f.at = d.deepest;
    return f;
}

geom::Region with(const geom::Region& all, const geom::Region& more) {
    if (more.empty()) return all;
    return all.empty() ? more : geom::unite(all, more);
}

}  // namespace

sim::turning::Move in_turning_plane(const Move& move) {
    sim::turning::Move m{{move.from.z, move.from.x}, {move.to.z, move.to.x}, {}, 0};
    if (const auto* arc = std::get_if<cl::Arc>(&move.record.step)) {
        m.centre = {arc->centre.z, arc->centre.x};
        m.sweep = arc->normal.y < 0 ? -arc->sweep : arc->sweep;
    }
    return m;
}

/// A pass leaves a groove that winds round the part: the section shows it here and there, so it stays in the model.
void Removal::cut_thread(const Move& move, const sim::turning::Move& way, const cl::Thread& thread, Removed& r) {
    r.simulated = true;
    const geom::Region band = work_->met(outline_, way);
    r.cuts = !band.empty();
    pitch_ = std::abs(thread.pitch);
    thread_along_ = thread_direction(way);
    judge_holder(move, way);
    if (band.empty()) return;
    out_.assumption("threads are not cut into the simulated part: within their depth nothing is judged",
                    move.record.from);
    passes_.cut(move, band, *tool_);
    judge_thread(move, {way, pitch_, outline_, band});
    threads_ = with(threads_, band);
}

/// What of a pass is thread is judged neither as gouge nor as rest material; the contour says how deep and how long it
/// may be.
void Removal::judge_thread(const Move& move, const ThreadPass& pass) {
    const auto& drawn = part_ ? part_ : allowance_;
    if (!drawn) return;
    ground_ = thread_ground(pass, drawn->region(), ground_);
    ridges_ = with(ridges_, ground_ ? thread_ridges(pass, *ground_) : pass.band);
    if (!part_) return;
    const double allowed = setup_.tolerances.gouge;
    std::optional<ThreadFault> fault;
    if (ground_ && root_width(pass, *ground_) > ground_->lead) return say_too_wide(move, pass);
    // What stands above the contour may be what a move that was not simulated takes away.
    if (ground_ && ground_->shows_core() && !complete_)
        return out_.unchecked(move.record, "the depth of the thread is not judged, since not every move was simulated");
    if (ground_) {
        fault = thread_fault(pass, *ground_, part_->region(), allowed);
    } else if (const auto d = part_->depth_inside(pass.band, allowed);
               d && d->along_x > deepest_thread * pitch_ + allowed) {
        fault = {pass.band, too_deep(pitch_), {}};
    }
    if (!fault) return;
    const auto depth = part_->depth_inside(fault->region, allowed);
    if (!depth) return;
    Finding f = into(*depth, true);
    f.text += "; " + fault->why;
    f.remedy = fault->remedy;
    out_.finding(move, std::move(f));
}

/// The turns of the thread overlap: it is turned off, whatever of it the part shows.
void Removal::say_too_wide(const Move& move, const ThreadPass& pass) {
    const double width = root_width(pass, *ground_);
    Finding f;
    f.code = base::codes::gouge;
    f.text = "the insert is " + mm(width) + " wide at its tip, the pitch is " + mm(ground_->lead) +
             ": nothing of the thread is left";
    f.remedy = "take a threading insert: tip_angle = 60, entering_angle = 60, orientation = 8 (in a bore 6)";
    f.amounts = {{"width_mm", width}, {"area_mm2", geom::area(pass.band)}};
    f.region = pass.band;
    out_.finding(move, std::move(f));
}

/// What is parted off falls: the workpiece is held at its left. A cut in what has fallen is not what it would be.
void Removal::note_fallen(const Move& move, const Cut& cut) {
    constexpr double whole_piece = 0.02;  // of the stock: less is a chip between two cuts
    if (cut.removed.empty()) return;
    if (!fallen_.empty() && box_of(fallen_).meets(box_of(cut.removed), 0) &&
        geom::area(geom::intersect(fallen_, cut.removed)) > setup_.tolerances.rapid)
        out_.unchecked(move.record, "this move cuts a piece that was parted off before: it is no longer held",
                       "part off last");
    const bool inwards = move.to.x < move.from.x && move.from.x - move.to.x > std::abs(move.to.z - move.from.z);
    if (!inwards || tool_->kind != shop::ToolKind::groove) return;
    const std::vector<geom::Region> pieces = geom::pieces(work_->region());
    if (pieces.size() < 2) return;
    const auto left_of = [](const geom::Region& a, const geom::Region& b) { return box_of(a).min_z < box_of(b).min_z; };
    const auto held = std::min_element(pieces.begin(), pieces.end(), left_of);
    fallen_ = {};
    for (auto p = pieces.begin(); p != pieces.end(); ++p)
        if (p != held && geom::area(*p) > whole_piece * out_.result().before->area_mm2)
            fallen_.contours.insert(fallen_.contours.end(), p->contours.begin(), p->contours.end());
}

/// What a tap leaves of its thread.
void Removal::add_to_threads(const geom::Region& band) {
    threads_ = with(threads_, band);
    ridges_ = with(ridges_, band);
}

/// The cut without what lies in threads: material that only stands because threads are not cut into the model. A rapid
/// is excused on its way out of a thread, not along it.
Cut Removal::beside_threads(const Move& move, const Cut& cut) const {
    const geom::Vec2 way{move.to.z - move.from.z, move.to.x - move.from.x};
    const bool along = move.rapid && std::abs(geom::dot(way, thread_along_)) > rapid_run_out * pitch_;
    if (threads_.empty() || along || !box_of(threads_).meets(box_of(cut.removed), 0)) return cut;
    Cut out = cut;
    out.removed = {};
    // What is no farther beside a thread than rounding is none.
    for (sim::turning::Depth& piece : sim::turning::pieces_outside(cut.removed, threads_, setup_.tolerances.gouge))
        out.removed.contours.insert(out.removed.contours.end(), piece.region.contours.begin(),
                                    piece.region.contours.end());
    out.across = geom::subtract(cut.across, threads_);
    out.area = geom::area(out.removed);
    out.volume = geom::volume(out.removed);
    const Box b = box_of(out.removed);
    out.depth_x = b.empty() ? 0 : b.max_x - b.min_x;
    return out;
}

void Removal::judge(const Move& move, const Cut& whole) {
    last_cuts_.add(move, whole.removed);
    const Cut cut = beside_threads(move, whole);
    if (cut.removed.empty()) return;
    if (move.rapid && cut.area > setup_.tolerances.rapid) {
        Finding f;
        f.code = base::codes::rapid_in_stock;
        f.text = "rapid move goes through the stock: " + mm(cut.depth_x) + " deep along X, " + mm2(cut.area);
        f.amounts = {{"depth_x_mm", cut.depth_x},
                     {"area_mm2", cut.area},
                     {"volume_mm3", cut.volume},
                     {"contact_length_mm", cut.contact_length}};
        if (from_above(move) && geom::area(cut.across) > setup_.tolerances.rapid) f.text += by_far_side;
        f.region = cut.removed;
        out_.finding(move, std::move(f));
    }
    const auto say = [&](const sim::turning::Kept& kept, const Depth& d) {
        Finding f = into(d, part_ && &kept == &*part_);
        if (from_above(move) && kept.depth_inside(cut.across, setup_.tolerances.gouge)) f.text += by_far_side;
        out_.finding(move, std::move(f));
    };
    std::optional<Depth> gouge;
    if (part_) gouge = part_->depth_inside(cut.removed, setup_.tolerances.gouge);
    if (gouge) say(*part_, *gouge);
    if (!allowance_) return;
    const auto allowance = allowance_->depth_inside(cut.removed, setup_.tolerances.gouge);
    if (allowance && allowance->area > (gouge ? gouge->area : 0) + beyond_gouge) say(*allowance_, *allowance);
}

}  // namespace obrys::check
