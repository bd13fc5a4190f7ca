/// What the arguments of a cycle at one hole mean, whatever control spells them. Source: docs/dialects/sinumerik.md,
/// "Cycles of one hole".

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "cycles/hole/between_planes.hpp"
#include "cycles/hole/metric.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cycles::Said;
using program::HoleArgument;
using program::HoleShape;

namespace {

/// What the arguments say of the heights; mm.
struct Planes {
    double end = 0, reference = 0, start = 0, bottom = 0;
};

void hole_alarm(Saying& run, const HoleCall& call, const std::string& text, const std::string& remedy,
                std::string_view number) {
    alarm(run, codes::value_range, call.where, std::string(call.cycle->name) + ": " + text + of_alarm(number), remedy);
}

/// Nothing after an alarm. Below the reference plane lies where the return plane does not.
std::optional<Planes> planes_of(Saying& run, const HoleCall& call) {
    Planes p;
    p.end = call.get(HoleArgument::return_plane, NAN);
    p.reference = call.get(HoleArgument::reference_plane, NAN);
    const auto bottom = call.find(HoleArgument::bottom), depth = call.find(HoleArgument::depth);
    const bool relative = depth && (*depth != 0 || !bottom);
    if (!bottom && !depth) {
        hole_alarm(run, call, "neither DP nor DPR says how deep the hole is", "write the final drilling depth", "");
        return std::nullopt;
    }
    p.bottom = relative ? p.reference - std::abs(*depth) : bottom.value_or(NAN);
    p.start = p.reference + std::abs(call.get(HoleArgument::clearance));
    if (p.end < p.reference || (relative && p.end == p.reference)) {
        hole_alarm(run, call, "the reference plane is defined incorrectly: the return plane RTP does not lie above RFP",
                   "write RTP above RFP, or the depth as DP", "61101");
        return std::nullopt;
    }
    return p;
}

/// s; negative numbers are turns of the spindle.
double seconds_of(const Reckoning& run, double written) {
    return written >= 0 ? written : -written * 60 / run.spindle.speed;
}

template <class Cycle>
Cycle between(const Planes& p) {
    Cycle c;
    c.surface = p.reference;
    c.retract_plane = p.start;
    c.bottom = p.bottom;
    c.return_level = p.end;
    return c;
}

/// Where 0 says nothing.
Said unless_0(double written) { return written != 0 ? Said(written) : std::nullopt; }

/// A feed in mm/min of a number in the unit in force.
double per_minute(const Reckoning& run, double written) {
    const double length = written * (run.modal.inch_feed ? 25.4 : 1);
    return run.modal.feed_mode == cl::FeedMode::per_rev ? length * run.spindle.speed : length;
}

/// 3 M3, 4 M4; 0 for all else.
int turning(double written) { return written == 3 ? 1 : written == 4 ? -1 : 0; }

/// After an infeed; 0 is 1 mm.
double way_back(const HoleCall& call) {
    const double written = std::abs(call.get(HoleArgument::way_back));
    return written == 0 ? 1 : written;
}

// --- Shapes.

/// By the rule that counts where _DIS1 is 0: 0.6 mm in holes of 30 mm, a fiftieth in deeper ones, 7 mm at most.
double stop_distance(Saying& run, const HoleCall& call, const Planes& p) {
    if (const double written = call.get(HoleArgument::stop_distance); written != 0) return std::abs(written);
    assume(run, call.where,
           std::string(call.cycle->name) +
               ": how far above the depth reached the rapid way back into the hole ends (_DIS1 is 0) is a rule of the "
               "control: 0.6 mm in holes down to 30 mm, a fiftieth of deeper ones");
    constexpr double least = 0.6, most = 7, share = 50;
    return std::min(std::max(least, (p.reference - p.bottom) / share), most);
}

/// The first infeed; nothing after an alarm.
std::optional<double> first_infeed(Saying& run, const HoleCall& call, const Planes& p) {
    const auto bottom = call.find(HoleArgument::first_bottom), depth = call.find(HoleArgument::first_depth);
    const double infeed = depth && *depth != 0 ? std::abs(*depth) : p.reference - bottom.value_or(p.bottom);
    constexpr double same = 1e-6;
    if (!(infeed <= 0) && !(infeed > p.reference - p.bottom + same)) return infeed;
    hole_alarm(run, call, "the first drilling depth (FDEP, FDPR) does not lie between RFP and the final depth",
               "write FDPR above 0 and not above the depth of the hole", "61107");
    return std::nullopt;
}

/// What the arguments say beyond a plain cycle of pecks.
struct DeepWay {
    double first = 0;  ///< infeed, mm
    bool out = false;  ///< of the hole after each infeed
    double factor = 0, degression = 0, dwell = 0, bottom_dwell = 0;

