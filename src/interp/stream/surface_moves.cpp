/// Moves on a cylinder or a face, as the axes make them.

#include <cmath>

#include "base/whole.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

using geom::Vec3;
using SurfaceKind = SurfaceMode::Kind;

namespace {

constexpr double chord = 0.001;  ///< mm between an arc on the cylinder and the straight ways that tell it

constexpr double at_axis = 1e-9;  ///< mm from the turning axis where C may be anything

double degrees(double radians) { return radians * 180 / geom::pi; }

}  // namespace

Vec3 turned_by(const Vec3& p, double by) {
    const double c = std::cos(geom::radians(by)), s = std::sin(geom::radians(by));
    return {by == 0 ? p.x : c * p.x - s * p.y, by == 0 ? p.y : s * p.x + c * p.y, p.z};
}

namespace {

/// By how far C turns on the straight way between two points of the plane, degrees.
double turn_between(const Vec3& a, const Vec3& b) {
    if (std::hypot(a.x, a.y) < at_axis || std::hypot(b.x, b.y) < at_axis) return 0;
    return degrees(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
}

double turn_on_arc(const Vec3& from, const cl::Arc& arc) {
    constexpr int steps = 90;
    double sum = 0;
    Vec3 before = from;
    for (int i = 1; i <= steps; ++i) {
        const double t = arc.sweep * (arc.normal.z < 0 ? -1 : 1) * i / steps;
        Vec3 p = arc.centre + turned_by(from - arc.centre, degrees(t));
        if (i == steps) p = arc.to;
        sum += turn_between(before, p);
        before = p;
    }
    return sum;
}

/// From the centre C stands where the way leads.
double after(const SurfaceMode& s, double turn, const Vec3& to) {
    if (std::hypot(s.at.x, s.at.y) >= at_axis || std::hypot(to.x, to.y) < at_axis) return s.angle + turn;
    const double wanted = s.start + degrees(std::atan2(to.y, to.x));
    return wanted + 360 * std::round((s.angle - wanted) / 360);
}

}  // namespace

void send_turned(Telling& run, cl::Record record, double angle, bool counted) {
    run.surface.angle = angle;
    cl::ends_of(record.step)->push_back(axis_end(turned_axis, angle, true, counted));
    run.sink(record);
}

namespace {

void send_polar(Telling& run, cl::Record record) {
    SurfaceMode& s = run.surface;
    double turn = 0;
    Vec3 to = s.at;
    if (auto* line = std::get_if<cl::Linear>(&record.step)) {
        to = line->to;
        turn = turn_between(s.at, to);
        line->to = turned_by(to, s.start);
    } else if (auto* arc = std::get_if<cl::Arc>(&record.step)) {
        to = arc->to;
        turn = turn_on_arc(s.at, *arc);
        arc->to = turned_by(to, s.start);
        arc->centre = turned_by(arc->centre, s.start);
    } else {
        return run.sink(record);
    }
    const double angle = after(s, turn, to);
    s.at = to;
    send_turned(run, std::move(record), angle, true);
}

/// A straight way on the unrolled cylinder.
void send_unrolled(Telling& run, const cl::Record& record, const Vec3& to, bool rapid) {
    run.surface.at = to;
    send_turned(run, {cl::Linear{{to.x, 0, to.z}, {0, 0, 1}, rapid}, record.from, record.stack},
                degrees(to.y / run.surface.radius), false);
}

void send_cylinder(Telling& run, const cl::Record& record) {
    if (const auto* line = std::get_if<cl::Linear>(&record.step))
        return send_unrolled(run, record, line->to, line->rapid);
    const auto* arc = std::get_if<cl::Arc>(&record.step);
    if (arc == nullptr) return run.sink(record);
    assume(run, run.here(), "an arc on the cylinder is told in straight ways, 0.001 mm off at most");
    const Vec3 from = run.surface.at;
    const double y = from.y - arc->centre.y, z = from.z - arc->centre.z, radius = std::hypot(y, z);
    const double most = radius > chord ? 2 * std::acos(1 - chord / radius) : geom::pi / 2;
    const int steps = base::clipped<int>(std::ceil(std::abs(arc->sweep) / most), 1, 100'000);
    const double sense = arc->normal.x < 0 ? -1 : 1;
    for (int i = 1; i < steps; ++i) {
        const double part = static_cast<double>(i) / steps, t = sense * arc->sweep * part;
        const Vec3 p{from.x + (arc->to.x - from.x) * part, arc->centre.y + y * std::cos(t) - z * std::sin(t),
                     arc->centre.z + y * std::sin(t) + z * std::cos(t)};
        send_unrolled(run, record, p, false);
    }
    send_unrolled(run, record, arc->to, false);
}

}  // namespace

void send_on_surface(Telling& run, const cl::Record& record) {
    run.surface.kind == SurfaceKind::polar ? send_polar(run, record) : send_cylinder(run, record);
}

}  // namespace obrys::interp
