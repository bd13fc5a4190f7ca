#pragma once
/// What is compared of a record of each kind, and where.

#include <cstdint>
#include <type_traits>

#include "cl/record.hpp"

namespace obrys::compare {

template <class T, class... Kinds>
concept one_of = (std::is_same_v<T, Kinds> || ...);

/// Where a record is compared.
enum class Role : std::uint8_t { move, holds, event, cycle, contour, part, preparation, remark };
/// A kind that is not named here does not compile.
struct RoleOf {
    Role operator()(const one_of<cl::Linear, cl::Arc, cl::Spline, cl::Thread> auto&) const { return Role::move; }
    Role operator()(const one_of<cl::Feed, cl::Spindle, cl::Coolant, cl::ToolLength, cl::Datum, cl::Frame,
                                 cl::Tolerance, cl::PathMode> auto&) const {
        return Role::holds;
    }
    Role operator()(const one_of<cl::OtherSpindle, cl::ToolChange, cl::ToolData, cl::Stop, cl::Dwell, cl::Auxiliary,
                                 cl::MachinePlace, cl::DatumData, cl::Output, cl::Override> auto&) const {
        return Role::event;
    }
    Role operator()(const one_of<cl::CycleBegin, cl::CycleEnd> auto&) const { return Role::cycle; }
    Role operator()(const one_of<cl::CompensationBegin, cl::CompensationEnd, cl::Programmed, cl::LeadBegin,
                                 cl::LeadEnd> auto&) const {
        return Role::contour;
    }
    Role operator()(const one_of<cl::PartBegin, cl::PartEnd> auto&) const { return Role::part; }
    Role operator()(const cl::ToolSelection&) const { return Role::preparation; }
    Role operator()(const cl::Comment&) const { return Role::remark; }  // text without effect
};

/// What turns and flows while the event happens counts.
[[nodiscard]] inline bool has_state(const cl::Step& event) {
    const auto* output = std::get_if<cl::Output>(&event);  // one with the next move is looked at there
    return std::holds_alternative<cl::Dwell>(event) || std::holds_alternative<cl::Stop>(event) ||
           std::holds_alternative<cl::Auxiliary>(event) || (output != nullptr && !output->with_motion);
}

/// What its block says behind it holds there, too; but a dwell of a cycle stands between its steps, all of one block.
[[nodiscard]] inline bool holds_to_the_end_of_its_block(const cl::Step& event) {
    return has_state(event) && !std::holds_alternative<cl::Dwell>(event);
}

}  // namespace obrys::compare
