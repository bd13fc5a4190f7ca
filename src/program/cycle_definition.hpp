#pragma once
/// How a program defines a cycle: what it says of each value, and how much of the cycle obrys runs.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.hpp"
#include "cl/cycle.hpp"
#include "program/expr.hpp"

namespace obrys::program {

inline constexpr std::uint32_t no_target = 0xFFFFFFFF;

/// How a setting is given: by a number, or by a word that stands for one at the call.
enum class SettingGiven : std::uint8_t {
    number,
    rapid,         ///< FMAX
    tool_feed,     ///< FAUTO: the feed given with the tool
    per_rev,       ///< FU: `value` for each revolution of the spindle
    per_tooth,     ///< FZ: … and tooth of the tool
    set_globally,  ///< PREDEF: what CycleKind::global_values says of the same parameter
};
/// One value of a cycle definition.
struct CycleSetting {
    cl::CycleRole role = cl::CycleRole::depth;
    /// Numbered parameter that holds it: the definition assigns it, the call reads it. no_target: `value` alone counts,
    /// as it was at the definition.
    std::uint32_t parameter = no_target;
    ExprId value = no_expr;
    bool incremental = false;
    bool as_modal = false;  ///< incremental where G91 holds when it is defined
    bool scales = false;    ///< a length in the program's unit
    bool is_feed = false;   ///< a feed in the program's unit
    base::Span where;
    bool across = false;  ///< a diameter where the program has diameters
    SettingGiven given = SettingGiven::number;
};

/// What a turning cycle takes where neither it nor an earlier one says it: on the machine the control's own data hold
/// it, which are not known here.
struct CycleDefault {
    cl::CycleRole role = cl::CycleRole::depth;
    double value = 0;  ///< mm, degrees
    cl::CycleRole needs =
        cl::CycleRole::depth;  ///< matters only where this one is written; the same as `role`: matters always
    std::string_view text;     ///< what is taken, for whom it concerns
};

/// How much of a cycle obrys runs.
enum class CycleUse : std::uint8_t { run, accepted, refused };
struct CycleDefinition {
    cl::CycleKind kind = cl::CycleKind::drill;
    std::string name;          ///< as the control calls it: "CYCL DEF 25"
    bool call_active = false;  ///< runs where it is called; else it acts here
    CycleUse use = CycleUse::run;
    std::string reason;  ///< why it is refused, or what it does without effect on the path
    std::vector<CycleSetting> settings;
    std::vector<ExprId> texts;  ///< labels of contours, names of programs
    base::Span where;
    // Turning cycles (cycles/turn/turning.hpp) act at their definition.
    /// The contour: the blocks of this program from the one with this number to that one, which are not run where they
    /// stand. One whose first block names both axes of the plane may have pockets.
    ExprId first_block = no_expr, last_block = no_expr;
    std::uint8_t store = 0;  ///< values that stay with the control, by group of cycles; 0: there are none
    bool sets_only = false;  ///< its values go to the store, nothing is cut
    std::span<const CycleDefault> otherwise{};
};

}  // namespace obrys::program
