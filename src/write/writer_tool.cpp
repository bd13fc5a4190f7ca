/// The tool in the spindle, its offsets, its length, its place in the magazine, and what a postprocessor refuses to cut
/// with.

#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "cl/unknown_tool.hpp"
#include "write/writer.hpp"

namespace obrys::write {

namespace {

bool is_same_tool(const cl::ToolChange& a, const cl::ToolChange& b) { return a.number == b.number && a.name == b.name; }

}  // namespace

void Writer::write_standing(const cl::ToolChange& change) {
    values_.clear();
    values_.set(Value::number, change.number);
    print(Command::tool_standing, "the tool in the spindle");
}

/// Offsets are switched on, off or to others, and no tool is called: by a post whose words for a tool say none, a call
/// would do something else.
bool Writer::has_offsets_alone(const cl::ToolChange& change) const {
    if (cl::is_uncalled(change)) return true;
    const Template& call = post_[Command::tool_change];
    return tool_ && is_same_tool(*tool_, change) && tool_->edge != change.edge && tool_->raised == change.raised &&
           tool_->wider == change.wider && !says(call, index_of(Value::turret)) && !says(call, index_of(Value::edge));
}

/// The tool stays in the spindle: another edge, or nothing but what is written by other words.
bool Writer::stays(const cl::ToolChange& change) const {
    return has_offsets_alone(change) || (tool_ && is_same_tool(*tool_, change) && !post_.repeats_tool);
}

/// Of offsets that no move has asked for nobody asks any more once a tool is called.
void Writer::drop_offsets_alone(const cl::ToolChange& next) {
    if (tool_waits_ && !next.standing && cl::is_uncalled(cursor_.state().change)) tool_waits_ = false;
}

/// The tool moves by offsets that the text has not said.
void Writer::note_offsets() {
    if (!std::exchange(offsets_unsaid_, false)) return;
    const About about(*this, Topic::tool);
    const cl::ToolChange& change = cursor_.state().change;
    const std::string edge = change.edge == cl::unknown_tool ? "D?" : "D" + std::to_string(change.edge);
    note(Fate::lost, cl::is_uncalled(change) ? "offset " + edge + " of the tool that is in the spindle when it begins"
                     : change.edge == 0      ? "that the tool's offsets are switched off: the post has no tool.edge"
                                             : "offset " + edge + " of the tool: the post has no tool.edge");
}

void Writer::write_tool() {
    const About about(*this, Topic::tool);
    tool_waits_ = false;
    end_cycles();
    const motion::State& s = cursor_.state();
    const cl::ToolChange& change = s.change;
    end_compensation_alone(stays(change) ? Urgency::may_wait : Urgency::now);
    return_plane();
    set_tool(change);
    if (s.spindle.speed > 0 && s.spindle.mode == cl::SpindleMode::rpm) values_.set(Value::speed, s.spindle.speed);
    const bool none = change.number == 0 && change.name.empty();
    const bool by_name = !change.name.empty() && post_.has(Command::tool_by_name);
    const std::string what = "tool " + (change.number == 0 ? change.name : std::to_string(change.number));
    const bool same = stays(change);
    const bool had_length = same && tool_ && tool_->with_length;
    tool_ = change;
    if (same) {
        const bool says_edge = post_.has(Command::tool_edge);
        if (says_edge) print(Command::tool_edge, what);
        offsets_unsaid_ = !says_edge && change.edge != edge_said_;
        if (!had_length && !cl::is_uncalled(change)) await_length_of(change);
        return;
    }
    edge_said_ = change.edge;
    offsets_unsaid_ = false;
    if (change.number == cl::unknown_tool)
        return note(Fate::lost, "a tool whose number depends on a value that is not known");
    printer_.forget_coordinates();
    if (change.number == 0 && !none && !by_name) return note(Fate::lost, what + ", which is known by name alone,");
    if (change.raised != 0 && !says(post_[Command::tool_change], index_of(Value::raised)))
        note(Fate::lost, "a tool that is taken to be longer (DL)");
    if (change.wider != 0 && !says(post_[Command::tool_change], index_of(Value::wider)))
        note(Fate::lost, "a tool that is taken to be larger (DR)");
    if (!place_tool(change, what)) return;
    print(none ? Command::tool_none : by_name ? Command::tool_by_name : Command::tool_change, what);
    stop_spindle(post_.change_stops_spindle);
    await_length_of(change);
}

/// The tool's length is compensated with it; controls that have a word for that say it in the next straight move.
void Writer::await_length_of(const cl::ToolChange& change) {
    if (!change.with_length || !post_.has(Command::length_on)) return;
    length_ = {1, change.number, {}};
    length_waits_ = Command::length_on;
    printer_.forget_coordinates();
}

void Writer::set_tool(const cl::ToolChange& change) {
    values_.clear();
    values_.set(Text::name, change.name);
    values_.set(Value::number, change.number);
    // Where a program names an offset, the tool's own is its first edge.
    values_.set(Value::edge, change.offset == change.number && change.offset != 0 ? 1 : change.edge);
    constexpr double hundred = 100;
    const std::uint32_t own = change.edge == 0 ? 0 : change.number;
    values_.set(Value::turret, hundred * change.number + (change.offset != 0 ? change.offset : own));
    if (change.raised != 0) values_.set(Value::raised, change.raised);
    if (change.wider != 0) values_.set(Value::wider, change.wider);
}

/// Waits for the next straight move: blocks of programs have both ("G43 H1 Z50").
void Writer::write_length() {
    const About about(*this, Topic::length);
    const cl::ToolLength& length = cursor_.state().length;
    if (cursor_.state().change.with_length && length.sense == 0) return;  // with the tool
    if (length == length_) return;
    if (post_.length_moves)
        length_waits_.reset();  // nothing has moved by it
    else
        write_waiting_length();
    length_ = length;
    end_cycles();
    printer_.forget_coordinates();
    length_waits_ = length.sense == 0  ? Command::length_off
                    : length.by        ? Command::length_by
                    : length.sense > 0 ? Command::length_on
                                       : Command::length_subtracted;
    const auto is_unknown = [](const geom::Vec3& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z); };
    if (length.by && is_unknown(*length.by)) {
        length_waits_.reset();
        return note(Fate::lost, "a length of the tool that is not known");
    }
    if (length.by && post_.has(*length_waits_)) return write_waiting_length();  // in a block of its own
    if (post_.has(*length_waits_)) return;
    // A control without such words compensates each tool by its own length.
    const bool own = length.sense > 0 && !length.by && length.offset == cursor_.state().change.number;
    if (!own && length.sense != 0)
        note(Fate::lost, "the length of the tool: the post has no " + std::string(name_of(*length_waits_)));
    length_waits_.reset();
}

