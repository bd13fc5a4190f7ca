/// Tilted working planes (PLANE, cycle 19): the frame in which the program goes on.
/// Angles as the iTNC 530 manual, "The PLANE function", defines them.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/moves/moves.hpp"
#include "interp/setup/tilted_axes.hpp"
#include "shop/kinematics.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Frame;
using geom::Vec3;
using program::Datum;
using program::Special;
using program::SpecialKind;

namespace {

double angle(Reckoning& run, const Special& s, Datum d) { return geom::radians(datum_of(run, s, d)); }

Frame of_axes(const Vec3& x, const Vec3& y, const Vec3& z) {
    Frame f;
    f.linear = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
    return f;
}

Vec3 unit(const Vec3& v) { return (1 / geom::length(v)) * v; }

/// About the machine's X, then its Y, then its Z (each about the fixed axes), or in the order that is said.
Frame spatial(Reckoning& run, const Special& s) {
    constexpr double x_y_z = 123;
    constexpr std::array angles{Datum::angle_a, Datum::angle_b, Datum::angle_c};
    Frame f;
    for (const char c : std::to_string(base::whole<int>(datum_of(run, s, Datum::order, x_y_z), 1, 999).value_or(0)))
        if (const int axis = c - '1'; axis >= 0 && axis < 3)
            f = Frame::rotation(axis, angle(run, s, angles[static_cast<std::size_t>(axis)])) * f;
    return f;
}

/// The same where one of them alone turns; else unknown: no manual at hand says about which axes the later ones do.
Frame roll_pitch_yaw(Reckoning& run, const Special& s) {
    int turns = 0;
    for (const Datum d : {Datum::angle_a, Datum::angle_b, Datum::angle_c}) turns += datum_of(run, s, d) != 0 ? 1 : 0;
    Frame f = spatial(run, s);
    if (turns > 1) f.linear.fill(std::numeric_limits<double>::quiet_NaN());
    return f;
}

/// Its axes are those of the spindle as the rotary axes stand.
Frame of_rotary_axes(Reckoning& run) {
    Frame f = shop::spindle_frame(shop::chain_of(run.env.machine), rotary(run).values);
    f.origin = {};
    const auto turn = run.env.machine.datum_rotations.find(run.reference_datum);
    return turn == run.env.machine.datum_rotations.end() ? f : Frame::rotation(2, -turn->second) * f;
}

/// Precession about Z, nutation about the turned X, rotation about the turned Z.
Frame euler(Reckoning& run, const Special& s) {
    return Frame::rotation(2, angle(run, s, Datum::angle_a)) * Frame::rotation(0, angle(run, s, Datum::angle_b)) *
           Frame::rotation(2, angle(run, s, Datum::angle_c));
}

/// Projection angles: of the plane's trace in Z/X to X and in Y/Z to Y; ROT turns in the plane, whose X is as the first
/// angle says.
Frame projected(Reckoning& run, const Special& s) {
    const double p = angle(run, s, Datum::angle_a), q = angle(run, s, Datum::angle_b);
    const Vec3 u = {std::cos(p), 0, -std::sin(p)}, v = {0, std::cos(q), std::sin(q)};
    const Vec3 x = unit(u), z = unit(geom::cross(u, v));
    return of_axes(x, geom::cross(z, x), z) * Frame::rotation(2, angle(run, s, Datum::angle_c));
}

/// Base vector and normal; the base is brought into the plane.
Frame vectors(const Vec3& base, const Vec3& normal) {
    const Vec3 z = unit(normal);
    const Vec3 x = unit(base - geom::dot(base, z) * z);
    return of_axes(x, geom::cross(z, x), z);
}

Vec3 vector_of(Reckoning& run, const Special& s, Datum x, Datum y, Datum z) {
    return {datum_of(run, s, x), datum_of(run, s, y), datum_of(run, s, z)};
}

/// P1 to P2 is the principal axis, P3 lies on the side of the secondary one.
Frame points(Reckoning& run, const Special& s) {
    const Vec3 a = vector_of(run, s, Datum::point1_x, Datum::point1_y, Datum::point1_z);
    const Vec3 b = vector_of(run, s, Datum::point2_x, Datum::point2_y, Datum::point2_z);
    const Vec3 c = vector_of(run, s, Datum::point3_x, Datum::point3_y, Datum::point3_z);
    return vectors(b - a, geom::cross(b - a, c - a));
}

bool is_known(const Frame& f) {
    for (const double v : f.linear)
        if (!std::isfinite(v)) return false;
    return true;
}

}  // namespace

