#include "motion/stand.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::motion {

using geom::Vec3;

namespace {

constexpr double still = 1e-12;      ///< radians
constexpr double along_axis = 1e-6;  ///< sine of the angle by which the tool's axis may miss the programmed one

}  // namespace

double part_along(const Vec3& along, const Vec3& p) {
    return (along.x == 0 ? 0 : along.x * p.x) + (along.y == 0 ? 0 : along.y * p.y) + (along.z == 0 ? 0 : along.z * p.z);
}

Stand::Stand(const shop::Machine& machine)
    : machine_(machine), chain_(shop::chain_of(machine)), has_rotary_(shop::has_rotary(chain_)) {
    values_.assign(chain_.joints.size(), 0);
}

bool Stand::upright() const {
    return std::all_of(values_.begin(), values_.end(), [](double v) { return std::abs(v) < still; });
}

void Stand::take(const cl::Datum& datum) {
    datum_ = datum;
    viewed_ = false;
}

void Stand::take_tool(const shop::Tool* tool, bool offsets, double raised) {
    tool_ = tool;
    raised_ = raised;
    offsets_ = offsets;
    update();
}

void Stand::take(const cl::AxisEnd& axis) {
    const std::string name(axis.name.data(), std::find(axis.name.begin(), axis.name.end(), '\0'));
    if (!axis.rotary) {
        if (parallel_.empty()) parallel_ = name;
        return update();
    }
    turning_ = turning_ || (!upright() && counted_ != axis.counted);
    counted_ = axis.counted;
    const auto joint = std::find_if(chain_.joints.begin(), chain_.joints.end(),
                                    [&](const shop::Joint& j) { return j.rotary && j.name == name; });
    if (joint == chain_.joints.end()) {
        double& at = strange_.try_emplace(name, 0).first->second;
        turning_ = turning_ || !(at == axis.to);
        at = axis.to;
        if (axis.to == 0) strange_.erase(name);
    } else {
        double& at = values_[static_cast<std::size_t>(joint - chain_.joints.begin())];
        turning_ = turning_ || !(std::abs(at - geom::radians(axis.to)) < still);
        at = geom::radians(axis.to);
    }
    update();
}

void Stand::update() {
    plain_ = offsets_ && raised_ == 0 && upright() && strange_.empty() && parallel_.empty();
    viewed_ = false;
}

std::vector<double> Stand::counted_values() const {
    return counted_ ? values_ : std::vector<double>(values_.size(), 0);
}

double Stand::counted_length() const { return tool_ != nullptr && offsets_ ? tool_length() + raised_ : 0; }

void Stand::moved() {
    turning_ = false;
    last_values_ = values_;
    last_counted_ = counted_;
}

std::vector<shop::ToolPose> Stand::swing(const Vec3& from, const Vec3& to) const {
    constexpr double step = geom::pi / 180;
    constexpr int most = 3600;
    if (!has_rotary_ || !tool_length_known() || last_values_.size() != values_.size() || !strange_.empty()) return {};
    const auto joints = [&](const std::vector<double>& values, bool counted, const Vec3& p) {
        return shop::joints_at(chain_, values, counted, datum_.origin + p, counted_length());
    };
    const std::vector<double> begin = joints(last_values_, last_counted_, from), end = joints(values_, counted_, to);
    double turn = 0;
    for (std::size_t i = 0; i < begin.size(); ++i) {
        if (!std::isfinite(begin[i]) || !std::isfinite(end[i])) return {};
        if (chain_.joints[i].rotary) turn = std::max(turn, std::abs(end[i] - begin[i]));
    }
    const int steps = base::clipped<int>(std::ceil(turn / step), 1, most);
    std::vector<shop::ToolPose> out;
    std::vector<double> at(begin.size());
    for (int n = 0; n <= steps; ++n) {
        for (std::size_t i = 0; i < at.size(); ++i) at[i] = begin[i] + (end[i] - begin[i]) * n / steps;
        out.push_back(shop::pose_of(chain_, at, tool_length()));
        out.back().tip = out.back().tip - datum_.origin;
    }
    return out;
}

const Stand::View& Stand::view(const Vec3& axis) {
    if (!viewed_ || !(viewed_axis_ == axis)) view_ = made_view(axis);
    viewed_ = true;
    viewed_axis_ = axis;
    return view_;
}

