/// Whether a tool is used as it cuts: with the spindle's sense, along its axis, a tap with its pitch.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "check/limits/feed_mode.hpp"
#include "check/milling/milling.hpp"
#include "check/milling_tool.hpp"
#include "check/use_findings.hpp"
#include "check/words.hpp"
#include "motion/technology.hpp"

namespace obrys::check {

namespace codes = base::codes;
using shop::ToolKind;

namespace {

std::string_view word_of(ToolKind kind) {
    return kind == ToolKind::drill ? "drill" : kind == ToolKind::tap ? "tap" : "reamer";
}

}  // namespace

/// A way coupled to the spindle as for a tap, down into a hole, with a tool that cuts no thread so. Said once a tool.
void Milling::judge_no_tap(const Move& move, const MilledMove& milled) {
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    if (thread != nullptr && thread->rigid_tap) say_no_tap(milled);
}

/// A cycle that reverses the spindle where it has fed down is one of tapping.
void Milling::judge_reversal(const cl::Spindle& before) {
    if (!is_placed(cycle_)) return;
    const int was = motion::turning_sense(before), now = motion::turning_sense(state_.spindle);
    if (was != 0) cycle_sense_ = was;
    if (now != 0 && now == -cycle_sense_ && !moves_.empty() && !moves_.back().rapid) say_no_tap(moves_.back());
}

void Milling::say_no_tap(const MilledMove& milled) {
    if (tool_ == nullptr || !(milled.sinking > along_axis) || no_tap_ == milled.tool) return;
    if (!shop::is_milling(tool_->kind) || tool_->kind == ToolKind::tap || tool_->kind == ToolKind::form) return;
    no_tap_ = milled.tool;
    found(milled, is_no_tap(milled.feed_per_rev_mm));
}

/// The core of a tap goes through a hole made before and may meet nothing: what it does is judged where it goes along
/// its axis within the stock's box.
void Milling::judge_tapping(const Move& move, const MilledMove& milled) {
    judge_no_tap(move, milled);
    if (tool_ == nullptr || tool_->kind != ToolKind::tap || std::abs(milled.sinking) < along_axis) return;
    const sim::milling::Box3 box = sim::milling::box_of(setup_.milling->stock);
    const auto passes = [&](double geom::Vec3::*k) {
        const double beside = tool_->radius * std::sqrt(std::max(0.0, 1 - axis_.*k * (axis_.*k)));
        return std::max(move.from.*k, move.to.*k) + beside <= box.min.*k ||
               std::min(move.from.*k, move.to.*k) - beside >= box.max.*k;
    };
    if (passes(&geom::Vec3::x) || passes(&geom::Vec3::y) || passes(&geom::Vec3::z)) return;
    judge_tap(move, milled, *tool_);
    judge_rotation(milled, *tool_);
    if (!(milled.sinking > 0)) return;
    tap_bottom_ = move.to;
    tap_way_ = milled.thread != 0 ? milled.feed_per_rev_mm : NAN;
    tap_sense_ = milled.thread;
    if (!tap_mouth_) tap_mouth_ = move.from;
}

/// Where a way out has ended: a tap that came out a little only, as to break the chip, is in its thread still.
void Milling::keep_in_thread(const Move& move) {
    const double deep = geom::dot(*tap_mouth_ - move.from, axis_), left = geom::dot(*tap_mouth_ - move.to, axis_);
    if (left > 0.5 * deep)
        tap_bottom_ = move.to;
    else
        tap_mouth_.reset();
}

/// Coupled to the spindle a tap comes out as it went in.
void Milling::judge_pitch_out(const MilledMove& milled) {
    if (auto f = comes_out_otherwise(milled.feed_per_rev_mm, tap_way_)) found(milled, std::move(*f));
}

/// A tap is turned out of the thread that it has cut: coupled to the spindle, or at feed with the spindle reversed.
void Milling::judge_tap_out(const Move& move, const MilledMove& milled) {
    constexpr double same = 1e-6;  // mm
    if (!tap_bottom_ || !(milled.sinking < 0)) return;
    const bool from_thread = geom::length(move.from - *tap_bottom_) < same;
    tap_bottom_.reset();
    const bool tap = tool_ != nullptr && tool_->kind == ToolKind::tap;
    if (!from_thread || !tap) return tap_mouth_.reset();
    keep_in_thread(move);
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    const bool positioned = thread != nullptr && thread->rigid_tap;  // the pitch's sign says how the spindle turns
    const bool reversed =
        positioned ? tap_sense_ == 0 || milled.thread == tap_sense_ : milled.spindle == (tool_->left_hand ? 1 : -1);
    if (!move.rapid && reversed && thread != nullptr) return judge_pitch_out(milled);
    if (!move.rapid && reversed) return;
    found(milled, drawn_out(move.rapid, milled.spindle == 0 && !positioned));
}

/// A feed move that has met material for the first time.
void Milling::judge_use(const MilledMove& move) {
    if (move.tool == 0) return;
    const auto listed = out_.result().tools[move.tool - 1].listed;
    if (!listed) return;
    const shop::Tool& tool = setup_.tools[*listed];
    const bool sideways = std::abs(move.sinking) <= along_axis;
    if (tool.kind == ToolKind::tap && !sideways) return;  // judge_tapping
    judge_rotation(move, tool);
    judge_feed(move, tool);
    if (!cuts_along_axis_only(tool.kind) || !sideways) return;
    Finding f;
    f.code = codes::sideways_cut;
    f.text = "the " + std::string(word_of(tool.kind)) + " is moved sideways in the material";
    f.remedy = "move it along its axis only, or take a mill";
    found(move, std::move(f));
}

/// Said again when the feed has changed.
void Milling::judge_feed(const MilledMove& move, const shop::Tool& tool) {
    if (move.thread != 0 || !shop::is_milling(shop::assumed_kind(tool)) || move.feed_mm_per_min == slow_feed_) return;
    auto f = too_slow(move.feed_mm_per_min, move.feed_per_rev_mm, finest_milled);
    if (!f) f = too_fast(move.feed_per_rev_mm, widest_feed(&tool, shop::MachineKind::mill));
    if (!f) return;
    slow_feed_ = move.feed_mm_per_min;
    found(move, std::move(*f));
}

void Milling::judge_rotation(const MilledMove& move, const shop::Tool& tool) {
    const bool backs_out = tool.kind == ToolKind::tap && move.sinking < 0;
    const int wanted = tool.left_hand ? -1 : 1;
    if (shop::is_milling(shop::assumed_kind(tool)) && !backs_out && move.spindle == -wanted && move.thread == 0 &&
        turned_wrong_ != std::pair{move.tool, move.spindle}) {
        turned_wrong_ = {move.tool, move.spindle};
        found(move, turns_wrong(move.spindle, tool.left_hand, false));
    }
}

/// A tap is driven in that does not turn: its core meets nothing that would tell.
void Milling::judge_driven_in(const MilledMove& move) {
    if (!stopped_reported_) found(move, driven_in());
    stopped_reported_ = true;
}

/// A tap whose pitch nobody gives has that of the coarse thread, or it is not known which thread it cuts.
void Milling::judge_pitch_not_given(const Move& at, const MilledMove& move, const shop::Tool& tool) {
    const double coarse = coarse_pitch(tool), way = move.feed_per_rev_mm;
    if (std::abs(way - coarse) <= pitch_tolerance * coarse)
        return out_.assumption("the pitch of the tap is not given: it is taken to be the one that is programmed",
                               move.where);
    out_.unchecked(at.record,
                   "the pitch of the tap is not given, and the programmed " + mm(way) +
                       " a revolution is not that of the coarse thread of its diameter, " + mm(coarse) +
                       ": its thread is not judged",
                   "give pitch in its [[tool]]");
}

void Milling::judge_tap(const Move& at, const MilledMove& move, const shop::Tool& tool) {
    if (move.thread != 0 && (move.thread < 0) != tool.left_hand && move.sinking > 0)
        found(move, cuts_other_hand(move.thread < 0, tool.left_hand));
    if (move.sinking < along_axis) return;
    const double way = move.feed_per_rev_mm;
    if (move.thread == 0 && (move.spindle == 0 || move.speed_rpm == 0)) return judge_driven_in(move);
    if (!std::isfinite(way))
        return out_.unchecked(at.record, "how far the tap goes a revolution is not known: its pitch is not judged");
    if (!tool.pitch) return judge_pitch_not_given(at, move, tool);
    if (auto f = wrong_pitch({way, move.speed_rpm, move.thread != 0}, *tool.pitch)) found(move, std::move(*f));
}

}  // namespace obrys::check