namespace {

/// The plane that the words say; nothing where it is not run, which has been said.
std::optional<Frame> plane_said(Moving& run, const Special& s) {
    switch (s.kind) {
        case SpecialKind::plane_spatial: return spatial(run, s);
        case SpecialKind::plane_euler: return euler(run, s);
        case SpecialKind::plane_roll_pitch_yaw: return roll_pitch_yaw(run, s);
        case SpecialKind::plane_projected: return projected(run, s);
        case SpecialKind::plane_vector:
            return vectors(vector_of(run, s, Datum::vector_x, Datum::vector_y, Datum::vector_z),
                           vector_of(run, s, Datum::normal_x, Datum::normal_y, Datum::normal_z));
        case SpecialKind::plane_points: return points(run, s);
        case SpecialKind::plane_relative: return active_plane(run) * spatial(run, s);
        case SpecialKind::plane_reset: return Frame{};
        case SpecialKind::plane_not_said: return std::nullopt;  // the reader has said it
        case SpecialKind::plane_of_axes:
            if (shop::has_rotary(shop::chain_of(run.env.machine))) return of_rotary_axes(run);
            unchecked(run, codes::unsupported, s.where,
                      "the plane is as the rotary axes stand, which turn about lines that are not known: it is not "
                      "followed",
                      "name a machine with its rotary axes (chain, docs/machine-file.md)");
            return std::nullopt;
        default:
            unchecked(run, codes::unsupported, s.where,
                      "PLANE AXIAL is not run: what plane the axes give depends on the machine's kinematics");
            return std::nullopt;
    }
}

bool is_known_plane(Saying& run, const Special& s, const Frame& f) {
    if (is_known(f) && geom::is_finite(f.origin)) return true;
    unchecked(run, codes::unknown_value, s.where,
              s.kind == SpecialKind::plane_roll_pitch_yaw
                  ? "this tilted plane is not run: several roll, pitch and yaw angles, and about which axes the later "
                    "ones turn is not known"
                  : "this tilted plane is not determined: a value is not known, or its vectors are parallel");
    return false;
}

/// The rotary axes have nowhere to go.
bool stand_as_aimed(const Reckoning& run) {
    constexpr double still = 1e-8;  // radians; they are kept in degrees, rounded
    const std::vector<double> now = rotary(run).values;
    return !run.aimed_at.empty() && std::equal(now.begin(), now.end(), run.aimed_at.begin(), run.aimed_at.end(),
                                               [](double a, double b) { return std::abs(a - b) < still; });
}

/// The rotary axes turn to the plane in force.
void take_up_plane(Moving& run, const Special& s) {
    const PlaneWait waited = std::exchange(run.modal.plane_waits, PlaneWait::none);
    if (waited == PlaneWait::lost)
        return unchecked(run, codes::unsupported, s.where,
                         "the rotary axes turn to a tilted plane that is not known: they are not followed");
    if (!tilted(run))
        return alarm(run, codes::value_range, s.where,
                     "no tilted plane is in force to which the rotary axes could turn: the control stops",
                     "define the plane before");
    aim(run, {}, s.where);
    if (run.stopped) return;
    if (stand_as_aimed(run)) {
        run.modal.plane_waits = waited;
        return;
    }
    swivel(run, false, true, {run.position, run.tool_axis, 0}, s.where);
}

}  // namespace

void plane(Moving& run, const Special& s) {
    flush_path(run);
    if (s.kind == SpecialKind::plane_taken_up) return take_up_plane(run, s);
    const auto said = plane_said(run, s);
    if (run.stopped) return;
    const double unit = length_unit(run.modal);
    const auto f =
        said ? std::optional(Frame::shift(unit * vector_of(run, s, Datum::origin_x, Datum::origin_y, Datum::origin_z)) *
                             *said)
             : std::nullopt;
    if (run.stopped) return;
    // Where nothing has moved since a plane has ended, the tool stands on the workpiece where it stood in that one.
    const bool goes_on = run.modal.plane_waits == PlaneWait::ended && run.modal.tool_before_plane == run.changed_to;
    run.modal.plane_waits = PlaneWait::lost;
    if (!f || !is_known_plane(run, s, *f)) return;
    run.modal.plane_waits = PlaneWait::none;
    const Vec3 tip = goes_on ? run.modal.tip_before_end : on_workpiece(run);
    const Vec3 axis_before = goes_on ? run.modal.axis_before_plane : run.tool_axis;
    constexpr double stay = 0, move = 1, later = 3, stands_on_it = 4;
    const double how = datum_of(run, s, Datum::positioning);
    const bool turn_here = how != later && s.kind != SpecialKind::plane_of_axes;
    tilt(run, *f,
         {.side = datum_of(run, s, Datum::side),
          .table_turns = datum_of(run, s, Datum::table_turns) == 1,
          .later = !turn_here,
          .by_control = how == stands_on_it},
         s.where);
    if (run.stopped) return;
    if (goes_on && tilted(run)) stand_at(run, tip);
    run.modal.axis_before_plane = axis_before;
    run.modal.tip_before_end = tip;
    run.modal.tool_before_plane = run.changed_to;
    if (how == later)
        run.modal.plane_waits = tilted(run) ? PlaneWait::for_axes : PlaneWait::ended;
    else if (how == stay || how == stands_on_it)
        tell_rotary(run, axis_before);
    else
        swivel(run, how == move, !run.block.has(Code::feed),
               {tip, axis_of_tool(run), datum_of(run, s, Datum::distance)}, s.where);
}

void judge_plane_taken_up(Moving& run) {
    if (run.modal.plane_waits != PlaneWait::for_axes && run.modal.plane_waits != PlaneWait::ended) return;
    const bool ended = std::exchange(run.modal.plane_waits, PlaneWait::none) == PlaneWait::ended;
    constexpr std::uint64_t linear = bit(Code::x) | bit(Code::y) | bit(Code::z),
                            rotary = bit(Code::a) | bit(Code::b) | bit(Code::c);
    // Rotary axes alone go back: how they count from here on is no step of its own.
    if (ended && (run.block.present & rotary) != 0 && (run.block.present & linear) == 0) {
        std::string own;
        for (int k = 3; k < 6; ++k)
            if (run.block.has(axis_code(k))) own += axis_name(static_cast<std::size_t>(k));
        return take_rotary_along(run, own);
    }
    tell_rotary(run, run.modal.axis_before_plane);
    if (ended) return;
    constexpr double along_axis = 1e-6;  // sine of the angle by which the tool's axis may miss the plane's normal
    if (geom::distance(axis_of_tool(run), run.tool_axis) <= along_axis) return;
    unchecked(
        run, codes::unsupported, run.here(),
        "the working plane is tilted, and no word has turned the rotary axes to it: the tool does not stand on it",
        "let the rotary axes turn before this move");
}

}  // namespace obrys::interp
