#pragma once
/// How a milling machine stands: its rotary axes, tool and zero, and what follows for a programmed point: where it is
/// on the workpiece, and where the linear axes must be for it.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "cl/record.hpp"
#include "geom/frame.hpp"
#include "shop/kinematics.hpp"
#include "shop/tool.hpp"

namespace obrys::motion {

/// dot(along, p); a coordinate of p that does not count need not be known.
[[nodiscard]] double part_along(const geom::Vec3& along, const geom::Vec3& p);

class Stand {
public:
    explicit Stand(const shop::Machine& machine);

    void take(const cl::Datum& datum);
    void take(const cl::AxisEnd& axis);
    /// A lathe's points turn with its workpiece (polar coordinate interpolation).
    [[nodiscard]] bool on_face() const { return on_face_; }
    void take_face(const cl::AxisEnd& axis) {
        on_face_ = axis.rotary ? axis.counted && machine_.kind == shop::MachineKind::lathe : on_face_;
    }
    /// `tool`: null where it is not known. `offsets`: the control counts its length (an edge is selected).
    void take_tool(const shop::Tool* tool, bool offsets, double raised = 0);
    void moved();

    /// Rotary axes move together with the next move.
    [[nodiscard]] bool turning() const { return turning_; }
    /// Points of moves with an upright tool are places of the tip on the workpiece as they are programmed.
    [[nodiscard]] bool plain() const { return plain_; }

    /// A programmed point as a place on the workpiece, both in the workpiece frame.
    struct View {
        std::string problem;  ///< not empty: why it is not known
        std::string remedy;
        std::string doubt;  ///< not empty: what is taken for granted and cannot be checked
        geom::Frame frame;
        geom::Vec3 axis{0, 0, 1};
        /// Along which the machine's X, Y and Z move the tool on the workpiece; NaN where that is not known.
        std::array<geom::Vec3, 3> linear{geom::Vec3{1, 0, 0}, geom::Vec3{0, 1, 0}, geom::Vec3{0, 0, 1}};
    };
    /// `axis`: of the move, as programmed. Holds until the next call.
    [[nodiscard]] const View& view(const geom::Vec3& axis);

    /// How the tool goes on the workpiece (workpiece frame) while rotary axes turn, from the last point of the last
    /// move to a point, both as programmed, all axes evenly: poses at most a degree apart. None where it is not known.
    [[nodiscard]] std::vector<shop::ToolPose> swing(const geom::Vec3& from, const geom::Vec3& to) const;

    /// A linear axis of the machine as it follows programmed points: `known` + dot(along, point), and `from_zero` more
    /// where the zero is known, else NaN.
    struct Way {
        std::string name;
        geom::Vec3 along;
        double known = 0, from_zero = 0;
    };
    /// The three linear axes; X, Y and Z where the machine has no chain.
    [[nodiscard]] std::vector<Way> ways() const;
    [[nodiscard]] bool tool_length_known() const { return tool_ != nullptr && tool_->length > 0; }

private:
    [[nodiscard]] std::vector<double> counted_values() const;
    [[nodiscard]] double counted_length() const;
    [[nodiscard]] double tool_length() const { return tool_ != nullptr ? tool_->length + tool_->delta_length : NAN; }
    [[nodiscard]] bool upright() const;  ///< every rotary axis of the chain stands at 0
    void update();
    [[nodiscard]] View made_view(const geom::Vec3& axis) const;
    [[nodiscard]] View swivelled_view() const;
    [[nodiscard]] std::array<geom::Vec3, 3> linear_axes() const;

    const shop::Machine& machine_;
    shop::Chain chain_;
    std::vector<double> values_;             ///< radians, by joint; linear ones 0
    std::map<std::string, double> strange_;  ///< rotary axes outside the chain that are not at 0, degrees
    std::string parallel_;                   ///< an additional linear axis that has moved; empty: none
    std::vector<double> last_values_;        ///< of the last move
    bool last_counted_ = false;
    bool on_face_ = false;
    bool counted_ = false, has_rotary_ = false;
    cl::Datum datum_{0, {NAN, NAN, NAN}};
    const shop::Tool* tool_ = nullptr;
    double raised_ = 0;  ///< cl::ToolChange
    bool offsets_ = true, turning_ = false, plain_ = true;
    View view_;
    geom::Vec3 viewed_axis_;
    bool viewed_ = false;
};

}  // namespace obrys::motion
