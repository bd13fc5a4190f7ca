/// Elements of the working plane on their way out: to whoever looks ahead, to the path stage, or as moves of the
/// stream.

#include <cmath>

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec3;

namespace {

void remember_direction(Moving& run, const path::Element& e) {
    if (path::moves_in_plane(e)) run.last_direction = path::EndDirection(e);
}

/// The element as seen in the plane that frames do not turn. An arc is no circle there.
path::Element in_fixed_plane(Moving& run, const path::Element& e) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    if (path::is_arc(e))
        unchecked(run, codes::unsupported, run.here(),
                  "with CUT2D an arc in a plane that a frame turns is not compensated: it is run as a straight move",
                  "write CUT2DF where the tool stands square to the turned plane");
    if (run.block.has(Code::round) || run.block.has(Code::chamfer_length) || run.block.has(Code::chamfer_leg))
        unchecked(run, codes::unsupported, run.here(),
                  "with CUT2D a chamfer or rounding in a plane that a frame turns is not run as the control does",
                  "write CUT2DF where the tool stands square to the turned plane");
    path::Element out;
    const Vec3 from = point_in_stream(run, e.from, e.w_from), to = point_in_stream(run, e.to, e.w_to);
    out.from = in_plane(from, a);
    out.to = in_plane(to, a);
    out.w_from = coordinate(from, a.w);
    out.w_to = coordinate(to, a.w);
    return out;
}

void push_element(Moving& run, path::Element&& e, bool rapid) {
    const bool fixed = compensates_in_fixed_plane(run);
    if (fixed != run.path->in_fixed_plane() && run.path->active()) flush_path(run);
    run.path->set_fixed_plane(fixed);
    if (fixed) e = in_fixed_plane(run, e);
    run.path->push(run, std::move(e), rapid);
}

}  // namespace

void plane_element(Moving& run, path::Element&& e, const Vec3& to, bool rapid) {
    rapid = rapid || run.block.rapid;
    remember_direction(run, e);
    if (path::is_arc(e) && run.modal.feed_mode == cl::FeedMode::inverse_time)
        hear_inverse_feed(run, std::hypot(e.sweep * geom::length(e.from - e.centre), e.w_to - e.w_from));
    if (run.free_contour.at_hand) run.free_contour = {};
    if (run.capture != nullptr)
        capture(run, e, rapid);
    else if (needs_path_stage(run)) {
        push_element(run, std::move(e), rapid);
    } else {
        run.record.from = run.here();
        run.record.stack = run.top().stack;
        run.feed_shape.plunge = run.modal.plunge_part;
        run.feed_shape.arc = 1;
        emit_element(run, e, rapid);
    }
    run.programmed_position = to;
    run.position = run.frame_is_identity ? to : geom::apply(run.frame, to);
}

bool programmed_element(const Reckoning& run, const path::Element& e, bool rapid, bool in_stream_already,
                        cl::Programmed& out) {
    const PlaneView view(run, in_stream_already);
    const std::optional<Vec3> normal = path::is_arc(e) ? view.normal_of_circle() : Vec3{0, 0, 1};
    if (!normal) return false;
    out.from = view.at(e.from, e.w_from);
    out.to = view.at(e.to, e.w_to);
    out.centre = path::is_arc(e) ? view.at(e.centre, e.w_from) : Vec3{};
    out.normal = *normal;
    out.sweep = e.sweep;
    out.rapid = rapid;
    out.corner = cl::Corner::none;
    out.size = out.corner_feed = 0;
    out.ends.clear();
    return true;
}

}  // namespace obrys::interp
