#include "write/writer.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::write {

Writer::Writer(const Post& post, std::string name, Output output)
    : post_(post),
      name_(std::move(name)),
      layout_(post, name_, output),
      printer_(post, [this](std::string_view block) { layout_.block(block, printer_.in_force()); }) {
    if (post_.lua) {
        HookFault fault;  // read_post has tried it out
        hooks_ = load_hooks(post_.lua->text, post_.named_styles(), fault);
    }
    for (std::size_t c = 0; c < places_.size(); ++c) places_[c] = Places(post.commands[c]);
    folded_ = std::move(output.folded);
    homes_ = output.homes;
    by_moves_ = std::move(output.by_moves);
    if (post_.magazine) magazine_.emplace(*post_.magazine);
    if (post_.staircase) begin_stairs(std::move(output.run));
    const auto folds = [&](cl::CycleKind kind) {
        return post_.cycles.count(kind) != 0 || post_.hooked_cycles.count(kind) != 0;
    };
    const bool by_cycles = folds(cl::CycleKind::canned_tap_rigid) || folds(cl::CycleKind::tap_rigid);
    if (!post_.has(Command::tap) && by_cycles && !stairs_)
        taps_.emplace([this](const cl::Record& record) { take_written(record); });
    values_.set(Text::name, name_);
    static_cast<void>(put(Command::file_begin, {}, "the begin of the file"));
    printer_.start();
}

/// `line`: 0 is that of the block that follows.
void Writer::note(Fate fate, std::string what, std::uint64_t line) { note_at({fate, std::move(what), {}, 0, line}); }

void Writer::note_at(Note note) {
    if (about_ != nullptr)
        note.from = about_->from, note.stack = about_->stack;
    else if (now_ != nullptr)
        note.from = now_->from, note.stack = now_->stack;
    layout_.note(std::move(note));
}

Writer::About::About(Writer& writer, Topic topic) : writer_(writer), before_(writer.about_) {
    const Source& source = writer.topics_[static_cast<std::size_t>(topic)];
    if (!(source == Source{})) writer.about_ = &source;
}
Writer::About::~About() { writer_.about_ = before_; }

void Writer::remember_topic(const cl::Step& step) {
    const auto set = [&](Topic t) { topics_[static_cast<std::size_t>(t)] = {now_->from, now_->stack}; };
    if (std::holds_alternative<cl::ToolChange>(step)) set(Topic::tool), set(Topic::length);
    if (std::holds_alternative<cl::ToolLength>(step)) set(Topic::length);
    if (std::holds_alternative<cl::Datum>(step)) set(Topic::datum);
    if (std::holds_alternative<cl::Frame>(step)) set(Topic::frame);
    if (std::holds_alternative<cl::Spindle>(step)) set(Topic::spindle);
    if (std::holds_alternative<cl::Coolant>(step)) set(Topic::coolant);
    if (std::holds_alternative<cl::Tolerance>(step)) set(Topic::tolerance);
    if (std::holds_alternative<cl::PathMode>(step)) set(Topic::path);
    if (std::holds_alternative<cl::CompensationBegin>(step) || std::holds_alternative<cl::CompensationEnd>(step))
        set(Topic::compensation);
}

/// Coolant that waited stands in the block of this line.
void Writer::coolant_said(std::uint64_t line) {
    if (!std::exchange(coolant_waits_, std::nullopt)) return;
    const About about(*this, Topic::coolant);
    note(Fate::mapped, "coolant", line);
}

/// Prints a command and says what becomes of it: it is lost where the post has none for it or a word cannot hold its
/// number.
bool Writer::print(Command command, std::string_view what, bool rapid) {
    if (!post_.has(command)) {
        note(Fate::lost, std::string(what) + ": the post has no " + std::string(name_of(command)));
        return false;
    }
    const std::uint64_t line = layout_.next();
    Parts parts = parts_of(rapid, nullptr);
    if (plane_turn_ && has_part(post_[command], Part::axes)) take_axes(parts);
    const Printed printed = put(command, parts, what);
    if (printed == Printed::failed) {
        note(Fate::lost, std::string(what) + ": a word cannot hold " + printer_.failed_word());
        return false;
    }
    if (printed == Printed::all && places(command).has(Part::coolant)) coolant_said(line);
    const bool remark = command == Command::comment;  // and nothing that the machine does
    if (printed != Printed::refused && !remark) note(Fate::mapped, std::string(what), line);
    return true;
}

