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

double helix_length(const geom::Vec3& spoke, const geom::Vec3& chord, const Arc& arc) {
    const double rise = geom::dot(chord, arc.normal);
    const double radius = geom::length(spoke - geom::dot(spoke, arc.normal) * arc.normal);
    return geom::length(geom::Vec2{radius * arc.sweep, rise});
}

double curved(geom::Vec3 from, const Arc& arc) {
    const geom::Vec3 spoke = from - arc.centre;
    if (geom::is_finite(spoke) && geom::is_finite(arc.to))  // as nearly always
        return helix_length(spoke, arc.to - from, arc);
    const bool lost = (std::isnan(spoke.x) && std::abs(arc.normal.x) < 1) ||
                      (std::isnan(spoke.y) && std::abs(arc.normal.y) < 1) ||
                      (std::isnan(spoke.z) && std::abs(arc.normal.z) < 1);
    if (lost) return NAN;
    return helix_length(known(spoke), known(travel(from, arc.to)), arc);
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

namespace {

void add(Totals& t, bool rapid, double length, geom::Vec3 to) {
    ++t.moves;
    ++(rapid ? t.rapid_moves : t.feed_moves);
    if (std::isfinite(length)) (rapid ? t.rapid_length_mm : t.feed_length_mm) += length;
    t.position = to;
}

}  // namespace

void Totals::operator()(const Record& record) {
    ++records;
    const Step& step = record.step;
    if (const auto* line = std::get_if<Linear>(&step))
        return add(*this, line->rapid, straight(position, line->to), line->to);
    if (const auto* arc = std::get_if<Arc>(&step)) return add(*this, arc->rapid, curved(position, *arc), arc->to);
    if (const auto* datum = std::get_if<Datum>(&step)) change(zero, *datum, position);
    if (is_move(step)) add(*this, is_rapid(step), move_length(position, step), position_after(position, step));
}

}  // namespace obrys::cl
