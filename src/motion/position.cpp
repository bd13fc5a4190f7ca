#include "motion/position.hpp"

#include "cl/zero.hpp"

namespace obrys::motion {

void Position::take(const cl::Datum& datum) {
    if (datum_set_)
        here_ = here_ - cl::way(datum_, datum);
    else
        here_ = {NAN, NAN, NAN};
    datum_ = datum;
    // The machine frame is no place for a stock: the frame stays open until an offset is in force.
    if (!fixed_ && datum.number != 0) {
        stock_ = datum;
        fixed_ = true;
    }
    datum_set_ = true;
    shift_ = fixed_ ? cl::way(stock_, datum_) : geom::Vec3{};
}

void Position::move_to(geom::Vec3 to) { here_ = to; }

}  // namespace obrys::motion
