#pragma once
/// The tool that is in use when a program begins, and how the job's tools stand to what T names.

#include <cstdint>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/unit.hpp"
#include "shop/job.hpp"

namespace obrys::driver {

/// Number of the tool in use when the program begins: as the job says it (`first_tool`); else the only tool of the job
/// where no block of the program selects or defines one, which is an assumption. 0: not known.
[[nodiscard]] std::uint32_t first_tool(const shop::Job& job, const program::Unit& main, base::Diagnostics& diagnostics);

/// Whether some block has to do with which tool is in use: T, TOOL CALL, TOOL DEF, M6, M61.
[[nodiscard]] bool selects_tool(const program::Unit& unit);

/// Tools for which the job gives no edge, on controls whose T names an offset beside the tool (T0202): the offset of
/// the tool's own number.
void number_offsets(bool edge_is_offset_number, std::vector<shop::Tool>& tools);

}  // namespace obrys::driver
