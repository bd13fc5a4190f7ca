/// Rotary axes: where they go for a tilted plane, and what counts of them.

#include "interp/setup/tilted_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/codes.hpp"
#include "interp/setup/setup.hpp"
#include "shop/kinematics.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec3;

namespace {

constexpr double still = 1e-12;  ///< radians

constexpr double same_turn = 1e-6;  ///< radians by which two ways must differ for one to be the shorter

constexpr double upright = 1e-9;  ///< of a direction cosine: the joint turns about the tool's axis

}  // namespace

double in_degrees(double angle) { return std::round(geom::degrees(angle) * 1e9) / 1e9; }

namespace {

std::size_t master_axis(const shop::Chain& chain) {
    std::size_t master = 0;
    for (std::size_t i = 0; i < chain.joints.size(); ++i)
        if (chain.joints[i].rotary) master = i;
    return master;
}

/// What the control takes for the rotary axes' values in its coordinates.
std::vector<double> counted_values(const Rotary& r) {
    return r.counted ? r.values : std::vector<double>(r.values.size(), 0);
}

/// The same numbers mean the same place of the linear axes.
bool same_coordinates(const Rotary& a, const Rotary& b) {
    const std::vector<double> u = counted_values(a), v = counted_values(b);
    return std::equal(u.begin(), u.end(), v.begin(), v.end(),
                      [](double x, double y) { return std::abs(x - y) < still; });
}

}  // namespace

Vec3 counted_as(const Reckoning& run, const Vec3& position, const Rotary& from, const Rotary& to) {
    if (same_coordinates(from, to)) return position;
    const shop::Chain chain = shop::chain_of(run.env.machine);
    const Vec3 origin = stream_origin(run);
    const double tool = gauge_length(run);
    std::vector<double> then = shop::joints_at(chain, from.values, from.counted, origin + position, tool);
    const std::vector<double> turned = counted_values(to);
    for (std::size_t i = 0; i < then.size(); ++i)
        if (chain.joints[i].rotary) then[i] = turned[i];
    return shop::pose_of(chain, then, tool).tip - origin;
}

void stand_at(Reckoning& run, const Vec3& position) {
    run.position = position;
    run.programmed_position = run.frame_is_identity ? position : geom::apply(geom::inverse(run.frame), position);
}

namespace {

/// TABLE ROT: the joint about the tool's axis turns until the plane's X is the machine's.
double table_turn(const shop::Chain& chain, std::vector<double> values, std::size_t joint, const Vec3& x) {
    values[joint] = 0;
    const Vec3 about = chain.joints[joint].direction;
    const Vec3 now = geom::apply_direction(shop::spindle_frame(chain, values), {1, 0, 0});
    return std::atan2(geom::dot(about, geom::cross(now, x)), geom::dot(now, x));
}

/// Positions of the rotary axes for a tool axis, linear ones 0; those in the limits first. An angle is the one nearest
/// to `near` that the limits let; without that within half a turn of 0. Nothing where the chain cannot be worked out.
std::optional<std::vector<shop::AxisPosition>> rotary_positions(const shop::Chain& chain, const Vec3& axis,
                                                                std::span<const double> near) {
    shop::AxisPositions all = shop::positions_for(chain, {{}, axis}, 0, near);
    if (all.reach == shop::Reach::unsuitable) return std::nullopt;
    for (shop::AxisPosition& p : all.positions) {
        p.outside.clear();  // of the linear axes, which go elsewhere
        for (std::size_t i = 0; i < chain.joints.size(); ++i) {
            const shop::Joint& j = chain.joints[i];
            if (!j.rotary)
                p.values[i] = 0;
            else if (!(p.values[i] >= j.min - same_turn && p.values[i] <= j.max + same_turn))
                p.outside = j.name;
        }
    }
    std::stable_partition(all.positions.begin(), all.positions.end(), [](const auto& p) { return p.in_limits(); });
    return std::move(all.positions);
}

/// The nearer of the positions, the positive master axis where both are as near; with SEQ the one of its sign.
const shop::AxisPosition* chosen(const std::vector<shop::AxisPosition>& all, std::size_t master, double side,
                                 const std::vector<double>& now) {
    const auto way = [&](const shop::AxisPosition& p) {
        double sum = 0;
        for (std::size_t i = 0; i < now.size(); ++i) sum += p.values.size() > i ? std::abs(p.values[i] - now[i]) : 0;
        return sum;
    };
    const shop::AxisPosition* best = nullptr;
    for (const shop::AxisPosition& p : all) {
        if (side != 0 && p.values[master] * side < -still) continue;
        if (best == nullptr) {
            best = &p;
            continue;
        }
        if (p.in_limits() != best->in_limits()) continue;  // those in the limits come first
        const double longer = way(p) - way(*best);
        if (longer < -same_turn || (longer < same_turn && p.values[master] > best->values[master])) best = &p;
    }
    return best;
}

/// Rotary joints, the one that carries the others first, those of the table before those of the head.
std::vector<std::size_t> carriers_first(const shop::Chain& chain) {
    std::vector<std::size_t> table, head;
    bool behind_linear = false;
    for (std::size_t i = 0; i < chain.joints.size(); ++i) {
        behind_linear = behind_linear || !chain.joints[i].rotary;
        if (chain.joints[i].rotary) (behind_linear ? head : table).push_back(i);
    }
    std::reverse(table.begin(), table.end());
    table.insert(table.end(), head.begin(), head.end());
    return table;
}

/// The position whose first axis has the shorter way, then the second one; then whose first axis stands nearer to 0,
/// then the second one. Source: Traits::first_rotary_axis_decides.
const shop::AxisPosition* chosen_by_first_axis(const std::vector<shop::AxisPosition>& all, const shop::Chain& chain,
                                               const std::vector<double>& now, bool& tie) {
    const auto from_zero = [](double v) { return std::abs(std::remainder(v, 2 * geom::pi)); };
    const auto longer = [&](const shop::AxisPosition& p, const shop::AxisPosition& q) {
        for (const bool way : {true, false})
            for (const std::size_t i : carriers_first(chain)) {
                const double d = way ? std::abs(p.values[i] - now[i]) - std::abs(q.values[i] - now[i])
                                     : from_zero(p.values[i]) - from_zero(q.values[i]);
                if (std::abs(d) > same_turn) return d;
            }
        return 0.0;
    };
    const shop::AxisPosition* best = nullptr;
    tie = false;
    for (const shop::AxisPosition& p : all) {
        if (best != nullptr && p.in_limits() != best->in_limits()) continue;  // those in the limits come first
        const double by = best == nullptr ? -1 : longer(p, *best);
        const std::size_t first = carriers_first(chain).front();
        if (by == 0) tie = true;
        if (by < 0 || (by == 0 && p.values[first] > best->values[first])) best = &p;
    }
    return best;
}

/// The axis of the plane as the machine's table sees it: a zero offset may be turned about Z against it.
Vec3 in_table(const Reckoning& run, const Vec3& direction) {
    const auto turn = run.env.machine.datum_rotations.find(run.reference_datum);
    if (turn == run.env.machine.datum_rotations.end()) return direction;
    return geom::apply_direction(geom::Frame::rotation(2, turn->second), direction);
}

void tell_positions(Reckoning& run, const shop::Chain& chain) {
    run.tilted_axes.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < run.aimed_at.size(); ++i) {
        const auto k = std::string_view("ABC").find(chain.joints[i].name[0]);
        if (chain.joints[i].rotary && chain.joints[i].name.size() == 1 && k != std::string_view::npos)
            run.tilted_axes[k] = in_degrees(run.aimed_at[i]);
    }
    control_sets(run,
                 {program::ControlValue::tilted_a, program::ControlValue::tilted_b, program::ControlValue::tilted_c});
}

}  // namespace

