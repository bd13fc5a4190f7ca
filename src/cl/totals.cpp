#include "cl/totals.hpp"

#include "cl/spline.hpp"
#include "cl/zero.hpp"

namespace obrys::cl {

namespace {

double straight(geom::Vec3 from, geom::Vec3 to) { return geom::length(travel(from, to)); }

/// `v` with 0 for the coordinates along which the circle does not lie and that are not known.
geom::Vec3 known(geom::Vec3 v) {
    return {std::isnan(v.x) ? 0 : v.x, std::isnan(v.y) ? 0 : v.y, std::isnan(v.z) ? 0 : v.z};
}

double curved(geom::Vec3 from, const Arc& arc) {
    const geom::Vec3 spoke = from - arc.centre;
    const bool lost = (std::isnan(spoke.x) && std::abs(arc.normal.x) < 1) ||
                      (std::isnan(spoke.y) && std::abs(arc.normal.y) < 1) ||
                      (std::isnan(spoke.z) && std::abs(arc.normal.z) < 1);
    if (lost) return NAN;
    const geom::Vec3 chord = travel(from, arc.to);
    const double rise = geom::dot(known(chord), arc.normal);
    const geom::Vec3 s = known(spoke);
    const double radius = geom::length(s - geom::dot(s, arc.normal) * arc.normal);
    return geom::length(geom::Vec2{radius * arc.sweep, rise});
}

}  // namespace

geom::Vec3 position_after(geom::Vec3 from, const Step& step) {
    if (const auto* linear = std::get_if<Linear>(&step)) return linear->to;
    if (const auto* arc = std::get_if<Arc>(&step)) return arc->to;
    if (const auto* spline = std::get_if<Spline>(&step)) return spline->to;
    if (const auto* thread = std::get_if<Thread>(&step)) return thread->to;
    return from;
}

double move_length(geom::Vec3 from, const Step& move) {
    if (const auto* arc = std::get_if<Arc>(&move)) return curved(from, *arc);
    if (const auto* spline = std::get_if<Spline>(&move)) return geom::curve_length(curve(*spline));
    return straight(from, position_after(from, move));
}

void Totals::operator()(const Record& record) {
    ++records;
    if (const auto* datum = std::get_if<Datum>(&record.step)) change(zero, *datum, position);
    if (!is_move(record.step)) return;
    ++moves;
    const bool rapid = is_rapid(record.step);
    ++(rapid ? rapid_moves : feed_moves);
    const auto* line = std::get_if<Linear>(&record.step);
    const double length = line != nullptr ? straight(position, line->to) : move_length(position, record.step);
    if (std::isfinite(length)) (rapid ? rapid_length_mm : feed_length_mm) += length;
    position = line != nullptr ? line->to : position_after(position, record.step);
}

}  // namespace obrys::cl
