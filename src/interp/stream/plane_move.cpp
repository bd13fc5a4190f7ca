/// Elements of the working plane as moves of the stream.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// A circle of the working plane stays one.
bool keeps_circles(const Reckoning& run) {
    if (run.frame_is_identity || geom::is_shift_only(run.frame)) return true;
    const Vec3 zero = point_in_stream(run, {}, 0);
    const Vec3 u = point_in_stream(run, {1, 0}, 0) - zero, v = point_in_stream(run, {0, 1}, 0) - zero;
    return !(std::abs(geom::length(u) - geom::length(v)) > 1e-9);
}

}  // namespace

std::optional<Vec3> PlaneView::normal_of_circle() const {
    if (as_it_is_) return in_space(axes_, {}, 1);
    if (!keeps_circles(run_)) return std::nullopt;
    return plane_normal(run_);
}

bool PlaneView::arc(const path::Element& e, bool rapid, cl::Arc& out) const {
    const std::optional<Vec3> normal = normal_of_circle();
    if (!normal) return false;
    out.to = at(e.to, e.w_to);
    out.centre = at(e.centre, e.w_from);
    out.normal = *normal;
    out.sweep = e.sweep;
    out.rapid = rapid;
    out.axis = run_.tool_axis;
    out.ends.clear();
    return true;
}

void PlaneView::line(const path::Element& e, bool rapid, cl::Linear& out) const {
    out.to = at(e.to, e.w_to);
    out.axis = run_.tool_axis;
    out.rapid = rapid;
    out.seek = cl::Seek::nothing;
    out.ends.clear();
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
void lead_to_arc(Telling& run, const PlaneView& view, const path::Element& e, bool rapid) {
    const Vec3 start = view.at(e.from, e.w_from), gap = run.sent - start;
    if (gap == Vec3{}) return;
    const Vec3 along = view.at(e.from, e.w_from + 1) - start;  // how far the arc rises is no matter of its circle
    const Vec3 beside = gap - (geom::dot(gap, along) / geom::dot(along, along)) * along;
    if (!(geom::length(beside) > stream_joined)) return;
    run.record.step = cl::Linear{start, run.tool_axis, rapid};
    send(run, run.record);
}

/// The radii at both ends differ by no more than those of a programmed arc may (arc.cpp), and by what moved ends add
/// where the control keeps its centre (path::HeldMoveLimits).
bool is_on_its_circle(const Reckoning& run, const path::Element& e) {
    const double start = geom::distance(e.from, e.centre), end = geom::distance(e.to, e.centre);
    if (std::abs(start - end) <= stream_joined) return true;
    const path::ArcTolerance t = arc_tolerance(run);
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
    const PlaneView view(run, in_stream);
    if (path::is_arc(e)) {
        lead_to_arc(run, view, e, rapid);
        if (!view.arc(e, rapid, step_as<cl::Arc>(run.record.step))) return circle_alarm(run, run.record.from);
    } else {
        view.line(e, rapid, step_as<cl::Linear>(run.record.step));
    }
    send(run, run.record);
}

}  // namespace obrys::interp
