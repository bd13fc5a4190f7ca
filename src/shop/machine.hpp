#pragma once
/// What a machine can do and what its control assumes when switched on. File format: docs/machine-file.md.

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "geom/vec.hpp"

namespace obrys::shop {

/// Number of preset 0 among the datums.
inline constexpr std::uint32_t first_preset = 1000;

enum class MachineKind : std::uint8_t { lathe, mill };

struct MachineAxis {
    std::string name;                          ///< as programmed: "X", "Z", "C2"
    bool rotary = false;                       ///< values below in degrees instead of mm
    std::optional<double> min, max;            ///< travel in machine coordinates; a lathe's X as a radius
    double rapid = 10'000;                     ///< mm/min or degrees/min
    std::optional<double> acceleration, jerk;  ///< mm/s2, mm/s3 or degrees; nothing: as the path's (MachineMotion)
    std::optional<double> home;                ///< machine coordinate of the reference point (G28, G74), if known
    std::optional<double> second_home;         ///< the same of the second one (G30)
    /// Unit vector. Where its value grows, what stands behind the axis towards the tool moves that way, or turns
    /// counter-clockwise about it, as seen from the workpiece side: so too where really the table moves the other way.
    geom::Vec3 direction;
    geom::Vec3 centre;  ///< of a rotary axis: a point of its line, machine coordinates with all axes at 0
};

/// How axes that start a rapid move together end it: all at once, or each at its own rapid, so that the path bends;
/// `either`: a setting that is not known decides.
enum class RapidPath : std::uint8_t { straight, dog_leg, either };

/// How a control goes through the places where a path turns.
enum class CornerPassing : std::uint8_t { exact_stop, filter, blend };

/// How a control moves, for how long that takes. Nothing: the file does not say it.
struct MachineMotion {
    std::optional<double> acceleration, jerk;  ///< along the path, mm/s2, mm/s3
    std::optional<double> tolerance;           ///< mm that corners are rounded by where a program says nothing
    std::optional<double> block_time;          ///< s for a block
    std::optional<double> look_ahead;          ///< blocks; 0: without end
    std::optional<double> spindle_time;        ///< s for 1000 1/min more or less
    std::optional<CornerPassing> corner;
    std::optional<double> servo_gain;   ///< 1/s: how fast lag is made up; 0: there is none (feed forward)
    std::optional<double> window;       ///< mm within which an axis counts as in position
    std::optional<double> strobe_time;  ///< s that an M function takes
};

struct MachineSpindle {
    double min = 0, max = std::numeric_limits<double>::infinity();  ///< 1/min; infinite: not limited
    std::optional<double> power;                                    ///< kW
};

/// State of the control at the start of a program.
struct ControlDefaults {
    bool diameter_programming = false;  ///< X words are diameters (DIAMON)
    bool inch = false;
    bool feed_per_rev = false;
    int plane = 17;                  ///< 17, 18, 19
    double circle_tolerance = 0.01;  ///< mm the two radii of an arc may differ (MD CIRCLE_ERROR_CONST)
};

/// What a control leaves to the builder of its machine; nothing: the file does not say it.
struct ControlSettings {
    std::optional<char> g_code_system;        ///< of FANUC lathes: 'A', 'B', 'C'
    std::optional<bool> whole_numbers_count;  ///< lengths without a point count increments; false: mm, inches, degrees
    std::optional<double> increments_per_mm;  ///< coordinates count in so many (IS-B: 1000, IS-C: 10000)
    std::optional<bool> angles_from_zero;  ///< ATAN is 0 … 360 degrees, ASIN 270 … 90; false: -180 … 180, -90 … 90
};

struct Machine {
    std::string name = "generic";
    MachineKind kind = MachineKind::mill;
    std::vector<MachineAxis> axes;
    /// Axes that move workpiece and tool against each other, as indices, from the workpiece to the tool:
    /// shop/kinematics.hpp.
    std::vector<std::size_t> chain;
    std::optional<RapidPath> rapid_path;  ///< not said: as the control does it
    bool more_axes = false;               ///< axes it does not list are taken for granted (the machine was not named)
    MachineSpindle spindle;
    MachineMotion motion;
    double max_feed = 0, min_feed = 0;                   ///< mm/min; 0 = not limited
    std::optional<double> tool_change_time;              ///< s; nothing: the file does not say it
    std::optional<bool> tool_change_stops_spindle;       ///< not said: as the control does it, else mills do
    std::map<std::string, double> tool_change_position;  ///< machine coordinate by name of an axis; others stay
    ControlDefaults defaults;
    ControlSettings control;
    /// Settable zero offsets (54 … 599): position of the workpiece zero in machine coordinates, mm, x as a radius.
    /// 500: the one in force where a program selects none; from `first_preset` on the presets of HEIDENHAIN controls,
    /// NaN in axes that a preset leaves as they are.
    std::map<std::uint32_t, geom::Vec3> datums;
    std::map<std::uint32_t, double> datum_rotations;  ///< about Z, radians; of datums that are turned
    std::map<std::string, double> machine_data;       ///< by upper-case name with its $: "$MC_…", "$MN_…"
    /// Where values that decide times come from, in the words of the file: by "motion.jerk", "tool_change_time",
    /// "axis.X.rapid", of all axes "axis.rapid".
    std::map<std::string, std::string> origins;
};

}  // namespace obrys::shop
