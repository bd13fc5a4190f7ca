/// Radius compensation: it begins and ends with a move, and ends by itself before what no control does under it.

#include <cmath>

#include "write/writer.hpp"

namespace obrys::write {

/// What switches it on; nothing where the program says the radius itself and the post has no word for that. The side is
/// that of the stream's normal: a mirror, or a plane seen from behind, makes the other one of it in the text.
std::optional<Command> Writer::compensation_of(const cl::CompensationBegin& begin) const {
    const geom::Vec3 n = frames_.programmed_direction(begin.normal);
    const bool other = (n.x + n.y + n.z < 0) != frames_.mirrors();
    const bool left = (begin.side == cl::CompensationSide::left) != other;
    if (!begin.given) return left ? Command::compensation_left : Command::compensation_right;
    const Command command = left ? Command::compensation_left_by : Command::compensation_right_by;
    return post_.has(command) ? std::optional(command) : std::nullopt;
}

/// Where the tool's path stands in the place of the contour: without a radius the run's moves are those of the contour
/// itself, and no path of any tool. True where that was said.
bool Writer::note_path_of_no_radius(const cl::CompensationBegin& begin) {
    if (std::abs(begin.radius) > 0) return false;
    note(Fate::lost, "radius compensation by a radius that is not known");
    return true;
}

void Writer::event(const cl::CompensationBegin& begin) {
    if (plain_) return static_cast<void>(note_path_of_no_radius(begin));
    write_state();  // the frame in which its side counts
    values_.clear();
    const std::optional<Command> wanted = compensation_of(begin);
    if (!wanted || !post_.has(*wanted)) {
        end_compensation_alone(Urgency::now);  // of the contour before
        if (!note_path_of_no_radius(begin))
            note(Fate::expanded,
                 wanted ? std::string(radius_compensation) : "radius compensation by a radius that the program says");
        compensation_.reset();
        plain_ = true;
    } else {
        // G40 in a block of its own, not the change of the sides in one.
        const bool ended_before = compensation_end_ && !(*compensation_end_ == Source{now_->from, now_->stack});
        if (ended_before) end_compensation_alone(Urgency::may_wait);
        compensation_ = wanted;
    }
    contour_begun_ = false;
    programmed_.clear();
}

void Writer::event(const cl::CompensationEnd&) {
    if (std::exchange(plain_, false)) return;
    compensation_ = Command::compensation_off;
    compensation_end_ = Source{now_->from, now_->stack};
}

/// The end of compensation that waits for a move stands in a block of its own before what is not to be done under it:
/// a change of tools, zeros or frames, cycles, places of the machine, the end of the program.
void Writer::end_compensation_alone(Urgency urgency) {
    if (!is_compensating_ || compensation_ != Command::compensation_off) return;
    const About about(*this, Topic::compensation);
    constexpr std::string_view what = "the end of radius compensation";
    const bool sayable = post_.has(Command::compensation_off_alone);
    if (!sayable && urgency == Urgency::may_wait) return;
    compensation_.reset();
    is_compensating_ = false;
    if (!sayable && urgency == Urgency::at_end) {
        Note left_out{Fate::expanded, std::string(what) + ", which the end of the program brings,", {}, 0, 0};
        left_out.instead = "is left out";
        return note_at(std::move(left_out));
    }
    const Values of_what_follows = std::exchange(values_, {});
    print(Command::compensation_off_alone, what);
    values_ = of_what_follows;
}

/// A block that has no place for the end of compensation, or an arc, with which no control takes it.
bool Writer::ends_before(const Template& form, Command command) const {
    const bool turns = command >= Command::arc_cw && command <= Command::helix_ccw;
    return turns || !has_part(form, Part::compensation);
}

void Writer::end_wait_of_compensation(Command command, const Template& form, std::uint64_t line) {
    const About about(*this, Topic::compensation);
    if (!has_part(form, Part::compensation))
        note(Fate::lost, "compensation: " + std::string(name_of(command)) + " of the post has no place for it");
    else if (compensation_ == Command::compensation_off)
        note(Fate::mapped, "the end of radius compensation", line);
    else
        note(Fate::mapped, std::string(radius_compensation), line);
    is_compensating_ = compensation_ != Command::compensation_off;
    compensation_.reset();
}

}  // namespace obrys::write
