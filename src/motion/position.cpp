#include "motion/position.hpp"

namespace obrys::motion {

namespace {

/// Way from one zero to another, mm: none within the same offset even where it is not known.
double way(double from, double to, bool same_number) {
    return same_number && std::isnan(from) && std::isnan(to) ? 0 : to - from;
}

geom::Vec3 way(const cl::Datum& from, const cl::Datum& to) {
    const bool same = from.number == to.number;
    return {way(from.origin.x, to.origin.x, same), way(from.origin.y, to.origin.y, same),
            way(from.origin.z, to.origin.z, same)};
}

}  // namespace

void Position::take(const cl::Datum& datum) {
    if (datum_set_)
        here_ = here_ - way(datum_, datum);
    else
        here_ = {NAN, NAN, NAN};
    datum_ = datum;
    // The machine frame is no place for a stock: the frame stays open until an offset is in force.
    if (!fixed_ && datum.number != 0) {
        stock_ = datum;
        fixed_ = true;
    }
    datum_set_ = true;
    shift_ = fixed_ ? way(stock_, datum_) : geom::Vec3{};
}

void Position::move_to(geom::Vec3 to) { here_ = to; }

}  // namespace obrys::motion
