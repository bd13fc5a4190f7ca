#include "write/holes/same_hole.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "write/holes/plain_hole.hpp"

namespace obrys::write {

namespace {

using cl::CycleKind;
using Role = cl::CycleRole;

/// The values of a cycle, each asked for once: what nobody has asked for is what this file does not understand.
class Asked {
public:
    explicit Asked(const cl::Cycle& cycle) : left_(cycle.values) {}
    std::optional<double> find(Role role) {
        const auto it = std::find_if(left_.begin(), left_.end(), [&](const auto& v) { return v.role == role; });
        if (it == left_.end()) return std::nullopt;
        const double value = it->value;
        left_.erase(it);
        known_ = known_ && !std::isnan(value);
        return value;
    }
    double or_0(Role role) { return find(role).value_or(0); }
    double needed(Role role) {
        const auto value = find(role);
        known_ = known_ && value.has_value();
        return value.value_or(NAN);
    }
    /// What makes no difference to the hole.
    void pass(std::initializer_list<Role> roles) {
        for (const Role role : roles) static_cast<void>(find(role));
    }
    /// As this file knows it, or it is another hole.
    void expect(bool holds) { known_ = known_ && holds; }
    [[nodiscard]] bool all_known() const { return known_ && left_.empty(); }

private:
    std::vector<cl::CycleValue> left_;
    bool known_ = true;
};

std::optional<Way> way_of(CycleKind kind) {
    switch (kind) {
        case CycleKind::canned_drill:
        case CycleKind::drill: return Way::drill;
        case CycleKind::canned_peck: return Way::peck;
        case CycleKind::canned_chip_break: return Way::chip_break;
        case CycleKind::canned_bore_feed:
        case CycleKind::ream: return Way::feed_out;
        case CycleKind::canned_tap_floating:
        case CycleKind::tap_floating: return Way::tap_floating;
        case CycleKind::canned_tap_rigid:
        case CycleKind::tap_rigid: return Way::tap_rigid;
        case CycleKind::universal_drill:
        case CycleKind::universal_peck: return Way::peck;  // looked at more closely
        default: return std::nullopt;
    }
}

bool is_canned(CycleKind kind) { return kind >= CycleKind::canned_drill && kind <= CycleKind::canned_bore_manual; }

/// Where a rigid tap does not say how it turns and how far in a turn, it does so as the spindle and the feed say.
void take_tap(Hole& h, Asked& asked, const motion::State& state) {
    const bool per_minute = state.feed.mode == cl::FeedMode::per_minute && state.spindle.speed > 0;
    h.direction = asked.find(Role::spindle_direction).value_or(state.spindle.direction);
    h.speed = asked.find(Role::spindle_speed);
    asked.pass({Role::spindle_after});  // what turns it on again is written behind the cycle
    h.pitch = asked.find(Role::pitch).value_or(per_minute ? h.feed / state.spindle.speed : 0);
    asked.expect(h.direction != 0 && std::isfinite(h.pitch) && h.pitch > 0);
}

/// G84 Q: how far the tap goes back is the machine's own where nothing says it; it is run as 1 mm, and so is what is
/// written. Behind a way out (0) the next step begins where it went out.
void take_tap_infeeds(Hole& h, Asked& asked) {
    constexpr double back_of_machine = 1;
    const double infeed = asked.or_0(Role::infeed);
    if (infeed == 0) return;
    const auto distance = asked.find(Role::chip_break_distance), turns = asked.find(Role::chip_break_turns),
               stop = asked.find(Role::stop_distance_first);
    asked.expect(infeed > 0 && h.dwell == 0 && stop.value_or(0) == 0);
    h.way = Way::tap_chip_break;
    h.infeed = infeed;
    h.gap = turns ? *turns * h.pitch : distance.value_or(stop ? 0 : back_of_machine);
}

/// By a retract plane and a bottom; the feed is that in force.
std::optional<Hole> of_canned(const cl::Cycle& cycle, Way way, const motion::State& state) {
    Asked asked(cycle);
    Hole h;
    h.way = way;
    h.surface = asked.find(Role::surface);
    h.top = asked.needed(Role::retract_plane);
    h.bottom = asked.needed(Role::bottom);
    h.end = asked.find(Role::return_level).value_or(h.top);
    h.dwell = asked.or_0(Role::dwell_bottom);
    if (way == Way::peck || way == Way::chip_break) h.infeed = asked.needed(Role::infeed);
    if (way == Way::peck) h.gap = asked.needed(Role::stop_distance_first);
    if (way == Way::chip_break) h.gap = asked.needed(Role::chip_break_distance);
    if (way == Way::tap_floating) h.direction = asked.needed(Role::spindle_direction);
    h.feed = state.feed.value;
    if (way == Way::tap_rigid) take_tap(h, asked, state);
    if (way == Way::tap_rigid) take_tap_infeeds(h, asked);
    asked.pass({Role::starts_spindle});
    const bool takes_feed = way != Way::tap_rigid;
    asked.expect(!takes_feed || (state.feed.mode == cl::FeedMode::per_minute && h.feed > 0));
    return asked.all_known() ? std::optional(h) : std::nullopt;
}

/// Infeeds of CYCL DEF 203 and 205: all in one, out to the clearance after each, or a little back.
void take_infeeds(Hole& h, Asked& asked, CycleKind kind) {
    const double way = -(h.bottom - h.top);
    h.infeed = asked.needed(Role::infeed);
    asked.expect(asked.or_0(Role::decrement) == 0);
    asked.pass({Role::min_infeed});
    const double back = asked.or_0(Role::chip_break_distance);
    if (kind == CycleKind::universal_drill) {
        const double breaks = asked.or_0(Role::breaks_before_retract);
        asked.expect(breaks == 0 || breaks * h.infeed >= way);
        h.way = breaks == 0 ? Way::peck : Way::chip_break;
        h.gap = breaks == 0 ? h.top - h.surface.value_or(h.top) : back;
        const double out = asked.or_0(Role::feed_retract);
        asked.expect(out == 0 || std::isinf(out));
        if (out == 0) h.way = Way::feed_out;
    } else {
        const double first = asked.or_0(Role::stop_distance_first), last = asked.or_0(Role::stop_distance_last);
        const double breaks_at = asked.or_0(Role::chip_break_depth);
        asked.expect(first == last && asked.or_0(Role::deepened_start) == 0);
        asked.pass({Role::feed_position, Role::feed_retract});
        h.way = breaks_at > 0 ? Way::chip_break : Way::peck;
        h.gap = breaks_at > 0 ? back : first;
        if (breaks_at > 0) {
            asked.expect(h.infeed >= way);  // else both, in turn
            h.infeed = breaks_at;
        }
    }
}

/// By a surface, a clearance and a depth; the feed is the cycle's own.
std::optional<Hole> of_depths(const cl::Cycle& cycle, Way way, const motion::State& state) {
    Asked asked(cycle);
    Hole h;
    h.way = way;
    h.surface = asked.needed(Role::surface);
    h.top = *h.surface + asked.needed(Role::clearance);
    h.bottom = *h.surface + asked.needed(Role::depth);
    h.end = std::max(h.top, *h.surface + asked.or_0(Role::second_clearance));
    h.dwell = asked.or_0(Role::dwell_bottom);
    asked.expect(asked.or_0(Role::depth_reference) == 0);
    if (way == Way::tap_rigid)
        h.pitch = asked.needed(Role::pitch);
    else
        h.feed = asked.needed(Role::feed_plunge);
    asked.expect(way == Way::tap_rigid || (std::isfinite(h.feed) && h.feed > 0));
    const bool universal = cycle.kind == CycleKind::universal_drill || cycle.kind == CycleKind::universal_peck;
    if (cycle.kind == CycleKind::drill) h.infeed = asked.needed(Role::infeed);
    if (cycle.kind == CycleKind::drill) h.way = Way::peck, h.gap = h.top - *h.surface;
    if (universal) take_infeeds(h, asked, cycle.kind);
    const double dwell_top = asked.or_0(Role::dwell_top);
    const bool in_one = h.infeed >= *h.surface - h.bottom - same_length;
    if ((h.way == Way::peck || h.way == Way::chip_break) && in_one) h.way = Way::drill;
    asked.expect(h.way != Way::feed_out || !universal || in_one);
    asked.expect(dwell_top == 0 || in_one);  // after each infeed
    if (way == Way::feed_out) {
        const double out = asked.or_0(Role::feed_retract);
        asked.expect(out == 0 || out == h.feed);
    }
    h.direction = state.spindle.direction;
    if (way == Way::tap_rigid) h.direction = h.pitch < 0 ? -1 : 1;
    h.pitch = std::abs(h.pitch);
    return asked.all_known() ? std::optional(h) : std::nullopt;
}

}  // namespace

std::vector<HoleWay> same_hole(const cl::Cycle& cycle, const motion::State& state) {
    const std::optional<Way> way = way_of(cycle.kind);
    if (!way) return {};
    const bool canned = is_canned(cycle.kind);
    const std::optional<Hole> hole = canned ? of_canned(cycle, *way, state) : of_depths(cycle, *way, state);
    if (!hole || !(hole->top > hole->bottom)) return {};
    if (canned) {
        if (hole->way == Way::tap_chip_break) {
            std::vector<HoleWay> out{as_tap_chip_breaking(cycle, *hole)};
            if (hole->gap > 0) out.push_back(as_canned(cycle, *hole));
            return out;
        }
        std::vector<HoleWay> out = as_depths(cycle, *hole);
        if (cycle.kind == CycleKind::canned_tap_rigid) out.insert(out.begin(), as_canned(cycle, *hole));
        return out;
    }
    return {as_canned(cycle, *hole)};
}

}  // namespace obrys::write
