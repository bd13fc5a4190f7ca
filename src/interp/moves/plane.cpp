/// Tilted working planes (PLANE, cycle 19): the frame in which the program goes on.
/// Angles as the iTNC 530 manual, "The PLANE function", defines them.

#include <cmath>

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"
#include "interp/setup/tilted_axes.hpp"

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

/// About the machine's X, then its Y, then its Z (each about the fixed axes).
Frame spatial(Reckoning& run, const Special& s) {
    return Frame::rotation(2, angle(run, s, Datum::angle_c)) * Frame::rotation(1, angle(run, s, Datum::angle_b)) *
           Frame::rotation(0, angle(run, s, Datum::angle_a));
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

void plane(Moving& run, const Special& s) {
    flush_path(run);
    Frame f;
    switch (s.kind) {
        case SpecialKind::plane_spatial: f = spatial(run, s); break;
        case SpecialKind::plane_euler: f = euler(run, s); break;
        case SpecialKind::plane_projected: f = projected(run, s); break;
        case SpecialKind::plane_vector:
            f = vectors(vector_of(run, s, Datum::vector_x, Datum::vector_y, Datum::vector_z),
                        vector_of(run, s, Datum::normal_x, Datum::normal_y, Datum::normal_z));
            break;
        case SpecialKind::plane_points: f = points(run, s); break;
        case SpecialKind::plane_relative: f = active_plane(run) * spatial(run, s); break;
        case SpecialKind::plane_reset: break;
        default:
            unchecked(run, codes::unsupported, s.where,
                      "PLANE AXIAL is not run: what plane the axes give depends on the machine's kinematics");
            return;
    }
    if (run.stopped) return;
    if (!is_known(f)) {
        unchecked(run, codes::unknown_value, s.where,
                  "this tilted plane is not determined: a value is not known, or its vectors are parallel");
        return;
    }
    const Vec3 tip = on_workpiece(run), axis_before = run.tool_axis;
    tilt(run, f, {datum_of(run, s, Datum::side), datum_of(run, s, Datum::table_turns) == 1}, s.where);
    constexpr double stay = 0, move = 1;
    const double how = datum_of(run, s, Datum::positioning);
    if (run.stopped) return;
    if (how == stay)
        tell_rotary(run, axis_before);
    else
        swivel(run, how == move, !run.block.has(Code::feed),
               {tip, axis_of_tool(run), datum_of(run, s, Datum::distance)}, s.where);
}

}  // namespace obrys::interp
