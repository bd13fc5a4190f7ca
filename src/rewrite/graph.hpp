#pragma once
/// Where a run may go on behind each statement of a program.

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "base/source.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::rewrite {

/// The statement's entry in its kind's table; blocks have none.
[[nodiscard]] std::size_t entry_of(const program::Unit& unit, std::uint32_t statement);

/// How a block ends its program.
enum class Ends : std::uint8_t {
    no,
    program,  ///< M2, M30
    call,     ///< M17
};
[[nodiscard]] Ends ends_of(const program::Unit& unit, std::uint32_t statement);

/// The statement that a jump at `from` goes to; nothing where it is computed or not there.
[[nodiscard]] std::optional<std::uint32_t> destination(const program::Unit& unit, std::uint32_t from,
                                                       const program::Jump& jump, const program::Names& names,
                                                       const base::Sources& sources);
/// Of a name in the program, seen from a statement.
[[nodiscard]] std::optional<std::uint32_t> labelled(const program::Unit& unit, std::uint32_t from, program::NameId name,
                                                    program::JumpDirection direction);

/// Statements from the label of a call to the one that leads back, both included; nothing where it is not known.
struct Range {
    std::uint32_t first = 0, last = 0;
};
[[nodiscard]] std::optional<Range> called_range(const program::Unit& unit, const program::LabelCall& call);
/// The same of a repeated section.
[[nodiscard]] std::optional<Range> repeated_range(const program::Unit& unit, std::uint32_t statement,
                                                  const program::Section& section);

struct Graph {
    std::vector<std::vector<std::uint32_t>> next;  ///< one behind the last statement is the end
    std::set<std::uint32_t> jumped_to;             ///< by words of the program, not by its structures
};
[[nodiscard]] Graph graph_of(const program::Unit& unit, const program::Names& names, const base::Sources& sources);

}  // namespace obrys::rewrite
