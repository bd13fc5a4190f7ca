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
    if (!tap_returns_) write_spindle();  // reversed by the word of the tap
    if (!coolant_may_wait_) write_coolant();
    write_tolerance();
    write_path();
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
    if (std::exchange(tap_stops_, {}).empty()) return;
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
    if (datum_ && datum_->number == datum.number) return write_datum_anew();
    const bool first = !datum_;
    datum_ = datum;
    end_cycles();
    end_compensation_alone(Urgency::may_wait);
    printer_.forget_coordinates();
    constexpr std::uint32_t none_selected = 500;
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
    if (datum.number != none_selected)
        note(first ? Fate::expanded : Fate::lost, "zero " + std::to_string(datum.number));
}

void Writer::write_spindle() {
    const About about(*this, Topic::spindle);
    const cl::Spindle& s = cursor_.state().spindle;
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    if (same(s.speed, spindle_.speed) && s.mode == spindle_.mode && s.direction == spindle_.direction &&
        same(s.limit, spindle_.limit) && s.held.has_value() == spindle_.held.has_value() &&
        same(s.held.value_or(0), spindle_.held.value_or(0)))
        return;
    const bool leaves = spindle_.mode == cl::SpindleMode::surface && s.mode == cl::SpindleMode::rpm;
    if (s.direction != 0) end_tap();
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
    if (s.limit != 0) values_.set(Value::limit, s.limit);
    const bool surface = s.mode == cl::SpindleMode::surface;
    const Command command = s.direction > 0   ? (surface ? Command::surface_cw : Command::spindle_cw)
                            : s.direction < 0 ? (surface ? Command::surface_ccw : Command::spindle_ccw)
                                              : (surface ? Command::surface_stop : Command::spindle_stop);
    print(command, "the spindle");
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
    values_.clear();
    if (t == cl::Tolerance{}) {
        print(Command::tolerance_reset, "a tolerance");
        return;
    }
    values_.set(Value::contour, t.contour);
    if (t.rotary != 0) values_.set(Value::rotary, t.rotary);
    if (t.filter != cl::Filter::none) values_.set(Value::filter, static_cast<double>(t.filter));
    print(Command::tolerance_set, "a tolerance");
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
    print(static_cast<Command>(first + static_cast<std::size_t>(path->kind)), "how moves are joined");
}

/// A series of cycles whose parameters hold from its begin.
void Writer::begin_cycles(const std::string& defined) {
    if (!post_.has(Command::cycle_begin)) return;
    if (in_cycles_ && defined != defined_) end_cycles();
    if (!in_cycles_) static_cast<void>(printer_.print(post_[Command::cycle_begin], Values{}));
}

void Writer::end_cycles() {
    if (!in_cycles_) return;
    in_cycles_ = false;
    defined_.clear();
    series_says_.clear();
    values_.clear();
    static_cast<void>(put(Command::cycle_end, {}, "the end of cycles"));
}

void Writer::select_plane(const geom::Vec3& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    const Command plane = z >= x && z >= y ? Command::plane_xy : y >= x ? Command::plane_zx : Command::plane_yz;
    values_.clear();
    in_other_plane_ = plane != Command::plane_xy;
    static_cast<void>(put(plane, {}, "a plane"));
}

/// The axis along which the control counts the tool's length goes with the plane: no longer than arcs ask for it.
void Writer::return_plane() {
    if (post_.plane_returns && in_other_plane_ && !is_compensating_) select_plane({0, 0, 1});
}

}  // namespace obrys::write
