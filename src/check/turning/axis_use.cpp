#include "check/turning/axis_use.hpp"

#include <algorithm>
#include <cmath>

#include "check/milling_tool.hpp"
#include "check/turning/rest.hpp"
#include "check/use_findings.hpp"
#include "geom/boolean.hpp"
#include "geom/region.hpp"
#include "motion/technology.hpp"

namespace obrys::check {

namespace {

constexpr double no_way = 1e-6;       ///< mm
constexpr double narrower_by = 1e-3;  ///< mm by which a hole may be narrower than what must fit in it: rounding

/// Straight along the axis: +1 towards the spindle, -1 away from it, else 0.
int inwards(const sim::turning::Move& way) {
    const double along = way.from.x - way.to.x;
    if (way.sweep != 0 || std::abs(along) < no_way || std::abs(way.to.y - way.from.y) > no_way) return 0;
    return along > 0 ? 1 : -1;
}

}  // namespace

void AxisUse::tool_changed() {
    mouth_ = bottom_ = NAN;
    in_ = {};
    turned_wrong_ = 0;
    no_tap_ = false;
}

AxisUse::Coupled AxisUse::coupled(const Move& move, double way) const {
    Coupled c;
    const bool turns = motion::turning_sense(state_.spindle) != 0;
    c.speed_rpm = turns ? motion::spindle_speed(state_.spindle, 0, setup_.machine.spindle.max) : 0;
    if (move.rapid) return c;
    if (const auto* thread = std::get_if<cl::Thread>(&move.record.step)) {
        c.hand = thread->pitch < 0 ? -1 : 1;
        c.per_rev = std::abs(thread->pitch);
    } else if (state_.feed.mode == cl::FeedMode::per_rev) {
        c.per_rev = state_.feed.value > 0 ? state_.feed.value : NAN;
    } else if (c.speed_rpm > 0) {
        c.per_rev = 60 * way / motion::feed_seconds(state_.feed, way, c.speed_rpm) / c.speed_rpm;
    }
    return c;
}

void AxisUse::take(const Move& move, const sim::turning::Move& way, const Box& stock) {
    const int in = inwards(way);
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    const bool is_tap = tool().kind == shop::ToolKind::tap;
    if (!is_tap) {
        if (in <= 0 || thread == nullptr || !thread->rigid_tap || no_tap_ || tool().kind == shop::ToolKind::form)
            return;
        no_tap_ = true;
        return out_.finding(move, is_no_tap(std::abs(thread->pitch)));
    }
    if (in == 0) return;
    if (in < 0) return judge_out(move, way);
    if (move.rapid || std::min(way.from.x, way.to.x) >= stock.max_z || std::max(way.from.x, way.to.x) <= stock.min_z)
        return;
    judge_in(move, way);
}

void AxisUse::judge_in(const Move& move, const sim::turning::Move& way) {
    const Coupled c = coupled(move, way.from.x - way.to.x);
    if (c.hand != 0 && (c.hand < 0) != tool().left_hand)
        out_.finding(move, cuts_other_hand(c.hand < 0, tool().left_hand));
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    if (thread == nullptr || !thread->rigid_tap) judge_rotation(move);
    judge_pitch(move, c);
    if (std::isnan(mouth_)) mouth_ = way.from.x;
    bottom_ = way.to.x;
    in_ = c;
}

void AxisUse::judge_pitch(const Move& move, const Coupled& c) {
    if (c.hand == 0 && c.speed_rpm == 0) return out_.finding(move, driven_in());
    if (!std::isfinite(c.per_rev))
        return out_.unchecked(move.record, "how far the tap goes a revolution is not known: its pitch is not judged");
    if (tool().pitch) {
        if (auto f = wrong_pitch({c.per_rev, c.speed_rpm, c.hand != 0}, *tool().pitch))
            out_.finding(move, std::move(*f));
        return;
    }
    const double coarse = coarse_pitch(tool());
    if (std::abs(c.per_rev - coarse) <= pitch_tolerance * coarse)
        return out_.assumption("the pitch of the tap is not given: it is taken to be the one that is programmed",
                               move.record.from);
    out_.unchecked(move.record,
                   "the pitch of the tap is not given, and the programmed " + mm(c.per_rev) +
                       " a revolution is not that of the coarse thread of its diameter, " + mm(coarse) +
                       ": its thread is not judged",
                   "give pitch in its [[tool]]");
}

/// A tap is turned out of the thread that it has cut: coupled to the spindle, or at feed with the spindle reversed.
void AxisUse::judge_out(const Move& move, const sim::turning::Move& way) {
    if (std::isnan(bottom_)) return;
    const bool from_thread = std::abs(way.from.x - bottom_) < no_way;
    const double left = mouth_ - way.to.x;
    const Coupled in = in_;
    if (left > 0.5 * (mouth_ - bottom_))  // to break the chip
        bottom_ = way.to.x;
    else
        mouth_ = bottom_ = NAN;
    if (!from_thread) return;
    const int sense = motion::turning_sense(state_.spindle), cutting = tool().left_hand ? -1 : 1;
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    const bool positioned = thread != nullptr && thread->rigid_tap;  // the control reverses the spindle
    if (!move.rapid && (positioned || sense == -cutting)) {
        const Coupled out = coupled(move, way.to.x - way.from.x);
        if (thread == nullptr || in.hand == 0) return;
        if (auto f = comes_out_otherwise(out.per_rev, in.per_rev)) out_.finding(move, std::move(*f));
        return;
    }
    out_.finding(move, drawn_out(move.rapid, sense == 0 && !positioned));
}

void AxisUse::judge_rotation(const Move& move) {
    const int sense = motion::turning_sense(state_.spindle), wanted = tool().left_hand ? -1 : 1;
    if (sense != -wanted || sense == turned_wrong_) return;
    turned_wrong_ = sense;
    out_.finding(move, turns_wrong(sense, tool().left_hand, true));
}

void AxisUse::cut(const Move& move, const sim::turning::Move& way, const sim::turning::Cut& cut) {
    if (move.rapid || !(cut.area > setup_.tolerances.rapid)) return;
    if (tool().kind != shop::ToolKind::tap) judge_rotation(move);
    if (inwards(way) <= 0) return;
    const double blind = blind_radius(tool());
    if (!(blind > 0)) return;
    double met = 0;
    for (const geom::Region& piece : geom::pieces(cut.removed))
        if (box_of(piece).min_x < blind - narrower_by && geom::area(piece) > setup_.tolerances.rapid)
            met += geom::volume(piece);
    if (met > 0) out_.finding(move, plunges(tool().kind == shop::ToolKind::tap, met));
}

}  // namespace obrys::check
