/// Tilted planes whose block turns the rotary axes: PLANE ... TURN and MOVE.

#include <algorithm>
#include <cmath>

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

/// The tip stays where it is while the axes turn.
bool is_kept_tip(const cl::MachinePlace& place) {
    return place.kind == cl::PlaceKind::frame && place.axes == std::array{true, true, true};
}

}  // namespace

/// Whether an axis of the next move stands elsewhere yet, or nobody knows where.
bool Writer::take_places_of_axes() {
    bool any = false;
    for (const cl::Axis& axis : axes_) {
        const auto [at, is_new] = axes_at_.try_emplace(axis.name, axis.to);
        any = any || is_new || !(std::abs(at->second - axis.to) <= 1e-9);
        at->second = axis.to;
    }
    return any;
}

/// The block that changes the plane is the one that moves the axes.
bool Writer::turns_with_plane(const cl::Step& step) const {
    if (!std::holds_alternative<cl::Linear>(step) || axes_.empty() || now_ == nullptr) return false;
    if (place_ && !is_kept_tip(*place_)) return false;
    const Source& block = topics_[static_cast<std::size_t>(Topic::frame)];
    return !(block == Source{}) && block == Source{now_->from, now_->stack} &&
           !is_same_plane(plane_of(cursor_.state().frame.parts), plane_of(frames_.parts()));
}

/// Writes the plane with the turn of its axes; false where the post cannot, and the move is yet to be written.
bool Writer::write_turn(const cl::Linear& line) {
    turning_ = place_ ? Turning::keeps_tip : Turning::axes_alone;
    turns_at_rapid_ = line.rapid;
    has_turned_ = false;
    write_state();
    turning_ = Turning::none;
    if (!has_turned_) return false;
    place_.reset();
    axes_.clear();
    pointed_ = line.axis;
    return true;
}

/// The command that does the same and turns the axes, where they turn now.
std::optional<Command> Writer::turning_form(Command plain) const {
    if (turning_ == Turning::none) return std::nullopt;
    const bool keeps = turning_ == Turning::keeps_tip;
    std::optional<Command> form;
    if (plain == Command::plane) form = keeps ? Command::plane_move : Command::plane_turn;
    if (plain == Command::plane_off) form = keeps ? Command::plane_move_off : Command::plane_turn_off;
    return form && post_.has(*form) ? form : std::nullopt;
}

/// What the program has said: of the other axes nobody knows where they stand, or the machine has taken them elsewhere.
/// False where the frame is another one in the text: the point on the workpiece is written.
bool Writer::write_said(const cl::Linear& line, const cl::MachinePlace& place) {
    if (!(frames_.parts() == cursor_.state().frame.parts)) {
        if (geom::is_finite(line.to)) return false;
        note(Fate::lost, "a move to a coordinate that is not known");
        return true;
    }
    const std::array said{place.to.x, place.to.y, place.to.z};
    for (std::size_t k = 0; k < said.size(); ++k)
        if (place.axes[k] && !std::isfinite(said[k])) {
            note(Fate::lost, "that the tip stays where it is while the axes turn");
            return true;
        }
    end_cycles();
    note_direction(line.axis);
    const Command command = line.rapid ? Command::rapid : Command::linear;
    if (length_waits_ && !has_part(post_[command], Part::length)) write_all();
    constexpr std::array words{Value::x, Value::y, Value::z};
    values_.clear();
    for (std::size_t k = 0; k < said.size(); ++k)
        if (place.axes[k]) values_.set(words[k], said[k]);
    print_move(command, line.rapid, nullptr);
    return true;
}

}  // namespace obrys::write
