#pragma once
/// The words of the text form: the first of each line, and those of enumerators. Private to cl.

#include <array>
#include <string_view>

#include "cl/record.hpp"

namespace obrys::cl {

inline constexpr std::array<std::string_view, 2> axis_units{"mm", "deg"}, switches{"off", "on"},
    lead_ends{"off", "onto"}, speed_units{"1/min", "m/min"};
inline constexpr std::array<std::string_view, 3> feed_units{"mm/min", "mm/rev", "1/min"},
    stop_kinds{"program", "optional", "end"}, spindle_senses{"ccw", "stop", "cw"},
    length_senses{"subtracted", "off", "added"};
inline constexpr std::array<std::string_view, 5> filters{"none", "finishing", "semi-finishing", "roughing",
                                                         "precision"};

/// First words of lines by record; a rapid, a message and a part have further ones (`head_of`).
template <class T>
inline constexpr std::string_view head = "";
template <>
inline constexpr std::string_view head<Linear> = "linear";
template <>
inline constexpr std::string_view head<Arc> = "arc";
template <>
inline constexpr std::string_view head<Spline> = "spline";
template <>
inline constexpr std::string_view head<AxisEnd> = "axis";
template <>
inline constexpr std::string_view head<MachinePlace> = "machine";
template <>
inline constexpr std::string_view head<Thread> = "thread";
template <>
inline constexpr std::string_view head<Dwell> = "dwell";
template <>
inline constexpr std::string_view head<Feed> = "feed";
template <>
inline constexpr std::string_view head<Spindle> = "spindle";
template <>
inline constexpr std::string_view head<OtherSpindle> = "other-spindle";
template <>
inline constexpr std::string_view head<ToolChange> = "tool";
template <>
inline constexpr std::string_view head<ToolSelection> = "next-tool";
template <>
inline constexpr std::string_view head<ToolData> = "tool-data";
template <>
inline constexpr std::string_view head<DatumData> = "zero-data";
template <>
inline constexpr std::string_view head<ToolLength> = "length";
template <>
inline constexpr std::string_view head<Coolant> = "coolant";
template <>
inline constexpr std::string_view head<Stop> = "stop";
template <>
inline constexpr std::string_view head<Comment> = "comment";
template <>
inline constexpr std::string_view head<Datum> = "datum";
template <>
inline constexpr std::string_view head<Frame> = "frame";
template <>
inline constexpr std::string_view head<Tolerance> = "tolerance";
template <>
inline constexpr std::string_view head<PathMode> = "path";
template <>
inline constexpr std::string_view head<Auxiliary> = "aux";
template <>
inline constexpr std::string_view head<Output> = "output";
template <>
inline constexpr std::string_view head<Override> = "override";
template <>
inline constexpr std::string_view head<CycleBegin> = "cycle";
template <>
inline constexpr std::string_view head<CycleEnd> = "cycle-end";
template <>
inline constexpr std::string_view head<PartBegin> = "call";
template <>
inline constexpr std::string_view head<PartEnd> = "part-end";
template <>
inline constexpr std::string_view head<CompensationBegin> = "compensation";
template <>
inline constexpr std::string_view head<CompensationEnd> = "compensation-end";
template <>
inline constexpr std::string_view head<Programmed> = "programmed";
template <>
inline constexpr std::string_view head<LeadBegin> = "lead";
template <>
inline constexpr std::string_view head<LeadEnd> = "lead-end";

}  // namespace obrys::cl
