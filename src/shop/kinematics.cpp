// Product of the joints' motions in the table frame (R. M. Murray, Z. Li, S. S. Sastry, A Mathematical Introduction to
// Robotic Manipulation, 1994: product of exponentials, chapter 3, section 2; subproblems 1 and 2, section 3).
#include "shop/kinematics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace obrys::shop {

namespace {

using geom::Vec3;

constexpr double parallel =
    1e-7;                        ///< sine below which two directions are the same line; its square is rounding already
constexpr double beside = 1e-9;  ///< how far a unit vector may miss a cone and still lie on it
constexpr double limit_slack = 1e-9;  ///< mm, radians: a limit that is met exactly is kept
constexpr Vec3 spindle_axis{0, 0, 1};

/// Rotation about a unit vector through the origin (Rodrigues).
Vec3 turned(Vec3 v, Vec3 about, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return c * v + s * cross(about, v) + ((1 - c) * dot(about, v)) * about;
}

geom::Frame motion(const Joint& j, double value) {
    if (!j.rotary) return geom::Frame::shift(value * j.direction);
    const Vec3 x = turned({1, 0, 0}, j.direction, value), y = turned({0, 1, 0}, j.direction, value),
               z = turned({0, 0, 1}, j.direction, value);
    geom::Frame f;
    f.linear = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
    f.origin = j.centre - turned(j.centre, j.direction, value);
    return f;
}

double value_at(std::span<const double> values, std::size_t i) { return i < values.size() ? values[i] : 0; }

/// Turns a into b about a unit vector: only their parts across it count. Nothing where a has none.
std::optional<double> angle_between(Vec3 a, Vec3 b, Vec3 about) {
    const Vec3 u = a - dot(a, about) * about, v = b - dot(b, about) * about;
    if (length(u) < parallel || length(v) < parallel) return std::nullopt;
    return std::atan2(dot(about, cross(u, v)), dot(u, v));
}

/// Angles of the rotary joints; `free` are those that could be any.
struct Angles {
    std::array<double, 2> value{};
    std::array<bool, 2> free{};
};

std::vector<Angles> one_joint(Vec3 u, Vec3 axis) {
    if (std::abs(dot(u, axis) - dot(u, spindle_axis)) > beside) return {};
    Angles a;
    const auto angle = angle_between(spindle_axis, axis, u);
    a.value[0] = angle.value_or(0);
    a.free[0] = !angle;
    return {a};
}

/// u1 and u2, not parallel: the spindle's axis turned about u2 is c, c turned about u1 is the axis asked for. c lies at
/// a given height over both, which leaves two places that mirror each other in the plane of u1 and u2.
std::vector<Angles> two_joints(Vec3 u1, Vec3 u2, Vec3 axis) {
    const double between = dot(u1, u2), h1 = dot(u1, axis), h2 = dot(u2, spindle_axis);
    const double square = 1 - between * between;
    const double alpha = (h1 - between * h2) / square, beta = (h2 - between * h1) / square;
    const double rest = (1 - alpha * alpha - beta * beta - 2 * alpha * beta * between) / square;
    if (rest < -beside) return {};
    const double gamma = std::sqrt(std::max(0.0, rest));
    std::vector<Angles> out;
    for (const double side : {gamma, -gamma}) {
        const Vec3 c = alpha * u1 + beta * u2 + side * cross(u1, u2);
        const auto first = angle_between(c, axis, u1), second = angle_between(spindle_axis, c, u2);
        out.push_back({{first.value_or(0), second.value_or(0)}, {!first, !second}});
        if (gamma < parallel) break;  // both are the same
    }
    return out;
}

/// All rotary positions of a tool axis. Two parallel joints turn as one; the second one stays at 0 then.
std::vector<Angles> inclinations(const Chain& chain, const std::vector<std::size_t>& rotary, Vec3 axis) {
    if (rotary.empty()) return length(axis - spindle_axis) < 1e-6 ? std::vector<Angles>(1) : std::vector<Angles>{};
    const Vec3 u1 = chain.joints[rotary[0]].direction;
    if (rotary.size() == 1) return one_joint(u1, axis);
    const Vec3 u2 = chain.joints[rotary[1]].direction;
    if (length(cross(u1, u2)) > parallel) return two_joints(u1, u2, axis);
    return one_joint(u1, axis);
}

/// The turn of an angle that lies in the limits, and of these the nearest one; the nearest to the limits where none
/// does.
double nearest_turn(double angle, const Joint& j, double near) {
    const double turn = 2 * geom::pi;
    const double within = j.min <= j.max ? std::clamp(near, j.min, j.max) : near;
    const double base = angle + turn * std::round((within - angle) / turn);
    double best = base, distance = std::numeric_limits<double>::infinity();
    for (const double a : {base, base - turn, base + turn}) {
        if (a < j.min - limit_slack || a > j.max + limit_slack || std::abs(a - near) >= distance) continue;
        best = a;
        distance = std::abs(a - near);
    }
    return best;
}

/// Values of the linear joints that bring the tip to its place; the rotary ones stand already. False where the three
/// do not span space.
bool place_tip(const Chain& chain, Vec3 tip, double tool_length, std::vector<double>& values) {
    const std::vector<Follower> all = followers(chain, values, tool_length);
    for (const Follower& f : all) values[f.joint] = dot(f.along, tip) + f.at;
    return !all.empty();
}

double turn_to(const AxisPosition& p, const Chain& chain, std::span<const double> near) {
    double sum = 0;
    for (std::size_t i = 0; i < chain.joints.size(); ++i)
        if (chain.joints[i].rotary) sum += std::abs(p.values[i] - value_at(near, i));
    return sum;
}

/// A value that is not known is outside.
std::string first_outside(const Chain& chain, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(values[i] >= chain.joints[i].min - limit_slack && values[i] <= chain.joints[i].max + limit_slack))
            return chain.joints[i].name;
    return {};
}

}  // namespace

