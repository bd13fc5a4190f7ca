#pragma once
/// What the writer has in hand for some records.

#include <optional>

#include "write/commands.hpp"
#include "write/values.hpp"

namespace obrys::write {

/// The rotary axes turn in the block that tilts the plane.
struct PlaneTurn {
    bool rapid = false;
    std::optional<double> about{};  ///< mm before the tip: what stays there; nothing: the linear axes stand
    bool is_written = false;        ///< the words of the plane have done it
};

struct Lead {
    Command command = Command::onto_tangent_line;
    bool onto = true, rapid = false;
    Values values;
};

/// Calls and repetitions that are open.
struct OpenPart {
    bool in_layout = false;  ///< else it is a contour of a cycle, or the like
    bool whole = true;       ///< it may be called by itself
};

}  // namespace obrys::write
