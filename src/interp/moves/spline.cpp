/// Splines of RS-274: G5, G5.1, and curves of control points between G5.2 and G5.3 or by G6.2 with knots.
/// Source: LinuxCNC, G-Codes, "G5 Cubic spline", "G5.1 Quadratic spline", "G5.2 G5.3 NURBS block"; geom/nurbs.hpp.

#include "cl/spline.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "geom/nurbs.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec3;

namespace {

/// mm that a rational curve may be left by, where the stream has only cubics.
constexpr double curve_tolerance = 1e-3;

void refuse_curve(Saying& run, std::string text) { alarm(run, codes::value_range, run.here(), std::move(text)); }

/// Compensation that was switched off without a move leaves the tool where it was.
bool stands_beside(const Telling& run) {
    constexpr double same = 1e-6;  // mm
    return !run.env.stand_alone && geom::is_finite(run.sent) && geom::distance(run.sent, run.position) > same;
}

/// False after a complaint.
bool allowed(Moving& run) {
    if (run.modal.compensation != Modal::compensation_off)
        refuse_curve(run, "a spline cannot be run with radius compensation on");
    else if (!geom::is_finite(run.programmed_position))
        unchecked(run, codes::unknown_value, run.here(),
                  "the spline starts at a position that is not known: it is left out", "position all axes before it");
    else if (stands_beside(run))
        unchecked(
            run, codes::unsupported, run.here(),
            "the spline starts where the program is, and radius compensation has left the tool beside it: how the "
            "control comes to the spline is not known, it is left out",
            "leave the compensation with a straight move before the spline");
    else
        return true;
    if (!run.stopped) arrive(run, programmed_target(run));
    return false;
}

void emit_curve(Telling& run, const geom::Cubic& c) { emit(run, cl::spline_of(c)); }

bool has_axes_beside_plane(const Moving& run) {
    for (int k = 2; k < 9; ++k)
        if (run.block.has(axis_code(k))) return true;
    return false;
}

/// What G5 and G5.1 want of their block: the plane, and not one word of another axis, be it where it stands.
bool is_in_plane(Moving& run) {
    if (run.modal.plane != 17)
        refuse_curve(run, "splines must be in the plane of G17");
    else if (has_axes_beside_plane(run))
        refuse_curve(run, "splines move X and Y alone: no other axis may stand in the block");
    return !run.stopped;
}

Vec3 offset_of(const Moving& run, Code x, Code y) {
    const double unit = length_unit(run.modal);
    const BlockWords& b = run.block;
    return {(b.has(x) ? b.get(x) : 0) * unit, (b.has(y) ? b.get(y) : 0) * unit, 0};
}

bool cubic(Moving& run) {
    const BlockWords& b = run.block;
    if (!is_in_plane(run)) return false;
    if (b.has(Code::i) != b.has(Code::j)) {
        refuse_curve(run, "G5 needs both I and J, or neither");
        return false;
    }
    if (!b.has(Code::p) || !b.has(Code::q)) {
        refuse_curve(run, "G5 needs both P and Q");
        return false;
    }
    const Vec3 from = run.programmed_position, to = programmed_target(run);
    const Vec3 first = b.has(Code::i) ? offset_of(run, Code::i, Code::j) : -1.0 * run.last_spline_end;
    run.last_spline_end = offset_of(run, Code::p, Code::q);
    const Vec3 second = to + run.last_spline_end;
    hear(run, heard::Curve{4});
    const geom::Frame& f = run.frame;
    const geom::Cubic c =
        geom::bezier(geom::apply(f, from), geom::apply(f, from + first), geom::apply(f, second), geom::apply(f, to));
    arrive(run, to);
    emit_curve(run, c);
    return true;
}

bool quadratic(Moving& run) {
    if (!is_in_plane(run)) return false;
    if (!run.block.has(Code::i) || !run.block.has(Code::j)) {
        refuse_curve(run, "G5.1 needs both I and J");
        return false;
    }
    const Vec3 from = run.programmed_position, to = programmed_target(run);
    hear(run, heard::Curve{3});
    const geom::Frame& f = run.frame;
    const geom::Cubic c =
        geom::bezier(geom::apply(f, from), geom::apply(f, from + offset_of(run, Code::i, Code::j)), geom::apply(f, to));
    arrive(run, to);
    emit_curve(run, c);
    return true;
}

/// Blocks between G5.2 and G5.3 may have moved the tool, and G6.2 names its first point itself.
void begin_at(Telling& run, const Vec3& start) {
    if (!(geom::length(run.sent - start) > stream_joined)) return;
    unchecked(run, codes::unsupported, run.here(),
              "this curve does not begin where the tool stands: how the control comes to its first point is not known, "
              "a straight move is taken",
              "move to the first control point before the curve, and nowhere else until it ends");
    emit(run, cl::Linear{start, run.tool_axis, false});
}

/// The whole curve into the stream.
bool finish(Moving& run) {
    ControlCurve& n = run.curve;
    n.open = false;
    if (!n.own_knots) n.curve.knots = geom::clamped_knots(n.curve.points.size(), n.curve.order);
    if (n.curve.points.size() < static_cast<std::size_t>(n.curve.order) || !geom::is_valid(n.curve)) {
        refuse_curve(run, "this curve of order " + std::to_string(n.curve.order) +
                              " has too few control points, or weights or knots that make no curve");
        return false;
    }
    geom::Nurbs placed = n.curve;
    for (geom::NurbsPoint& p : placed.points) p.p = geom::apply(run.frame, p.p);
    const auto pieces = geom::cubic_pieces(placed, curve_tolerance);
    if (!pieces || !(pieces->deviation <= 10 * curve_tolerance)) {
        refuse_curve(run, "this curve cannot be run within " + printed(Value::real(curve_tolerance)) + " mm");
        return false;
    }
    if (pieces->deviation > 0)
        assume(run, run.here(), "rational curves are run as cubics that leave them by 0.001 mm at most");
    hear(run, heard::Curve{static_cast<int>(n.curve.points.size())});
    begin_at(run, placed.points.front().p);
    arrive(run, n.curve.points.back().p);
    for (const auto& piece : pieces->pieces) emit_curve(run, piece.curve);
    return true;
}

/// G6.2: the curve is complete when the last `order` knots are equal.
bool knots_complete(const geom::Nurbs& c) {
    const auto order = static_cast<std::size_t>(c.order);
    if (c.knots.size() < c.points.size() + order || c.knots.size() <= order) return false;
    for (std::size_t i = c.knots.size() - order; i + 1 < c.knots.size(); ++i)
        if (c.knots[i] != c.knots[i + 1]) return false;
    return true;
}

void begin_curve(Moving& run, bool own_knots) {
    run.curve = {};
    run.curve.open = true;
    run.curve.own_knots = own_knots;
    run.curve.curve.order = 3;
    if (!own_knots) run.curve.curve.points.push_back({run.programmed_position, 1});
}

/// P of G6.2, L of G5.2, which takes the largest one and none below 3; false after a complaint.
bool take_order(Moving& run) {
    ControlCurve& n = run.curve;
    const Code word = n.own_knots ? Code::p : Code::l;
    if (!run.block.has(word)) return true;
    const double v = run.block.get(word);
    const int least = n.own_knots ? 2 : 0;
    const std::string letter = n.own_knots ? "P" : "L";
    const auto order = base::whole<int>(v, least, geom::largest_order);
    if (std::isnan(v))
        unchecked(run, codes::unknown_value, run.here(),
                  "the order of this curve depends on a value that is not known");
    else if (!order)
        refuse_curve(run, letter + printed(Value::real(v)) + " is no order of a curve: whole numbers from " +
                              std::to_string(least) + " to " + std::to_string(geom::largest_order) + " are run here");
    if (order) n.curve.order = n.own_knots ? *order : std::max(n.curve.order, *order);
    return !run.stopped;
}

/// What G5.2 wants of the blocks of its control points; `opens`: it stands in the block itself, which may leave out P.
bool is_point_of_plane(Moving& run, bool opens) {
    const BlockWords& b = run.block;
    if (b.has(Code::x) != b.has(Code::y))
        refuse_curve(run, "a control point needs both X and Y");
    else if (b.has(Code::x) && !b.has(Code::p) && !opens)
        refuse_curve(run, "every control point needs its weight P");
    else if (!b.has(Code::x) && b.has(Code::p) && !opens)
        refuse_curve(run, "P without X and Y is the weight of the first control point alone");
    else if (has_axes_beside_plane(run))
        unchecked(run, codes::unknown_word, run.here(),
                  "control points have X and Y alone: the control passes over the other axes",
                  "take them out, and move these axes before G5.2");
    return !run.stopped;
}

/// Of a plane: other axes stay where they are.
Vec3 point_target(Moving& run) {
    Vec3 to = programmed_target(run);
    if (!run.curve.own_knots) to.z = run.programmed_position.z;
    return to;
}

bool add_point(Moving& run, bool opens) {
    const BlockWords& b = run.block;
    ControlCurve& n = run.curve;
    if (!n.own_knots && !is_point_of_plane(run, opens)) return false;
    const bool point = b.has(Code::x) || b.has(Code::y) || (n.own_knots && b.has(Code::z));
    const Code weight = n.own_knots ? Code::radius : Code::p;
    const double w = b.has(weight) ? b.get(weight) : 1;
    if (!(w > 0)) {
        refuse_curve(run, "every control point needs a weight above 0");
        return false;
    }
    if (!take_order(run)) return false;
    if (n.own_knots) b.use(Code::q);  // how the control steps along the curve, which stays the same
    if (n.own_knots && b.has(Code::k)) n.curve.knots.push_back(b.get(Code::k));
    if (!point && !n.own_knots && n.curve.points.size() == 1 && b.has(Code::p)) n.curve.points.front().weight = w;
    if (point) n.curve.points.push_back({point_target(run), w});
    if (n.own_knots && point) run.programmed_position = n.curve.points.back().p;
    return !n.own_knots || !knots_complete(n.curve) || finish(run);
}

}  // namespace

bool spline_motion(Moving& run) {
    flush_path(run);
    const bool ends_nothing = run.block.special == Modal::nurbs_end && !geom::is_finite(run.programmed_position);
    if (ends_nothing || !allowed(run)) return false;
    require_feed(run);
    if (run.block.special == Modal::spline_cubic) return cubic(run);
    if (run.block.special == Modal::spline_quadratic) return quadratic(run);
    if (run.block.special == Modal::nurbs_end) {
        run.modal.motion = Modal::canned_off;
        if (run.curve.open) return finish(run);
        refuse_curve(run, "G5.3 without G5.2 before it");
        return false;
    }
    const bool opens = !run.curve.open;
    if (opens) begin_curve(run, run.modal.motion_number == 62);
    return add_point(run, opens);
}

}  // namespace obrys::interp
