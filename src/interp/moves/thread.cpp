/// Moves coupled to the spindle: threads and rigid tapping.

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// The way along which the control counts the pitch; `axis`: that of the word that says it.
double way_of_pitch(const Saying& run, const geom::Vec3& from, const geom::Vec3& to, double axis) {
    const geom::Vec3 way = to - from;
    switch (run.traits->pitch_along) {
        case program::PitchAlong::axis_of_word: return axis;
        case program::PitchAlong::farthest_axis:
            return std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z), axis});
        case program::PitchAlong::move: break;
    }
    return geom::length(way);
}

/// The words of the pitch belong to the axes: I to X, J to Y, K to Z (SINUMERIK Fundamentals, thread cutting G33).
void say_other_axis(Moving& run, const geom::Vec3& way) {
    std::string axes, words;
    const std::pair<double, const char*> all[]{{way.x, "XI"}, {way.y, "YJ"}, {way.z, "ZK"}};
    for (const auto& [length, names] : all) {
        if (length == 0) continue;
        axes += (axes.empty() ? "" : " and ") + std::string(1, names[0]);
        words += (words.empty() ? "" : " or ") + std::string(1, names[1]);
    }
    doubt(run, codes::value_range, run.here(),
          "the thread goes along " + axes +
              ", and its pitch is written for an axis that does not move: it is run with "
              "that pitch",
          "write the pitch with " + words);
}

/// Along the move.
double thread_pitch(Moving& run, const geom::Vec3& from, const geom::Vec3& to) {
    const BlockWords& b = run.block;
    double pitch = 0, longest = -1;
    const Code pitches[3] = {Code::i, Code::j, Code::k};
    for (int k = 0; k < 3; ++k) {
        const double step = std::abs(coordinate(to, k) - coordinate(from, k));
        if (b.has(pitches[k]) && step != 0 && !(step < longest)) {
            pitch = b.get(pitches[k]);
            longest = step;
        }
    }
    for (int k = 0; k < 3 && longest < 0; ++k)  // a thread that goes nowhere has its pitch all the same
        if (b.has(pitches[k])) {
            pitch = b.get(pitches[k]);
            break;
        }
    const double way = geom::distance(from, to);
    if (longest < 0 && pitch != 0 && way > 0 && run.traits->pitch_along == program::PitchAlong::axis_of_word)
        say_other_axis(run, to - run.programmed_position);
    if (longest > 0 && std::isfinite(way)) pitch *= way / way_of_pitch(run, from, to, longest);
    return pitch * length_unit(run.modal);
}

/// The sign of G331's pitch is the sense in which the spindle turns, and G332 reverses that by itself (SINUMERIK
/// Fundamentals, "Rigid tapping (G331, G332)"); the stream's is that of the thread. Both are the same on the way in
/// with G331 and on the way out with G332: another way along the tool axis makes a thread of the other hand. On a
/// lathe, where taps work from either side, nothing tells the way in.
double pitch_of_thread(const Reckoning& run, double pitch, const geom::Vec3& from, const geom::Vec3& to) {
    const Modal m = run.modal.motion;
    if ((m != Modal::tap && m != Modal::tap_retract) || run.env.machine.kind != shop::MachineKind::mill) return pitch;
    const geom::Vec3 way = run.frame_is_identity ? to - from : geom::apply_direction(run.frame, to - from);
    const double out = geom::dot(way, run.tool_axis);
    const bool turned = m == Modal::tap ? out > 0 : out < 0;
    return turned ? -pitch : pitch;
}

/// G33.1 has no sign for the hand: the spindle that turns backwards on the way in cuts a left-hand thread.
int hand_of_spindle(const Reckoning& run, const geom::Vec3& from, const geom::Vec3& to) {
    if (run.env.machine.kind != shop::MachineKind::mill) return 1;
    const geom::Vec3 way = run.frame_is_identity ? to - from : geom::apply_direction(run.frame, to - from);
    const bool backwards = run.spindle.direction < 0;
    const bool out = geom::dot(way, run.tool_axis) > 0;
    return backwards != out ? -1 : 1;
}

}  // namespace

/// G33.1: down with the spindle, and back with it reversed.
bool rigid_tap(Moving& run) {
    flush_path(run);
    const geom::Vec3 from = run.programmed_position, to = programmed_target(run);
    cl::Thread t;
    t.axis = run.tool_axis;
    t.pitch = run.block.get(Code::k) * length_unit(run.modal) * hand_of_spindle(run, from, to);
    t.rigid_tap = true;
    for (const geom::Vec3& p : {to, from}) {
        arrive(run, p);
        t.to = run.position;
        emit(run, t);
    }
    return true;
}

bool thread_motion(Moving& run, const geom::Vec3& to) {
    const Modal m = run.modal.motion;
    flush_path(run);
    if (m > Modal::tap_retract) {
        alarm(run, codes::value_range, run.here(), "coordinates without a motion that could run them");
        return false;
    }
    const bool taps = m == Modal::tap || m == Modal::tap_retract;
    if (!taps && run.modal.compensation != Modal::compensation_off && run.capture == nullptr)
        assume(run, run.here(), compensation_in_force(run) + " is still in force in a thread, which is run without it",
               "switch it off before the thread, in a block with a way of its own");
    cl::Thread t;
    t.axis = run.tool_axis;
    t.pitch = pitch_of_thread(run, thread_pitch(run, run.programmed_position, to), run.programmed_position, to);
    if (t.pitch == 0) {
        unchecked(run, codes::value_range, run.here(),
                  "no pitch stands in this block of a thread: it is run as a straight line",
                  "write the pitch in every block of a thread");
        straight_motion(run, to, false);
        return true;
    }
    t.rigid_tap = taps;
    t.start = std::exchange(run.block.thread_start, std::nullopt).value_or(0);
    if (run.traits->thread_begins_at_q && run.block.has(Code::q)) t.start = run.block.get(Code::q);
    if (changes_pitch(m) && run.block.has(Code::feed))
        t.change = (m == Modal::thread_rising ? 1 : -1) * run.block.get(Code::feed) * length_unit(run.modal);
    else if (changes_pitch(m)) {
        t.change = NAN;
        unchecked(run, codes::value_range, run.here(),
                  "no F stands in this block: by how much the pitch changes with every revolution is not known",
                  "write F, mm per revolution and revolution, behind G34 or G35");
    }
    arrive(run, to);
    t.to = run.position;
    emit(run, t);
    return true;
}

}  // namespace obrys::interp
