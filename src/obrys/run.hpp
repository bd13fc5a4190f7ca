#pragma once
/// Runs a prepared program and hands out what it makes the machine do.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "obrys/workspace.hpp"

namespace obrys::api {

/// X, Y, Z in mm, X a radius also on lathes; NaN where the program does not say where the axis is.
using Point = std::array<double, 3>;

enum class MoveKind : std::uint8_t {
    straight,
    arc,     ///< about `centre`, perhaps a helix
    curve,   ///< a spline: `from` and `to` are all that is said here
    thread,  ///< straight, coupled to the spindle
};
enum class FeedUnit : std::uint8_t { mm_per_min, mm_per_rev, per_min };
enum class SpeedUnit : std::uint8_t { rev_per_min, m_per_min };

/// Where an axis besides X, Y and Z stands at both ends of a move: degrees of a rotary one, mm of a linear one. NaN:
/// the program does not say it.
struct AxisWay {
    std::string name;  ///< as the control calls it: "B", "C2"
    double from = 0, to = 0;
    bool rotary = true;
    /// The control counts where it stands (tilted working plane, TCPM): points and tool axis are those on the
    /// workpiece, however the axis turns. Else points are in the machine's directions, as though the axis stood at 0,
    /// and where the tool then is on the workpiece follows from the machine.
    bool counted = false;
    bool operator==(const AxisWay&) const = default;
};

/// The zero point from which points count.
struct Zero {
    /// 54 for G54, 505 for G505; 1000 and more: presets 0 … of HEIDENHAIN controls; 500: none was selected; 0: that of
    /// the machine.
    std::uint32_t number = 0;
    Point origin{};  ///< in machine coordinates, mm, X as a radius; NaN where nobody gives it
};

/// One move of the tool's tip, in the frame of the zero point in force.
struct Move {
    MoveKind kind = MoveKind::straight;
    bool rapid = false;
    std::uint64_t index = 0;  ///< from 0
    Point from{}, to{};
    /// Unit vectors along the tool at both ends, from the tip into the holder, in the same frame; NaN at the begin of
    /// the first move. What lies between is the control's: evenly by `axes` where these move, else in the plane of
    /// both.
    Point axis_from{}, axis_to{0, 0, 1};
    /// The axes besides X, Y and Z that the program has moved so far, in the order in which it did so first.
    std::vector<AxisWay> axes;
    Zero zero;  ///< of this move, of `from` as well: where another one was selected, `from` is seen from the new one
    Point centre{}, normal{0, 0, 1};  ///< of an arc
    double sweep = 0;                 ///< of an arc, radians, counter-clockwise positive seen against `normal`
    double feed = 0;                  ///< 0: none was programmed
    FeedUnit feed_unit = FeedUnit::mm_per_min;
    double speed = 0;  ///< of the spindle
    SpeedUnit speed_unit = SpeedUnit::rev_per_min;
    int spindle = 0;         ///< 1 clockwise (M3), -1 counter-clockwise (M4), 0 standing
    std::uint32_t tool = 0;  ///< its number; 0: none, or known by name only
    bool in_cycle = false;   ///< made by a cycle of the control
    Place where;             ///< of the block
};

enum class Ending : std::uint8_t {
    regular,
    alarm,   ///< the control would stop; messages say where and why
    budget,  ///< the job's limit of blocks or time
};

struct Ran {
    Ending ending = Ending::regular;
    std::uint64_t blocks = 0;
    std::map<std::string, double> parameters;  ///< numbered ones that were assigned: "R5", "Q12"
    std::vector<Message> messages;             ///< of reading and running
};

/// `take` may be empty. Throws std::invalid_argument where the image is not usable.
Ran run(const Image& image, const std::function<void(const Move&)>& take = {}, const Inputs& inputs = {});

/// The stream in its text form (docs/cl-stream.md): everything, not the moves alone.
[[nodiscard]] std::string stream(const Image& image, const Inputs& inputs = {});

}  // namespace obrys::api
