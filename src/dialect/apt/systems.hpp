#pragma once
/// Who wrote a text of cutter locations: what CAM systems write differently, one row each.

#include <array>
#include <cstdint>
#include <string_view>

namespace obrys::dialect::apt {

/// Where the tool goes between two holes, and what a number of a cycle counts from.
enum class RapidTo : std::uint8_t {
    above_point,     ///< RAPTO: above the point of GOTO; the feed begins there
    from_clearance,  ///< RAPTO: below CLEAR, towards the work
};

struct System {
    std::string_view name;
    std::array<std::string_view, 6> signs{};  ///< what its texts hold and others do not, upper case without blanks
    /// +1: arcs run counter-clockwise about the vector of CIRCLE; -1: clockwise.
    int sense = 1;
    /// All points behind CIRCLE that lie on the circle are of the arc; else the next one alone is.
    bool several_points = false;
    /// An arc to where it starts is a whole circle; else it is none.
    bool same_point_is_circle = true;
    RapidTo rapid_to = RapidTo::above_point;
    /// The point of a hole is the top of the work, which steps count from; else they count from where the feed begins.
    bool holes_begin_at_surface = false;
    bool inserts_notes = false;     ///< INSERT holds notes for the operator; else what the control shall get
    bool system_aims_tool = false;  ///< CSYS says how the tool stands: its third column
};

/// The first row is that of texts nobody can be named for.
[[nodiscard]] const System& system_of(std::string_view text);

}  // namespace obrys::dialect::apt
