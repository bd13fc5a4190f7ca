/// Threads and rigid taps.

#include <cmath>
#include <utility>

#include "write/writer.hpp"

namespace obrys::write {

namespace {

constexpr double way_back_noise = 1e-6;  ///< mm: a way back ends where it began

}  // namespace

/// A word of taps that says the way back leads to where they began.
void Writer::note_tap_back(const geom::Vec3& to) {
    if (post_.has(Command::tap) && !(geom::distance(to, tap_.from) <= way_back_noise))
        note(Fate::lost, "rigid tapping that goes back before it is done: the post has no motion.tap-back");
}

void Writer::write_thread(const cl::Thread& thread, const geom::Vec3& from) {
    const bool back = tap_.is_way_back(thread.rigid_tap, from);
    if (back && !post_.has(Command::tap_back)) return note_tap_back(thread.to);  // the word of the tap says it, too
    end_cycles();
    const geom::Vec3 to = frames_.programmed(thread.to), start = frames_.programmed(from);
    values_.clear();
    if (!std::isnan(to.x)) values_.set(Value::x, to.x);
    if (!std::isnan(to.y)) values_.set(Value::y, to.y);
    if (!std::isnan(to.z)) values_.set(Value::z, to.z);
    drop_standing_axes();
    const double pitch = thread.rigid_tap ? thread.pitch : std::abs(thread.pitch);
    values_.set(Value::pitch, std::abs(thread.pitch));
    const geom::Vec3 way = to - start;
    const double length = geom::length(way);
    if (length > 0 && std::isfinite(length)) {
        // Controls count the pitch along the axis that goes farther.
        const double x = std::abs(way.x), y = std::abs(way.y), z = std::abs(way.z);
        if (z >= x && z >= y)
            values_.set(Value::pitch_z, pitch * z / length);
        else if (x >= y)
            values_.set(Value::pitch_x, pitch * x / length);
        else
            values_.set(Value::pitch_y, pitch * y / length);
    } else {
        values_.set(Value::pitch_z, pitch);  // goes nowhere, or nobody knows from where
    }
    if (thread.rigid_tap) note_tapping();
    const Command command = back                ? Command::tap_back
                            : thread.rigid_tap  ? Command::tap
                            : thread.change > 0 ? Command::thread_rising
                            : thread.change < 0 ? Command::thread_falling
                                                : Command::thread;
    if (std::isnan(thread.change)) return note(Fate::lost, "a thread whose pitch changes by nobody knows how much");
    if (thread.change != 0) values_.set(Value::pitch_change, std::abs(thread.change));
    if (thread.start != 0) values_.set(Value::start, thread.start);
    if (thread.start != 0 && post_.has(command) && !says(post_[command], index_of(Value::start)))
        note(Fate::lost, "the angle at which a thread begins");
    if (thread.rigid_tap) set_tap();
    print_move(command, true, nullptr);
    if (thread.rigid_tap) leave_tap(command);
}

/// Values of taps alone: their speed, and the angle at which the spindle is held before them.
void Writer::set_tap() {
    const cl::Spindle& spindle = cursor_.state().spindle;
    if (spindle.speed > 0 && spindle.mode == cl::SpindleMode::rpm) values_.set(Value::speed, spindle.speed);
    const bool known = spindle.held && !std::isnan(*spindle.held);
    values_.set(Value::held, known ? *spindle.held : 0);
}

/// Before a tap the spindle stands where the post's word for it wants that, by that word itself; else it turns as the
/// thread does, also where the program has held it.
void Writer::ready_spindle(const cl::Thread& tap) {
    cl::Spindle now = cursor_.state().spindle;
    if (!(now.speed > 0) || !post_.has(Command::tap)) return;
    tap_.spindle_ready = says(post_[Command::tap], index_of(Value::held));
    if (tap_.spindle_ready || now.direction != 0 || !(std::abs(tap.pitch) > 0)) return;
    now.direction = tap.pitch > 0 ? 1 : -1;
    now.held.reset();
    write_spindle(now);
    tap_.spindle_ready = true;
}

/// Words of taps are said anew for each of them. A spindle that was held before it does not turn behind it by itself.
void Writer::leave_tap(Command command) {
    printer_.leave(post_[command]);
    if (!says(post_[command], index_of(Value::held))) return;
    spindle_.direction = 0;
    spindle_.held = cursor_.state().spindle.held.value_or(0);
    printer_.leave(post_[Command::spindle_cw]);
}

}  // namespace obrys::write
