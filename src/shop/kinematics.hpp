#pragma once
/// Where the tool stands against the workpiece while a machine's axes stand somewhere, and back: three linear axes and
/// up to two rotary ones, of table or head.
///
/// Frames. The machine frame is fixed; its origin is the gauge point of the spindle with all axes at 0. The table frame
/// moves with the workpiece and agrees with the machine frame while all axes stand at 0. mm and radians.

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "geom/frame.hpp"
#include "shop/machine.hpp"

namespace obrys::shop {

struct Joint {
    std::string name;
    bool rotary = false;
    geom::Vec3 direction;  ///< unit vector, as MachineAxis::direction
    geom::Vec3 centre;     ///< of a rotary joint: a point of its line with all axes at 0
    double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
    bool operator==(const Joint&) const = default;
};

/// From the workpiece to the tool. Values of a chain: one a joint, in its order.
struct Chain {
    std::vector<Joint> joints;
};
[[nodiscard]] Chain chain_of(const Machine& machine);

/// Tip and axis of a tool, the axis a unit vector from the tip towards the spindle.
struct ToolPose {
    geom::Vec3 tip;
    geom::Vec3 axis{0, 0, 1};
};

/// The spindle's frame in the table frame. A value too few counts as 0.
[[nodiscard]] geom::Frame spindle_frame(const Chain& chain, std::span<const double> values);

/// The pose of a tool so long (gauge point to tip) in the table frame; to have it in a workpiece frame that lies in the
/// table frame as `f` says, apply its inverse.
[[nodiscard]] ToolPose pose_of(const Chain& chain, std::span<const double> values, double tool_length);

/// How the machine must stand along one linear joint while the rotary ones stand: value = dot(along, tip) + at.
struct Follower {
    std::size_t joint = 0;  ///< index in the chain
    geom::Vec3 along;
    double at = 0;
};
/// The three linear joints as they follow a tip in the table frame; `values` are read for the rotary joints alone.
/// None where the chain has not three independent linear joints.
[[nodiscard]] std::vector<Follower> followers(const Chain& chain, std::span<const double> values, double tool_length);

/// Whether a joint of it is rotary.
[[nodiscard]] bool has_rotary(const Chain& chain);
/// Values of the joints while a control takes the tip for `tip`, table frame: it counts the rotary joints as they stand
/// in `values`, or (`counted` false) as though they stood at 0. Of `values` the rotary joints alone are read. Linear
/// joints are NaN where the chain has not three independent ones.
[[nodiscard]] std::vector<double> joints_at(const Chain& chain, std::span<const double> values, bool counted,
                                            geom::Vec3 tip, double tool_length);

struct AxisPosition {
    std::vector<double> values;  ///< one a joint
    std::string outside;         ///< first axis that leaves its travel; empty: none
    /// The tool's axis lies in a rotary axis here, so that this axis could stand anywhere: it has the value of `near`.
    bool singular = false;
    [[nodiscard]] bool in_limits() const { return outside.empty(); }
};

enum class Reach : std::uint8_t {
    reached,
    not_inclined,  ///< no position of the rotary axes gives this tool axis
    unsuitable,    ///< not three independent linear axes, or more than two rotary ones
};
struct AxisPositions {
    Reach reach = Reach::reached;
    std::vector<AxisPosition> positions;  ///< none, one, or the two of two rotary axes; those in the limits first,
                                          ///< then what turns least from `near`
};

/// Axis positions for a pose in the table frame. Angles are those in the limits that are nearest to `near` (values of
/// the chain; 0 where it has none). `pose.axis` need not be of length 1, only not 0.
[[nodiscard]] AxisPositions positions_for(const Chain& chain, const ToolPose& pose, double tool_length,
                                          std::span<const double> near = {});

}  // namespace obrys::shop
