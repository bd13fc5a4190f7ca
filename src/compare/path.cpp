#include <cmath>

#include "cl/totals.hpp"
#include "compare/compare.hpp"

namespace obrys::compare {

namespace {

bool is_same(double a, double b, double tolerance) {
    return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance;
}

}  // namespace

void Path::hold() {
    const motion::State& s = cursor_.state();
    Holding now{s.feed, s.spindle, s.coolant, s.change, s.datum, s.frame, s.tolerance};
    if (!(now == *holding_)) holding_ = std::make_shared<const Holding>(std::move(now));
}

void Path::take_move(const cl::Record& record, const geom::Vec3& to) {
    const auto* line = std::get_if<cl::Linear>(&record.step);
    const bool stays = line != nullptr && at_ && axes_.empty() && is_same(at_->x, to.x, same_place_) &&
                       is_same(at_->y, to.y, same_place_) && is_same(at_->z, to.z, same_place_);
    if (stays) return;
    hold();
    for (const cl::Axis& axis : axes_) stands_[axis.name] = axis.to;
    moves.push_back({record.step, std::exchange(axes_, {}), holding_, record.from, record.stack});
    at_ = to;
}

/// An axis that is told to go where it stands does not move.
void Path::take_axis(const cl::Axis& axis) {
    std::erase_if(axes_, [&](const cl::Axis& a) { return a.name == axis.name; });
    const auto [stands, is_new] = stands_.emplace(axis.name, NAN);
    if (is_same(stands->second, axis.to, same_place_) && !std::isnan(axis.to)) return;
    axes_.push_back(axis);
}

void Path::take(const cl::Record& record) {
    const cl::Step& step = record.step;
    const auto datum = cursor_.state().datum;
    if (const auto moved = cursor_.take(record)) return take_move(record, moved->to);
    // Another zero: the tool stands still, and its place has other numbers.
    if (std::holds_alternative<cl::Datum>(step) && !(cursor_.state().datum == datum)) at_.reset();
    const Item item{step, record.from, record.stack, moves.size()};
    if (const auto* axis = std::get_if<cl::Axis>(&step)) take_axis(*axis);
    if (std::holds_alternative<cl::CycleBegin>(step))
        cycles.push_back(item);
    else if (std::holds_alternative<cl::CompensationBegin>(step) || std::holds_alternative<cl::CompensationEnd>(step) ||
             std::holds_alternative<cl::Programmed>(step) || std::holds_alternative<cl::LeadBegin>(step))
        contours.push_back(item);
    else if (std::holds_alternative<cl::Stop>(step) || std::holds_alternative<cl::Dwell>(step) ||
             std::holds_alternative<cl::Comment>(step) || std::holds_alternative<cl::Auxiliary>(step) ||
             std::holds_alternative<cl::ToolChange>(step) || std::holds_alternative<cl::ToolLength>(step) ||
             std::holds_alternative<cl::ToolData>(step) || std::holds_alternative<cl::DatumData>(step) ||
             std::holds_alternative<cl::MachinePlace>(step))
        events.push_back(item);
}

}  // namespace obrys::compare
