#pragma once
/// The cutter-location stream: what a program makes the machine do, whatever control it was written for.
/// Meaning of each record: docs/cl-stream.md. Lengths in millimetres, angles in radians, workpiece frame, tool tip
/// (the point the control moves). On lathes x is a radius. A coordinate that is not known yet is NaN.

#include <cstdint>
#include <utility>
#include <variant>

#include "base/function_ref.hpp"
#include "base/source.hpp"
#include "cl/brackets.hpp"
#include "cl/moves.hpp"
#include "cl/technology.hpp"
#include "cl/zeros.hpp"

namespace obrys::cl {

/// One step of the tool's life. Closed on purpose: a new kind must break every visitor that names all kinds.
using Step = std::variant<Linear, Arc, Spline, MachinePlace, Thread, Dwell, Feed, Spindle, OtherSpindle, ToolChange,
                          ToolSelection, ToolData, DatumData, ToolLength, Coolant, Stop, Comment, Datum, Frame,
                          Tolerance, PathMode, Auxiliary, Output, Override, CycleBegin, CycleEnd, PartBegin, PartEnd,
                          CompensationBegin, CompensationEnd, Programmed, LeadBegin, LeadEnd>;

/// Identifies a call stack in `CallStacks`; 0 is the main program.
using StackId = std::uint32_t;

struct Record {
    Step step;
    base::Span from;    ///< the source text that caused it; along a contour cycle's contour: the block of that element
    StackId stack = 0;  ///< where it was called from
};

/// Takes records one by one; memory does not grow with the length of the program.
using Sink = base::FunctionRef<void(const Record&)>;

[[nodiscard]] inline bool is_move(const Step& s) {
    return std::holds_alternative<Linear>(s) || std::holds_alternative<Arc>(s) || std::holds_alternative<Spline>(s) ||
           std::holds_alternative<Thread>(s);
}
/// Where the additional axes stand that a move takes along; null: no move.
[[nodiscard]] inline const AxisEnds* ends_of(const Step& s) {
    if (const auto* linear = std::get_if<Linear>(&s)) return &linear->ends;
    if (const auto* arc = std::get_if<Arc>(&s)) return &arc->ends;
    if (const auto* spline = std::get_if<Spline>(&s)) return &spline->ends;
    const auto* thread = std::get_if<Thread>(&s);
    return thread != nullptr ? &thread->ends : nullptr;
}
[[nodiscard]] inline AxisEnds* ends_of(Step& s) { return const_cast<AxisEnds*>(ends_of(std::as_const(s))); }
/// How the tool stands at the end of a move: the unit vector from the tip into the holder. None of what is no move.
[[nodiscard]] inline const geom::Vec3* tool_axis_of(const Step& s) {
    if (const auto* linear = std::get_if<Linear>(&s)) return &linear->axis;
    if (const auto* arc = std::get_if<Arc>(&s)) return &arc->axis;
    if (const auto* spline = std::get_if<Spline>(&s)) return &spline->axis;
    const auto* thread = std::get_if<Thread>(&s);
    return thread != nullptr ? &thread->axis : nullptr;
}
[[nodiscard]] inline bool is_rapid(const Step& s) {
    if (const auto* arc = std::get_if<Arc>(&s)) return arc->rapid;
    const auto* linear = std::get_if<Linear>(&s);
    return linear != nullptr && linear->rapid;
}

}  // namespace obrys::cl
