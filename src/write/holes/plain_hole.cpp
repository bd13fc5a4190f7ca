#include "write/holes/plain_hole.hpp"

#include <algorithm>
#include <utility>

#include "cycles/hole/below_surface.hpp"
#include "cycles/hole/between_planes.hpp"
#include "cycles/hole/tapping_below_surface.hpp"

namespace obrys::write {

namespace {

template <class Cycle>
HoleWay with(const cl::Cycle& from, const Cycle& to) {
    cycles::Demand demand = cycles::demand_of(to);
    HoleWay out{from};
    out.cycle.kind = demand.kind;
    out.cycle.values = std::move(demand.values);
    return out;
}

template <class Cycle>
Cycle between_planes(const Hole& h) {
    Cycle c;
    c.surface = h.surface;
    c.retract_plane = h.top;
    c.bottom = h.bottom;
    if (h.end > h.top + same_length) c.return_level = h.end;
    if (h.dwell > 0) c.dwell_bottom = h.dwell;
    return c;
}

HoleWay canned(const cl::Cycle& from, const Hole& h) {
    switch (h.way) {
        case Way::drill: return with(from, between_planes<cycles::Drilling>(h));
        case Way::feed_out: return with(from, between_planes<cycles::FeedBoring>(h));
        case Way::peck: {
            auto c = between_planes<cycles::PeckDrilling>(h);
            c.infeed = h.infeed;
            c.stop_distance_first = h.gap;
            return with(from, c);
        }
        case Way::chip_break: {
            auto c = between_planes<cycles::ChipBreakDrilling>(h);
            c.infeed = h.infeed;
            c.chip_break_distance = h.gap;
            return with(from, c);
        }
        case Way::tap_floating: {
            auto c = between_planes<cycles::FloatingTapping>(h);
            c.spindle_direction = h.direction;
            return with(from, c);
        }
        default: break;
    }
    auto c = between_planes<cycles::RigidTapping>(h);
    c.spindle_direction = h.direction;
    c.pitch = h.pitch;
    // How far it goes back is said in turns of the spindle.
    if (h.way == Way::tap_chip_break) c.infeed = h.infeed, c.chip_break_turns = h.gap / h.pitch;
    return with(from, c);
}

/// Where nobody says where the surface lies: at 0 where the tool comes from above and ends below, else 2 mm below the
/// plane to which the tool comes at rapid.
double surface_of(const Hole& h) {
    if (h.surface && h.top > *h.surface + same_length && h.bottom < *h.surface - same_length) return *h.surface;
    if (h.top > same_length && h.bottom < -same_length) return 0;
    return h.top - std::min(2.0, (h.top - h.bottom) / 2);
}

template <class Cycle>
Cycle below(double surface, const Hole& h) {
    Cycle c;
    c.surface = surface;
    c.clearance = h.top - surface;
    c.depth = h.bottom - surface;
    c.second_clearance = h.end - surface;
    return c;
}

/// Out to the clearance after each infeed, or a little back: the first reaches less far below the surface than those
/// of a control that counts from its retract plane, unless that lies in it.
cycles::UniversalPecking as_pecking(double surface, const Hole& h) {
    auto c = below<cycles::UniversalPecking>(surface, h);
    const bool breaks = h.way == Way::chip_break;
    c.feed_plunge = h.feed;
    c.dwell_bottom = h.dwell;
    c.infeed = breaks ? -c.depth : h.infeed;
    c.decrement = c.min_infeed = 0;
    c.stop_distance_first = c.stop_distance_last = h.gap;
    c.chip_break_depth = breaks ? h.infeed : 0;
    c.chip_break_distance = breaks ? h.gap : 0;
    return c;
}

/// None where no cycle says it all.
std::optional<HoleWay> below_surface(const cl::Cycle& from, double surface, const Hole& h) {
    switch (h.way) {
        case Way::drill: {
            auto c = below<cycles::DepthDrilling>(surface, h);
            c.feed_plunge = h.feed;
            c.dwell_bottom = h.dwell;
            c.infeed = -c.depth;
            c.dwell_top = 0;
            return with(from, c);
        }
        case Way::feed_out: {
            auto c = below<cycles::Reaming>(surface, h);
            c.feed_plunge = h.feed;
            c.dwell_bottom = h.dwell;
            c.feed_retract = 0;
            return with(from, c);
        }
        case Way::tap_floating: {
            auto c = below<cycles::DepthFloatingTapping>(surface, h);
            c.feed_plunge = h.feed;
            c.dwell_bottom = h.dwell;
            return with(from, c);
        }
        case Way::tap_rigid: {
            auto c = below<cycles::DepthRigidTapping>(surface, h);
            c.pitch = h.direction < 0 ? -h.pitch : h.pitch;
            return h.dwell == 0 ? std::optional(with(from, c)) : std::nullopt;
        }
        default: return with(from, as_pecking(surface, h));
    }
}

}  // namespace

HoleWay as_canned(const cl::Cycle& from, const Hole& h) {
    HoleWay out = canned(from, h);
    if (h.way != Way::tap_rigid && h.way != Way::tap_chip_break) out.feed = h.feed;
    out.speed = h.speed;
    return out;
}

/// CYCL DEF 209 counts its steps from the surface, G84 from the retract plane where no surface is said, and says how
/// far it goes back in pitches.
HoleWay as_tap_chip_breaking(const cl::Cycle& from, const Hole& h) {
    auto c = below<cycles::ChipBreakTapping>(h.surface.value_or(h.top), h);
    c.pitch = h.direction * h.pitch;
    c.chip_break_depth = h.infeed;
    c.chip_break_distance = h.gap / h.pitch;
    HoleWay out = with(from, c);
    out.speed = h.speed;
    return out;
}

std::vector<HoleWay> as_depths(const cl::Cycle& from, const Hole& h) {
    const double surface = surface_of(h);
    if (!(h.bottom < surface)) return {};
    std::optional<HoleWay> out = below_surface(from, surface, h);
    if (!out) return {};
    out->speed = h.speed;
    return {*std::move(out)};
}

}  // namespace obrys::write