bool tilted(const Reckoning& run) {
    return std::any_of(run.modal.transforms.begin(), run.modal.transforms.end(),
                       [](const Transform& t) { return t.kind == TransformKind::plane; });
}

Rotary rotary(const Reckoning& run) {
    const shop::Machine& m = run.env.machine;
    Rotary r{std::vector<double>(m.chain.size(), 0), tilted(run)};
    for (std::size_t i = 0; i < m.chain.size(); ++i) {
        const shop::MachineAxis& a = m.axes[m.chain[i]];
        if (const auto at = run.extra_axes.find(a.name); a.rotary && at != run.extra_axes.end())
            r.values[i] = geom::radians(at->second);
    }
    return r;
}

void aim(Reckoning& run, const TiltChoice& choice, const base::Span& where) {
    const shop::Chain chain = shop::chain_of(run.env.machine);
    run.aimed_at.clear();
    if (!shop::has_rotary(chain)) return tell_positions(run, chain);
    const std::vector<double> now = rotary(run).values;
    if (!tilted(run)) {
        run.aimed_at.assign(now.size(), 0);
        return tell_positions(run, chain);
    }
    const bool by_first = run.traits->first_rotary_axis_decides;
    const auto turned =
        rotary_positions(chain, in_table(run, run.tool_axis), by_first ? std::span(now) : std::span<const double>());
    if (!turned) return tell_positions(run, chain);
    bool tie = false;
    const shop::AxisPosition* best = by_first ? chosen_by_first_axis(*turned, chain, now, tie)
                                              : chosen(*turned, master_axis(chain), choice.side, now);
    if (tie)
        assume(run, where,
               "both positions of the rotary axes lie as near: the one with the greater value of " +
                   chain.joints[carriers_first(chain).front()].name + " is taken",
               "position the rotary axes before");
    if (best == nullptr || !best->in_limits())
        return alarm(run, codes::value_range, where,
                     best == nullptr
                         ? "no position of the rotary axes of " + run.env.machine.name + " gives this tilted plane"
                         : "the rotary axis " + best->outside + " would leave its travel for this tilted plane",
                     choice.side != 0 ? "take the other side, or let the control choose" : std::string());
    run.aimed_at = best->values;
    const Vec3 x = in_table(run, geom::apply_direction(active_plane(run), {1, 0, 0}));
    for (std::size_t i = 0; i < chain.joints.size() && best->singular; ++i) {
        const shop::Joint& j = chain.joints[i];
        if (!j.rotary || std::abs(std::abs(geom::dot(j.direction, in_table(run, run.tool_axis))) - 1) > upright)
            continue;
        run.aimed_at[i] = choice.table_turns ? table_turn(chain, run.aimed_at, i, x) : now[i];
    }
    tell_positions(run, chain);
}

void recount(Reckoning& run, const Rotary& before) {
    const Rotary now = rotary(run);
    if (!same_coordinates(before, now)) stand_at(run, counted_as(run, run.position, before, now));
}

}  // namespace obrys::interp
