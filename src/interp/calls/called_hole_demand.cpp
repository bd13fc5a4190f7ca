/// What the arguments of a cycle at one hole mean, whatever control spells them. Source: docs/dialects/sinumerik.md,
/// "Cycles of one hole".

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "cycles/hole/metric.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleRole;
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

void add(cycles::Demand& d, CycleRole role, double value) { d.values.push_back({role, value}); }

/// A feed in mm/min of a number in the unit in force.
double per_minute(const Reckoning& run, double written) {
    const double length = written * (run.modal.inch_feed ? 25.4 : 1);
    return run.modal.feed_mode == cl::FeedMode::per_rev ? length * run.spindle.speed : length;
}

/// 3 M3, 4 M4; 0 for all else.
int turning(double written) { return written == 3 ? 1 : written == 4 ? -1 : 0; }

void add_dwell(cycles::Demand& d, const Reckoning& run, const HoleCall& call, HoleArgument a, CycleRole role) {
    if (const double written = call.get(a); written != 0) add(d, role, seconds_of(run, written));
}

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

/// As a cycle that other controls have, too, where nothing more is said; else with all its dwells and falling infeeds.
bool add_deep(Reckoning& run, const HoleCall& call, const Planes& p, cycles::Demand& d) {
    const auto first = first_infeed(run, call, p);
    if (!first) return false;
    const bool out = call.get(HoleArgument::way_out) != 0;
    const double factor = call.get(HoleArgument::feed_factor), degression = call.get(HoleArgument::degression);
    const double dwell = call.get(HoleArgument::dwell_or_turns), last = call.get(HoleArgument::dwell_last);
    const bool slower = factor != 0 && factor != 1;
    const bool plain = degression == 0 && dwell == 0 && call.get(HoleArgument::dwell_first) == 0 && !slower;
    d.kind = !plain ? cl::CycleKind::canned_deep : out ? cl::CycleKind::canned_peck : cl::CycleKind::canned_chip_break;
    add(d, CycleRole::infeed, *first);
    if (out)
        add(d, CycleRole::stop_distance_first, stop_distance(run, call, p));
    else
        add(d, CycleRole::chip_break_distance, way_back(call));
    const double bottom_dwell = last != 0 ? last : dwell;
    if (plain && bottom_dwell != 0) add(d, CycleRole::dwell_bottom, seconds_of(run, bottom_dwell));
    if (plain) return true;
    if (degression >= 0) add(d, CycleRole::decrement, degression);
    if (degression < 0) {
        add(d, CycleRole::infeed_factor, -degression);
        add(d, CycleRole::min_infeed, std::max(0.0, call.get(HoleArgument::least_infeed)));
    }
    add(d, CycleRole::dwell, seconds_of(run, dwell));
    add(d, CycleRole::dwell_top, out ? seconds_of(run, call.get(HoleArgument::dwell_first)) : 0);
    add(d, CycleRole::dwell_bottom, seconds_of(run, bottom_dwell));
    add(d, CycleRole::feed_factor, slower ? factor * 100 : 100);
    return true;
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

bool add_rigid(Reckoning& run, const HoleCall& call, cycles::Demand& d) {
    d.kind = cl::CycleKind::canned_tap_rigid;
    const auto pitch = pitch_of(run, call);
    if (!pitch) return false;
    if (*pitch == 0) {
        hole_alarm(run, call, "the thread has no pitch", "write MPIT or PIT", "61001");
        return false;
    }
    add(d, CycleRole::pitch, std::abs(*pitch));
    add(d, CycleRole::spindle_direction, *pitch < 0 ? -1 : 1);
    add(d, CycleRole::starts_spindle, 1);
    const double in = call.get(HoleArgument::speed_in), out = call.get(HoleArgument::speed_out);
    if (in != 0) add(d, CycleRole::spindle_speed, in);
    if (out != 0 && out != in) add(d, CycleRole::rpm_factor, out / (in != 0 ? in : run.spindle.speed));
    if (const double s = call.get(HoleArgument::dwell); s != 0) add(d, CycleRole::dwell_bottom, s);
    add(d, CycleRole::spindle_after, turning(call.get(HoleArgument::direction_after)));
    const double steps = call.get(HoleArgument::steps), infeed = call.get(HoleArgument::infeed);
    if (steps == 0 || infeed == 0) return true;
    add(d, CycleRole::infeed, std::abs(infeed));
    if (steps == 1)
        add(d, CycleRole::chip_break_distance, way_back(call));
    else
        add(d, CycleRole::stop_distance_first, 0);
    return true;
}

bool add_floating(Reckoning& run, const HoleCall& call, cycles::Demand& d) {
    d.kind = cl::CycleKind::canned_tap_floating;
    const auto pitch = pitch_of(run, call);
    if (!pitch) return false;
    const int back = turning(call.get(HoleArgument::direction_back));
    const int in = back != 0 ? -back : *pitch < 0 ? -1 : run.spindle.direction;
    constexpr double with_encoder = 0, with_encoder_and_dwell = 20, computed = 11;
    const double encoder = call.get(HoleArgument::encoder);
    const bool by_pitch = encoder == with_encoder || encoder == with_encoder_and_dwell || encoder == computed;
    if (by_pitch && *pitch == 0) {
        hole_alarm(run, call, "the thread has no pitch", "write MPIT or PIT, or ENC = 1 with F in force", "61001");
        return false;
    }
    if (in != 0) add(d, CycleRole::spindle_direction, in);
    if (by_pitch) add(d, CycleRole::pitch, std::abs(*pitch));
    if (const double s = call.get(HoleArgument::dwell); s != 0) add(d, CycleRole::dwell_bottom, s);
    // 0 reverses by itself: what SDAC says does not count then.
    if (back != 0) add(d, CycleRole::spindle_after, turning(call.get(HoleArgument::direction_after)));
    return true;
}

/// Of boring that stops the spindle: it is turned on by the cycle, and stands behind it.
bool add_direction(Saying& run, const HoleCall& call, cycles::Demand& d) {
    const int direction = turning(call.get(HoleArgument::direction));
    if (direction == 0) {
        hole_alarm(run, call, "no direction of the spindle is programmed", "write SDIR = 3 (M3) or 4 (M4)", "61102");
        return false;
    }
    add(d, CycleRole::spindle_direction, direction);
    add(d, CycleRole::starts_spindle, 1);
    add(d, CycleRole::spindle_after, 0);
    if (const double s = call.get(HoleArgument::dwell); s != 0) add(d, CycleRole::dwell_bottom, s);
    return true;
}

bool add_orient(Saying& run, const HoleCall& call, cycles::Demand& d) {
    d.kind = cl::CycleKind::canned_bore_orient;
    if (!add_direction(run, call, d)) return false;
    add(d, CycleRole::shift_u, call.get(HoleArgument::shift_u));
    add(d, CycleRole::shift_v, call.get(HoleArgument::shift_v));
    if (const double w = call.get(HoleArgument::shift_w); w != 0) add(d, CycleRole::shift_w, w);
    if (const auto angle = call.find(HoleArgument::spindle_angle)) add(d, CycleRole::spindle_angle, *angle);
    return true;
}

bool add_shape(Reckoning& run, const HoleCall& call, const Planes& p, cycles::Demand& d) {
    switch (call.cycle->shape) {
        case HoleShape::drill:
            d.kind = cl::CycleKind::canned_drill;
            add_dwell(d, run, call, HoleArgument::dwell_or_turns, CycleRole::dwell_bottom);
            return true;
        case HoleShape::deep_drill: return add_deep(run, call, p, d);
        case HoleShape::tap_rigid: return add_rigid(run, call, d);
        case HoleShape::tap_floating: return add_floating(run, call, d);
        case HoleShape::bore_feed:
            d.kind = cl::CycleKind::canned_bore_feed;
            if (const double s = call.get(HoleArgument::dwell); s != 0) add(d, CycleRole::dwell_bottom, s);
            if (const double f = call.get(HoleArgument::feed_in); f != 0)
                add(d, CycleRole::feed_plunge, per_minute(run, f));
            if (const double f = call.get(HoleArgument::feed_out); f != 0)
                add(d, CycleRole::feed_retract, per_minute(run, f));
            return true;
        case HoleShape::bore_orient: return add_orient(run, call, d);
        case HoleShape::bore_stop:
            d.kind = cl::CycleKind::canned_bore_stop;
            if (call.cycle->stops_program) add(d, CycleRole::stops_program, 1);
            return add_direction(run, call, d);
    }
    return false;
}

}  // namespace

std::optional<cycles::Demand> demand_of(Reckoning& run, const HoleCall& call) {
    const auto planes = planes_of(run, call);
    if (!planes) return std::nullopt;
    cycles::Demand d;
    add(d, CycleRole::surface, planes->reference);
    add(d, CycleRole::retract_plane, planes->start);
    add(d, CycleRole::bottom, planes->bottom);
    add(d, CycleRole::return_level, planes->end);
    return add_shape(run, call, *planes, d) ? std::optional(d) : std::nullopt;
}

}  // namespace obrys::interp
