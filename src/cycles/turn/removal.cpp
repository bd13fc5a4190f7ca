/// Stock removal, pattern repeating, finishing (Fanuc G70 … G73). Sources: cycles/turn/turning.hpp. The finishing
/// allowances shift the contour, they are no distance normal to it.
///
/// Type I (the contour runs in one direction in both axes): from the start point, shifted by the allowances, down by
/// one infeed (as the contour's first element is written: G0 or G1), along to the contour, away at 45 degrees by the
/// escape, back at rapid; at last once along the whole contour. Type II (pockets 1): its order of cuts is not
/// documented in detail; here as LinuxCNC does it: what is removed is the same.

#include <algorithm>
#include <cmath>

#include "cycles/turn/rough.hpp"

namespace obrys::cycles {

using geom::Vec2;

namespace {

constexpr double rise_slack = 1e-6;  ///< mm

void along_contour(TurningPath& path, const std::vector<TurningElement>& contour, Vec2 shift, bool finishing) {
    for (const TurningElement& e : contour) path.element(e, shift, finishing);
}

template <class Cycle>
Vec2 allowance_of(const Cycle& d) {
    return {d.allowance_u.value_or(0), d.allowance_v.value_or(0)};
}

/// Where the cycle begins; the contour must be one that it can follow.
Vec2 begin(Course& c, const TurningDemand& demand) {
    const Vec2 start = ends_of(c, {}, {}, demand.situation).start;
    if (demand.contour.empty()) c.fault("the contour is empty");
    for (const TurningElement& e : demand.contour)
        if (e.fillet != 0 || e.chamfer != 0) c.not_simulated("corners of the contour are not made in this cycle");
    return start;
}

/// Laid so that the infeed runs towards smaller v and the cuts towards smaller u.
Profile lay_for_removal(const TurningDemand& demand, Vec2 start, bool across) {
    Profile p = profile_of(demand.contour, start, 1);
    if (p.pieces.size() < 2) return p;
    if (across) p.turn_quarter();
    const Piece first = p.pieces.front();
    const double infeed = first.to.y - first.from.y, cut = p.pieces.back().to.x - first.to.x;
    const bool flip_u = cut > 0, flip_v = infeed > 0;
    for (Piece& piece : p.pieces) {
        for (Vec2* q : {&piece.from, &piece.to, &piece.centre}) *q = {flip_u ? -q->x : q->x, flip_v ? -q->y : q->y};
        if (flip_u != flip_v) piece.turn = -piece.turn;
    }
    p.mirrored_u = flip_u;
    p.mirrored_v = flip_v;
    return p;
}

/// The highest and the lowest point of an arc lie at its ends.
bool arc_rises(const Piece& p) {
    const double radius = geom::distance(p.from, p.centre);
    const double low = std::min(p.from.y, p.to.y), high = std::max(p.from.y, p.to.y);
    const bool over_top = p.centre.y + radius > high + profile::slack &&
                          (p.from.x - p.centre.x) * (p.to.x - p.centre.x) < 0 && p.turn > 0;
    const bool through_bottom =
        p.centre.y - radius < low - profile::slack && (p.from.x - p.centre.x) * (p.to.x - p.centre.x) < 0 && p.turn < 0;
    return !over_top && !through_bottom;
}

bool rises(const Piece& p) { return p.to.y >= p.from.y - rise_slack && (p.turn == 0 || arc_rises(p)); }

struct Removal {
    double infeed = 0, escape = 0;
    bool pockets = false, rapid_infeed = true;
    Vec2 start;  ///< laid
    Vec2 left;   ///< laid: what the cuts leave for the last pass along the contour
};

void shift_pieces(Profile& p, Vec2 by) {
    for (Piece& piece : p.pieces)
        for (Vec2* q : {&piece.from, &piece.to, &piece.centre}) *q = *q + by;
}

/// Where a cut at this height ends: at the contour, or at its last point's u.
double end_of_cut(const Profile& p, double v) {
    for (std::size_t i = 1; i < p.pieces.size(); ++i) {
        const auto u = meetings(p.pieces[i], v);
        if (!u.empty()) return *std::max_element(u.begin(), u.end());
    }
    return p.pieces.back().to.x;
}

void cuts(ProfilePath& out, const Profile& p, const Removal& r) {
    const double bottom = p.pieces.front().to.y;
    const auto infeed_to = [&](double v) { r.rapid_infeed ? out.rapid({r.start.x, v}) : out.feed({r.start.x, v}); };
    for (int k = 1; out.path().course().room(); ++k) {
        const double v = r.start.y - k * r.infeed;
        if (v <= bottom + rise_slack) return;
        infeed_to(v);
        const double u = end_of_cut(p, v);
        if (u > r.start.x - rise_slack) continue;
        out.feed({u, v});
        out.rapid({u + r.escape, v + r.escape});
        out.rapid({r.start.x, v + r.escape});
    }
}

/// `whole`: the contour of the last pass.
void type_one(ProfilePath& out, const Profile& p, const Profile& whole, const Removal& r) {
    out.rapid(r.start);
    Profile roughed = p;
    shift_pieces(roughed, r.left);
    cuts(out, roughed, r);
    const Piece& first = p.pieces.front();
    r.rapid_infeed ? out.rapid(first.to) : out.feed(first.to);
    for (std::size_t i = 1; i < whole.pieces.size(); ++i) out.along(whole.pieces[i]);
    out.rapid({whole.pieces.back().to.x, std::max(r.start.y, whole.pieces.back().to.y)});
}

void type_two(ProfilePath& out, Profile p, const Removal& r) {
    Course& c = out.path().course();
    c.assume("the order of the cuts in pockets");
    if (!(r.left == Vec2{})) c.remark("the allowance of a pass of its own along the contour is not left in pockets");
    if (const Fault f = check_falling(p)) return c.fault(*f);
    const Vec2 from = p.pieces.front().from, end = p.pieces.back().to;
    out.rapid(from);
    if (end.y < from.y) p.pieces.push_back({end, {end.x, from.y}, {}, 0, Corner::none, 0});
    // The first cut lies one infeed below the start point.
    Piece& first = p.pieces.front();
    if (first.turn == 0 && from.y - r.infeed > first.to.y) {
        first.from = from + r.infeed / (from.y - first.to.y) * (first.to - from);
        r.rapid_infeed ? out.rapid(first.from) : out.feed(first.from);
    }
    if (const Fault f = rough_down(out, p.pieces, r.infeed, r.escape, 0)) return c.fault(*f);
    out.rapid({out.laid_at().x, from.y});
}

/// False after a complaint: a contour without pockets runs in one direction in both axes, one with them along the cuts.
bool check_direction(Course& c, const Profile& p, bool pockets) {
    const auto wrong = std::find_if(p.pieces.begin() + 1, p.pieces.end(),
                                    [&](const Piece& q) { return !falls(q) || (!pockets && !rises(q)); });
    if (wrong == p.pieces.end()) return true;
    const bool back = !falls(*wrong);
    c.fault_at(
        wrong->element,
        back ? "the contour turns back here: along the cuts it must run in one direction"
             : "the contour has a pocket here: without pockets (type I) it must run in one direction in both axes",
        back ? "" : "name both axes in the contour's first block to allow pockets (type II)");
    return false;
}

/// A straight last block that goes back along the cuts and away from the axis leads off the contour, as CAM systems
/// write it: the cuts end before it. Controls that check every block stop there (alarm 64 or 329).
void leave_way_out(Course& c, Profile& p) {
    const Piece& last = p.pieces.back();
    if (p.pieces.size() < 3 || last.turn != 0 || falls(last) || !(last.to.y > last.from.y + rise_slack)) return;
    c.remark(
        "the contour's last block goes back along the cuts: it is taken for the way off the contour, and the cuts end "
        "before it",
        "a control that wants the contour to run in one direction stops here (FANUC: alarm 64 or 329)");
    p.pieces.pop_back();
}

/// Beyond the start point nothing is removed by the cuts.
void check_height(Course& c, const Profile& p) {
    double top = 0;
    for (const Piece& q : p.pieces) top = std::max(top, q.to.y - p.pieces.front().from.y);
    if (top > profile::slack)
        c.remark(
            "the contour reaches beyond the start point of the cycle: what lies there is cut by the last pass alone",
            "begin the cycle outside; newer controls stop here");
}

void remove(TurningPath& path, const StockRemoval& d, const TurningDemand& demand, bool across) {
    Course& c = path.course();
    const Vec2 start = begin(c, demand);
    Removal r;
    r.infeed = d.infeed;
    if (r.infeed <= 0) c.fault(Role::infeed, "the depth of cut must be greater than 0", "give the depth of one cut");
    r.escape = d.escape;
    r.pockets = c.whole(Role::pockets, d.pockets, 0, 0, 1, "the type of stock removal") == 1;
    const Vec2 allowance = allowance_of(d);
    if (!c.ready()) return;
    Profile p = lay_for_removal(demand, start, across);
    if (p.pieces.size() < 2) return c.fault("the contour has no length");
    r.rapid_infeed = demand.contour.front().rapid;
    shift_pieces(p, p.laid(allowance));
    r.left = p.laid({d.relief_u.value_or(0), d.relief_v.value_or(0)});
    r.start = p.pieces.front().from;
    if ((r.start.y - p.pieces.front().to.y) / r.infeed > double(most_steps) / 8)
        return c.fault(Role::infeed, "the infeed is too small for the contour");
    const Profile whole = p;
    leave_way_out(c, p);
    if (!check_direction(c, p, r.pockets)) return;
    check_height(c, p);
    ProfilePath out(path, p, 1);
    r.pockets ? type_two(out, p, r) : type_one(out, p, whole, r);
    if (c.ready()) path.rapid(start);
}

}  // namespace

void write_steps(TurningPath& path, const ContourFinishing&, const TurningDemand& demand) {
    Course& c = path.course();
    const Vec2 start = begin(c, demand);
    if (!c.ready()) return;
    along_contour(path, demand.contour, {}, true);
    path.rapid(start);
}

void write_steps(TurningPath& path, const RemovalAlong& d, const TurningDemand& demand) {
    remove(path, d, demand, false);
}
void write_steps(TurningPath& path, const RemovalAcross& d, const TurningDemand& demand) {
    remove(path, d, demand, true);
}

void write_steps(TurningPath& path, const PatternRepeating& d, const TurningDemand& demand) {
    Course& c = path.course();
    const Vec2 start = begin(c, demand), allowance = allowance_of(d), relief{d.relief_u, d.relief_v};
    const int passes = c.whole(Role::passes, d.passes, 1, 1, 10'000, "the number of passes");
    if (!c.ready()) return;
    if (passes == 1) c.assume("a single pass has no relief");
    for (int i = 0; i < passes && c.room(); ++i) {
        const double part = passes > 1 ? double(passes - 1 - i) / (passes - 1) : 0;
        const Vec2 shift = allowance + part * relief;
        path.rapid(start + shift);
        along_contour(path, demand.contour, shift, false);
    }
    path.rapid(start);
}

}  // namespace obrys::cycles
