#include "compare/path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/near.hpp"
#include "compare/role.hpp"

namespace obrys::compare {

namespace {

/// A tool whose offset has its own number is the same as one whose first edge is named.
cl::ToolChange tool_of(cl::ToolChange change) {
    if (change.offset == change.number && change.offset != 0)
        change.edge = 1, change.offset = 0;
    else if (change.offset == change.edge)
        change.offset = 0;
    change.with_length = change.standing = false;
    return change;
}

/// NaN equals nothing, not even itself.
void mark(double& v) {
    constexpr double nobody_knows = -1e300;
    if (std::isnan(v)) v = nobody_knows;
}
void mark(geom::Vec3& v) { mark(v.x), mark(v.y), mark(v.z); }

Holding with_marks(Holding h) {
    mark(h.feed.value), mark(h.spindle.speed), mark(h.spindle.limit);
    if (h.spindle.held) mark(*h.spindle.held);
    mark(h.tool.raised), mark(h.tool.wider), mark(h.datum.origin), mark(h.tolerance.contour), mark(h.tolerance.rotary);
    if (h.length_by) mark(*h.length_by);
    for (cl::FramePart& p : h.frame.parts) {
        mark(p.frame.origin);
        for (double& v : p.frame.linear) mark(v);
    }
    if (h.path) mark(h.path->tolerance), mark(h.path->merge);
    return h;
}

std::int64_t length_of(const motion::State& s) {
    const bool own = s.length.sense > 0 && !s.length.by && s.length.offset == s.change.number;
    if (own || (s.length.sense == 0 && s.change.with_length)) return -1;
    if (s.length.sense == 0) return 0;
    if (s.length.by) return s.length.sense > 0 ? -2 : -4;
    return (std::int64_t{s.length.offset} + 1) * (s.length.sense > 0 ? 1 : -3);
}

bool turned_by_control(const cl::Frame& frame) { return turn_by_control(frame) != nullptr; }

}  // namespace

const cl::PlaneTurn* turn_by_control(const cl::Frame& frame) {
    const auto at = std::find_if(frame.parts.rbegin(), frame.parts.rend(),
                                 [](const cl::FramePart& p) { return p.turn.by_control; });
    return at == frame.parts.rend() ? nullptr : &at->turn;
}

bool can_be_joined(const Holding& h, bool rapid) {
    const bool stops = h.path && h.path->kind == cl::PathKind::exact_stop;
    return !stops && (rapid || h.feed.mode != cl::FeedMode::inverse_time);
}

void Path::hold() {
    if (std::exchange(held_, true)) return;
    const motion::State& s = cursor_.state();
    const std::int64_t length = length_of(s);
    const bool by_values = length == -2 || length == -4;
    Holding now{s.feed, s.spindle, s.coolant, tool_of(s.change), length, {}, s.datum, s.frame, s.tolerance, s.path};
    if (by_values) now.length_by = s.length.by;
    if (!now.path && joins_freely_) now.path = cl::PathMode{cl::PathKind::free};
    compensates_length = compensates_length || now.length != 0;
    // There the tool's length does not count: a control may have to put it off and on again for that.
    if (to_holder_) now.tool.edge = 0, now.length = 0, now.length_by.reset();
    Holding marked = with_marks(now);
    if (marked == marked_) return;
    marked_ = std::move(marked);
    holding_ = std::make_shared<const Holding>(std::move(now));
}

/// An arc that goes on about the axis of the last move, as steep and as wide, with nothing between them. Where a move
/// takes its time (inverse time) or the tool stands still behind each, two are not one.
bool Path::goes_on(const cl::Record& record) const {
    const auto* next = std::get_if<cl::Arc>(&record.step);
    if (next == nullptr || moves.none_left() || !axes_.empty() || !at_ || !moves.back().axes.empty() ||
        moves.back().holding != holding_ || item_at_ == moves.size() || !can_be_joined(*holding_, next->rapid))
        return false;
    const auto* arc = std::get_if<cl::Arc>(&moves.back().step);
    if (arc == nullptr || arc->rapid != next->rapid) return false;
    const geom::Vec3 along = next->normal, between = next->centre - arc->centre;
    const auto beside = [&](const geom::Vec3& v) { return geom::length(v - geom::dot(v, along) * along); };
    if (geom::distance(arc->normal, along) > 1e-9 || !(beside(between) <= same_place_)) return false;
    if ((arc->sweep > 0) != (next->sweep > 0)) return false;
    const double radius = beside(arc->to - arc->centre), next_radius = beside(next->to - arc->centre);
    const double rise = geom::dot(arc->to - arc_from_, along) / arc->sweep;
    const double next_rise = geom::dot(next->to - *at_, along) / next->sweep;
    const double rounded = 4 * same_place_;  // both ends of both are
    return std::abs(rise - next_rise) * geom::full_turn <= rounded && std::abs(radius - next_radius) <= rounded;
}

/// Of a move whose block has not said all of its coordinates since the tool was changed: where the others are nobody
/// knows. Readers tell them by what they count: where the length comes with the tool, the tip has the height that it
/// had; where it comes by a word behind it, it stands off by what the one tool is longer. No word moves that axis in
/// either of them.
geom::Vec3 Path::as_said(geom::Vec3 to, const geom::Vec3& others) const {
    if (!said_) return to;
    const auto& place = std::get<cl::MachinePlace>(said_->step);
    if (!place.axes[0]) to.x = others.x;
    if (!place.axes[1]) to.y = others.y;
    if (!place.axes[2]) to.z = others.z;
    return to;
}

/// The axes of the program are not those of the workpiece.
bool Path::is_turned() const {
    const auto& frames = cursor_.state().frame.parts;
    return !std::all_of(frames.begin(), frames.end(),
                        [](const cl::FramePart& p) { return p.frame.linear == geom::Frame{}.linear; });
}

/// An arc no longer than places lie apart: rounded words beside a smooth joint have it or not.
bool Path::is_of_no_length(const cl::Arc& arc) const {
    if (!at_ || !axes_.empty() || !near(*at_, arc.to, same_place_) || !near(tool_, arc.axis, 1e-6)) return false;
    return std::abs(arc.sweep) * geom::length(geom::cross(*at_ - arc.centre, arc.normal)) <= same_place_;
}

/// A line to where the tool stands, with its axis as it is. A working plane that is tilted tells another axis, and
/// nothing moves yet; nor does what the control does by itself to turn to it, which no move tells, or with the end of a
/// plane to which it has turned: where the tip is then nobody knows.
bool Path::leads_nowhere(const cl::Step& step, const geom::Vec3& to) const {
    if (const auto* arc = std::get_if<cl::Arc>(&step)) return is_of_no_length(*arc);
    const auto* line = std::get_if<cl::Linear>(&step);
    const bool by_control = tilts_ && (was_turned_ || turned_by_control(cursor_.state().frame));
    const bool unknown = std::isnan(to.x) && std::isnan(to.y) && std::isnan(to.z);
    const bool rapid = line != nullptr && line->rapid && line->seek == cl::Seek::nothing;
    // With another plane the axes count otherwise, and nobody knows the tip's place in it; the next move tells them.
    const bool axes_stand = std::all_of(axes_.begin(), axes_.end(), [&](const cl::AxisEnd& axis) {
        const auto at = stands_.find(axis.name);
        return at != stands_.end() && near(at->second.to, axis.to, same_place_);
    });
    if (rapid && tilts_ && unknown && !axes_.empty() && axes_stand) return true;
    if (by_control && rapid && unknown && axes_.empty()) return true;
    if (line == nullptr || line->seek != cl::Seek::nothing || !at_ || !axes_.empty() ||
        !near(*at_, as_said(to, *at_), same_place_))
        return false;
    return (line->rapid && tilts_) || near(tool_, line->axis, 1e-6);
}

/// The rotary axes have gone in the move before to where this one takes them, as the new plane counts them: the machine
/// does the same where the control turns them to the plane by itself (G0 A29 C120, G68.2 …, G53.1).
bool Path::has_turned_before(const cl::Step& step) const {
    constexpr double same_angle = 0.05;  // degrees: the control goes on to where the plane's rounded angles want it
    const auto* line = std::get_if<cl::Linear>(&step);
    if (line == nullptr || !line->rapid || line->seek != cl::Seek::nothing) return false;
    const bool follows = turns_alone_ && tilts_ && !moves.none_left() && item_at_ != moves.size() && !axes_.empty();
    return follows && std::all_of(axes_.begin(), axes_.end(), [&](const cl::AxisEnd& axis) {
               const auto at = stands_.find(axis.name);
               return at != stands_.end() && axis.counted && !at->second.counted &&
                      near(at->second.to, axis.to, same_angle);
           });
}

/// What holds in the move. A rigid tap is coupled to the spindle on its way back as on its way in: whether a program
/// says that the spindle is reversed for it, or the word of the tap does that, makes no difference; nor does it whether
/// the spindle turns again before or behind the rapid that leads out of the hole.
std::shared_ptr<const Holding> Path::holding_of(const cl::Step& step) {
    const auto* thread = std::get_if<cl::Thread>(&step);
    const bool taps = thread != nullptr && thread->rigid_tap;
    const bool back = taps && tap_ == Tap::in, out = !taps && tap_ == Tap::back && cl::is_rapid(step);
    tap_ = back ? Tap::back : taps ? Tap::in : Tap::none;
    if (tap_ == Tap::in) tap_sense_ = holding_->spindle;
    if ((!back && !out) || (tap_sense_.direction == 0 && !tap_sense_.held)) return holding_;
    if (back && holding_->spindle.direction == 0) return holding_;
    Holding coupled = *holding_;
    if (out)
        coupled.spindle = tap_sense_, coupled.leads_out = true;
    else
        coupled.spindle.direction = tap_sense_.direction;
    return std::make_shared<const Holding>(std::move(coupled));
}

/// An empty spindle is no tool.
void Path::note_tool() {
    const cl::ToolChange& tool = holding_->tool;
    if (moving_ == holding_ || (tool.number == 0 && tool.name.empty())) return;
    has_several_tools =
        has_several_tools || (moving_ && (moving_->tool.number != tool.number || moving_->tool.name != tool.name));
    moving_ = holding_;
}

void Path::take_move(const cl::Record& record, const geom::Vec3& to) {
    // The same numbers with another length are another place.
    const cl::ToolLength& length = cursor_.state().length;
    if (!(length == length_there_)) at_.reset(), length_there_ = length;
    const bool turned = has_turned_before(record.step);
    // Ways to places of the machine that nobody knows are as many as the program says, however near they lie.
    const bool is_known = std::isfinite(to.x) && std::isfinite(to.y) && std::isfinite(to.z);
    if (!turned && !(to_holder_ && !is_known) && leads_nowhere(record.step, to)) {
        const bool ends_nowhere = was_turned_ && !turned_by_control(cursor_.state().frame) && std::isnan(to.x);
        if (ends_nowhere) at_ = to;
        tilts_ = tilts_ && !std::isnan(to.x);  // one such step a plane: the next one to nobody knows where is a move
        return said_.reset();
    }
    constexpr geom::Vec3 nowhere{NAN, NAN, NAN};
    const geom::Vec3 now = as_said(to, at_.value_or(nowhere));
    const bool says_in_part = said_ && !is_turned();
    take_said();
    if (to_holder_) held_ = false;
    hold();
    if (std::exchange(to_holder_, false)) held_ = false;
    note_tool();
    const auto* line = std::get_if<cl::Linear>(&record.step);
    turns_alone_ = line != nullptr && line->rapid && !axes_.empty() && !axes_.front().counted && at_ &&
                   near(*at_, now, same_place_);
    for (const cl::AxisEnd& axis : axes_) stands_[axis.name] = {axis.to, axis.counted};
    if (turned) {
        Move& move = moves.back();
        move.step = record.step, move.axes = std::exchange(axes_, {});
        move.holding = holding_, move.from = record.from, move.stack = record.stack;
    } else if (goes_on(record)) {
        auto& arc = std::get<cl::Arc>(moves.back().step);
        const auto& next = std::get<cl::Arc>(record.step);
        arc.to = next.to;
        arc.sweep += next.sweep;
    } else {
        if (std::holds_alternative<cl::Arc>(record.step)) arc_from_ = at_.value_or(nowhere);
        const bool taps = tap_ != Tap::none || std::holds_alternative<cl::Thread>(record.step);
        const std::shared_ptr<const Holding> of_tap = taps ? holding_of(record.step) : nullptr;
        const std::shared_ptr<const Holding>& holds = taps ? of_tap : holding_;
        Move& move = moves.grow();
        move.step = record.step;
        if (auto* straight = std::get_if<cl::Linear>(&move.step); straight != nullptr && says_in_part)
            straight->to = now;
        move.axes.clear();
        std::swap(move.axes, axes_);
        if (move.holding != holds) move.holding = holds;
        move.from = record.from, move.stack = record.stack;
    }
    at_ = now;
    tilts_ = was_turned_ = false;
    tool_ = *cl::tool_axis_of(record.step);
}

/// An axis that is told to go where it stands does not move.
void Path::take_axis(const cl::AxisEnd& axis) {
    std::erase_if(axes_, [&](const cl::AxisEnd& a) { return a.name == axis.name; });
    const Stand stands = stands_[axis.name];
    if (near(stands.to, axis.to, same_place_) && !std::isnan(axis.to) && stands.counted == axis.counted) return;
    axes_.push_back(axis);
}

void Path::take_item(Kept<Item>& items, cl::Step step, const cl::Record& record) {
    // An arc goes on behind the end of a bracket, or in another part of the program, as it does without them.
    const bool parts_nothing = &items == &parts || &items == &preparations ||
                               std::holds_alternative<cl::CycleEnd>(step) || std::holds_alternative<cl::LeadEnd>(step);
    if (!parts_nothing) item_at_ = moves.size();
    const bool is_event = &items == &events;
    if (std::holds_alternative<cl::CompensationBegin>(step) && !items.none_left()) {
        Item& last = items.back();
        last.changes_side = std::holds_alternative<cl::CompensationEnd>(last.step) && last.from == record.from &&
                            last.stack == record.stack && last.moves == moves.size();
    }
    items.push_back({std::move(step), record.from, record.stack, moves.size(),
                     is_event ? holding_ : std::shared_ptr<const Holding>()});
}

void Path::take(const cl::Record& record) {
    const cl::Step& step = record.step;
    if (const cl::AxisEnds* ends = cl::ends_of(step)) {
        for (const cl::AxisEnd& axis : *ends) take_axis(axis);
        return take_move(record, cursor_.take(record)->to);
    }
    const auto* said = std::get_if<cl::MachinePlace>(&step);
    if (said != nullptr && said->kind == cl::PlaceKind::frame) {
        take_said();
        if (!is_axis_by_axis_) said_ = record;
        return;
    }
    const auto datum = cursor_.state().datum;
    was_turned_ = was_turned_ || (std::holds_alternative<cl::Frame>(step) && turned_by_control(cursor_.state().frame));
    cursor_.take(record);
    held_ = false;
    const auto* stop = std::get_if<cl::Stop>(&step);
    ends_ = ends_ || (stop != nullptr && stop->kind == cl::StopKind::end);
    tilts_ = tilts_ || std::holds_alternative<cl::Frame>(step);
    // Another zero: the tool stands still, and its place has other numbers.
    if (std::holds_alternative<cl::Datum>(step) && !(cursor_.state().datum == datum)) at_.reset();
    // What a block of a stop or function does besides holds there, whatever stands first in it.
    const bool of_block = !events.none_left() && holds_to_the_end_of_its_block(events.back().step) &&
                          events.back().from == record.from && events.back().moves == moves.size();
    if (of_block && (std::holds_alternative<cl::Spindle>(step) || std::holds_alternative<cl::Coolant>(step))) {
        hold();
        events.back().holding = holding_;
    }
    switch (std::visit(RoleOf{}, step)) {
        case Role::cycle: return take_item(cycles, step, record);
        case Role::contour: return take_item(contours, step, record);
        case Role::part: return take_item(parts, step, record);
        case Role::preparation: return take_item(preparations, step, record);
        case Role::event: return take_event(record);
        case Role::move:  // has been taken
        case Role::holds:
        case Role::remark: return;
    }
}

/// What the block of the move said, which counts where the move does.
void Path::take_said() {
    if (!said_) return;
    const cl::Record record = *std::exchange(said_, std::nullopt);
    hold();
    take_item(events, record.step, record);
}

/// Length and radius each for itself: controls set them together or one by one.
void Path::take_tool_data(const cl::Record& record, const cl::ToolData& data) {
    hold();
    const auto add = [&](const cl::ToolData& d) { take_item(events, d, record); };
    if (data.length) add({data.number, data.edge, data.length, {}});
    if (data.radius) add({data.number, data.edge, {}, data.radius});
    if (!data.length && !data.radius) add(data);
}

void Path::take_event(const cl::Record& record) {
    if (const auto* data = std::get_if<cl::ToolData>(&record.step)) return take_tool_data(record, *data);
    cl::Step step = record.step;
    if (const auto* change = std::get_if<cl::ToolChange>(&step)) {
        const cl::ToolChange now = tool_of(*change), before = std::exchange(changed_to_, now);
        const bool same = now.number == before.number && now.name == before.name;
        hold();
        if (!same) at_.reset();  // another tool's tip is elsewhere, whatever its numbers are
        if (same && !change->standing && now == before && calls_again++ == 0)
            called_again = Item{now, record.from, record.stack, moves.size()};
        if (same || change->standing) return;
        step = now;
    }
    hold();
    const auto* place = std::get_if<cl::MachinePlace>(&step);
    to_holder_ = to_holder_ || (place != nullptr && !place->tip && place->kind != cl::PlaceKind::frame);
    take_item(events, std::move(step), record);
}

}  // namespace obrys::compare