    [[nodiscard]] bool is_slower() const { return factor != 0 && factor != 1; }
};

/// As a cycle that other controls have, too.
cycles::Demand plain_pecks(Saying& run, const HoleCall& call, const Planes& p, const DeepWay& way, Said dwell) {
    if (!way.out) {
        auto d = between<cycles::ChipBreakDrilling>(p);
        d.infeed = way.first;
        d.chip_break_distance = way_back(call);
        d.dwell_bottom = dwell;
        return cycles::demand_of(d);
    }
    auto d = between<cycles::PeckDrilling>(p);
    d.infeed = way.first;
    d.stop_distance_first = stop_distance(run, call, p);
    d.dwell_bottom = dwell;
    return cycles::demand_of(d);
}

/// Plain where nothing more is said; else with all its dwells and falling infeeds.
std::optional<cycles::Demand> deep(Reckoning& run, const HoleCall& call, const Planes& p) {
    const auto first = first_infeed(run, call, p);
    if (!first) return std::nullopt;
    const double dwell = call.get(HoleArgument::dwell_or_turns), last = call.get(HoleArgument::dwell_last);
    const DeepWay way{*first,
                      call.get(HoleArgument::way_out) != 0,
                      call.get(HoleArgument::feed_factor),
                      call.get(HoleArgument::degression),
                      dwell,
                      last != 0 ? last : dwell};
    const bool plain =
        way.degression == 0 && dwell == 0 && call.get(HoleArgument::dwell_first) == 0 && !way.is_slower();
    if (plain)
        return plain_pecks(run, call, p, way,
                           way.bottom_dwell != 0 ? Said(seconds_of(run, way.bottom_dwell)) : std::nullopt);
    auto d = between<cycles::DeepDrilling>(p);
    d.infeed = way.first;
    if (way.out)
        d.stop_distance_first = stop_distance(run, call, p);
    else
        d.chip_break_distance = way_back(call);
    if (way.degression >= 0) d.decrement = way.degression;
    if (way.degression < 0) {
        d.infeed_factor = -way.degression;
        d.min_infeed = std::max(0.0, call.get(HoleArgument::least_infeed));
    }
    d.dwell = seconds_of(run, dwell);
    d.dwell_top = way.out ? seconds_of(run, call.get(HoleArgument::dwell_first)) : 0;
    d.dwell_bottom = seconds_of(run, way.bottom_dwell);
    d.feed_factor = way.is_slower() ? way.factor * 100 : 100;
    return cycles::demand_of(d);
}

/// The pitch in mm, negative left-hand; 0 where none is written; nothing after an alarm.
std::optional<double> pitch_of(Reckoning& run, const HoleCall& call) {
    constexpr double inch = 25.4;
    const double size = call.get(HoleArgument::size), written = call.get(HoleArgument::pitch);
    const double unit = call.get(HoleArgument::pitch_unit), own = length_unit(run.modal);
    const double pitch = unit == 1   ? written
                         : unit == 2 ? (written == 0 ? 0 : inch / written)
                         : unit == 3 ? written * inch
                                     : written * own;
    if (size == 0) return pitch;
    const auto coarse = cycles::coarse_pitch(std::abs(size));
    const double by_size = coarse ? std::copysign(*coarse, size) : 0;
    if (coarse && (pitch == 0 || std::abs(pitch - by_size) < 1e-6)) return by_size;
    hole_alarm(run, call,
               coarse ? "the size of the thread (MPIT) and its pitch (PIT) contradict each other"
                      : "the size of the thread (MPIT) is none of the ISO metric sizes",
               "write either the size or the pitch", "61001");
    return std::nullopt;
}

std::optional<cycles::Demand> rigid(Reckoning& run, const HoleCall& call, const Planes& p) {
    const auto pitch = pitch_of(run, call);
    if (!pitch) return std::nullopt;
    if (*pitch == 0) {
        hole_alarm(run, call, "the thread has no pitch", "write MPIT or PIT", "61001");
        return std::nullopt;
    }
    auto d = between<cycles::RigidTapping>(p);
    d.pitch = std::abs(*pitch);
    d.spindle_direction = *pitch < 0 ? -1 : 1;
    d.starts_spindle = 1;
    const double in = call.get(HoleArgument::speed_in), out = call.get(HoleArgument::speed_out);
    d.spindle_speed = unless_0(in);
    if (out != 0 && out != in) d.rpm_factor = out / (in != 0 ? in : run.spindle.speed);
    d.dwell_bottom = unless_0(call.get(HoleArgument::dwell));
    d.spindle_after = turning(call.get(HoleArgument::direction_after));
    const double steps = call.get(HoleArgument::steps), infeed = call.get(HoleArgument::infeed);
    if (steps == 0 || infeed == 0) return cycles::demand_of(d);
    d.infeed = std::abs(infeed);
    if (steps == 1)
        d.chip_break_distance = way_back(call);
    else
        d.stop_distance_first = 0;
    return cycles::demand_of(d);
}

std::optional<cycles::Demand> floating(Reckoning& run, const HoleCall& call, const Planes& p) {
    const auto pitch = pitch_of(run, call);
    if (!pitch) return std::nullopt;
    const int back = turning(call.get(HoleArgument::direction_back));
    const int in = back != 0 ? -back : *pitch < 0 ? -1 : run.spindle.direction;
    constexpr double with_encoder = 0, with_encoder_and_dwell = 20, computed = 11;
    const double encoder = call.get(HoleArgument::encoder);
    const bool by_pitch = encoder == with_encoder || encoder == with_encoder_and_dwell || encoder == computed;
    if (by_pitch && *pitch == 0) {
        hole_alarm(run, call, "the thread has no pitch", "write MPIT or PIT, or ENC = 1 with F in force", "61001");
        return std::nullopt;
    }
    auto d = between<cycles::FloatingTapping>(p);
    d.spindle_direction = unless_0(in);
    if (by_pitch) d.pitch = std::abs(*pitch);
    d.dwell_bottom = unless_0(call.get(HoleArgument::dwell));
    // 0 reverses by itself: what SDAC says does not count then.
    if (back != 0) d.spindle_after = turning(call.get(HoleArgument::direction_after));
    return cycles::demand_of(d);
}

/// Of boring that stops the spindle: it is turned on by the cycle, and stands behind it.
template <class Cycle>
bool turns(Saying& run, const HoleCall& call, Cycle& d) {
    const int direction = turning(call.get(HoleArgument::direction));
    if (direction == 0) {
        hole_alarm(run, call, "no direction of the spindle is programmed", "write SDIR = 3 (M3) or 4 (M4)", "61102");
        return false;
    }
    d.spindle_direction = direction;
    d.starts_spindle = 1;
    d.spindle_after = 0;
    d.dwell_bottom = unless_0(call.get(HoleArgument::dwell));
    return true;
}

std::optional<cycles::Demand> oriented(Saying& run, const HoleCall& call, const Planes& p) {
    auto d = between<cycles::OrientedBoring>(p);
    if (!turns(run, call, d)) return std::nullopt;
    d.shift_u = call.get(HoleArgument::shift_u);
    d.shift_v = call.get(HoleArgument::shift_v);
    d.shift_w = unless_0(call.get(HoleArgument::shift_w));
    d.spindle_angle = call.find(HoleArgument::spindle_angle);
    return cycles::demand_of(d);
}

std::optional<cycles::Demand> stopped(Saying& run, const HoleCall& call, const Planes& p) {
    auto d = between<cycles::StopBoring>(p);
    if (!turns(run, call, d)) return std::nullopt;
    if (call.cycle->stops_program) d.stops_program = 1;
    return cycles::demand_of(d);
}

cycles::Demand at_feed(const Reckoning& run, const HoleCall& call, const Planes& p) {
    auto d = between<cycles::FeedBoring>(p);
    d.dwell_bottom = unless_0(call.get(HoleArgument::dwell));
    if (const double f = call.get(HoleArgument::feed_in); f != 0) d.feed_plunge = per_minute(run, f);
    if (const double f = call.get(HoleArgument::feed_out); f != 0) d.feed_retract = per_minute(run, f);
    return cycles::demand_of(d);
}

cycles::Demand drilled(const Reckoning& run, const HoleCall& call, const Planes& p) {
    auto d = between<cycles::Drilling>(p);
    if (const double written = call.get(HoleArgument::dwell_or_turns); written != 0)
        d.dwell_bottom = seconds_of(run, written);
    return cycles::demand_of(d);
}

}  // namespace

std::optional<cycles::Demand> demand_of(Reckoning& run, const HoleCall& call) {
    const auto planes = planes_of(run, call);
    if (!planes) return std::nullopt;
    switch (call.cycle->shape) {
        case HoleShape::drill: return drilled(run, call, *planes);
        case HoleShape::deep_drill: return deep(run, call, *planes);
        case HoleShape::tap_rigid: return rigid(run, call, *planes);
        case HoleShape::tap_floating: return floating(run, call, *planes);
        case HoleShape::bore_feed: return at_feed(run, call, *planes);
        case HoleShape::bore_orient: return oriented(run, call, *planes);
        case HoleShape::bore_stop: return stopped(run, call, *planes);
    }
    return std::nullopt;
}

}  // namespace obrys::interp
