/// What holds is written before something happens: tool, zero, frame, spindle, coolant, tolerance, in this order.

#include <algorithm>

#include "base/number.hpp"
#include "write/writer.hpp"

namespace obrys::write {

void Writer::write_state() {
    if (tool_waits_) write_tool();
    write_datum();
    write_length();
    write_frame();
    await_coolant();
    if (!tap_.returns && !tap_.spindle_ready)
        write_spindle(cursor_.state().spindle);  // else the word of the tap does it
    if (!coolant_may_wait_) write_coolant();
    write_tolerance();
    write_path();
}

/// Of all that holds nothing is to be written any more, nor looked at again, as long as only straight moves come.
bool Writer::is_state_written() const {
    const motion::State& s = cursor_.state();
    const bool with_tool = s.change.with_length && s.length.sense == 0;
    return !tool_waits_ && !coolant_waits_ && !length_waits_ && (with_tool || s.length == length_) &&
           s.frame.parts == frames_.parts() && s.tolerance == tolerance_ && (!s.path || s.path == path_);
}

/// The control stops the spindle by itself; `word` says it stands. Empty: it does not.
void Writer::stop_spindle(const std::string& word) {
    if (word.empty()) return;
    spindle_.direction = 0;
    spindle_.held.reset();
    printer_.force(word);
}

/// The spindle is not to be turned on by a word of its own within a series of taps.
void Writer::end_tap() {
    if (std::exchange(tap_.stops, {}).empty()) return;
    end_cycles();
}

/// The zero in force is another place now: what has set it is written, where its place is known.
void Writer::write_datum_anew() {
    const cl::Datum& datum = cursor_.state().datum;
    const geom::Vec3 was = std::exchange(datum_->origin, datum.origin);
    values_.clear();
    bool any = false;
    const auto set = [&](Value value, double before, double now) {
        if (std::isnan(now) || before == now) return;
        values_.set(value, now);
        any = true;
    };
    set(Value::machine_x, was.x, datum.origin.x);
    set(Value::machine_y, was.y, datum.origin.y);
    set(Value::machine_z, was.z, datum.origin.z);
    if (!any || std::exchange(zero_said_, false)) return;
    set_zero(datum.number, false);
}

/// What the program itself says a zero is; its places are in the values.
void Writer::set_zero(std::uint32_t number, bool added) {
    end_cycles();
    end_compensation_alone(Urgency::may_wait);
    printer_.forget_coordinates();
    for (const DatumForm& form : post_.datums) {
        const Template& text = added ? form.add : form.set;
        if (number < form.from || number > form.to || text.empty()) continue;
        values_.set(Value::number, number - form.set_less);
        const std::uint64_t line = layout_.next();
        const bool failed = printer_.print(text, values_) == Printed::failed;
        return note(failed ? Fate::lost : Fate::mapped, "the place of a zero", line);
    }
    const std::string what = number == 0 ? "the shift of all zeros" : "zero " + std::to_string(number);
    note(Fate::lost, what + " is set anew, and the post has no words for that");
}

void Writer::write_zero(const cl::DatumData& data) {
    constexpr std::array names{Value::machine_x, Value::machine_y, Value::machine_z};
    const std::array<double, 3> origin{data.origin.x, data.origin.y, data.origin.z};
    bool any = false;
    values_.clear();
    for (std::size_t k = 0; k < 3; ++k)
        if (!std::isnan(origin[k])) values_.set(names[k], origin[k]), any = true;
    if (data.turn) values_.set(Value::angle, geom::degrees(*data.turn)), any = true;
    zero_said_ = data.number == 0 || data.number == cursor_.state().datum.number;
    if (any) return set_zero(data.number, data.added);
    note(Fate::lost, "zero " + std::to_string(data.number) + " is set to a place that is not known");
}

void Writer::write_datum() {
    const About about(*this, Topic::datum);
    const cl::Datum& datum = cursor_.state().datum;
    const bool none_yet = datum.number == 0 && std::isnan(datum.origin.x) && !datum_;
    if (none_yet) return;
    constexpr std::uint32_t none_selected = 500;
    const bool by_word = datum.number != none_selected || datum.selected;
    if (datum_ && datum_->number == datum.number && datum_->selected == datum.selected) return write_datum_anew();
    const bool first = !datum_;
    datum_ = datum;
    if (first && !by_word) return;  // the zero that the control has without a word
    end_cycles();
    end_compensation_alone(Urgency::may_wait);
    printer_.forget_coordinates();
    for (const DatumForm& form : post_.datums) {
        if (datum.number < form.from || datum.number > form.to || form.text.empty()) continue;
        values_.clear();
        values_.set(Value::number, datum.number - form.less);
        const std::uint64_t line = layout_.next();
        if (printer_.print(form.text, values_) == Printed::failed)
            return note(Fate::lost, "a zero: its number does not fit");
        return note(Fate::mapped, "zero " + std::to_string(datum.number), line);
    }
    // One zero alone may be the one that is in force on the control; of several, the others are lost.
    if (datum.number == none_selected) return;
    Note zero{first ? Fate::expanded : Fate::lost, "zero " + std::to_string(datum.number), {}, 0, 0};
    zero.instead = "is taken to be the one that is active on the control when the program begins";
    if (!first) zero.what += ": the post has no word for it, and another zero is in force before";
    if (!first) zero.remedy = "give its number a word in a post of your own ([[datum]]: from, to, less, text)";
    note_at(std::move(zero));
}

/// Where S is a whole number, and the program has another one.
void Writer::note_speed(const cl::Spindle& s) {
    const NumberStyle& style = post_.styles[static_cast<std::size_t>(Usual::speed)];
    if (style.decimals != 0 || std::isnan(s.speed) || s.direction == 0) return;
    if (std::abs(as_written(s.speed, style) - s.speed) <= 1e-6 * std::abs(s.speed)) return;
    Note rounded;
    rounded.fate = Fate::expanded;
    rounded.what = "S" + base::shortest(s.speed);
    rounded.instead = "is rounded to a whole number, which S is there";
    note_at(std::move(rounded));
}

void Writer::write_spindle(const cl::Spindle& s) {
    const About about(*this, Topic::spindle);
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    if (same(s.speed, spindle_.speed) && s.mode == spindle_.mode && s.direction == spindle_.direction &&
        same(s.limit, spindle_.limit) && s.held.has_value() == spindle_.held.has_value() &&
        same(s.held.value_or(0), spindle_.held.value_or(0)))
        return;
    const bool leaves = spindle_.mode == cl::SpindleMode::surface && s.mode == cl::SpindleMode::rpm;
    if (s.direction != 0 || s.held) end_tap();
    if (post_.speeds_call_cycle) end_cycles();
    spindle_ = s;
    values_.clear();
    if (leaves && !post_[Command::leave_surface].empty())
        static_cast<void>(printer_.print(post_[Command::leave_surface], values_));
    if (s.held) {
        if (!std::isnan(*s.held)) values_.set(Value::held, *s.held);
        print(Command::spindle_held, "an oriented spindle");
        printer_.leave(post_[Command::spindle_cw]);
        return;
    }
    if (std::isnan(s.speed)) note(Fate::lost, "a speed that is not known");
    if (!std::isnan(s.speed) && !(s.speed == 0 && s.direction == 0)) values_.set(Value::speed, s.speed);
    note_speed(s);
    if (s.limit != 0) values_.set(Value::limit, s.limit);
    const bool surface = s.mode == cl::SpindleMode::surface;
    const Command command = s.direction > 0   ? (surface ? Command::surface_cw : Command::spindle_cw)
                            : s.direction < 0 ? (surface ? Command::surface_ccw : Command::spindle_ccw)
                                              : (surface ? Command::surface_stop : Command::spindle_stop);
    print(command, "the spindle");
}

/// The unit of the feed, where it has words of its own; in another unit F is said anew, whatever its number was.
void Writer::say_feed_mode(cl::FeedMode mode) {
    if (feed_mode_ == mode) return;
    if (feed_mode_) printer_.forget_values_of(post_[feed_command(false)]);
    feed_mode_ = mode;
    const Command command = mode == cl::FeedMode::per_rev ? Command::feed_mode_per_rev : Command::feed_mode_per_minute;
    if (mode == cl::FeedMode::inverse_time || !post_.has(command)) return;
    end_compensation_alone(Urgency::may_wait);
    static_cast<void>(printer_.print(post_[command], Values{}));
}

/// It may stand in the block of the spindle or of the next move; the word that comes before another one may not.
void Writer::await_coolant() {
    const About about(*this, Topic::coolant);
    const cl::Coolant& c = cursor_.state().coolant;
    if (c == coolant_) return;
    if (coolant_waits_) write_coolant();
    values_.clear();
    const bool less = (coolant_.flood && !c.flood) || (coolant_.mist && !c.mist);
    if (less && (c.flood || c.mist)) print(Command::coolant_off, "coolant");
    coolant_ = c;
    coolant_waits_ = c.flood && c.mist ? Command::coolant_both
                     : c.flood         ? Command::coolant_flood
                     : c.mist          ? Command::coolant_mist
                                       : Command::coolant_off;
    if (post_[*coolant_waits_].size() > 1) write_coolant();  // a place in another block holds one
}

void Writer::write_coolant() {
    if (!coolant_waits_) return;
    const About about(*this, Topic::coolant);
    values_.clear();
    print(*std::exchange(coolant_waits_, std::nullopt), "coolant");
}

void Writer::write_tolerance() {
    const About about(*this, Topic::tolerance);
    const cl::Tolerance& t = cursor_.state().tolerance;
    if (t == tolerance_) return;
    tolerance_ = t;
    const bool ends = t == cl::Tolerance{};
    const Command command = ends ? Command::tolerance_reset : Command::tolerance_set;
    if (!post_.has(command)) {
        Note left_out{
            Fate::expanded, "a tolerance of the path: the post has no " + std::string(name_of(command)), {}, 0, 0};
        left_out.instead = "is left out";
        return note_at(std::move(left_out));
    }
    values_.clear();
    if (!ends) set_tolerance(t);
    print(command, "a tolerance");
}

void Writer::set_tolerance(const cl::Tolerance& t) {
    values_.set(Value::contour, t.contour);
    if (t.rotary != 0) values_.set(Value::rotary, t.rotary);
    if (t.filter != cl::Filter::none) values_.set(Value::filter, static_cast<double>(t.filter));
    // In one number, as SINUMERIK has it; its cycle wants a purpose and an angle also where they count nothing.
    constexpr double finishing = 1, with_angle = 10;
    const double purpose = t.filter == cl::Filter::none ? finishing : static_cast<double>(t.filter);
    values_.set(Value::purpose, purpose + (t.rotary != 0 ? with_angle : 0));
    values_.set(Value::purpose_angle, t.rotary != 0 ? t.rotary : 1);
}

void Writer::write_path() {
    const About about(*this, Topic::path);
    const std::optional<cl::PathMode>& path = cursor_.state().path;
    if (path == path_ || !path) return;
    path_ = path;
    end_compensation_alone(Urgency::may_wait);
    values_.clear();
    if (path->tolerance != 0) values_.set(Value::contour, path->tolerance);
    if (path->merge != 0) values_.set(Value::merge, path->merge);
    if (path->way != 0) values_.set(Value::way, path->way);
    const auto first = static_cast<std::size_t>(Command::path_exact);
    auto command = static_cast<Command>(first + static_cast<std::size_t>(path->kind));
    if (command == Command::path_within && !post_.has(command) && post_.has(Command::path_free)) {
        Note left_out{
            Fate::expanded, "the tolerance within which moves are joined: the post has no path.within", {}, 0, 0};
        left_out.instead = "is left out";
        note_at(std::move(left_out));
        command = Command::path_free;
    }
    // That the control need not go through every point asks for nothing that it must do.
    if (command >= Command::path_free && !post_.has(command)) {
        Note left_out{
            Fate::expanded, "how moves are joined: the post has no " + std::string(name_of(command)), {}, 0, 0};
        left_out.instead = "is left out";
        return note_at(std::move(left_out));
    }
    print(command, "how moves are joined");
}

/// A series of cycles whose parameters hold from its begin.
void Writer::begin_cycles(const std::string& defined) {
    if (!post_.has(Command::cycle_begin)) return;
    if (series_.open && defined != series_.defined) end_cycles();
    if (!series_.open) static_cast<void>(printer_.print(post_[Command::cycle_begin], Values{}));
}

void Writer::end_cycles() {
    if (!series_.open) return;
    series_.end();
    values_.clear();
    static_cast<void>(put(Command::cycle_end, {}, "the end of cycles"));
}

}  // namespace obrys::write