/// Within what is written as a cycle or as a way onto a contour, the control makes the moves; what holds behind it is
/// known from the records.
void Writer::take_folded(const cl::Record& record) {
    const cl::Step& step = record.step;
    if (std::holds_alternative<cl::CycleBegin>(step) || std::holds_alternative<cl::LeadBegin>(step)) ++folding_;
    if (std::holds_alternative<cl::CycleEnd>(step) || std::holds_alternative<cl::LeadEnd>(step)) --folding_;
    static_cast<void>(cursor_.take(record));
    if (std::holds_alternative<cl::CompensationBegin>(step)) contour_begun_ = false;
    if (folding_ == 0) end_fold();
}

void Writer::begin_stairs(std::function<void(const cl::Record&)> run) {
    Staircase::Output out;
    out.record = [this, run = std::move(run)](const cl::Record& record) {
        if (run) run(record);
        take_written(record);
    };
    const auto say = [this](Fate fate) {
        return [this, fate](const cl::Record& of, std::string what) {
            now_ = &of;
            note(fate, std::move(what));
            now_ = nullptr;
        };
    };
    out.lost = say(Fate::lost);
    out.expanded = say(Fate::expanded);
    stairs_.emplace(*post_.staircase, std::move(out));
}

void Writer::take(const cl::Record& record) {
    if (stairs_) return stairs_->take(record);
    if (taps_) return taps_->take(record);
    take_written(record);
}

void Writer::take_written(const cl::Record& record) {
    if (stop_waits_ && !is_of_stop(record)) write_stop();
    now_ = &record;
    const bool straight = std::holds_alternative<cl::Linear>(record.step);
    if (!straight) remember_topic(record.step);
    if (folding_ > 0) {
        take_folded(record);
    } else if (const auto* begin = std::get_if<cl::CycleBegin>(&record.step)) {
        take_cycle(record, *begin);
    } else if (const auto* lead = std::get_if<cl::LeadBegin>(&record.step)) {
        take_lead(record, *lead);
    } else if (std::holds_alternative<cl::PartBegin>(record.step) || std::holds_alternative<cl::PartEnd>(record.step)) {
        take_part(record);
    } else if (cl::is_move(record.step)) {
        take_move(record);
    } else {
        take_event(record);
    }
    straight_alone_ = straight && straight_alone_;
    now_ = nullptr;
}

/// Whether the control makes the move by itself, from an element that has been written.
bool Writer::is_made(const cl::Record& record) {
    if (place_ || plain_) return false;
    if (cursor_.state().compensation && !moves_are_contour()) return contour_begun_;
    const Source source{record.from, record.stack};
    if (std::find(programmed_.begin(), programmed_.end(), source) != programmed_.end()) return true;
    programmed_.clear();
    return false;
}

void Writer::take_move(const cl::Record& record) {
    if (is_made(record)) {
        static_cast<void>(cursor_.take(record));
        return;
    }
    const bool same_block =
        !held_.empty() && held_.back().record.from == record.from && held_.back().record.stack == record.stack;
    const auto* line = std::get_if<cl::Linear>(&record.step);
    const cl::AxisEnds& ends = *cl::ends_of(record.step);
    const bool may_wait = line != nullptr && line->rapid && ends.empty() && !place_ && !stairs_;
    const bool behind_rise = held_.size() == 1 && rise_waits();
    if (!may_wait || !(same_block || behind_rise)) flush_held();
    if (!axes_.empty() || !ends.empty()) axes_ = ends;
    const geom::Vec3 from = cursor_.position().here();
    static_cast<void>(cursor_.take(record));
    note_height(line);
    if (may_wait)
        held_.push_back({record, from});
    else
        write_move(record.step, from);
}

/// Behind a change of tools the height is nobody's until a block says one: of the other tool it was another one.
void Writer::note_height(const cl::Linear* line) {
    const bool said = line != nullptr && (!place_ || place_->axes[2]);
    const bool of_frame = place_ && place_->kind == cl::PlaceKind::frame;
    const bool known = of_frame || std::isfinite(cursor_.position().here().z);
    height_said_ = known && (height_said_ || said);
}

/// The way up behind a cycle, of which is not known yet whether it leads to another one.
bool Writer::rise_waits() const {
    if (!post_.rise_before_cycle_end || !series_.open || held_.empty()) return false;
    const auto* line = std::get_if<cl::Linear>(&held_.front().record.step);
    const geom::Vec3& from = held_.front().from;
    return line != nullptr && line->to.x == from.x && line->to.y == from.y && line->to.z > from.z;
}

void Writer::write_first_held() {
    const Held first = held_.front();
    held_.erase(held_.begin());
    const cl::Record* now = std::exchange(now_, &first.record);
    write_move(first.record.step, first.from);
    now_ = now;
}

