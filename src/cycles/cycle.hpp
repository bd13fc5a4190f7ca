#pragma once
/// One call of a machining cycle -> the steps the tool makes. Knows no control, no program and no frame.
///
/// Coordinates: (u, v, w) of the working plane, kept as geom::Vec3 x, y, z; w along the tool axis, away from the
/// workpiece positive; millimetres; the moved point is the tool tip. Feeds in mm/min, angles of parameters in degrees,
/// times in s. The caller maps the steps into its frame. Unknown is NaN: a path that would depend on it is not made.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cl/cycle.hpp"
#include "cl/record.hpp"
#include "geom/vec.hpp"

namespace obrys::cycles {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What holds when the cycle is called. NaN = not known.
struct Situation {
    geom::Vec3 at{unknown, unknown, unknown};  ///< the tool; u and v are the called position
    double tool_radius = unknown;
    double tool_corner_radius = unknown;
    double tool_point_angle = unknown;   ///< full angle of a drill's point, degrees
    double spindle_speed = unknown;      ///< 1/min
    int spindle_direction = 0;           ///< +1 M3, -1 M4, 0 standing
    double feed = unknown;               ///< programmed last
    double tool_plunge_angle = unknown;  ///< largest, degrees (ANGLE of the tool table); 0: it may not plunge obliquely
    double tool_cutting_length = unknown;  ///< LCUTS of the tool table
};

struct Demand {
    cl::CycleKind kind = cl::CycleKind::drill;
    std::vector<cl::CycleValue> values;

    /// What was written; nothing where it was not (the last one counts).
    [[nodiscard]] std::optional<double> find(cl::CycleRole role) const;
    [[nodiscard]] double get(cl::CycleRole role, double otherwise = unknown) const {
        return find(role).value_or(otherwise);
    }
};

/// What is wrong with a call, in programmer's terms.
struct Complaint {
    bool fatal = true;  ///< the control stops with it; otherwise a remark
    std::string text;
    std::string remedy;                    ///< may be empty
    std::optional<cl::CycleRole> role;     ///< the parameter at fault
    std::optional<std::size_t> element{};  ///< the element of a turning cycle's contour at fault
    bool doubtful = false;                 ///< hardly meant so: a finding, and the cycle is run
    bool too_many = false;                 ///< the steps are more than `most_steps`
};

struct Expansion {
    std::vector<cl::Step> steps;  ///< Linear, Arc (normal +w), Dwell, Feed, Spindle, Thread, Coolant
    std::size_t leads = 0;        ///< the first of them, which only lead over the place where the cycle begins
    std::vector<Complaint> complaints;
    /// Where the manuals leave the path in the material open: what was chosen. Empty: the path is as documented.
    std::string_view assumption;
    bool simulated = true;  ///< false: the path is not known, `steps` is empty; to be reported as not checked

    [[nodiscard]] bool ok() const {
        for (const Complaint& c : complaints)
            if (c.fatal) return false;
        return simulated;
    }
};

/// Number of steps after which an expansion is given up with a complaint (infeeds far too small).
inline constexpr std::size_t most_steps = 200'000;

}  // namespace obrys::cycles
