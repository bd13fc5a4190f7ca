#include "interp/selected_zero.hpp"

namespace obrys::interp {

/// The same for all the places that share it.
const base::SharedValue<cl::Cycle>& SelectedZero::moved_cycle(const base::SharedValue<cl::Cycle>& cycle) {
    if (cycle_from_.is_same(cycle) && cycle_by_ == by_) return cycle_to_;
    cl::Cycle moved = *cycle;
    moved.plane.origin = moved.plane.origin + by_;
    cycle_from_ = cycle, cycle_to_ = std::move(moved), cycle_by_ = by_;
    return cycle_to_;
}

void SelectedZero::operator()(const cl::Record& record) {
    if (const auto* datum = std::get_if<cl::Datum>(&record.step)) {
        if (!first_) first_ = *datum;
        by_ = geom::Vec3{} - cl::way(*first_, *datum);
        moved_ = by_ != geom::Vec3{};
    }
    if (!moved_ || !cl::has_points(record.step)) return out_(record);
    record_ = record;
    cl::shift(record_.step, by_);
    if (auto* begin = std::get_if<cl::CycleBegin>(&record_.step)) begin->cycle = moved_cycle(begin->cycle);
    out_(record_);
}

}  // namespace obrys::interp