void Writer::set_length() {
    values_.set(Value::number, length_.offset);
    if (!length_.by) return;
    values_.set(Value::machine_x, length_.by->x);
    values_.set(Value::machine_y, length_.by->y);
    values_.set(Value::machine_z, length_.by->z);
}

void Writer::write_all() {
    write_state();
    if (!post_.length_moves || can_end_length_alone()) write_waiting_length();
}

/// At a place of the machine the tool's length does not count, so that its end moves nothing.
bool Writer::can_end_length_alone() const { return z_of_machine_ && length_waits_ == Command::length_off; }

/// In a block of its own before what has no place for it: an arc, a cycle.
void Writer::write_length_alone() {
    const bool falls = post_.length_moves && length_waits_ == Command::length_off && !can_end_length_alone();
    if (!falls) return write_waiting_length();
    const About about(*this, Topic::length);
    length_waits_.reset();
    note(Fate::lost,
         "the end of the tool's length: where no straight move along Z has it in its block, the control may "
         "move by the length");
}

/// Nothing moves behind the end of the program.
void Writer::write_last_length() {
    if (!length_waits_ || !post_.length_moves || length_waits_ != Command::length_off || can_end_length_alone())
        return write_waiting_length();
    const About about(*this, Topic::length);
    length_waits_.reset();
    Note left_out{Fate::expanded, "the end of the tool's length, behind which nothing moves,", {}, 0, 0};
    left_out.instead = "is left out";
    note_at(std::move(left_out));
}

void Writer::write_waiting_length() {
    const About about(*this, Topic::length);
    if (!length_waits_) return;
    end_compensation_alone(Urgency::may_wait);
    values_.clear();
    set_length();
    print(*std::exchange(length_waits_, std::nullopt), "the length of the tool");
}

/// The tool's place in the magazine; false where it has none.
bool Writer::place_tool(const cl::ToolChange& change, const std::string& what) {
    slot_ = nullptr;
    if (!magazine_ || change.number == 0) return true;
    std::string why;
    const MagazineSlot* slot = magazine_->take(change.number, why);
    if (slot == nullptr) {
        note(Fate::lost, what + ": " + why);
        return false;
    }
    slot_ = slot;
    offsets_wait_ = true;
    values_.set(Value::place, slot->place);
    return true;
}

/// Moves along Z say with which offset they go: another one into the material than towards it.
void Writer::set_offsets(bool rapid) {
    if (slot_ == nullptr || !values_.has(index_of(Value::z))) return;
    constexpr double still = 1e-6;  // mm
    if (!std::exchange(offsets_wait_, false) && std::abs(values_.number(index_of(Value::z)) - stands_[2]) <= still)
        return;
    if (rapid)
        values_.set(Value::approach, slot_->approach());
    else
        values_.set(Value::entry, slot_->entry());
}

/// A program whose tools are not said cuts with what is in the spindle.
void Writer::note_cut_without_tool(bool rapid) {
    if (!magazine_ || rapid || slot_ != nullptr || without_tool_noted_) return;
    without_tool_noted_ = true;
    note(Fate::lost, "the tool of a cut, which the program does not say,");
}

void Writer::note_tapping() {
    const cl::Spindle& spindle = cursor_.state().spindle;
    const double most = post_.most_tapping_speed;
    if (most == 0 || spindle.mode != cl::SpindleMode::rpm || !(spindle.speed > most)) return;
    note(Fate::lost, "tapping at " + base::shortest(spindle.speed) + " 1/min, where the post allows " +
                         base::shortest(most) + " 1/min at most,");
}

}  // namespace obrys::write
