#pragma once
/// Cycles as definitions and calls have left them: values only. Private to interp.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/source.hpp"
#include "cl/stacks.hpp"
#include "geom/edge.hpp"
#include "geom/vec.hpp"
#include "interp/value.hpp"
#include "program/unit.hpp"

namespace obrys::interp {

using program::Unit;

/// What a call of a cycle at one hole says (Traits::called_holes): mm, degrees, s, 1/min; NaN: written, but not known.
struct HoleCall {
    const program::CalledHole* cycle = nullptr;
    std::vector<std::optional<double>> arguments;  ///< as the cycle has them; nothing: left out
    base::Span where;

    [[nodiscard]] std::optional<double> find(program::HoleArgument a) const {
        for (std::size_t i = 0; i < arguments.size(); ++i)
            if (cycle->arguments[i] == a) return arguments[i];
        return std::nullopt;
    }
    [[nodiscard]] double get(program::HoleArgument a, double otherwise = 0) const {
        return find(a).value_or(otherwise);
    }
};

/// A word of a cycle that stays with the control, and where it was said.
struct KeptSetting {
    double value = 0;  ///< mm, degrees
    base::Span where;
};

/// MCALL: the call that follows every block with motion.
struct ModalCall {
    const Unit* unit = nullptr;
    std::vector<Value> arguments;  ///< as they were when MCALL stood in the program
    std::vector<std::uint8_t> given;
    base::Span where;
    /// With Traits::argument_parameters: the called program's own parameters, which stay from call to call.
    std::vector<std::pair<double, bool>> parameters;
    std::uint64_t repeats = 0;  ///< further runs of each call
    HoleCall hole;              ///< a cycle of the control, instead of `unit`

    [[nodiscard]] bool is_on() const { return unit != nullptr || hole.cycle != nullptr; }
};

/// A cycle as its definition left it.
struct ActiveCycle {
    const program::CycleDefinition* definition = nullptr;
    const Unit* unit = nullptr;
    std::vector<double> values;      ///< per setting, as it was at the definition
    std::vector<double> written;     ///< … and what stood there: the number behind FU, FZ
    std::vector<std::string> texts;  ///< labels, names of programs
    bool modal = false;              ///< M89: behind every block with motion
};

/// What the words of a canned cycle's blocks have said, until it is cancelled.
struct CannedState {
    bool active = false;
    int cycle = -1;            ///< index in Traits::canned
    double retract = 0;        ///< R, mm: a position where Traits::canned_positions_stay, else as written
    double bottom = 0;         ///< coordinate of the tool axis, mm: the same
    double initial_level = 0;  ///< of the tool axis when the series began, mm
    bool has_retract = false, has_bottom = false;
    bool bottom_from_retract = false;  ///< it was said in G91
    std::array<double, 12> values{};   ///< by word of the cycle; mm, degrees, s
    std::array<bool, 12> given{};
    std::array<base::Span, 12> places{};  ///< where they were said
    std::optional<double> last_dwell;  ///< P of the last cycle that had one, s
};

/// Points at which CYCL CALL PAT calls the cycle, as PATTERN DEF or SEL PATTERN left them; mm.
struct CallPattern {
    struct Point {
        geom::Vec3 at;         ///< the coordinate of the tool axis is that of the surface
        double clearance = 0;  ///< coordinate of the tool axis on the way to it; NaN: none
    };
    bool defined = false;
    std::vector<Point> points;
    base::Span where;
};

/// A statement about the contour of contour cycles that was run, with its values as they were.
struct ContourChoice {
    struct Part {
        std::string name;  ///< of the label or program
        double depth = 0;  ///< mm; NaN: none of its own
    };
    const program::ContourStatement* statement = nullptr;
    const Unit* unit = nullptr;
    std::vector<Part> parts;
};

/// An element as it ended up, chamfers and roundings apart (they belong to the block before them), and the block that
/// makes it: called from the cycle's call.
struct ContourElement {
    geom::Edge edge;
    base::Span where;
    cl::StackId stack = 0;
};
using ContourElements = std::vector<ContourElement>;

}  // namespace obrys::interp
