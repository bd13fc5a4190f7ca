/// Polar (G12.1) and cylindrical (G7.1) interpolation: the program moves in a plane which linear and rotary axis make
/// together. In the stream polar interpolation is the path on the workpiece with C counted, cylindrical interpolation
/// the points of the machine with C beside them (docs/cl-stream.md, Axis).
/// Source: FANUC series 16/18-C operator's manual B-62764EN/01, page 51; 15i-MA B-63324EN/03, pages 60 and 66.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/motion.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec3;
using SurfaceKind = SurfaceMode::Kind;

namespace {

constexpr double chord = 0.001;   ///< mm between an arc on the cylinder and the straight ways that tell it
constexpr double at_axis = 1e-9;  ///< mm from the turning axis where C may be anything
constexpr const char* turned_axis = "C";

double degrees(double radians) { return radians * 180 / geom::pi; }

Vec3 turned(const Vec3& p, double by) {
    const double c = std::cos(geom::radians(by)), s = std::sin(geom::radians(by));
    return {by == 0 ? p.x : c * p.x - s * p.y, by == 0 ? p.y : s * p.x + c * p.y, p.z};
}

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
        Vec3 p = arc.centre + turned(from - arc.centre, degrees(t));
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

void tell_axis(Telling& run, const cl::Record& record, double angle, bool counted) {
    run.surface.angle = angle;
    run.sink({axis_record(turned_axis, angle, true, counted), record.from, record.stack});
}

void send_polar(Telling& run, cl::Record record) {
    SurfaceMode& s = run.surface;
    double turn = 0;
    Vec3 to = s.at;
    if (auto* line = std::get_if<cl::Linear>(&record.step)) {
        to = line->to;
        turn = turn_between(s.at, to);
        line->to = turned(to, s.start);
    } else if (auto* arc = std::get_if<cl::Arc>(&record.step)) {
        to = arc->to;
        turn = turn_on_arc(s.at, *arc);
        arc->to = turned(to, s.start);
        arc->centre = turned(arc->centre, s.start);
    } else {
        return run.sink(record);
    }
    tell_axis(run, record, after(s, turn, to), true);
    s.at = to;
    run.sink(record);
}

/// A straight way on the unrolled cylinder.
void send_unrolled(Telling& run, const cl::Record& record, const Vec3& to, bool rapid) {
    tell_axis(run, record, degrees(to.y / run.surface.radius), false);
    run.surface.at = to;
    run.sink({cl::Linear{{to.x, 0, to.z}, {0, 0, 1}, rapid}, record.from, record.stack});
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

/// Where C stands; said where that is not known.
double begin_angle(Reckoning& run) {
    const auto at = run.extra_axes.find(turned_axis);
    if (at != run.extra_axes.end() && !std::isnan(at->second)) return at->second;
    unchecked(run, codes::unknown_value, run.here(),
              "where C stands when the interpolation is switched on is not known: C0 is taken",
              "position C before it (G0 C0)");
    return 0;
}

bool compensates(Reckoning& run, const char* when) {
    if (run.modal.compensation == Modal::compensation_off) return false;
    alarm(run, codes::compensation, run.here(),
          std::string("polar or cylindrical interpolation is switched ") + when + " while radius compensation is on",
          "write G40 before it");
    return true;
}

/// The place where the tool stands, told anew.
void tell_place(Telling& run, bool counted) {
    SurfaceMode& s = run.surface;
    const cl::Record here{cl::Linear{turned(run.position, counted ? s.start : 0), {0, 0, 1}, true}, run.here(),
                          run.top().stack};
    tell_axis(run, here, s.angle, counted);
    run.sink(here);
}

void begin(Moving& run, SurfaceKind kind) {
    if (compensates(run, "on")) return;
    SurfaceMode s;
    s.kind = kind;
    s.plane = run.modal.plane;
    s.radius = run.block.has(Code::p) ? run.block.get(Code::p) * length_unit(run.modal) : 0;
    if (kind == SurfaceKind::cylinder && !(s.radius > 0))
        return alarm(run, codes::value_range, run.here(), "the radius of the cylinder must be greater than 0");
    begin_motion(run);
    s.angle = begin_angle(run);
    s.start = kind == SurfaceKind::polar ? s.angle : 0;
    set_plane(run, kind == SurfaceKind::polar ? 17 : 19);
    Vec3 to = run.programmed_position;
    to.y = kind == SurfaceKind::polar ? 0 : geom::radians(s.angle) * s.radius;
    arrive(run, to);
    s.at = run.sent = run.position;
    run.surface = s;
    if (kind == SurfaceKind::polar) tell_place(run, true);
}

void end(Moving& run) {
    if (run.surface.kind == SurfaceKind::none || compensates(run, "off")) return;
    const SurfaceMode s = run.surface;
    run.surface = {};
    run.surface.angle = s.angle;
    Vec3 to = run.position;
    if (s.kind == SurfaceKind::polar) to.x = std::hypot(to.x, to.y);
    to.y = 0;
    run.position = run.sent = to;
    run.programmed_position = geom::apply(geom::inverse(run.frame), to);
    run.extra_axes[turned_axis] = s.angle;
    set_plane(run, s.plane);
    if (s.kind == SurfaceKind::polar) tell_place(run, false);
}

}  // namespace

void set_surface(Calling& run, Modal m) {
    flush_path(run);
    if (run.capture != nullptr) {
        if (run.look != Look::next_element)
            unchecked(run, base::codes::unsupported, run.here(),
                      "polar and cylindrical interpolation are not run in a contour");
        return;
    }
    if (m == Modal::interpolation_off) return end(run);
    end(run);
    if (!run.stopped) begin(run, m == Modal::polar_face ? SurfaceKind::polar : SurfaceKind::cylinder);
}

void send_on_surface(Telling& run, const cl::Record& record) {
    run.surface.kind == SurfaceKind::polar ? send_polar(run, record) : send_cylinder(run, record);
}

}  // namespace obrys::interp
