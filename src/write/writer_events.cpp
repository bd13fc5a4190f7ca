/// What a record says besides moves and what holds while the tool moves: stops, dwells, functions, texts, data.

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "cl/unknown_tool.hpp"
#include "write/writer.hpp"

namespace obrys::write {

void Writer::event(const cl::ToolChange& change) {
    const bool offsets = cl::is_uncalled(change);
    tool_waits_ = !change.standing || offsets;
    if (change.standing && !offsets && post_.has(Command::tool_standing)) write_standing(change);
}

void Writer::event(const cl::DatumData& data) {
    write_all();
    write_zero(data);
}

void Writer::event(const cl::Dwell& dwell) {
    write_all();
    values_.clear();
    const bool turns = dwell.seconds == 0 && dwell.revolutions != 0;
    if (std::isnan(turns ? dwell.revolutions : dwell.seconds))
        return note(Fate::lost, "a dwell whose time is not known");
    const double seconds = cl::seconds_of(dwell, cursor_.state().spindle);
    if (turns && !std::isnan(seconds) && !post_.has(Command::dwell_revolutions)) {
        Note in_seconds{Fate::expanded, "a dwell of so many revolutions", {}, 0, 0};
        in_seconds.instead = "is written in seconds, at the speed of the spindle";
        note_at(std::move(in_seconds));
        values_.set(Value::seconds, seconds);
        return static_cast<void>(print(Command::dwell_seconds, "a dwell"));
    }
    values_.set(Value::seconds, dwell.seconds);
    values_.set(Value::revolutions, dwell.revolutions);
    print(turns ? Command::dwell_revolutions : Command::dwell_seconds, "a dwell");
}

void Writer::event(const cl::Stop& stop) {
    if (stop.kind != cl::StopKind::end) {
        stop_waits_ = *now_;
        return;
    }
    const bool stays = stop.stays && post_.has(Command::stop_end_stays);
    const bool pallets = stop.pallets && post_.has(Command::stop_end_pallets);
    end_program(stays ? Command::stop_end_stays : pallets ? Command::stop_end_pallets : Command::stop_end, "a stop");
}

void Writer::end_program(Command command, std::string_view what) {
    write_all();
    end_compensation_alone(Urgency::at_end);
    write_frame();                                     // what was cancelled is not to hold for the next program
    if (command == Command::stop_again) end_cycles();  // the end of the program ends them by itself
    write_last_length();
    return_plane();
    values_.clear();
    ended_ = true;
    print(command, what);
    spill_parts();
}

bool Writer::begin_anew() {
    if (ended_ || !post_.has(Command::stop_again)) return false;
    if (stairs_) stairs_->finish();
    if (taps_) taps_->settle();
    if (stop_waits_) write_stop();
    flush_held();
    end_program(Command::stop_again, "the way back to the begin of the program");
    return true;
}

/// What its block does besides holds while the machine stands, and is written before it.
bool Writer::is_of_stop(const cl::Record& record) const {
    const bool holds =
        std::holds_alternative<cl::Spindle>(record.step) || std::holds_alternative<cl::Coolant>(record.step);
    return holds && stop_waits_->from == record.from && stop_waits_->stack == record.stack;
}

void Writer::write_stop() {
    const cl::Record record = *std::exchange(stop_waits_, std::nullopt);
    const cl::Record* now = std::exchange(now_, &record);
    write_all();
    values_.clear();
    const auto& stop = std::get<cl::Stop>(record.step);
    const bool pallets = stop.pallets && post_.has(Command::stop_pallets);
    if (stop.pallets && !pallets) note(Fate::lost, "the exchange of pallets at a stop");
    print(stop.kind == cl::StopKind::optional ? Command::stop_optional
          : pallets                           ? Command::stop_pallets
                                              : Command::stop_program,
          "a stop");
    if (!post_.stop_stops_spindle.empty() && (spindle_.direction != 0 || !(coolant_ == cl::Coolant{}))) {
        Note stands{
            Fate::expanded, "a stop while spindle or coolant is on, which this control stops with it,", {}, 0, 0};
        stands.instead = "is written, and both are told again behind it";
        note_at(std::move(stands));
    }
    stop_spindle(post_.stop_stops_spindle);
    if (!post_.stop_stops_spindle.empty()) coolant_ = {};  // what stops the one stops the other
    now_ = now;
}

/// Nothing that moves here is driven by it, but the machine does it.
void Writer::event(const cl::OtherSpindle& other) {
    write_all();
    values_.clear();
    values_.set(Value::number, other.number);
    if (other.speed) values_.set(Value::speed, *other.speed);
    if (other.limit) values_.set(Value::limit, *other.limit);
    if (other.held && !std::isnan(*other.held)) values_.set(Value::held, *other.held);
    constexpr std::array senses{4.0, 5.0, 3.0};
    constexpr double oriented = 19;
    if (other.direction) values_.set(Value::value, senses[static_cast<std::size_t>(*other.direction + 1)]);
    if (other.held && std::isnan(*other.held)) values_.set(Value::value, oriented);
    if (other.function != 0) values_.set(Value::value, static_cast<double>(other.function));
    print(Command::spindle_other, "what spindle " + std::to_string(other.number) + " is told");
}

void Writer::event(const cl::Override& allowed) {
    write_all();
    constexpr std::array on{Command::override_feed, Command::override_spindle, Command::override_adaptive,
                            Command::override_hold};
    constexpr std::array off{Command::override_feed_off, Command::override_spindle_off, Command::override_adaptive_off,
                             Command::override_hold_off};
    values_.clear();
    print((allowed.on ? on : off)[static_cast<std::size_t>(allowed.kind)], "what the operator may change");
}

void Writer::event(const cl::Auxiliary& aux) {
    write_all();
    values_.clear();
    values_.set(Text::letter, std::string(1, aux.letter));
    values_.set(Value::number, static_cast<double>(aux.number));
    const std::string what = "function " + std::string(1, aux.letter) + std::to_string(aux.number);
    if (aux.extension != 0) {
        values_.set(Value::edge, aux.extension);
        return static_cast<void>(
            print(Command::function_extended, what + " of address extension " + std::to_string(aux.extension)));
    }
    const std::string& letters = post_.function_letters;
    if (!letters.empty() && letters.find(aux.letter) == std::string::npos)
        return note(Fate::lost, what + ": the control has no functions of this letter");
    if (is_among(post_.functions_refused, aux.letter, aux.number))
        return note(Fate::lost, what + ", which means nothing to this control, or something else,");
    const double speed = cursor_.state().spindle.speed;
    if (is_among(post_.functions_with_speed, aux.letter, aux.number) && speed > 0) values_.set(Value::speed, speed);
    print(Command::function, what);
}

/// That a magazine brings a tool beforehand makes no difference to the path: where the post does not say it, it is left
/// out.
void Writer::event(const cl::ToolSelection& next) {
    if (tool_ && tool_->number == next.number) return;  // words of its edge that follow are for it as it is
    if (!post_.has(Command::tool_next) || next.number == 0) return note(Fate::expanded, "a tool that is prepared");
    write_all();
    values_.clear();
    values_.set(Value::number, next.number);
    print(Command::tool_next, "a tool that is prepared");
}

void Writer::event(const cl::Output& signal) {
    write_all();
    values_.clear();
    values_.set(Value::number, signal.number);
    values_.set(Value::value, signal.value);
    const bool moving = signal.with_motion;
    print(signal.analog       ? (moving ? Command::output_value_moving : Command::output_value)
          : signal.value != 0 ? (moving ? Command::output_on_moving : Command::output_on)
                              : (moving ? Command::output_off_moving : Command::output_off),
          "output " + std::to_string(signal.number));
}

void Writer::event(const cl::ToolData& data) {
    if (!data.length && !data.radius)
        return note(Fate::lost,
                    "what the program sets of tool " + std::to_string(data.number) + " besides its length and radius");
    values_.set(Value::number, data.number);
    values_.set(Value::edge, data.edge);
    if (data.length) values_.set(Value::length, *data.length);
    if (data.radius) values_.set(Value::tool_radius, *data.radius);
    print(Command::tool_data, "what a tool is");
}

/// Lines that the post writes about cycles whatever these say: comments are among them.
std::vector<std::string> Writer::lines_about_cycles() const {
    std::vector<std::string> out;
    const auto add = [&](const Template& text) {
        for (const Block& block : text) {
            const bool fixed =
                std::all_of(block.begin(), block.end(), [](const Token& t) { return t.kind == Token::Kind::literal; });
            if (const auto line = fixed ? printer_.whole(block, Values{}) : std::nullopt) out.push_back(*line);
        }
    };
    add(post_[Command::cycle_begin]), add(post_[Command::cycle_end]);
    for (const auto& [kind, forms] : post_.cycles)
        for (const CycleForm& form : forms) add(form.define), add(form.call);
    return out;
}

void Writer::event(const cl::Comment& comment) {
    const Command wanted = comment.terminal ? Command::terminal : Command::message;
    const Command command = comment.message && post_.has(wanted) ? wanted : Command::comment;
    if (!post_.has(command)) {
        Note left_out{Fate::expanded, "a comment: the post has no text.comment", {}, 0, 0};
        left_out.instead = "is left out";
        return note_at(std::move(left_out));
    }
    if (comment.message) write_all();  // it stands before the stop that it is for
    std::string text = base::comment_text(comment.text, post_.comments);
    if (post_.encoding != Encoding::utf8) text = base::without_marks(text, post_.encoding == Encoding::windows_1252);
    if (comment.message && command == Command::comment) {
        Note shown{Fate::expanded, "a message", {}, 0, 0};
        shown.instead = "is a comment there";
        note_at(std::move(shown));
    }
    if (post_.encoding == Encoding::windows_1252 && base::utf8_to_cp1252(text, '?') != base::utf8_to_cp1252(text, '_'))
        note(Fate::expanded, "a comment, with ? for characters that Windows-1252 has not,");
    values_.set(Text::text, text);
    const auto line = post_[command].empty() ? std::nullopt : printer_.whole(post_[command].front(), values_);
    const std::vector<std::string> own = line ? lines_about_cycles() : std::vector<std::string>{};
    if (std::find(own.begin(), own.end(), line) != own.end()) return;  // the cycle brings it along
    print(command, "a comment");
}

}  // namespace obrys::write
