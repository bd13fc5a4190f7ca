#include <algorithm>
#include <cmath>
#include <utility>

#include "write/writer.hpp"

namespace obrys::write {

namespace {

constexpr double place_noise = 1e-6;  ///< mm

Command corner_command(const cl::Programmed& p) {
    return p.corner == cl::Corner::chamfer       ? Command::corner_chamfer
           : p.corner == cl::Corner::chamfer_leg ? Command::corner_chamfer_leg
                                                 : Command::corner_rounding;
}

/// What the ledger calls a move that is more than its way; empty: it is not.
std::string_view special_move(Command command) {
    if (command == Command::tap || command == Command::tap_back) return "rigid tapping";
    if (command >= Command::spline && command <= Command::spline_yz) return "a spline";
    if (command >= Command::thread && command <= Command::thread_falling) return "a thread";
    return command >= Command::seek_contact && command <= Command::seek_release_or_end ? "a probe's way" : "";
}

}  // namespace

Command Writer::feed_command(bool rapid) const {
    const motion::State& s = cursor_.state();
    if (rapid) return Command::feed_rapid;
    if (s.feed.mode == cl::FeedMode::inverse_time) return Command::feed_inverse_time;
    const bool per_rev = s.feed.mode == cl::FeedMode::per_rev;
    const Command surface = per_rev ? Command::feed_surface_per_rev : Command::feed_surface_per_minute;
    if (s.spindle.mode == cl::SpindleMode::surface && post_.has(surface)) return surface;
    return per_rev ? Command::feed_per_rev : Command::feed_per_minute;
}

Parts Writer::parts_of(bool rapid, const cl::Programmed* corner) {
    Parts parts;
    const motion::State& s = cursor_.state();
    if (s.feed.value != 0 && !std::isnan(s.feed.value)) values_.set(Value::feed, s.feed.value);
    const Command feed = feed_command(rapid);
    parts.feed = &post_[feed];
    if (compensation_) parts.compensation = &post_[*compensation_];
    if (coolant_waits_) parts.coolant = &post_[*coolant_waits_];
    if (corner != nullptr && post_.corner_in_block) parts.corner = &post_[corner_command(*corner)];
    return parts;
}

/// A feed that nobody knows, or of a kind that the post has no word for.
void Writer::note_feed(bool rapid) {
    const cl::Feed& feed = cursor_.state().feed;
    const bool said = feed.mode == feed_noted_.mode && std::isnan(feed.value) == std::isnan(feed_noted_.value);
    if (rapid || said) return;
    feed_noted_ = feed;
    if (std::isnan(feed.value)) note(Fate::lost, "a feed that is not known");
    if (feed.value != 0 && !post_.has(feed_command(false)))
        note(Fate::lost, "a feed: the post has no " + std::string(name_of(feed_command(false))));
}

/// Axes that the move cannot take along.
void Writer::lose_axes() {
    if (axes_.empty()) return;
    for (const cl::AxisEnd& axis : std::exchange(axes_, {}))
        note(Fate::lost, "axis " + std::string(axis.name.data()) + ", which moves together with others here,");
}

/// What a move has and its template has no place for.
void Writer::note_unsaid(Command command, bool rapid) {
    const Places& form = places(command);
    for (std::size_t k = 0; k < stands_.size(); ++k) {
        const auto v = static_cast<ValueIndex>(index_of(Value::x) + k);
        if (!values_.has(v)) continue;
        const double before = std::exchange(stands_[k], values_.number(v));
        const bool said = form.says_axis(k) || places(Command::linear).says_axis(k);
        if (said || std::abs(stands_[k] - before) <= place_noise) continue;
        note(Fate::lost, std::string("a move along ") + "XYZ"[k]);
    }
    if (!axes_.empty() && !form.has(Part::axes)) lose_axes();
    const bool may_feed = !rapid && !form.has(Part::feed) && cursor_.state().feed.value != 0;
    if (may_feed && post_.has(feed_command(false)) && without_feed_.insert(command).second)
        note(Fate::lost, "a feed: " + std::string(name_of(command)) + " of the post has no place for it");
}

/// What stands in the block of a move, and is a word of its own elsewhere.
void Writer::note_printed(Command command, const Template& form, const Parts& parts, std::uint64_t line) {
    const Places said = &form == &said_ ? Places(said_) : places(command);
    if (parts.length != nullptr && said.has(Part::length)) {
        const About about(*this, Topic::length);
        note(Fate::mapped, "the length of the tool", line);
        length_waits_.reset();
    }
    if (said.has(Part::coolant)) coolant_said(line);
    if (compensation_) end_wait_of_compensation(command, form, line);
    const std::string_view special = special_move(command);
    if (!special.empty()) note(Fate::mapped, std::string(special), line);
    if (parts.corner != nullptr && !parts.corner->empty()) note(Fate::mapped, "a chamfer or rounding", line);
}

/// Words of the axes that move along; `home`: to their own zero, wherever that is.
void Writer::take_axes(Parts& parts, bool home) {
    if (axes_.empty()) return;
    for (const cl::AxisEnd& axis : std::exchange(axes_, {})) {
        const bool numbered = axis.name[1] != 0;
        const Template& word = post_[numbered ? Command::axis_numbered : Command::axis];
        Values value;
        value.set(Text::name, axis.name.data());
        value.set(Value::axis, home ? 0 : axis.to);
        const auto text = word.empty() ? std::nullopt : printer_.whole(word.front(), value);
        if (text)
            parts.axes.push_back(*text);
        else
            note(Fate::lost, "axis " + std::string(axis.name.data()) +
                                 (std::isnan(axis.to) && !home ? ", which goes to a place that is not known," : ""));
    }
}

void Writer::print_move(Command command, bool rapid, const cl::Programmed* corner) {
    note_feed(rapid);
    if (!rapid && cursor_.state().feed.value != 0) say_feed_mode(cursor_.state().feed.mode);
    note_cut_without_tool(rapid);
    const std::string_view special = special_move(command);
    if (!post_.has(command))
        return note(Fate::lost, std::string(special.empty() ? "a move" : special) + ": the post has no " +
                                    std::string(name_of(command)));
    if (const auto& c = cursor_.state().compensation) {
        values_.set(Value::offset, c->offset != 0 ? c->offset : cursor_.state().change.number);
        if (c->given) values_.set(Value::own_diameter, 2 * c->radius);
        if (c->given && c->nose != 0) values_.set(Value::nose, c->nose);
        if (c->approach == cl::Approach::around) values_.set(Value::around, 1);
        if (c->sharp) values_.set(Value::sharp, 1);
    }
    if (corner != nullptr) {
        if (const Command wanted = corner_command(*corner); !post_.has(wanted))
            note(Fate::lost,
                 "a chamfer or rounding of a compensated contour: the post has no " + std::string(name_of(wanted)));
        values_.set(Value::size, corner->size);
        if (corner->corner_feed != 0) values_.set(Value::own_feed, corner->corner_feed);
    }
    Parts parts = parts_of(rapid, corner);
    const bool along_z = values_.has(index_of(Value::z));
    if (along_z) z_of_machine_ = false;
    if (length_waits_ && (along_z || !post_.length_moves)) {
        set_length();
        parts.length = &post_[*length_waits_];
    }
    if (magazine_) set_offsets(rapid);
    const Template* form = form_of(command, "a move");
    if (form == nullptr) return axes_.clear();
    if (compensation_ && ends_before(*form, command)) {
        end_compensation_alone(Urgency::may_wait);
        if (!compensation_) parts.compensation = nullptr;
    }
    if (form != &said_) note_unsaid(command, rapid);
    take_axes(parts);
    const std::uint64_t line = layout_.next();
    const Printed printed = printer_.print(*form, values_, parts, form != &said_, form == &said_);
    if (form == &said_) printer_.forget_words_of(said_);
    if (printed == Printed::failed) note(Fate::lost, "a move: a word cannot hold " + printer_.failed_word());
    if (printed == Printed::all) note_printed(command, *form, parts, line);
    if (corner != nullptr && !post_.corner_in_block && post_.has(corner_command(*corner)))
        print(corner_command(*corner), "a corner");
}

namespace {

Command straight_command(bool rapid, cl::Seek seek) {
    switch (seek) {
        case cl::Seek::contact: return Command::seek_contact;
        case cl::Seek::contact_or_end: return Command::seek_contact_or_end;
        case cl::Seek::release: return Command::seek_release;
        case cl::Seek::release_or_end: return Command::seek_release_or_end;
        case cl::Seek::nothing: break;
    }
    return rapid ? Command::rapid : Command::linear;
}

}  // namespace

/// A control that moves one axis at a time is told of no other one.
void Writer::drop_standing_axes() {
    if (!stairs_ || !stairs_->said()) return;
    constexpr std::array axes{Value::x, Value::y, Value::z};
    for (std::size_t k = 0; k < axes.size(); ++k)
        if (!(*stairs_->said())[k]) values_.drop(axes[k]);
}

void Writer::write_line(const geom::Vec3& to, bool rapid, const cl::Programmed* corner, cl::Seek seek) {
    end_cycles();
    print_straight(frames_.programmed(to), rapid, corner, seek);
}

/// `to`: in the frame of the text; what is not known, or not to be said, has no word.
void Writer::print_straight(const geom::Vec3& to, bool rapid, const cl::Programmed* corner, cl::Seek seek) {
    values_.clear();
    if (!std::isnan(to.x)) values_.set(Value::x, to.x);
    if (!std::isnan(to.y)) values_.set(Value::y, to.y);
    if (!std::isnan(to.z)) values_.set(Value::z, to.z);
    drop_standing_axes();
    const Command command = straight_command(rapid, seek);
    if (!post_.has(command))
        return note(Fate::lost, "a probing move: the post has no " + std::string(name_of(command)));
    print_move(command, rapid, corner);
}

/// A move to where nobody knows: from a place that is known, or of which nothing is known.
void Writer::note_unknown(const geom::Vec3& from, const cl::Linear& line) {
    const geom::Vec3& to = line.to;
    const auto leaves = [](double a, double b) { return std::isfinite(a) && std::isnan(b); };
    const bool points_as_before = std::exchange(pointed_, line.axis) == line.axis;
    if (std::exchange(counts_anew_, false)) return;
    const bool nowhere = std::isnan(to.x) && std::isnan(to.y) && std::isnan(to.z) && axes_.empty() && points_as_before;
    if (nowhere || leaves(from.x, to.x) || leaves(from.y, to.y) || leaves(from.z, to.z))
        note(Fate::lost, "a move to a coordinate that is not known");
}

/// A tool that does not stand along Z of the frame in force: programs say that by their tilted plane or by rotary axes.
void Writer::note_direction(const geom::Vec3& axis) {
    const geom::Vec3 d = frames_.programmed_direction(axis);
    constexpr double noise = 1e-6;
    const bool along_z = !(std::hypot(d.x, d.y) > noise * std::abs(d.z)) || hooks_ != nullptr;
    if (along_z || !axes_.empty() || axis == direction_noted_) return;
    direction_noted_ = axis;
    Note lost{Fate::lost,
              "a tool that stands aslant to the plane in force: the program says its direction alone, and "
              "which rotary axes turn to it goes with the machine",
              {},
              0,
              0};
    lost.remedy = "have the rotary axes in the program, by their angles";
    note_at(std::move(lost));
}

namespace {

/// It says how the tool stands in another plane, and leads nowhere.
bool tells_axis_alone(const cl::Linear* line, const geom::Vec3& from) {
    const auto same = [](double a, double b) {
        return std::abs(a - b) <= place_noise || (std::isnan(a) && std::isnan(b));
    };
    return line != nullptr && line->rapid && line->seek == cl::Seek::nothing && same(from.x, line->to.x) &&
           same(from.y, line->to.y) && same(from.z, line->to.z);
}

/// Coordinates, and nothing else; of those that nobody knows none.
void set_known(Values& values, const geom::Vec3& at) {
    values.clear();
    if (std::isfinite(at.x)) values.set(Value::x, at.x);
    if (std::isfinite(at.y)) values.set(Value::y, at.y);
    if (std::isfinite(at.z)) values.set(Value::z, at.z);
}

}  // namespace

void Writer::write_move(const cl::Step& step, const geom::Vec3& from) {
    const auto* line = std::get_if<cl::Linear>(&step);
    const bool axes_turn = take_places_of_axes();
    const Source& frame_block = topics_[static_cast<std::size_t>(Topic::frame)];
    const bool with_plane = now_ != nullptr && frame_block == Source{now_->from, now_->stack};
    if (axes_turn && turns_with_plane(step) && write_turn(*line, from)) return;
    const bool stand_anew = !axes_turn && turns_with_plane(step);
    counts_anew_ = stand_anew || is_turned_by_control(step);
    if (stand_anew) axes_.clear();  // the plane counts them otherwise, and they stand
    coolant_may_wait_ =
        line != nullptr && !place_ && places(line->rapid ? Command::rapid : Command::linear).has(Part::coolant);
    // The spindle of a tap reverses by itself.
    const auto* thread = std::get_if<cl::Thread>(&step);
    const bool taps = thread != nullptr && thread->rigid_tap;
    if (taps && !tap_.returns) ready_spindle(*thread);
    const bool stands = line != nullptr && std::exchange(straight_alone_, false) && axes_.empty();
    if (!stands && (!taps || !tap_.returns)) write_state();
    tap_.spindle_ready = false;
    coolant_may_wait_ = false;
    const bool nowhere_known = !with_plane && std::exchange(turned_by_control_, false);
    printer_.stand_at(nowhere_known ? geom::Vec3{NAN, NAN, NAN} : frames_.programmed(from));
    const bool straight = line != nullptr && !place_ && axes_.empty();
    const bool points_as_before = stands && line->axis == pointed_;
    // The words of the plane, which move nothing, have said all of it.
    const auto& frame = cursor_.state().frame.parts;
    const bool turned = taken_up_ && std::any_of(frame.begin(), frame.end(),
                                                 [](const auto& p) { return p.kind == cl::FrameKind::plane; });
    const bool is_said = with_plane && !place_ && !stand_anew && axes_.empty() && tells_axis_alone(line, from) &&
                         frames_.parts() == frame && !turned;
    if (is_said) {
        pointed_ = line->axis, counts_anew_ = false;
        set_known(values_, frames_.programmed(line->to));
        printer_.remember(post_[Command::rapid], values_);
    } else {
        write_way(step, from, points_as_before);
    }
    printer_.stand_at({NAN, NAN, NAN});
    if (coolant_waits_) write_coolant();  // the move had no block
    lose_axes();
    straight_alone_ = straight && (stands || is_state_written());
}

/// `points_as_before`: the tool and the frame stand as in the move before, of which it has been said.
void Writer::write_way(const cl::Step& step, const geom::Vec3& from, bool points_as_before) {
    const auto* line = std::get_if<cl::Linear>(&step);
    const bool to_holder = place_ && !place_->tip && place_->kind != cl::PlaceKind::frame;
    if (!to_holder) note_offsets();
    if (line != nullptr) return_plane();
    if (line != nullptr && write_place(*line)) return;
    if (line != nullptr) {
        note_unknown(from, *line);
        if (!points_as_before) note_direction(line->axis);
        const Command command = straight_command(line->rapid, line->seek);
        if (length_waits_ && !places(command).has(Part::length)) write_all();
        return write_line(line->to, line->rapid, nullptr, line->seek);
    }
    if (length_waits_) write_state(), write_length_alone();
    if (const auto* arc = std::get_if<cl::Arc>(&step)) return write_arc(*arc, from);
    if (const auto* thread = std::get_if<cl::Thread>(&step)) return write_thread(*thread, from);
    if (const auto* spline = std::get_if<cl::Spline>(&step)) write_spline(*spline);
}

}  // namespace obrys::write
