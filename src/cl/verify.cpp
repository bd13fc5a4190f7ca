#include "cl/verify.hpp"

#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "cl/spline.hpp"
#include "cl/totals.hpp"
#include "cl/zero.hpp"

namespace obrys::cl {

namespace {

constexpr double unit_tolerance = 1e-9;   ///< of the length of a unit vector
constexpr double place_tolerance = 1e-6;  ///< mm between the tool and the place of a cycle
constexpr double angle_tolerance = 1e-6;  ///< radians the sweep may differ from the end point's angle

bool is_unit(geom::Vec3 v) { return std::abs(geom::length(v) - 1) <= unit_tolerance; }
bool infinite(geom::Vec3 v) { return std::isinf(v.x) || std::isinf(v.y) || std::isinf(v.z); }
geom::Vec3 in_plane(geom::Vec3 v, geom::Vec3 normal) { return v - geom::dot(v, normal) * normal; }

}  // namespace

void Verifier::complain(const Record& record, std::string_view code, std::string text) {
    base::Diagnostic d{base::Severity::error, code, record.from, std::move(text), "", {}, {}};
    if (stacks_ != nullptr) d.stack = stacks_->sites(record.stack);
    diagnostics_.add(std::move(d));
}

void Verifier::operator()(const Record& record) {
    if (const AxisEnds* ends = ends_of(record.step)) check(record, *ends);
    std::visit([&](const auto& step) { check(record, step); }, record.step);
    position_ = position_after(position_, record.step);
}

void Verifier::finish() {
    for (const Record& r : open_)
        complain(r, base::codes::unclosed, "cycle " + std::get<CycleBegin>(r.step).cycle->name + " has no end");
    for (const Record& r : parts_)
        complain(r, base::codes::unclosed, "the part \"" + std::get<PartBegin>(r.step).name + "\" has no end");
    if (compensation_) complain(*compensation_, base::codes::unclosed, "radius compensation has no end");
    if (lead_) complain(*lead_, base::codes::unclosed, "a way onto a contour or off it has no end");
    open_.clear();
    parts_.clear();
    compensation_.reset();
    lead_.reset();
}

void Verifier::check(const Record& r, const Linear& s) {
    if (infinite(s.to)) complain(r, base::codes::value_range, "end point is not finite");
    if (!is_unit(s.axis)) complain(r, base::codes::value_range, "tool axis is not a unit vector");
    if (s.rapid && s.seek != Seek::nothing) complain(r, base::codes::value_range, "a probe does not move at rapid");
}

void Verifier::check(const Record& r, const Arc& s) {
    if (infinite(s.to) || infinite(s.centre) || !std::isfinite(s.sweep))
        return complain(r, base::codes::value_range, "arc with a value that is not finite");
    if (!is_unit(s.normal)) return complain(r, base::codes::value_range, "normal of the arc is not a unit vector");
    if (!is_unit(s.axis)) complain(r, base::codes::value_range, "tool axis is not a unit vector");
    if (s.sweep == 0) return complain(r, base::codes::value_range, "arc without sweep");
    if (!is_finite(position_) || !is_finite(s.to) || !is_finite(s.centre)) return;
    const geom::Vec3 a = in_plane(position_ - s.centre, s.normal), b = in_plane(s.to - s.centre, s.normal);
    const double difference = std::abs(geom::length(a) - geom::length(b));
    if (difference > options_.circle_tolerance)
        return complain(r, base::codes::arc_radius,
                        "radius at the start " + base::fixed(geom::length(a), 4) + " mm, at the end " +
                            base::fixed(geom::length(b), 4) + " mm: they differ by " + base::fixed(difference, 4) +
                            " mm");
    // The angle from start to end must be the sweep but for whole turns; radii within tolerance allow as much off.
    const double angle = std::atan2(geom::dot(geom::cross(a, b), s.normal), geom::dot(a, b));
    const double off = std::remainder(angle - s.sweep, 2 * geom::pi);
    const double radius = geom::length(a);
    if (std::abs(off) > angle_tolerance && std::abs(off) * radius > options_.circle_tolerance)
        complain(r, base::codes::arc_radius,
                 "the sweep of " + base::fixed(geom::degrees(s.sweep), 4) + " degrees ends " +
                     base::fixed(std::abs(off) * radius, 4) + " mm off the end point");
}

void Verifier::check(const Record& r, const Spline& s) {
    if (infinite(s.to) || infinite(s.k1) || infinite(s.k2) || infinite(s.k3))
        return complain(r, base::codes::value_range, "spline with a value that is not finite");
    if (!is_unit(s.axis)) complain(r, base::codes::value_range, "tool axis is not a unit vector");
    if (s.axes.size() > 2) complain(r, base::codes::value_range, "spline with more than two additional axes");
    for (const SplineAxis& a : s.axes) {
        if (a.name[0] == 0) complain(r, base::codes::value_range, "axis without a name");
        if (std::isinf(a.to) || std::isinf(a.k1) || std::isinf(a.k2) || std::isinf(a.k3))
            complain(r, base::codes::value_range, "spline with a value that is not finite");
    }
    const double gap = geom::length(start_gap(position_, s));
    if (gap > options_.spline_tolerance)
        complain(r, base::codes::spline_start,
                 "the spline starts " + base::fixed(gap, 4) + " mm beside the end of the last move");
}

void Verifier::check(const Record& r, const AxisEnds& ends) {
    for (const AxisEnd& end : ends) {
        if (end.name[0] == 0) complain(r, base::codes::value_range, "axis without a name");
        if (std::isinf(end.to)) complain(r, base::codes::value_range, "axis position is not finite");
    }
}

void Verifier::check(const Record& r, const Thread& s) {
    if (infinite(s.to)) complain(r, base::codes::value_range, "end point is not finite");
    if (!is_unit(s.axis)) complain(r, base::codes::value_range, "tool axis is not a unit vector");
    if (std::isinf(s.pitch) || s.pitch == 0) complain(r, base::codes::value_range, "thread without pitch");
    if (std::isinf(s.start) || std::isinf(s.change))
        complain(r, base::codes::value_range, "start or change of pitch of a thread is not finite");
}

void Verifier::check(const Record& r, const Output& s) {
    if (std::isinf(s.value) || (!s.analog && s.value != 0 && s.value != 1 && !std::isnan(s.value)))
        complain(r, base::codes::value_range, "a digital output is 0 or 1, an analog one finite");
}

void Verifier::check(const Record& r, const Dwell& s) {
    if (!(s.seconds >= 0) || !(s.revolutions >= 0) || std::isinf(s.seconds) || std::isinf(s.revolutions))
        complain(r, base::codes::value_range, "dwell must be a finite time or number of revolutions, not negative");
}

void Verifier::check(const Record& r, const Feed& s) {
    if (s.value < 0 || std::isinf(s.value))
        complain(r, base::codes::value_range, "feed must be finite and not negative");
}

void Verifier::check(const Record& r, const Spindle& s) {
    if (s.speed < 0 || std::isinf(s.speed))
        complain(r, base::codes::value_range,
                 "spindle speed must be finite and not negative; the direction is a field of its own");
    if (!(s.limit >= 0) || std::isinf(s.limit))
        complain(r, base::codes::value_range, "spindle speed limit must be finite and not negative");
    if (s.direction < -1 || s.direction > 1)
        complain(r, base::codes::value_range, "spindle direction must be -1, 0 or 1");
    if (s.held && s.direction != 0)
        complain(r, base::codes::value_range, "a spindle that turns is not held at an angle");
    if (s.held && std::isinf(*s.held)) complain(r, base::codes::value_range, "the spindle's angle is not finite");
}

void Verifier::check(const Record& r, const OtherSpindle& s) {
    if (s.speed.value_or(0) < 0 || std::isinf(s.speed.value_or(0)) || s.limit.value_or(0) < 0 ||
        std::isinf(s.limit.value_or(0)))
        complain(r, base::codes::value_range, "speeds of a spindle must be finite and not negative");
    if (std::abs(s.direction.value_or(0)) > 1)
        complain(r, base::codes::value_range, "spindle direction must be -1, 0 or 1");
    if (std::isinf(s.held.value_or(0))) complain(r, base::codes::value_range, "the spindle's angle is not finite");
}

void Verifier::check(const Record& r, const Datum& s) {
    if (infinite(s.origin)) complain(r, base::codes::value_range, "zero offset is not finite");
    change(zero_, s, position_);
}

void Verifier::check(const Record& r, const Frame& s) {
    for (const FramePart& p : s.parts) {
        const auto& l = p.frame.linear;
        if (infinite(p.frame.origin) || std::any_of(l.begin(), l.end(), [](double v) { return std::isinf(v); }))
            return complain(r, base::codes::value_range, "a frame is not finite");
        if (determinant(p.frame) == 0) return complain(r, base::codes::value_range, "a frame has no inverse");
    }
}

void Verifier::check(const Record& r, const Tolerance& s) {
    if (!(s.contour >= 0) || !(s.rotary >= 0) || std::isinf(s.contour) || std::isinf(s.rotary))
        complain(r, base::codes::value_range, "tolerance must be finite and not negative");
}

void Verifier::check(const Record& r, const CycleBegin& s) {
    const Cycle& c = *s.cycle;
    open_.push_back(r);
    if (s.pass == 0 || s.pass > s.passes)
        complain(r, base::codes::value_range,
                 "place " + std::to_string(s.pass) + " of " + std::to_string(s.passes) + " is none");
    if (geom::distance(position_, s.place) > place_tolerance)  // false where either is not known
        complain(r, base::codes::value_range,
                 "cycle " + c.name + " begins " + base::fixed(geom::distance(position_, s.place), 4) +
                     " mm beside the tool");
    if (!is_invertible(c.plane)) complain(r, base::codes::value_range, "the plane of a cycle has no inverse");
    for (auto v = c.values.begin(); v != c.values.end(); ++v) {
        const bool twice =
            std::any_of(c.values.begin(), v, [&](const CycleValue& other) { return other.role == v->role; });
        const bool feed = v->role == CycleRole::feed_position || v->role == CycleRole::feed_retract;
        if (twice) complain(r, base::codes::value_range, "a cycle says " + std::string(spelling(v->role)) + " twice");
        if (std::isinf(v->value) && !(feed && v->value > 0))
            complain(r, base::codes::value_range, std::string(spelling(v->role)) + " of a cycle is not finite");
    }
}

void Verifier::check(const Record& r, const CycleEnd&) {
    if (open_.empty()) return complain(r, base::codes::unclosed, "end of a cycle that was not begun");
    open_.pop_back();
}

void Verifier::check(const Record& r, const PartBegin& s) {
    if (s.pass == 0 || s.pass > s.passes)
        complain(r, base::codes::value_range,
                 "pass " + std::to_string(s.pass) + " of " + std::to_string(s.passes) + " is none");
    parts_.push_back(r);
}

void Verifier::check(const Record& r, const PartEnd&) {
    if (parts_.empty()) return complain(r, base::codes::unclosed, "end of a part that was not begun");
    parts_.pop_back();
}

void Verifier::check(const Record& r, const CompensationBegin& s) {
    if (compensation_) complain(r, base::codes::unclosed, "radius compensation begins while another one is in force");
    if (std::isinf(s.radius)) complain(r, base::codes::value_range, "the radius of a compensation is not finite");
    if (!is_unit(s.normal))
        complain(r, base::codes::value_range, "normal of a compensation's plane is not a unit vector");
    compensation_ = r;
}

void Verifier::check(const Record& r, const CompensationEnd&) {
    if (!compensation_) complain(r, base::codes::unclosed, "end of a radius compensation that was not begun");
    compensation_.reset();
}

void Verifier::check(const Record& r, const Programmed& s) {
    if (infinite(s.from) || infinite(s.to) || infinite(s.centre) || !std::isfinite(s.sweep))
        return complain(r, base::codes::value_range, "programmed element with a value that is not finite");
    if (s.sweep != 0 && !is_unit(s.normal))
        complain(r, base::codes::value_range, "normal of a programmed arc is not a unit vector");
    if (s.corner != Corner::none && !std::isfinite(s.size))
        complain(r, base::codes::value_range, "size of a chamfer or rounding is not finite");
}

void Verifier::check(const Record& r, const ToolLength& s) {
    if (s.sense < -1 || s.sense > 1) complain(r, base::codes::value_range, "a length is added, subtracted or off");
    if (s.by && infinite(*s.by)) complain(r, base::codes::value_range, "a length that is not finite");
}

void Verifier::check(const Record& r, const MachinePlace& s) {
    if (!s.axes[0] && !s.axes[1] && !s.axes[2])
        complain(r, base::codes::value_range, "a place of the machine along no axis");
    if (infinite(s.to)) complain(r, base::codes::value_range, "a place of the machine that is not finite");
}

void Verifier::check(const Record& r, const PathMode& s) {
    if (s.tolerance < 0 || s.merge < 0 || std::isinf(s.tolerance) || std::isinf(s.merge))
        complain(r, base::codes::value_range, "tolerances of the path must be finite and not negative");
}

void Verifier::check(const Record& r, const ToolData& s) {
    if (std::isinf(s.length.value_or(0)) || std::isinf(s.radius.value_or(0)))
        complain(r, base::codes::value_range, "length or radius of a tool is not finite");
}

void Verifier::check(const Record& r, const DatumData& s) {
    if (infinite(s.origin) || std::isinf(s.turn.value_or(0)))
        complain(r, base::codes::value_range, "the place of a zero is not finite");
}

void Verifier::check(const Record& r, const LeadBegin& s) {
    if (lead_) complain(r, base::codes::unclosed, "a way onto a contour or off it begins within another one");
    if (infinite(s.at) || !std::isfinite(s.length) || !std::isfinite(s.radius) || !std::isfinite(s.angle))
        complain(r, base::codes::value_range, "a way onto a contour or off it with a value that is not finite");
    lead_ = r;
}

void Verifier::check(const Record& r, const LeadEnd&) {
    if (!lead_) complain(r, base::codes::unclosed, "end of a way onto a contour or off it that was not begun");
    lead_.reset();
}

void Verifier::check(const Record&, const Stop& s) {
    if (s.kind == StopKind::end) parts_.clear();
}

}  // namespace obrys::cl
