#include <algorithm>
#include <cmath>

#include "write/holes/same_hole.hpp"
#include "write/writer.hpp"

namespace obrys::write {

namespace {

bool holds(const Condition& c, const cl::Cycle& cycle) {
    const auto found = std::find_if(cycle.values.begin(), cycle.values.end(),
                                    [&](const cl::CycleValue& v) { return index_of(v.role) == c.value; });
    const bool there = found != cycle.values.end() && (!c.equals || found->value == *c.equals);
    return there == c.present;
}

/// All that the cycle says has its word, or need not be said, or is what a condition asks for.
bool says_all(const CycleForm& form, const cl::Cycle& cycle) {
    const auto has = [&](cl::CycleRole role) {
        return std::any_of(cycle.values.begin(), cycle.values.end(),
                           [&](const cl::CycleValue& v) { return v.role == role; });
    };
    // Between retract plane and bottom the surface tells where infeeds begin, and nothing else.
    const bool surface_counts = !has(cl::CycleRole::retract_plane) || has(cl::CycleRole::infeed);
    return std::all_of(cycle.values.begin(), cycle.values.end(), [&](const cl::CycleValue& v) {
        const ValueIndex value = index_of(v.role);
        if (v.role == cl::CycleRole::surface && !surface_counts) return true;
        const bool asked = std::any_of(form.when.begin(), form.when.end(),
                                       [&](const Condition& c) { return c.value == value && c.present && c.equals; });
        return asked || says(form.define, value) || says(form.call, value) ||
               std::find(form.unsaid.begin(), form.unsaid.end(), value) != form.unsaid.end();
    });
}

/// Where the cycle's plane is one of the frame in force: its normal there.
std::optional<geom::Vec3> plane_of(const geom::Frame& f) {
    constexpr double same = 1e-9;
    if (geom::length(f.origin) > 1e-6) return std::nullopt;
    constexpr std::array<std::array<double, 9>, 3> planes{{{1, 0, 0, 0, 1, 0, 0, 0, 1},    // x y z
                                                           {0, 1, 0, 0, 0, 1, 1, 0, 0},    // z x y
                                                           {0, 0, 1, 1, 0, 0, 0, 1, 0}}};  // y z x
    const std::array<geom::Vec3, 3> normals{geom::Vec3{0, 0, 1}, geom::Vec3{0, 1, 0}, geom::Vec3{1, 0, 0}};
    for (std::size_t p = 0; p < planes.size(); ++p)
        if (std::equal(planes[p].begin(), planes[p].end(), f.linear.begin(),
                       [&](double a, double b) { return std::abs(a - b) < same; }))
            return normals[p];
    return std::nullopt;
}

std::optional<double> height(const cl::Cycle& cycle, cl::CycleRole role) {
    const auto found =
        std::find_if(cycle.values.begin(), cycle.values.end(), [&](const cl::CycleValue& v) { return v.role == role; });
    return found == cycle.values.end() ? std::nullopt : std::optional(found->value);
}

/// Whether the number stands in a block; a word that is chosen by it (G98) does not say it.
bool prints(const Template& text, ValueIndex value) {
    return std::any_of(text.begin(), text.end(), [&](const Block& block) {
        return std::any_of(block.begin(), block.end(),
                           [&](const Token& t) { return t.kind == Token::Kind::word && t.value == value; });
    });
}

/// A tap that the program makes by moves (LoneTaps).
bool is_lone_tap(const cl::Cycle& cycle) { return cycle.kind == cl::CycleKind::canned_tap_rigid && cycle.name.empty(); }

std::string name_of_cycle(const cl::Cycle& cycle) {
    if (is_lone_tap(cycle)) return "rigid tapping";
    return "cycle " + cycle.name + " (" + std::string(cl::spelling(cycle.kind)) + ")";
}

}  // namespace

const CycleForm* Writer::cycle_form(const cl::Cycle& cycle) const {
    const auto forms = post_.cycles.find(cycle.kind);
    if (forms == post_.cycles.end()) return nullptr;
    for (const CycleForm& form : forms->second)
        if (std::all_of(form.when.begin(), form.when.end(), [&](const Condition& c) { return holds(c, cycle); }) &&
            says_all(form, cycle))
            return form.call.empty() ? nullptr : &form;
    return nullptr;
}

void Writer::set_values(const HoleWay& way, const geom::Vec3& at) {
    const cl::Cycle& cycle = way.cycle;
    values_.clear();
    if (!std::isnan(at.x)) values_.set(Value::x, at.x);
    if (!std::isnan(at.y)) values_.set(Value::y, at.y);
    if (!std::isnan(at.z)) values_.set(Value::z, at.z);
    for (const cl::CycleValue& v : cycle.values) values_.set(index_of(v.role), v.value);
    const motion::State& s = cursor_.state();
    if (const auto retract = height(cycle, cl::CycleRole::retract_plane)) {
        const double top = height(cycle, cl::CycleRole::surface).value_or(*retract);
        values_.set(Value::hole_top, top);
        values_.set(Value::hole_gap, *retract - top);
        values_.set(Value::hole_end, height(cycle, cl::CycleRole::return_level).value_or(*retract));
        if (const auto bottom = height(cycle, cl::CycleRole::bottom)) values_.set(Value::hole_way, top - *bottom);
    }
    if (s.feed.value != 0) values_.set(Value::feed, s.feed.value);
    if (way.feed) values_.set(Value::feed, *way.feed);
    // A tap turns the spindle with the speed with which it turned last.
    if (s.spindle.speed > 0 && s.spindle.mode == cl::SpindleMode::rpm) turning_speed_ = s.spindle.speed;
    if (turning_speed_ > 0) values_.set(Value::speed, turning_speed_);
    if (way.speed) values_.set(Value::speed, *way.speed);
    const double tapping = height(cycle, cl::CycleRole::spindle_speed).value_or(way.speed.value_or(turning_speed_));
    if (tapping > 0) values_.set(Value::speed_back, tapping * height(cycle, cl::CycleRole::rpm_factor).value_or(1));
}

/// Where the tool stood when the series began, or stands when it begins with a cycle now. Of a way over the hole its
/// end counts: where it begins is not known behind a change of the tool's length.
double Writer::level_of_series(bool over) const {
    const bool ends_series = over && held_.size() > 1 && !post_.raises_to_retract_plane;
    if (series_.open && !rise_waits() && !ends_series) return series_.level;
    if (!height_said_) return NAN;
    const auto* way = over || rise_waits() ? std::get_if<cl::Linear>(&held_.front().record.step) : nullptr;
    return frames_.programmed(way != nullptr ? way->to : cursor_.position().here()).z;
}

/// Whether the control ends where the cycle does: words that name no height (G98) mean that of the series' begin. And
/// whether it gets to the retract plane by the moves that were made, from where the tool stands over the hole.
bool Writer::gets_there(const CycleForm& form, const cl::Cycle& cycle, double level, double stands) const {
    constexpr double same = 1e-6;  // mm
    const auto retract = height(cycle, cl::CycleRole::retract_plane);
    if (post_.raises_to_retract_plane && retract && !(stands >= *retract - same)) return false;
    const auto end = height(cycle, cl::CycleRole::return_level);
    const ValueIndex value = index_of(cl::CycleRole::return_level);
    if (!end || prints(form.define, value) || prints(form.call, value)) return true;
    if (!says(form.define, value) && !says(form.call, value)) return true;
    return std::abs(level - *end) <= same || (retract && *end <= *retract && level <= *retract + same);
}

/// Letters of words that the call says and that then hold until the end of the series. The values are set.
std::set<std::string> Writer::kept_words(const CycleForm& form) const {
    std::set<std::string> out;
    for (const Block& block : form.call) {
        const std::string text = " " + printer_.whole(block, values_).value_or("");
        for (const std::string& letter : post_.kept_in_cycles)
            if (text.find(" " + letter) != std::string::npos) out.insert(letter);
    }
    return out;
}

/// A word of the series (the dwell P) that this cycle does not say would hold for it, too.
void Writer::end_series_that_says_more(const CycleForm& form) {
    if (!series_.takes(kept_words(form))) end_cycles();
}

/// Writes the bracket as a cycle of the control, its own or one that makes the same hole; false, and nothing is
/// written, where it has none that says it all.
bool Writer::fold(const cl::CycleBegin& begin) {
    if (cursor_.state().compensation) return false;
    if (fold_as(begin, {*begin.cycle})) return true;
    const std::vector<HoleWay> others = same_hole(*begin.cycle, cursor_.state());
    if (std::any_of(others.begin(), others.end(), [&](const HoleWay& way) { return fold_as(begin, way, true); }))
        return true;
    return std::any_of(others.begin(), others.end(), [&](const HoleWay& way) { return fold_below(begin, way); });
}

/// The control ends at the retract plane: the way up from there is a move of its own.
bool Writer::fold_below(const cl::CycleBegin& begin, HoleWay way) {
    const std::size_t erased =
        std::erase_if(way.cycle.values, [](const auto& v) { return v.role == cl::CycleRole::return_level; });
    series_.rises = erased != 0 && fold_as(begin, way, true);
    return series_.rises;
}

/// A block of a cycle may turn the spindle on (G84.1 X Y Z M3): the sense, 0 where it does not.
int Writer::spindle_word(const Template& call) const {
    const auto has = [](const Template& words, const std::string& literal) {
        return std::any_of(words.begin(), words.end(), [&](const Block& block) {
            return std::any_of(block.begin(), block.end(),
                               [&](const Token& t) { return t.kind == Token::Kind::literal && t.before == literal; });
        });
    };
    for (const Block& block : call)
        for (const Token& t : block) {
            if (t.kind != Token::Kind::literal) continue;
            if (has(post_[Command::spindle_cw], t.before)) return 1;
            if (has(post_[Command::spindle_ccw], t.before)) return -1;
        }
    return 0;
}

/// Nothing but the place differs from the last cycle of the series; what there is besides is remembered.
bool Writer::is_again(const Template& call, const Parts& parts) {
    if (!post_.has(Command::cycle_again)) return false;
    Values elsewhere = values_;
    elsewhere.drop(Value::x);
    elsewhere.drop(Value::y);
    std::string all;
    for (const Block& block : call) all += printer_.whole(block, elsewhere, parts).value_or("") + "\n";
    return series_.is_again(std::move(all));
}

/// Where no block has said a height of this tool, the program's cycle comes to its plane from wherever that is; a word
/// that goes over the hole at the height of before has none. So the way to the plane is a move of its own.
void Writer::come_to_plane(const cl::Cycle& cycle, const geom::Vec3& at) {
    end_cycles();
    print_straight({at.x, at.y, *height(cycle, cl::CycleRole::retract_plane)}, true, nullptr, cl::Seek::nothing);
    height_said_ = true;
}

/// The normal of a cycle's plane in the text. Where that says other coordinates than the program, those of the
/// workpiece for a shift that it has no words for, heights of holes become the text's.
std::optional<geom::Vec3> Writer::lay_in_text(cl::Cycle& cycle) const {
    using Role = cl::CycleRole;
    const geom::Frame seen = frames_.into() * cycle.plane;
    const bool canned = cycle.kind >= cl::CycleKind::canned_drill && cycle.kind <= cl::CycleKind::canned_bore_manual;
    const bool hole = canned || cycle.kind <= cl::CycleKind::tap_chip_breaking;
    if (!hole || !geom::is_shift_only(seen)) return plane_of(seen);
    for (cl::CycleValue& v : cycle.values)
        for (const Role role :
             {Role::surface, Role::retract_plane, Role::bottom, Role::return_level, Role::counterbore_top})
            if (v.role == role) v.value += seen.origin.z;
    return geom::Vec3{0, 0, 1};
}

/// `may_come`: to the plane where the height is not known, for the cycle is another control's.
bool Writer::fold_as(const cl::CycleBegin& begin, HoleWay way, bool may_come) {
    const cl::Cycle& cycle = way.cycle;
    const CycleForm* form = cycle_form(cycle);
    const bool hooked = hooks_ != nullptr && post_.hooked_cycles.count(cycle.kind) != 0;
    if (form == nullptr && !hooked) return false;
    write_state();
    const auto normal = lay_in_text(way.cycle);
    if (!normal || normal->z != 1) return false;  // forms of cycles say heights along Z
    const geom::Vec3 at = frames_.programmed(begin.place);
    // Nothing is written, and no move left out, before all of it can be said.
    set_values(way, at);
    CycleForm said;
    if (hooked && !ask_cycle(cycle, said)) return false;
    if (!said.call.empty()) form = &said;
    if (form == nullptr) return false;
    const bool takes_speed = !says(form->define, index_of(Value::speed)) && !says(form->call, index_of(Value::speed));
    if (way.speed && takes_speed && *way.speed != turning_speed_) return false;
    const auto sayable = [&](const Block& block) { return printer_.whole(block, values_).has_value(); };
    if (!std::all_of(form->define.begin(), form->define.end(), sayable) ||
        !std::all_of(form->call.begin(), form->call.end(), sayable))
        return false;
    // The spindle is not to turn before the tool is over the hole where it does not, and the length waits for a move.
    const bool turns_on = cursor_.state().spindle.direction == 0 && spindle_word(form->call) != 0;
    const auto goes_over = [&] {
        return form->moves_over && !turns_on && !length_waits_ && !held_.empty() &&
               held_.back().record.from == now_->from && held_.back().record.stack == now_->stack;
    };
    end_series_that_says_more(*form);
    const double level = level_of_series(goes_over());
    const auto* over_hole = goes_over() ? std::get_if<cl::Linear>(&held_.back().record.step) : nullptr;
    const auto plane = height(cycle, cl::CycleRole::retract_plane);
    const bool comes = may_come && plane && !height_said_ && !series_.open && post_.has(Command::rapid);
    const geom::Vec3 before = over_hole != nullptr ? over_hole->to : cursor_.position().here();
    const double stands = comes ? *plane : frames_.programmed(before).z;
    if (!gets_there(*form, cycle, level, stands)) return false;
    if (rise_waits()) write_rise();
    const bool over = goes_over();
    // A control that does not raise the tool first makes the last of these moves alone.
    while (over && held_.size() > 1 && !post_.raises_to_retract_plane) write_first_held();
    if (over)
        held_.clear();
    else
        flush_held();
    write_state();
    if (comes) come_to_plane(cycle, at);
    write_length_alone();
    note_offsets();
    z_of_machine_ = false;
    end_compensation_alone(Urgency::may_wait);
    select_plane(*normal);
    set_values(way, at);
    // Feeds of cycles are in mm/min.
    if (way.feed || post_.has(Command::feed_mode_per_minute)) say_feed_mode(cl::FeedMode::per_minute);
    std::string defined;
    for (const Block& block : form->define) defined += printer_.whole(block, values_).value_or("") + "\n";
    begin_cycles(defined);
    set_values(way, at);  // the begin of a series has values of its own
    if (defined != series_.defined && printer_.print(form->define, values_) == Printed::failed) return false;
    series_.defined = defined;
    series_.says.merge(kept_words(*form));
    const std::uint64_t line = layout_.next();
    Parts parts = parts_of(false, nullptr);
    if (way.feed) parts.feed = &post_[Command::feed_per_minute], values_.set(Value::feed, *way.feed);
    const Template& call = is_again(form->call, parts) && form != &said ? post_[Command::cycle_again] : form->call;
    if (printer_.print(call, values_, parts, false, form == &said) == Printed::failed) return false;
    if (form == &said) printer_.forget_words_of(said.call);
    note(Fate::mapped, name_of_cycle(*begin.cycle), line);
    if (folded_) folded_({cycle.kind, form == &said ? nullptr : form, cycles_taken_ - 1});
    series_.open = post_.has(Command::cycle_end);
    series_.level = level;
    if (const int turns = spindle_word(form->call); turns != 0) spindle_.direction = turns > 0 ? 1 : -1;
    tap_.stops = form->stops_spindle;
    if (!tap_.stops.empty()) stop_spindle(tap_.stops);
    return true;
}

/// Cycles that hold the spindle and move aside, so that the edge comes free of the wall: at which angle the control
/// holds it, and so which way the edge points, is its own. The moves alone would be for another control's angle.
void Writer::note_held_aside(const cl::Cycle& cycle) {
    const bool aside = cycle.kind == cl::CycleKind::canned_bore_orient || cycle.kind == cl::CycleKind::canned_back_bore;
    if (!aside) return;
    note(Fate::lost, "the side to which " + name_of_cycle(cycle) +
                         " moves away, which goes with the angle at which the control itself holds the spindle,");
}

void Writer::take_cycle(const cl::Record& record, const cl::CycleBegin& begin) {
    const cl::CycleKind kind = begin.cycle->kind;
    const bool taps = (kind >= cl::CycleKind::tap_floating_simple && kind <= cl::CycleKind::tap_chip_breaking) ||
                      kind == cl::CycleKind::canned_tap_floating || kind == cl::CycleKind::canned_tap_rigid;
    if (taps) note_tapping();
    const bool folded = !by_moves_.contains(cycles_taken_++) && fold(begin);
    static_cast<void>(cursor_.take(record));
    if (folded) {
        folding_ = 1;
        return;
    }
    flush_held();
    note_held_aside(*begin.cycle);
    if (height(*begin.cycle, cl::CycleRole::rpm_factor).value_or(1) != 1 && !post_.has(Command::tap))
        note(Fate::lost, name_of_cycle(*begin.cycle) +
                             ": its tap goes back at another speed than it goes in, and the "
                             "post has no words for that");
    // Else its moves say what is lost.
    if (!is_lone_tap(*begin.cycle)) note(Fate::expanded, name_of_cycle(*begin.cycle));
}

/// Behind a cycle the tool stands somewhere else than the words that were printed say.
void Writer::end_fold() {
    const bool cycle = !lead_;
    if (lead_) print_lead();
    printer_.forget_coordinates();
    const geom::Vec3 at = frames_.programmed(cursor_.position().here());
    height_said_ = height_said_ || std::isfinite(at.z);
    if (std::exchange(series_.rises, false)) return write_line(cursor_.position().here(), true);
    if (!cycle || !post_.place_known_behind_cycle || !geom::is_finite(at)) return;
    values_.clear();
    values_.set(Value::x, at.x);
    values_.set(Value::y, at.y);
    values_.set(Value::z, at.z);
    printer_.remember(post_[Command::rapid], values_);
}

}  // namespace obrys::write
