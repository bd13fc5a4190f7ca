/// The path: blocks and the places between them.

#include <algorithm>
#include <cmath>

#include "cl/spline.hpp"
#include "cl/totals.hpp"
#include "motion/technology.hpp"
#include "sim/time/timer.hpp"

namespace obrys::sim::time {
namespace {

constexpr double curve_turn = geom::radians(20.0);  ///< more is a corner, however short its neighbours are
constexpr double coarsest_chord = 0.1;              ///< mm: what is wider is meant, not the rest of a curve

/// How much of the way each axis may have at some place of an arc.
geom::Vec3 reach_of(const cl::Arc& a, const geom::Vec3& way) {
    const auto across = [](double n) { return std::sqrt(std::max(0.0, 1 - n * n)); };
    const bool rises = std::abs(dot(way, a.normal)) > 0;
    return rises ? geom::Vec3{1, 1, 1} : geom::Vec3{across(a.normal.x), across(a.normal.y), across(a.normal.z)};
}

bool known(const geom::Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double turn_between(const geom::Vec3& a, const geom::Vec3& b) {
    if (!known(a) || !known(b) || a == geom::Vec3{} || b == geom::Vec3{}) return geom::pi;
    return std::atan2(length(cross(a, b)), dot(a, b));
}

}  // namespace

double curvature_of(const cl::Step& step, double length) {
    const auto* a = std::get_if<cl::Arc>(&step);
    if (a == nullptr) return 0;
    const geom::Vec3 spoke = a->to - a->centre;
    const geom::Vec3 across = spoke - dot(spoke, a->normal) * a->normal;
    // Of a helix: what lies across its axis is all that bends.
    return length > 0 ? geom::length(across) * a->sweep * a->sweep / (length * length) : 0;
}

void Timer::add(const motion::Step& step, double length, const geom::Vec3& from, const geom::Vec3& to, double curvature,
                const Turns& turns) {
    // Coordinates that nobody knows do not move.
    geom::Vec3 way = to - from;
    for (std::size_t i = 0; i < 3; ++i)
        if (double& part = i == 0 ? way.x : i == 1 ? way.y : way.z; std::isnan(part)) part = 0;
    const bool straight = curvature == 0;
    const geom::Vec3 direction = straight ? (1 / geom::length(way)) * way : geom::Vec3{};
    WayLimits own = along(dynamics_, straight ? direction : reach_of(std::get<cl::Arc>(step.record.step), way));
    Piece piece;
    piece.place = {step.record.from.file, step.record.from.begin};
    piece.tool = step.state.change.number;
    piece.asked = piece.most = step.rapid ? Cause::rapid : Cause::feed;
    piece.fed = step.rapid
                    ? own.speed
                    : dynamics_.feed_override * length / motion::feed_seconds(step, length, dynamics_.highest_speed);
    if (!(piece.fed > 0)) return untimed(step);
    // The spindle of a rigid tap starts and stands with the axis.
    if (const auto* thread = std::get_if<cl::Thread>(&step.record.step);
        thread != nullptr && thread->rigid_tap && dynamics_.spindle_time > 0)
        own.limits.acceleration =
            std::min(own.limits.acceleration, std::abs(thread->pitch) * 1000 / 60 / dynamics_.spindle_time);
    Block block{length, piece.fed, own.limits, INFINITY};
    const double axes = step.rapid ? own.speed : std::min(own.speed, dynamics_.most_feed);
    if (axes < block.speed) block.speed = axes, piece.most = Cause::axis_speed;
    // Additional axes go along, and may be slower than the path.
    for (const auto& [limits, turned] : turns.ways)
        if (const double speed = limits->speed * length / turned; speed < block.speed)
            block.speed = speed, piece.most = Cause::axis_speed;
    const CornerSpeed bent = curve_speed(curvature, block.speed, own.limits);
    if (bent.by != CornerLimit::none) block.speed = bent.speed, piece.most = Cause::curvature;
    if (dynamics_.block_time > 0 && length / dynamics_.block_time < block.speed)
        block.speed = length / dynamics_.block_time, piece.most = Cause::block_rate;
    join(straight ? direction : cl::first_direction(step.from, step.record.step), length, step);
    piece.leaves = straight ? direction : cl::last_direction(step.from, step.record.step);
    piece.sharpness = straight ? length : 0;
    blocks_.push_back(block);
    pieces_.push_back(piece);
    wait(block);
}

double Timer::tolerance_at(const motion::Step& step) const {
    const cl::PathMode* path = step.state.path ? &*step.state.path : nullptr;
    const double said = step.state.tolerance.contour > 0         ? step.state.tolerance.contour
                        : path != nullptr && path->tolerance > 0 ? path->tolerance
                                                                 : 0;
    return options_.contour_tolerance.value_or(said > 0 ? said : dynamics_.tolerance);
}

/// Turns are exact stops: the program asks for it, or the machine makes them so unless the program asks for a
/// tolerance.
bool Timer::is_exact(const motion::Step& step) const {
    const cl::PathMode* path = step.state.path ? &*step.state.path : nullptr;
    if (path != nullptr && (path->kind == cl::PathKind::exact || path->kind == cl::PathKind::exact_stop)) return true;
    return dynamics_.corner == CornerMode::exact_stop && path == nullptr && !(step.state.tolerance.contour > 0);
}

ToleranceUse& Timer::use_of(double tolerance, const motion::Step& step) {
    if (use_ < tolerances_.size() && tolerances_[use_].tolerance == tolerance) return tolerances_[use_];
    for (use_ = 0; use_ < tolerances_.size(); ++use_)
        if (tolerances_[use_].tolerance == tolerance) return tolerances_[use_];
    const bool said = step.state.tolerance.contour > 0 || (step.state.path && step.state.path->tolerance > 0);
    return tolerances_.emplace_back(ToleranceUse{tolerance, said, step.record.from});
}

/// How fast the last block may end where a move of this direction follows.
void Timer::join(const geom::Vec3& direction, double length, const motion::Step& step) {
    if (blocks_.empty()) return;
    Block& last = blocks_.back();
    Piece& piece = pieces_.back();
    const double turn = turn_between(piece.leaves, direction);
    piece.end = Cause::acceleration;
    if (turn < 1e-6) return;  // straight on
    const double tolerance = tolerance_at(step);
    const double before = piece.sharpness, mean = (before + length) / 2, chord_error = turn * mean / 8;
    ToleranceUse& use = use_of(tolerance, step);
    const bool bends = before > 0 && turn < curve_turn;
    if (bends && chord_error <= coarsest_chord)
        use.take(chord_error);
    else
        ++use.corners;
    CornerSpeed corner{last.speed, CornerLimit::none};
    if (is_exact(step)) {
        corner = {0, CornerLimit::stop};
        piece.end = Cause::exact_stop;
    } else if (bends && chord_error <= tolerance) {
        corner = curve_speed(turn / mean, last.speed, last.limits);
        if (corner.by != CornerLimit::none) piece.end = Cause::curvature;
    } else {
        const double shorter = std::min(before > 0 ? before : length, length);
        corner = dynamics_.corner == CornerMode::blend
                     ? blended_corner(turn, tolerance, shorter, last.speed, last.limits)
                     : filtered_corner(turn, tolerance, last.speed, last.limits);
        if (corner.by != CornerLimit::none) piece.end = Cause::corner;
    }
    last.end_speed = std::min(last.end_speed, corner.speed);
}

}  // namespace obrys::sim::time
