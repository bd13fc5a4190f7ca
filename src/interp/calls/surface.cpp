/// Polar (G12.1) and cylindrical (G7.1) interpolation: the program moves in a plane which linear and rotary axis make
/// together. In the stream polar interpolation is the path on the workpiece with C counted, cylindrical interpolation
/// the points of the machine with C beside them (docs/cl-stream.md, Axis).
/// Source: FANUC series 16/18-C operator's manual B-62764EN/01, page 51; 15i-MA B-63324EN/03, pages 60 and 66.

#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec3;
using SurfaceKind = SurfaceMode::Kind;

namespace {

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
    const cl::Linear here{turned_by(run.position, counted ? s.start : 0), {0, 0, 1}, true};
    send_turned(run, {here, run.here(), run.top().stack}, s.angle, counted);
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

}  // namespace obrys::interp