Stand::View Stand::made_view(const Vec3& axis) const {
    View v;
    v.axis = axis;
    if (!strange_.empty() && !counted_) {
        v.problem =
            "the rotary axis " + strange_.begin()->first +
            " turns workpiece or tool, and the machine file does not say about which line: removal not simulated";
        v.remedy = "name a machine whose chain holds it (docs/machine-file.md)";
        return v;
    }
    if (!parallel_.empty()) v.doubt = "the axis " + parallel_ + " moves tool or workpiece, too, which is not simulated";
    if (!counted_ && !upright()) return swivelled_view();
    const Vec3 real = geom::apply_direction(shop::spindle_frame(chain_, values_), {0, 0, 1});
    // A zero offset that is turned about Z against the machine: heights are what can be compared.
    const bool turned_zero = machine_.datum_rotations.contains(datum_.number);
    const double off = turned_zero ? std::abs(real.z - axis.z) : geom::distance(real, axis);
    if (has_rotary_ && !(off < along_axis)) {
        v.problem = "the rotary axes do not stand as the tilted plane asks: removal not simulated";
        v.remedy = "let PLANE position them (TURN, MOVE), or do so before the first move in the plane";
    }
    if ((!has_rotary_ && geom::distance(axis, {0, 0, 1}) > along_axis) || !strange_.empty()) {
        v.doubt = "the rotary axes of the machine are not known: the tool is taken to stand as the tilted plane asks";
        v.remedy = "name a machine whose chain holds them (docs/machine-file.md)";
    }
    if (!upright() || geom::distance(axis, {0, 0, 1}) > along_axis) v.linear = linear_axes();
    if (offsets_ && raised_ != 0) v.frame = geom::Frame::shift(raised_ * axis);
    if (offsets_) return v;
    if (!tool_length_known()) {
        v.problem = "no offset is selected and the tool's length is not known: removal not simulated";
        v.remedy = "give the tool with its length in the job";
    }
    v.frame = geom::Frame::shift(-tool_length() * axis);
    return v;
}

/// The control takes the linear axes for where they would be with the rotary ones at 0; the tip is where the chain has
/// it.
Stand::View Stand::swivelled_view() const {
    View v;
    const auto placed = [&](const Vec3& p) {
        const auto stands = shop::joints_at(chain_, values_, counted_, datum_.origin + p, counted_length());
        return shop::pose_of(chain_, stands, tool_length()).tip - datum_.origin;
    };
    const Vec3 o = placed({}), x = placed({1, 0, 0}) - o, y = placed({0, 1, 0}) - o, z = placed({0, 0, 1}) - o;
    v.axis = geom::apply_direction(shop::spindle_frame(chain_, values_), {0, 0, 1});
    v.frame.linear = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
    v.frame.origin = o;
    v.linear = {x, y, z};
    if (geom::is_finite(o) && tool_length_known()) return v;
    const bool zero = tool_length_known();
    v.problem = std::string(
                    "the rotary axes are not at 0 and no tilted plane counts them: where the tool is on the "
                    "workpiece depends on ") +
                (zero ? "the zero offset" : "the tool's length") + ", which is not known: removal not simulated";
    v.remedy = zero ? "give the zero offset in [datum] of the job" : "give the tool with its length in the job";
    return v;
}

std::array<Vec3, 3> Stand::linear_axes() const {
    const Vec3 unknown{NAN, NAN, NAN};
    std::array<Vec3, 3> axes{unknown, unknown, unknown};
    if (!has_rotary_) return axes;
    for (const Way& w : ways())
        if (const std::size_t k = std::string_view("XYZ").find(w.name); w.name.size() == 1 && k < axes.size())
            axes[k] = w.along;
    return axes;
}

std::vector<Stand::Way> Stand::ways() const {
    const auto follow = shop::followers(chain_, counted_values(), counted_length());
    if (follow.empty())
        return {{"X", {1, 0, 0}, 0, datum_.origin.x},
                {"Y", {0, 1, 0}, 0, datum_.origin.y},
                {"Z", {0, 0, 1}, counted_length(), datum_.origin.z}};
    std::vector<Way> out;
    for (const shop::Follower& f : follow)
        out.push_back({chain_.joints[f.joint].name, f.along, f.at, part_along(f.along, datum_.origin)});
    return out;
}

}  // namespace obrys::motion
