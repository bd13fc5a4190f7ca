/// Data of statements with words of their own.

#include "interp/capture.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::Datum;
using program::Special;

double datum_of(Reckoning& run, const Special& s, Datum datum, double otherwise) {
    for (const program::DatumValue& d : s.data)
        if (d.datum == datum) return number(run, d.value);
    return otherwise;
}

bool has_datum(const Special& s, Datum datum) {
    for (const program::DatumValue& d : s.data)
        if (d.datum == datum) return true;
    return false;
}

}  // namespace obrys::interp
