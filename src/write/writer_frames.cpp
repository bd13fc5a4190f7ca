/// What coordinates count in: frames, tilted planes whose block turns the rotary axes (PLANE ... TURN), the machine.

#include <algorithm>
#include <cmath>
#include <utility>

#include "write/samples.hpp"
#include "write/writer.hpp"

namespace obrys::write {

namespace {

const cl::FramePart* plane_of(const std::vector<cl::FramePart>& parts) {
    const auto at =
        std::find_if(parts.begin(), parts.end(), [](const cl::FramePart& p) { return p.kind == cl::FrameKind::plane; });
    return at == parts.end() ? nullptr : &*at;
}

bool is_same_plane(const cl::FramePart* a, const cl::FramePart* b) {
    return a == nullptr || b == nullptr ? a == b : *a == *b;
}

bool is_place_known(const cl::MachinePlace& place) {
    const std::array<double, 3> to{place.to.x, place.to.y, place.to.z};
    for (std::size_t k = 0; k < to.size(); ++k)
        if (place.axes[k] && !std::isfinite(to[k])) return false;
    return true;
}

constexpr double along_normal = 1e-9;

geom::Vec3 normal_of(const cl::FramePart& plane) { return geom::apply_direction(plane.frame, {0, 0, 1}); }

constexpr std::string_view frame_table = "frame.";  ///< of the names of its commands

}  // namespace

/// Whether an axis of the next move stands elsewhere yet, or nobody knows where.
bool Writer::take_places_of_axes() {
    bool any = false;
    for (const cl::AxisEnd& axis : axes_) {
        const auto [at, is_new] = axes_at_.try_emplace(axis.name, axis.to);
        any = any || is_new || !(std::abs(at->second - axis.to) <= 1e-9);
        at->second = axis.to;
    }
    return any;
}

/// The block that changes the plane is the one that moves the axes.
bool Writer::turns_with_plane(const cl::Step& step) const {
    const bool stays = place_ && place_->kind == cl::PlaceKind::frame;
    if (!std::holds_alternative<cl::Linear>(step) || axes_.empty() || (place_ && !stays) || now_ == nullptr)
        return false;
    const Source& block = topics_[static_cast<std::size_t>(Topic::frame)];
    return !(block == Source{}) && block == Source{now_->from, now_->stack} &&
           !is_same_plane(plane_of(cursor_.state().frame.parts), plane_of(frames_.parts()));
}

namespace {

bool turned_by_control(const cl::FramePart* plane) { return plane != nullptr && plane->turn.by_control; }

}  // namespace

/// The control turns the axes to the plane of the same block, or that ends one to which it has turned them: where the
/// tip then is nobody knows.
bool Writer::is_turned_by_control(const cl::Step& step) const {
    const auto* line = std::get_if<cl::Linear>(&step);
    const bool turned =
        turned_by_control(plane_of(cursor_.state().frame.parts)) || turned_by_control(plane_of(frames_.parts()));
    if (line == nullptr || !line->rapid || !axes_.empty() || place_ || now_ == nullptr || !turned) return false;
    const Source& block = topics_[static_cast<std::size_t>(Topic::frame)];
    return std::isnan(line->to.x) && std::isnan(line->to.y) && std::isnan(line->to.z) &&
           block == Source{now_->from, now_->stack};
}

namespace {

/// How far before the tip the place lies that the tool has turned about; nothing where it is none on its axis, or
/// nobody knows.
std::optional<double> distance_of_turn(const geom::Vec3& from, const cl::Linear& line, const geom::Vec3& axis_before) {
    constexpr double still = 1e-9, beside = 1e-4;  // mm
    const geom::Vec3 way = line.to - from, turn = line.axis - axis_before;
    const double square = geom::dot(turn, turn);
    if (square < still) return 0;
    const double distance = geom::dot(way, turn) / square;
    const bool fits = geom::length(way - distance * turn) <= beside;  // never of what is not known
    return fits ? std::optional(std::abs(distance) < beside ? 0 : distance) : std::nullopt;
}

}  // namespace

/// Writes the plane with the turn of its axes; false where the post cannot, and the move is yet to be written.
bool Writer::write_turn(const cl::Linear& line, const geom::Vec3& from) {
    plane_turn_ = PlaneTurn{line.rapid};
    if (place_) {
        plane_turn_->about = distance_of_turn(from, line, pointed_);
        if (!plane_turn_->about) return plane_turn_.reset(), false;
    }
    const auto place = std::exchange(place_, std::nullopt);
    write_state();
    if (!std::exchange(plane_turn_, std::nullopt)->is_written) return place_ = place, false;
    axes_.clear();
    pointed_ = line.axis;
    return true;
}

/// The command that does the same and turns the axes, where they turn now.
std::optional<Command> Writer::turning_form(const FrameStep& step) const {
    const Command plain = step.command;
    if (!plane_turn_) {
        if (plain != Command::plane || !post_.has(Command::plane_turn)) return std::nullopt;
        const bool again =
            post_.plane_anew && taken_up_ && geom::distance(*taken_up_, normal_of(step.part)) < along_normal;
        return again || step.part.turn.by_control ? std::optional(Command::plane_turn) : std::nullopt;
    }
    // What takes the place of a plane turns the axes.
    if (plain == Command::plane_off && plane_of(cursor_.state().frame.parts) != nullptr) return std::nullopt;
    std::optional<Command> form;
    if (plain == Command::plane) form = plane_turn_->about ? Command::plane_move : Command::plane_turn;
    if (plain == Command::plane_off) form = plane_turn_->about ? Command::plane_move_off : Command::plane_turn_off;
    if (!form || !post_.has(*form)) return std::nullopt;
    const bool by_feed = plane_turn_->rapid || has_part(post_[*form], Part::feed);
    const bool about = plane_turn_->about.value_or(0) == 0 || says(post_[*form], index_of(Value::distance));
    return by_feed && about ? form : std::nullopt;
}

namespace {

/// How the program wants the axes to turn, where the words have no place for it: they may turn otherwise.
std::vector<std::string> unsaid_of(const cl::PlaneTurn& turn, const Template& words) {
    std::vector<std::string> out;
    const auto said = [&](Value v) { return says(words, index_of(v)); };
    if (turn.side != 0 && !said(Value::side) && !said(Value::turn_side))
        out.emplace_back("which of their two positions the rotary axes take for the tilted plane");
    if (turn.table_turns && !said(Value::table_turns))
        out.emplace_back("that a table turns to the tilted plane rather than the coordinates");
    return out;
}

}  // namespace

void Writer::write_frame() {
    const About about(*this, Topic::frame);
    const cl::Frame& wanted = cursor_.state().frame;
    if (wanted.parts == frames_.parts()) return;
    const bool expanded = std::all_of(frames_.parts().begin(), frames_.parts().end(),
                                      [](const cl::FramePart& p) { return p.kind == cl::FrameKind::datum; });
    if (expanded && frames_refused_ == wanted) return;
    end_cycles();
    end_compensation_alone(Urgency::may_wait);
    printer_.forget_coordinates();
    auto steps = frames_.lead_to(wanted, post_);
    if (!steps) {
        steps = frames_.clear(wanted, post_);
        if (!(frames_refused_ == wanted))
            note(Fate::expanded, "a frame: coordinates are those of the workpiece from here on");
        frames_refused_ = wanted;
    }
    for (const FrameStep& step : *steps) {
        values_.clear();
        static_cast<void>(frame_values(step.part, values_));
        if (plane_turn_ && plane_turn_->about) values_.set(Value::distance, *plane_turn_->about);
        // Axes come in the order of the machine's chain: the last one is that whose sign tells the two positions apart.
        if (plane_turn_ && !axes_.empty() && !values_.has(index_of(Value::side)))
            values_.set(Value::turn_side, axes_.back().to < 0 ? -1 : 1);
        const auto turning = turning_form(step);
        const Command command = turning.value_or(step.command);
        const std::string what = "a frame (" + std::string(name_of(command)).substr(frame_table.size()) + ")";
        const bool printed = print(command, what, turning && (!plane_turn_ || plane_turn_->rapid));
        if (turning && plane_turn_) plane_turn_->is_written = printed;
        turned_by_control_ = turned_by_control_ || (step.part.turn.by_control && printed);
        if (step.part.turn.by_control && turning)
            for (const std::string& unsaid : unsaid_of(step.part.turn, post_[command])) note(Fate::lost, unsaid);
        if (step.part.turn.by_control && !turning)
            note(Fate::lost, "that the control turns the rotary axes to the tilted plane");
        if (step.command == Command::plane)
            taken_up_ = turning && printed ? std::optional(normal_of(step.part)) : std::nullopt;
    }
}

/// The post's words for such a reference point.
Command Writer::home_command(const cl::MachinePlace& place) const {
    if (place.number > 1) return Command::machine_second;
    const bool is_retract = place.axes == std::array{false, false, true} && !post_.has(Command::machine_home);
    return is_retract ? Command::machine_retract : Command::machine_home;
}

namespace {

constexpr double same_place = 1e-6;  ///< mm

/// By coordinates to where the reference point lies.
bool is_at_home(const cl::MachinePlace& place, const Homes& homes) {
    const std::array to{place.to.x, place.to.y, place.to.z};
    for (std::size_t k = 0; k < to.size(); ++k)
        if (place.axes[k] && !(std::abs(to[k] - homes.at[k]) <= same_place)) return false;
    return place.kind == cl::PlaceKind::coordinates && !place.tip;
}

/// What a post lacks that has no words for the place.
std::string why_not_placed(const cl::MachinePlace& place, Command command, const Post& post) {
    if (place.tip) return " that its tip goes to: the post has no " + std::string(name_of(command));
    const bool is_home = place.kind == cl::PlaceKind::home;
    if (is_home && !is_place_known(place) && post.has(Command::machine_coordinates))
        return place.number > 2   ? ", a further reference point,"
               : place.number > 1 ? ", a reference point of which no second_home is given in the machine file,"
                                  : ", a reference point of which no home is given in the machine file,";
    if (is_home && place.number == 1 && post.has(Command::machine_retract))
        return ", a reference point beside that of Z: the post has no " + std::string(name_of(Command::machine_home));
    if (!is_home && post.has(Command::machine_retract) && !post.has(command))
        return ": the post has a word for the reference point of Z alone";
    return "";
}

}  // namespace

/// Beside its tool a mill has no length: its words for the tip, which need not put that off, say the same.
Command Writer::place_command(const cl::MachinePlace& place, bool rapid) const {
    if (place.kind == cl::PlaceKind::fixed) return Command::machine_fixed;
    const Command home = home_command(place);
    if (place.kind == cl::PlaceKind::home && (post_.has(home) || !is_place_known(place)))
        return home;  // else by its coordinates
    if (rapid && !post_.has(Command::machine_coordinates) && post_.has(home) && is_at_home(place, homes_)) return home;
    const Command tip = rapid ? Command::machine_tip : Command::machine_linear_tip;
    const bool beside = !place.axes[2] && !turns(post_) && post_.has(tip);
    return place.tip || beside ? tip : rapid ? Command::machine_coordinates : Command::machine_linear;
}

/// The one is written for the other, and nobody has said that they are the same place.
void Writer::note_assumed_home(const cl::MachinePlace& place, bool by_home) {
    std::string axes;
    for (std::size_t k = 0; k < place.axes.size(); ++k)
        if (place.axes[k] && homes_.assumed[k]) axes += (axes.empty() ? "" : ", ") + std::string(1, "XYZ"[k]);
    if (axes.empty() || by_home == (place.kind == cl::PlaceKind::home)) return;
    Note assumed;
    assumed.fate = Fate::expanded;
    assumed.remedy = "give home of the axes in the machine file";
    assumed.what = std::string(by_home ? "a move to machine coordinate 0" : "a move to the reference point") +
                   ": no home of " + axes + " is given, and machine coordinate 0 is taken for it, as on most machines";
    assumed.instead = by_home ? "is written as one to the reference point" : "is written by its machine coordinates";
    note_at(std::move(assumed));
}

/// A move to a place of the machine; false where there is none, or the post cannot say it and the place is known.
bool Writer::write_place(const cl::Linear& line) {
    if (!place_) return false;
    const cl::MachinePlace place = *std::exchange(place_, std::nullopt);
    if (place.kind == cl::PlaceKind::frame) return write_said(line, place);
    const Command command = place_command(place, line.rapid);
    const bool by_home = command == Command::machine_home || command == Command::machine_retract;
    const bool said = by_home || command == Command::machine_second || command == Command::machine_fixed;
    const std::array<double, 3> to{place.to.x, place.to.y, place.to.z};
    if (!post_.has(command) || (!said && !is_place_known(place))) {
        const geom::Vec3 p = line.to;
        note(geom::is_finite(p) ? Fate::expanded : Fate::lost,
             "a move to a place of the machine" + why_not_placed(place, command, post_));
        return !geom::is_finite(p);
    }
    end_cycles();
    end_compensation_alone(Urgency::may_wait);
    const bool ends_length = post_.length_moves && length_waits_ == Command::length_off && place.axes[2] &&
                             has_part(post_[command], Part::length);
    if (length_waits_ && !post_.length_moves && !by_home) write_all();
    constexpr std::array names{Value::machine_x, Value::machine_y, Value::machine_z};
    values_.clear();
    for (std::size_t k = 0; k < 3; ++k)
        if (place.axes[k]) values_.set(names[k], said ? 0 : to[k]);
    values_.set(Value::number, place.number);
    if (const std::uint32_t edge = cursor_.state().change.edge; edge != 0) values_.set(Value::edge, edge);
    const std::uint64_t at = layout_.next();
    Parts parts = parts_of(line.rapid, nullptr);
    if (ends_length) set_length(), parts.length = &post_[Command::length_off];
    if (has_part(post_[command], Part::axes)) take_axes(parts, place.kind == cl::PlaceKind::home);
    const Printed printed = put(command, parts, "a move to a place of the machine");
    if (printed == Printed::all || printed == Printed::nothing)
        note(Fate::mapped, "a move to a place of the machine", at);
    else if (printed == Printed::failed)
        note(Fate::lost, "a move to a place of the machine: a word cannot hold " + printer_.failed_word());
    if (printed != Printed::failed) note_assumed_home(place, by_home);
    if (ends_length && printed != Printed::failed) note_printed(command, post_[command], parts, at);
    z_of_machine_ = z_of_machine_ || place.axes[2];
    printer_.forget_coordinates();
    return true;
}

namespace {

/// Each axis counts as that of the workpiece does, from another zero.
bool is_shift(const std::vector<cl::FramePart>& parts) {
    return std::all_of(parts.begin(), parts.end(),
                       [](const cl::FramePart& p) { return p.frame.linear == geom::Frame{}.linear; });
}

}  // namespace

/// What the program has said: of the other axes nobody knows where they stand, or the machine has taken them elsewhere.
/// Where the frame is another one in the text, and neither is turned, they are other numbers for the same axes; else
/// false: the point on the workpiece is written.
bool Writer::write_said(const cl::Linear& line, cl::MachinePlace place) {
    const std::vector<cl::FramePart>& wanted = cursor_.state().frame.parts;
    if (!(frames_.parts() == wanted)) {
        const bool shifted = is_shift(frames_.parts()) && is_shift(wanted);
        if (!shifted && geom::is_finite(line.to)) return false;
        const geom::Vec3 there = frames_.programmed(line.to), unsaid{NAN, NAN, NAN};
        const auto& said = place.axes;
        place.to = {said[0] ? there.x : unsaid.x, said[1] ? there.y : unsaid.y, said[2] ? there.z : unsaid.z};
        const bool known = (!said[0] || std::isfinite(there.x)) && (!said[1] || std::isfinite(there.y)) &&
                           (!said[2] || std::isfinite(there.z));
        if (!shifted || !known) return note(Fate::lost, "a move to a coordinate that is not known"), true;
    }
    const std::array said{place.to.x, place.to.y, place.to.z};
    for (std::size_t k = 0; k < said.size(); ++k)
        if (place.axes[k] && !std::isfinite(said[k])) {
            note(Fate::lost, "that the tip stays where it is while the axes turn");
            return true;
        }
    end_cycles();
    note_direction(line.axis);
    if (length_waits_ && !has_part(post_[line.rapid ? Command::rapid : Command::linear], Part::length)) write_all();
    print_straight(place.to, line.rapid, nullptr, cl::Seek::nothing);
    return true;
}

}  // namespace obrys::write
