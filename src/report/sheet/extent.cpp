#include <algorithm>

#include "cl/spline.hpp"
#include "report/sheet/sheet.hpp"

namespace obrys::report::sheet {

namespace {

using geom::Vec3;

double part_of(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Where the arc turns back along each axis.
void add_arc(Extent& extent, const cl::Arc& arc, const Vec3& from) {
    const Vec3 out = from - arc.centre;
    const Vec3 u = out - geom::dot(out, arc.normal) * arc.normal, v = geom::cross(arc.normal, u);
    const double sense = arc.sweep < 0 ? -1 : 1, sweep = std::abs(arc.sweep);
    const double rise = geom::dot(arc.to - from, arc.normal);
    for (int axis = 0; axis < 3; ++axis) {
        double angle = std::atan2(sense * part_of(v, axis), part_of(u, axis));
        for (int side = 0; side < 2; ++side, angle += geom::pi) {
            const double first = angle - geom::full_turn * std::floor(angle / geom::full_turn);
            if (!(first < sweep)) continue;
            // The last turn of a helix reaches farthest along it; its ends are points of the extent anyway.
            Vec3 at = from - u + std::cos(first) * u + (sense * std::sin(first)) * v;
            if (sweep > 0) at = at + (rise * first / sweep) * arc.normal;
            extent.add(at);
        }
    }
}

void add_spline(Extent& extent, const cl::Spline& s) {
    const geom::Box3 box = geom::box(cl::curve(s));
    extent.add(box.lo);
    extent.add(box.hi);
}

}  // namespace

void Extent::add(const Vec3& p) {
    const auto widen = [](double& least, double& most, double value) {
        if (!std::isfinite(value)) return;
        least = std::min(least, value);
        most = std::max(most, value);
    };
    widen(low.x, high.x, p.x);
    widen(low.y, high.y, p.y);
    widen(low.z, high.z, p.z);
}

void add_way(Extent& extent, const motion::Step& step) {
    extent.add(step.from);
    extent.add(step.to);
    if (const auto* arc = std::get_if<cl::Arc>(&step.record.step); arc != nullptr && geom::is_finite(step.from))
        add_arc(extent, *arc, step.from);
    if (const auto* spline = std::get_if<cl::Spline>(&step.record.step)) add_spline(extent, *spline);
}

}  // namespace obrys::report::sheet
