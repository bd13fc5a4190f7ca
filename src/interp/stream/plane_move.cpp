/// Elements of the working plane as moves of the stream.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "cl/verify.hpp"
#include "interp/stream/path_stage.hpp"
#include "interp/stream/stream.hpp"
#include "path/arc_input.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using geom::Vec3;

bool compensates_in_fixed_plane(const Telling& run) {
    if (!run.traits->compensates_in_fixed_plane || run.frame_is_identity || run.modal.compensation_in_frame)
        return false;
    if (run.modal.compensation == Modal::compensation_off && !run.path->in_fixed_plane()) return false;
    const auto w = static_cast<std::size_t>(plane_axes(run.modal.plane).w);
    double tilt = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (k != w) tilt += std::abs(run.frame.linear[3 * w + k]) + std::abs(run.frame.linear[3 * k + w]);
    return tilt > 1e-12;
}

namespace {

PlaneMove move_in_stream(const Reckoning& run, const path::Element& e, bool rapid) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const Vec3 to = in_space(a, e.to, e.w_to);
    if (!path::is_arc(e)) return cl::Linear{to, run.tool_axis, rapid};
    return cl::Arc{to, in_space(a, e.centre, e.w_from), in_space(a, {}, 1), e.sweep, rapid, run.tool_axis};
}

}  // namespace

std::optional<PlaneMove> plane_move(const Reckoning& run, const path::Element& e, bool rapid, bool in_stream_already) {
    if (in_stream_already) return move_in_stream(run, e, rapid);
    const Vec3 to = point_in_stream(run, e.to, e.w_to);
    if (!path::is_arc(e)) return cl::Linear{to, run.tool_axis, rapid};
    if (!run.frame_is_identity && !geom::is_shift_only(run.frame)) {
        const Vec3 zero = point_in_stream(run, {}, 0);
        const Vec3 u = point_in_stream(run, {1, 0}, 0) - zero, v = point_in_stream(run, {0, 1}, 0) - zero;
        if (std::abs(geom::length(u) - geom::length(v)) > 1e-9) return std::nullopt;
    }
    return cl::Arc{to, point_in_stream(run, e.centre, e.w_from), plane_normal(run), e.sweep, rapid, run.tool_axis};
}

Vec3 plane_normal(const Reckoning& run) {
    if (run.frame_is_identity || geom::is_shift_only(run.frame)) return in_space(plane_axes(run.modal.plane), {}, 1);
    const Vec3 zero = point_in_stream(run, {}, 0);
    const Vec3 normal = geom::cross(point_in_stream(run, {1, 0}, 0) - zero, point_in_stream(run, {0, 1}, 0) - zero);
    return (1 / geom::length(normal)) * normal;
}

void circle_alarm(Saying& run, const base::Span& where) {
    alarm(run, codes::value_range, where, "a circle cannot be run with different scale factors in its plane");
}

void lead_to_place(Telling& run) {
    if (geom::length(run.sent - run.position) > stream_joined)
        emit(run, cl::Linear{run.position, run.tool_axis, false});
}

namespace {

/// An arc has no start of its own in the stream: where what was refused, or a new frame, has left the tool beside it, a
/// straight move leads to it. Every arc of the working plane passes here, whoever made it.
void lead_to_arc(Telling& run, const path::Element& e, bool rapid, bool in_stream_already) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const auto in_its_frame = [&](Vec2 p, double w) {
        return in_stream_already ? in_space(a, p, w) : point_in_stream(run, p, w);
    };
    const Vec3 start = in_its_frame(e.from, e.w_from), gap = run.sent - start;
    const Vec3 along = in_its_frame(e.from, e.w_from + 1) - start;  // how far the arc rises is no matter of its circle
    const Vec3 beside = gap - (geom::dot(gap, along) / geom::dot(along, along)) * along;
    if (!(geom::length(beside) > stream_joined)) return;
    run.record.step = cl::Linear{start, run.tool_axis, rapid};
    send(run, run.record);
}

/// The radii at both ends differ by no more than those of a programmed arc may (arc.cpp), and by what moved ends add
/// where the control keeps its centre (path::HeldMoveLimits).
bool is_on_its_circle(const Reckoning& run, const path::Element& e) {
    const path::ArcTolerance t = arc_tolerance(run);
    const double start = geom::distance(e.from, e.centre), end = geom::distance(e.to, e.centre);
    const double allowed = t.keep_centre ? 2 * std::max(t.absolute, t.relative * std::max(start, end))
                                         : cl::circle_tolerance + stream_joined;
    return !(std::abs(start - end) > allowed);
}

}  // namespace

void emit_element(Telling& run, const path::Element& e, bool rapid, bool in_stream) {
    if (path::is_arc(e) && !is_on_its_circle(run, e)) {
        unchecked(run, codes::unsupported, run.record.from,
                  "what radius compensation leaves of this arc does not begin on its circle: it is run straight",
                  "switch the compensation off and on again where the contour is broken");
        return emit_element(run, path::line(e.from, e.to, e.w_to), rapid, in_stream);
    }
    if (path::is_arc(e)) lead_to_arc(run, e, rapid, in_stream);
    const std::optional<PlaneMove> move = plane_move(run, e, rapid, in_stream);
    if (!move) return circle_alarm(run, run.record.from);
    std::visit([&run](const auto& m) { put_step(run.record.step, m); }, *move);
    send(run, run.record);
}

path::ArcTolerance arc_tolerance(const Reckoning& run) {
    const program::Traits& t = *run.traits;
    const double own = run.modal.inch_geometry ? t.arc_tolerance_inch : t.arc_tolerance;
    return {own > 0 ? own : run.env.machine.defaults.circle_tolerance, 0.001, own > 0};
}

}  // namespace obrys::interp
