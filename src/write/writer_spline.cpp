/// Splines: cubic curves, which controls say by coefficients (SPL) or by control points (G5).

#include <algorithm>
#include <cmath>

#include "cl/spline.hpp"
#include "write/writer.hpp"

namespace obrys::write {

namespace {

/// The curve's control points in the frame in force. Bernstein form of u in 0 … 1.
std::array<geom::Vec3, 4> control_points(const cl::Spline& spline, const Frames& frames) {
    const geom::Cubic c = cl::forward(spline);
    const std::array points{c.k0, c.k0 + 1.0 / 3 * c.k1, c.k0 + 2.0 / 3 * c.k1 + 1.0 / 3 * c.k2, spline.to};
    return {frames.programmed(points[0]), frames.programmed(points[1]), frames.programmed(points[2]),
            frames.programmed(points[3])};
}

struct PlaneOfSpline {
    Command command;
    geom::Vec3 normal;
};
constexpr std::array<PlaneOfSpline, 3> planes_of_splines{
    {{Command::spline_xy, {0, 0, 1}}, {Command::spline_zx, {0, 1, 0}}, {Command::spline_yz, {1, 0, 0}}}};

bool lies_across(const std::array<geom::Vec3, 4>& b, const geom::Vec3& normal) {
    constexpr double flat = 1e-6;  // mm
    return std::all_of(b.begin(), b.end(),
                       [&](const geom::Vec3& p) { return std::abs(geom::dot(p - b[0], normal)) <= flat; });
}

void set(Values& values, Value first, const geom::Vec3& v) {
    const auto k = static_cast<std::size_t>(first);
    values.set(first, v.x);
    values.set(static_cast<Value>(k + 1), v.y);
    values.set(static_cast<Value>(k + 2), v.z);
}

}  // namespace

/// Coordinates that nobody knows have no curve.
void Writer::write_spline(const cl::Spline& spline) {
    end_cycles();
    const auto b = control_points(spline, frames_);
    if (!std::all_of(b.begin(), b.end(), [](const geom::Vec3& p) { return geom::is_finite(p); }))
        return note(Fate::lost, "a spline through a place that is not known");
    for (const cl::SplineAxis& axis : spline.axes)
        note(Fate::lost, "axis " + std::string(axis.name.data()) + " along a spline");
    note_direction(spline.axis);
    const auto in_plane = std::find_if(planes_of_splines.begin(), planes_of_splines.end(), [&](const PlaneOfSpline& p) {
        return post_.has(p.command) && lies_across(b, p.normal);
    });
    const bool anywhere = post_.has(Command::spline);
    if (!anywhere && in_plane == planes_of_splines.end()) {
        const bool planes = std::any_of(planes_of_splines.begin(), planes_of_splines.end(),
                                        [&](const PlaneOfSpline& p) { return post_.has(p.command); });
        return note(Fate::lost, planes ? "a spline that leaves the planes which the post has words for"
                                       : "a spline: the post has no motion.spline");
    }
    if (!anywhere) select_plane(in_plane->normal);
    values_.clear();
    set(values_, Value::x, b[3]);
    set(values_, Value::first_x, b[0]);
    set(values_, Value::second_x, b[1]);
    set(values_, Value::third_x, b[2]);
    set(values_, Value::handle_i, b[1] - b[0]);
    set(values_, Value::handle_p, b[2] - b[3]);
    set(values_, Value::k1_x, 3.0 * (b[2] - b[3]));
    set(values_, Value::k2_x, 3.0 * (b[3] - 2.0 * b[2] + b[1]));
    set(values_, Value::k3_x, b[0] - 3.0 * b[1] + 3.0 * b[2] - b[3]);
    const Command command = anywhere ? Command::spline : in_plane->command;
    print_move(command, false, nullptr);
    printer_.leave(post_[command]);  // the next one says it again
}

}  // namespace obrys::write
