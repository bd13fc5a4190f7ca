#include "cl/zero.hpp"

#include <cmath>

namespace obrys::cl {

namespace {

double way(double from, double to) { return std::isnan(from) || std::isnan(to) ? 0 : to - from; }

}  // namespace

geom::Vec3 way(const Datum& from, const Datum& to) {
    return {way(from.origin.x, to.origin.x), way(from.origin.y, to.origin.y), way(from.origin.z, to.origin.z)};
}

void change(std::optional<Datum>& zero, const Datum& next, geom::Vec3& place) {
    if (zero) place = place - way(*zero, next);
    zero = next;
}

bool has_points(const Step& step) {
    return is_move(step) || std::holds_alternative<CycleBegin>(step) || std::holds_alternative<Programmed>(step) ||
           std::holds_alternative<LeadBegin>(step);
}

void shift(Step& step, const geom::Vec3& by) {
    if (auto* linear = std::get_if<Linear>(&step)) linear->to = linear->to + by;
    if (auto* arc = std::get_if<Arc>(&step)) arc->to = arc->to + by, arc->centre = arc->centre + by;
    if (auto* spline = std::get_if<Spline>(&step)) spline->to = spline->to + by;
    if (auto* thread = std::get_if<Thread>(&step)) thread->to = thread->to + by;
    if (auto* p = std::get_if<Programmed>(&step))
        p->from = p->from + by, p->to = p->to + by, p->centre = p->centre + by;
    if (auto* begin = std::get_if<CycleBegin>(&step)) begin->place = begin->place + by;
    if (auto* lead = std::get_if<LeadBegin>(&step)) lead->at = lead->at + by;
}

}  // namespace obrys::cl