void Writer::write_rise() {
    series_.open = false;  // it stands before their end
    write_first_held();
    series_.open = true;
    end_cycles();
}

void Writer::flush_held() {
    const cl::Record* now = now_;
    for (const Held& h : std::exchange(held_, {})) {
        now_ = &h.record;
        write_move(h.record.step, h.from);
    }
    now_ = now;
}

/// Elements are said where compensation or a corner makes another path of them; where the post has no corners, those
/// outside of compensation are written as the moves that they become.
void Writer::take_programmed(const cl::Programmed& p) {
    if (plain_) return;
    note_offsets();
    const bool corners = post_.has(Command::corner_rounding) || post_.has(Command::corner_chamfer) ||
                         post_.has(Command::corner_chamfer_leg);
    if (!corners && !cursor_.state().compensation) {
        if (p.corner != cl::Corner::none) note(Fate::expanded, "a chamfer or rounding");
        return;
    }
    if (by_moves_of_corner(p)) return;
    write_state();
    if (const auto& c = cursor_.state().compensation) select_plane(frames_.programmed_direction(c->normal));
    programmed_.push_back({now_->from, now_->stack});
    constexpr std::size_t looked_back = 16;  // elements: no control looks further ahead
    if (programmed_.size() > looked_back) programmed_.erase(programmed_.begin());
    contour_begun_ = contour_begun_ || cursor_.state().compensation.has_value();
    const cl::Programmed* corner = p.corner == cl::Corner::none ? nullptr : &p;
    axes_ = p.ends;
    if (p.sweep == 0) return write_line(p.to, p.rapid, corner);
    cl::Arc arc{p.to, p.centre, p.normal, p.sweep, p.rapid};
    write_arc(arc, p.from, corner);
}

/// By a radius that nobody knows the contour is run as it is programmed.
bool Writer::moves_are_contour() const {
    const auto& c = cursor_.state().compensation;
    return c && !(std::abs(c->radius) > 0);
}

/// A corner for which the post has no words, or not for its own feed: it and the element behind it are written by their
/// moves. Under compensation by a radius these are the tool's path, which is none of the contour.
bool Writer::by_moves_of_corner(const cl::Programmed& p) {
    if (cursor_.state().compensation && !moves_are_contour()) return false;
    const Command command = p.corner == cl::Corner::chamfer       ? Command::corner_chamfer
                            : p.corner == cl::Corner::chamfer_leg ? Command::corner_chamfer_leg
                                                                  : Command::corner_rounding;
    const bool unsaid =
        p.corner != cl::Corner::none &&
        (!post_.has(command) || (p.corner_feed != 0 && !says(post_[command], index_of(Value::own_feed))));
    if (unsaid) note(Fate::expanded, "a chamfer or rounding");
    const bool by_moves = unsaid || corner_by_moves_;
    corner_by_moves_ = by_moves && p.corner != cl::Corner::none;
    return by_moves;
}

void Writer::take_event(const cl::Record& record) {
    if (!std::holds_alternative<cl::Feed>(record.step) || !rise_waits()) flush_held();
    const cl::Step& step = record.step;
    if (const auto* place = std::get_if<cl::MachinePlace>(&step)) {
        place_ = *place;
        return;
    }
    if (const auto* p = std::get_if<cl::Programmed>(&step)) {
        static_cast<void>(cursor_.take(record));
        return take_programmed(*p);
    }
    if (const auto* change = std::get_if<cl::ToolChange>(&step)) {
        const bool stops = !post_.change_stops_spindle.empty() && !stays(*change) &&
                           cursor_.state().spindle.direction == 0 && !cursor_.state().spindle.held;
        if (stops) spindle_ = cursor_.state().spindle;
        drop_offsets_alone(*change);
        write_all();
        if (!change->standing) height_said_ = false;
    }
    static_cast<void>(cursor_.take(record));
    values_.clear();
    std::visit([this](const auto& kind) { event(kind); }, step);
}

void Writer::finish() {
    if (stairs_) stairs_->finish();
    if (taps_) taps_->settle();
    if (stop_waits_) write_stop();
    flush_held();
    if (!ended_) write_all(), end_compensation_alone(Urgency::at_end), write_last_length(), return_plane();
    if (!ended_ && cursor_.moves() > 0) end_cycles();
    spill_parts();
    values_.clear();
    // The control must not run on into the subprograms.
    if (!ended_ && layout_.has_subprograms()) print(Command::stop_end, "the end of the program");
    layout_.put_subprograms();
    values_.clear();
    values_.set(Text::name, name_);
    static_cast<void>(put(Command::file_end, {}, "the end of the file"));
    layout_.finish();
}

}  // namespace obrys::write
