#include "motion/cursor.hpp"

#include <algorithm>
#include <utility>

#include "cl/totals.hpp"

namespace obrys::motion {

const shop::Tool* find_tool(std::span<const shop::Tool> tools, const cl::ToolChange& wanted) {
    if (wanted.number == 0 && wanted.name.empty()) return nullptr;
    for (const shop::Tool& t : tools) {
        const bool same = wanted.number != 0 ? t.number == wanted.number : t.name == wanted.name;
        if (same && (wanted.edge == 0 || t.edge == wanted.edge)) return &t;
    }
    return nullptr;
}

namespace {

template <class... Fs>
struct Visitor : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Visitor(Fs...) -> Visitor<Fs...>;

}  // namespace

/// All kinds are named: a new one stops this from compiling until somebody has said whether it holds on.
void Cursor::take_modal(const cl::Record& record) {
    State& s = state_;
    std::visit(Visitor{
                   [&](const cl::Feed& feed) { s.feed = feed; },
                   [&](const cl::Spindle& spindle) { s.spindle = spindle; },
                   [&](const cl::Coolant& coolant) { s.coolant = coolant; },
                   [&](const cl::Tolerance& tolerance) { s.tolerance = tolerance; },
                   [&](const cl::Datum& datum) {
                       s.datum = datum;
                       position_.take(datum);
                   },
                   [&](const cl::PathMode& path) { s.path = path; },
                   [&](const cl::Frame& frame) { s.frame = frame; },
                   [&](const cl::ToolChange& change) {
                       s.change = change;
                       s.changed = record.from;
                       s.changed_from = record.stack;
                       s.any_tool = change.number != 0 || !change.name.empty();
                       s.tool = find_tool(tools_, change);
                   },
                   [&](const cl::CycleBegin&) { ++s.cycles; },
                   [&](const cl::CycleEnd&) { s.cycles -= s.cycles > 0 ? 1 : 0; },
                   [&](const cl::PartBegin&) { ++s.parts; },
                   [&](const cl::PartEnd&) { s.parts -= s.parts > 0 ? 1 : 0; },
                   [&](const cl::CompensationBegin& begin) { s.compensation = begin; },
                   [&](const cl::CompensationEnd&) { s.compensation.reset(); },
                   [&](const cl::ToolLength& length) { s.length = length; },
                   [](const cl::OtherSpindle&) {},  // moves are not made with it
                   [](const cl::MachinePlace&) {},
                   [](const cl::ToolSelection&) {},
                   [](const cl::Output&) {},
                   [](const cl::Override&) {},
                   [](const cl::ToolData&) {},
                   [](const cl::DatumData&) {},  // Datum says what follows
                   [&](const cl::LeadBegin&) { s.leads = true; },
                   [&](const cl::LeadEnd&) { s.leads = false; },
                   [](const cl::Programmed&) {},
                   [](const cl::Linear&) {},
                   [](const cl::Arc&) {},
                   [](const cl::Spline&) {},
                   [](const cl::Thread&) {},
                   [](const cl::Dwell&) {},
                   [](const cl::Stop&) {},
                   [](const cl::Comment&) {},
                   [](const cl::Auxiliary&) {},
               },
               record.step);
}

const cl::AxisEnd* find_axis(const cl::AxisEnds& axes, const std::array<char, 8>& name) {
    const auto found =
        std::find_if(axes.begin(), axes.end(), [&](const cl::AxisEnd& axis) { return axis.name == name; });
    return found == axes.end() ? nullptr : &*found;
}

void Cursor::take_axes(const cl::Step& step) {
    if (std::exchange(axes_moved_, false)) axes_from_ = axes_;
    const auto take = [this](const cl::AxisEnd& end) {
        axes_moved_ = true;
        if (const cl::AxisEnd* stood = find_axis(axes_, end.name))
            axes_[static_cast<std::size_t>(stood - axes_.data())] = end;
        else
            axes_.push_back(end);
    };
    for (const cl::AxisEnd& end : *cl::ends_of(step)) take(end);
    if (const auto* spline = std::get_if<cl::Spline>(&step))
        for (const cl::SplineAxis& axis : spline->axes) take({axis.name, axis.to, axis.rotary, false});
}

std::optional<Step> Cursor::take(const cl::Record& record) {
    if (!cl::is_move(record.step)) {
        take_modal(record);
        return std::nullopt;
    }
    const geom::Vec3 from = position_.here(), to = cl::position_after(from, record.step);
    position_.move_to(to);
    take_axes(record.step);
    const geom::Vec3 axis_from = std::exchange(axis_, *cl::tool_axis_of(record.step));
    return Step{record,
                moves_++,
                from,
                to,
                axis_from,
                axis_,
                axes_from_,
                axes_,
                position_.to_stock(),
                cl::is_rapid(record.step),
                state_};
}

}  // namespace obrys::motion
