#include "interp/selected_zero.hpp"

namespace obrys::interp {

void SelectedZero::operator()(const cl::Record& record) {
    if (const auto* datum = std::get_if<cl::Datum>(&record.step)) {
        if (!first_) first_ = *datum;
        by_ = geom::Vec3{} - cl::way(*first_, *datum);
        moved_ = by_ != geom::Vec3{};
    }
    if (!moved_ || !(cl::is_move(record.step) || std::holds_alternative<cl::CycleBegin>(record.step)))
        return out_(record);
    record_ = record;
    cl::shift(record_.step, by_);
    out_(record_);
}

}  // namespace obrys::interp
