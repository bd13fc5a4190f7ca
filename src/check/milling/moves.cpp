/// What is kept of milling moves: their way for pictures, feed, speed and time.

#include <algorithm>
#include <cmath>

#include "check/milling/milling.hpp"
#include "check/milling_tool.hpp"
#include "check/trace.hpp"
#include "cl/path_element.hpp"
#include "cl/spline.hpp"
#include "motion/technology.hpp"

namespace obrys::check {

/// Chained to the move before; a gap between them (moves that were left out) is a point that is not known.
void Milling::keep_points(const Move& move, MilledMove& m) {
    if (moves_.size() >= setup_.milling->keep_moves) return;
    const bool begins = points_.empty() || geom::distance(points_.back(), move.from) > 1e-6;
    if (begins && !points_.empty()) points_.push_back({NAN, NAN, NAN});
    if (begins) points_.push_back(move.from);
    cl::points_between(move.from, move.record.step, drawn_chord, drawn_chords,
                       [this](geom::Vec3 p) { points_.push_back(p); });
    points_.push_back(move.to);
    m.points_end = static_cast<std::uint32_t>(points_.size());
    ++moves_with_points_;
}

/// Where a tap has been, the part may show the thread by any of its diameters.
void Milling::keep_thread(const Move& move) {
    if (tool_ == nullptr || shop::assumed_kind(*tool_) != shop::ToolKind::tap || move.rapid) return;
    const geom::Vec3 way = move.to - move.from;
    const double along = std::abs(geom::dot(way, axis_));
    if (!(along > 0) || geom::length(way) - along > 1e-9 * along) return;
    thread_bands_.add(move.from, move.to, axis_,
                      {core_radius(*tool_), tool_->radius + tool_->delta_radius, widest_hole_radius(*tool_)});
}

namespace {

/// 1/min; not known under constant cutting speed, which has no meaning for tools that turn.
double speed_of(const cl::Spindle& spindle) { return spindle.mode == cl::SpindleMode::rpm ? spindle.speed : NAN; }

}  // namespace

/// At the programmed feed; rapids in straight lines at the slowest axis' rapid.
double Milling::seconds_of(const Move& move, double way) const {
    return move.rapid ? motion::rapid_seconds(setup_.machine, way)
                      : motion::feed_seconds(state_.feed, way, speed_of(state_.spindle));
}

/// What chip thickness follows from.
void Milling::keep_technology(const Move& move, double way, MilledMove& m) const {
    m.sinking = way > 0 ? std::clamp(-geom::dot(move.to - move.from, axis_) / way, -1.0, 1.0) : 0;
    m.spindle = static_cast<std::int8_t>(motion::turning_sense(state_.spindle));
    m.speed_rpm = m.spindle == 0 ? 0 : speed_of(state_.spindle);
    if (move.rapid) return;
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    if (thread != nullptr) m.thread = thread->pitch < 0 ? -1 : 1;
    if (thread != nullptr)
        m.feed_per_rev_mm = std::abs(thread->pitch);
    else if (state_.feed.mode == cl::FeedMode::per_rev)
        m.feed_per_rev_mm = state_.feed.value > 0 ? state_.feed.value : NAN;
    else if (way > 0)
        m.feed_mm_per_min = 60 * way / m.seconds;
    if (std::isnan(m.feed_mm_per_min))
        m.feed_mm_per_min = m.feed_per_rev_mm * m.speed_rpm;
    else if (m.speed_rpm > 0)
        m.feed_per_rev_mm = m.feed_mm_per_min / m.speed_rpm;
}

}  // namespace obrys::check