Chain chain_of(const Machine& machine) {
    Chain chain;
    for (const std::size_t i : machine.chain) {
        const MachineAxis& a = machine.axes[i];
        Joint j{a.name, a.rotary, a.direction, a.centre};
        if (a.min) j.min = a.rotary ? geom::radians(*a.min) : *a.min;
        if (a.max) j.max = a.rotary ? geom::radians(*a.max) : *a.max;
        chain.joints.push_back(std::move(j));
    }
    return chain;
}

geom::Frame spindle_frame(const Chain& chain, std::span<const double> values) {
    geom::Frame f;
    for (std::size_t i = 0; i < chain.joints.size(); ++i) f = f * motion(chain.joints[i], value_at(values, i));
    return f;
}

ToolPose pose_of(const Chain& chain, std::span<const double> values, double tool_length) {
    const geom::Frame f = spindle_frame(chain, values);
    return {geom::apply(f, -tool_length * spindle_axis), geom::apply_direction(f, spindle_axis)};
}

std::vector<Follower> followers(const Chain& chain, std::span<const double> values, double tool_length) {
    std::vector<double> standing(values.begin(), values.end());
    standing.resize(chain.joints.size(), 0);
    std::vector<Follower> out;
    std::vector<Vec3> way;  // of the tip where the joint's value grows by 1
    for (std::size_t i = 0; i < chain.joints.size(); ++i) {
        if (chain.joints[i].rotary) continue;
        standing[i] = 0;
        const Chain inner{{chain.joints.begin(), chain.joints.begin() + static_cast<std::ptrdiff_t>(i)}};
        way.push_back(geom::apply_direction(spindle_frame(inner, standing), chain.joints[i].direction));
        out.push_back({i, {}, 0});
    }
    const double volume = way.size() == 3 ? dot(way[0], cross(way[1], way[2])) : 0;
    if (!(std::abs(volume) > 1e-9)) return {};
    const Vec3 start = pose_of(chain, standing, tool_length).tip;
    for (std::size_t k = 0; k < 3; ++k) {
        out[k].along = (1 / volume) * cross(way[(k + 1) % 3], way[(k + 2) % 3]);
        out[k].at = -dot(out[k].along, start);
    }
    return out;
}

bool has_rotary(const Chain& chain) {
    return std::any_of(chain.joints.begin(), chain.joints.end(), [](const Joint& j) { return j.rotary; });
}

std::vector<double> joints_at(const Chain& chain, std::span<const double> values, bool counted, Vec3 tip,
                              double tool_length) {
    std::vector<double> out(values.begin(), values.end());
    out.resize(chain.joints.size(), 0);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!chain.joints[i].rotary) out[i] = std::numeric_limits<double>::quiet_NaN();
    for (const Follower& f : followers(chain, counted ? values : std::span<const double>(), tool_length))
        out[f.joint] = dot(f.along, tip) + f.at;
    return out;
}

AxisPositions positions_for(const Chain& chain, const ToolPose& pose, double tool_length,
                            std::span<const double> near) {
    AxisPositions out;
    std::vector<std::size_t> linear, rotary;
    for (std::size_t i = 0; i < chain.joints.size(); ++i) (chain.joints[i].rotary ? rotary : linear).push_back(i);
    const double size = length(pose.axis);
    out.reach = Reach::unsuitable;
    if (linear.size() != 3 || rotary.size() > 2 || !(size > 0) || !geom::is_finite(pose.axis)) return out;
    for (const Angles& angles : inclinations(chain, rotary, (1 / size) * pose.axis)) {
        AxisPosition p;
        p.values.assign(chain.joints.size(), 0);
        for (std::size_t i = 0; i < rotary.size(); ++i) {
            const double wanted = value_at(near, rotary[i]);
            p.singular = p.singular || angles.free[i];
            p.values[rotary[i]] =
                angles.free[i] ? wanted : nearest_turn(angles.value[i], chain.joints[rotary[i]], wanted);
        }
        if (!place_tip(chain, pose.tip, tool_length, p.values)) return out;
        p.outside = first_outside(chain, p.values);
        out.positions.push_back(std::move(p));
    }
    std::stable_sort(out.positions.begin(), out.positions.end(), [&](const AxisPosition& a, const AxisPosition& b) {
        if (a.in_limits() != b.in_limits()) return a.in_limits();
        return turn_to(a, chain, near) < turn_to(b, chain, near);
    });
    out.reach = out.positions.empty() ? Reach::not_inclined : Reach::reached;
    return out;
}

}  // namespace obrys::shop
