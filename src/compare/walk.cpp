#include "compare/walk.hpp"

#include <cmath>

#include "cl/totals.hpp"

namespace obrys::compare {

namespace {

/// A difference in the length that is compensated belongs to an aspect that only the whole programs tell.
constexpr Aspect length_aspect = Aspect::count;
/// Differences of frames that are more than their words.
constexpr auto turn_aspect = static_cast<Aspect>(aspect_count + 1),
               unsaid_turn_aspect = static_cast<Aspect>(aspect_count + 2);

std::string with_axes(const Move& m) {
    std::string out = words(m.step);
    for (const cl::AxisEnd& axis : m.axes) out += ", " + cl::to_text(axis);
    return out;
}

bool is_rigid_tap(const cl::Step& step) {
    const auto* thread = std::get_if<cl::Thread>(&step);
    return thread != nullptr && thread->rigid_tap;
}

std::string tapping(const cl::Spindle& s) {
    return "tapping at " + (std::isnan(s.speed) ? "an unknown speed" : base::shortest(s.speed) + " 1/min");
}

/// Coupled to the way as a tap is, the spindle turns as the sign of the pitch says, whichever way it turned before, or
/// held as some controls want it before a tap.
bool may_tap_alike(const cl::Spindle& a, const cl::Spindle& b) {
    const auto ready = [](const cl::Spindle& s) { return s.direction != 0 || (s.held && !std::isnan(*s.held)); };
    return ready(a) && ready(b) && (a.direction != b.direction || a.held != b.held);
}

/// Zeros that controls call by the same numbers: G54 to G59, SINUMERIK's others, presets, FANUC's G54.1 P; 0: none.
int kind_of_zero(std::uint32_t number) {
    constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 4> kinds{
        {{54, 59}, {505, 599}, {1000, 5399}, {5401, 5700}}};
    for (std::size_t k = 0; k < kinds.size(); ++k)
        if (number >= kinds[k].first && number <= kinds[k].second) return static_cast<int>(k) + 1;
    return 0;
}

/// The machine goes to another place for the same numbers: both zeros are known and differ, or are known by other
/// numbers to one control or to two that number them alike.
bool is_elsewhere(const cl::Datum& a, const cl::Datum& b, const Likeness& like) {
    const geom::Vec3 &p = a.origin, &q = b.origin;
    const auto differ = [&](double x, double y) { return std::abs(x - y) > like.length(); };  // never of NaN
    const bool unknown = !geom::is_finite(p) || !geom::is_finite(q);
    const int kind = kind_of_zero(a.number);
    const bool by_number =
        like.same_control() || (like.is_written_from_a() && kind != 0 && kind == kind_of_zero(b.number));
    return differ(p.x, q.x) || differ(p.y, q.y) || differ(p.z, q.z) || (by_number && unknown && a.number != b.number);
}

/// Both choose, and not the same.
bool turn_otherwise(const cl::PlaneTurn& a, const cl::PlaneTurn& b) {
    return a.side != 0 && b.side != 0 && a.side != b.side;
}

/// One says what the other leaves to its control; of what was written, what the program leaves may be said.
bool may_turn_otherwise(const cl::PlaneTurn& a, const cl::PlaneTurn& b, const Likeness& like) {
    const bool left_to_it = a.side == 0 && like.is_written_from_a();
    return (a.side != b.side && !left_to_it) || a.table_turns != b.table_turns;
}

std::string words(const cl::PlaneTurn& turn) {
    const std::string which = turn.side > 0   ? "the position with its master axis positive"
                              : turn.side < 0 ? "the position with its master axis negative"
                                              : "whichever position the control chooses";
    return which + (turn.table_turns ? ", the table turning rather than the coordinates" : "");
}

}  // namespace

Walk::Walk(const Path& a, const Path& b, const Tolerance& t)
    : like(t),
      sides{Follower(a), Follower(b)},
      items{ItemPairs(Aspect::events, a.events, b.events), ItemPairs(Aspect::cycles, a.cycles, b.cycles),
            ItemPairs(Aspect::compensation, a.contours, b.contours), ItemPairs(Aspect::parts, a.parts, b.parts),
            ItemPairs(Aspect::preparation, a.preparations, b.preparations)} {}

void Walk::compare_items(bool ended) {
    if (std::none_of(items.begin(), items.end(), [](const ItemPairs& pairs) { return pairs.any_waits(); })) return;
    std::array<bool, 2> here{}, at_rest{};
    for (const std::size_t side : {0U, 1U}) {
        const Follower& s = sides[side];
        here[side] = s.has_piece() || s.is_over();
        at_rest[side] = s.path().is_at_rest();
        if (s.is_begun()) continue;  // all has been placed where the move began
        const Path& p = s.path();
        const auto lists = p.items();
        for (std::size_t i = 0; i < items.size(); ++i) {
            const Kept<Item>& list = *lists[i];
            const bool open = !s.ended() && !list.none_left() && list.back().moves == p.moves.size();
            items[i].place(side, s.number(), list.size() - (open ? 1 : 0), pieces_);
        }
    }
    for (std::size_t i = 0; i < items.size(); ++i) items[i].compare(like, {pieces_, here, ended, at_rest}, between_[i]);
}

void Walk::advance() {
    for (;;) {
        compare_items(false);
        const bool a = sides[0].has_piece(), b = sides[1].has_piece();
        if (a && b) {
            if (!compare_piece()) continue;
        } else if (a && sides[1].is_over())
            pass_lone(0);
        else if (b && sides[0].is_over())
            pass_lone(1);
        else
            return;
        ++pieces_;
    }
}

/// Whole moves, each with its counterpart, are most of what there is: nothing is copied for them.
bool Walk::pass_alike() {
    auto& [a, b] = sides;
    if (a.is_begun() || b.is_begun()) return false;
    const Move &m = a.move(), &n = b.move();
    if (!m.axes.empty() || !n.axes.empty() || !like.steps(m.step, n.step)) return false;
    if (m.holding != last_a_ || n.holding != last_b_) compare_holding(m, n);
    a.pass(), b.pass();
    return true;
}

/// It leads no farther than the increments of a control are apart: there it may not move at all.
bool Walk::is_lost_in_increments(const Follower& s) const {
    const Move& m = s.move();
    const Piece p = s.piece();
    const auto* line = std::get_if<cl::Linear>(&p.step);
    const auto* arc = std::get_if<cl::Arc>(&p.step);
    if (like.increment() == 0 || !m.axes.empty() || (line == nullptr && arc == nullptr)) return false;
    if (line != nullptr && (line->seek != cl::Seek::nothing || !like.direction(p.tool, line->axis))) return false;
    if (arc != nullptr && !(std::abs(arc->sweep) < geom::pi)) return false;
    const geom::Vec3 way = cl::position_after(p.from, p.step) - p.from;
    const double most = like.increment() * (1 + 1e-6);
    return std::abs(way.x) <= most && std::abs(way.y) <= most && std::abs(way.z) <= most;
}

/// False: a move was passed over on one side alone, which is lost in the increments of the other.
bool Walk::compare_piece() {
    if (pass_alike()) return true;
    auto& [a, b] = sides;
    const Move &m = a.move(), &n = b.move();
    const Piece p = a.piece(), q = b.piece();
    const bool whole = !a.is_begun() && !b.is_begun();
    const bool axes = (m.axes.empty() && n.axes.empty()) ||
                      (whole && std::is_permutation(m.axes.begin(), m.axes.end(), n.axes.begin(), n.axes.end(), like));
    const bool begins_alike = whole || geom::distance(p.from, q.from) <= 2 * like.length();
    const bool alike = axes && begins_alike && like.steps(p.step, q.step);
    // What stands between the moves stands there, too, where one of them is missing.
    if (!alike && is_lost_in_increments(a)) return a.pass(), false;
    if (!alike && is_lost_in_increments(b)) return b.pass(), false;
    std::optional<Piece> rest_a, rest_b;
    if (!alike && m.axes.empty() && n.axes.empty() && can_be_joined(*m.holding, cl::is_rapid(m.step)) &&
        can_be_joined(*n.holding, cl::is_rapid(n.step))) {
        rest_b = behind(q, p, like);
        if (!rest_b) rest_a = behind(p, q, like);
    }
    if (!whole && !alike && !rest_a && !rest_b) return pass_joined(), true;
    if (!alike && !rest_a && !rest_b) differs(m, n, number());
    if (whole && (rest_a || rest_b)) joined_ = Joined{m, n, number()};
    if (m.holding != last_a_ || n.holding != last_b_) compare_holding(m, n);
    rest_a ? a.pass_to(*rest_a) : a.pass();
    rest_b ? b.pass_to(*rest_b) : b.pass();
    return true;
}

void Walk::add_motion(Found& to, const Move* a, const Move* b, std::size_t at, std::string what) const {
    if (to.has(Aspect::motion)) return;
    to.add(Aspect::motion, a, b, at, std::move(what));
    to.all.back().move_b = sides[1].number();
}

void Walk::differs(const Move& a, const Move& b, std::size_t at) {
    add_motion(found(), &a, &b, at, with_axes(a) + "; in the other " + with_axes(b));
    if (!differs_at_) differs_at_ = at;
}

/// What looked like a beginning was none: the move is another one than that beside which it began.
void Walk::pass_joined() {
    differs(joined_->a, joined_->b, joined_->number);
    for (Follower& s : sides)
        if (s.is_begun()) s.pass();
}

void Walk::pass_lone(std::size_t side) {
    Follower& s = sides[side];
    if (s.is_begun()) return pass_joined();
    if (is_lost_in_increments(s)) return s.pass();
    const Move& move = s.move();
    if (!lone_at_) {
        lone_at_ = number();
        const Move* none = nullptr;
        if (side == 0)
            add_motion(lone_, &move, none, number(), with_axes(move) + ", which the other does not have");
        else
            add_motion(lone_, none, &move, number(), "the other has " + with_axes(move) + ", too");
    }
    s.pass();
}

void Walk::compare_holding(const Move& a, const Move& b) {
    const Holding &h = *a.holding, &k = *b.holding;
    Found& to = found();
    const auto held = [&](Aspect aspect, const auto& x, const auto& y) {
        if (!like(x, y) && !to.has(aspect)) to.add(aspect, &a, &b, number(), words(x) + "; in the other " + words(y));
    };
    const bool feeds = !cl::is_rapid(a.step) && !std::holds_alternative<cl::Thread>(a.step);
    if (feeds) held(Aspect::feed, h.feed, k.feed);
    cl::Spindle other = k.spindle;
    const bool of_tap = (is_rigid_tap(a.step) && is_rigid_tap(b.step)) || (h.leads_out && k.leads_out);
    const bool taps = of_tap && may_tap_alike(h.spindle, other);
    if (taps) other.direction = h.spindle.direction, other.held = h.spindle.held;
    held(Aspect::spindle, h.spindle, other);
    // A spindle that is held before it turns by the tap's own word.
    const bool by_tap = is_rigid_tap(a.step) && is_rigid_tap(b.step);
    if (by_tap && !like.speed(h.spindle.speed, k.spindle.speed) && !to.has(Aspect::spindle))
        to.add(Aspect::spindle, &a, &b, number(), tapping(h.spindle) + "; in the other " + tapping(k.spindle));
    held(Aspect::coolant, h.coolant, k.coolant);
    held(Aspect::tool, h.tool, k.tool);
    const bool as_long =
        h.length == k.length && like.place(h.length_by.value_or(geom::Vec3{}), k.length_by.value_or(geom::Vec3{}));
    const bool counts = sides[0].goes_to_height() && sides[1].goes_to_height();
    if (!as_long && counts)
        to.add(length_aspect, &a, &b, number(), "compensation of the tool's length; in the other another one, or none");
    held(Aspect::datum, h.datum, k.datum);
    if (!to.has(Aspect::motion) && is_elsewhere(h.datum, k.datum, like))
        add_motion(to, &a, &b, number(), words(h.datum) + "; in the other " + words(k.datum));
    held(Aspect::frame, h.frame, k.frame);
    compare_turns(a, b);
    held(Aspect::tolerance, h.tolerance, k.tolerance);
    if (h.path && k.path) held(Aspect::tolerance, *h.path, *k.path);
    if (h.path.has_value() != k.path.has_value())
        to.add(Aspect::tolerance, &a, &b, number(),
               h.path ? words(*h.path) + ", which the other does not say" : "the other says " + words(*k.path));
    const bool all_looked_at = !taps && (feeds || like(h.feed, k.feed)) && (as_long || counts);
    if (all_looked_at) last_a_ = a.holding, last_b_ = b.holding;
}

/// Turned to one plane, the rotary axes may stand in two ways, and the tool's way on the workpiece is the same.
void Walk::compare_turns(const Move& a, const Move& b) {
    const cl::PlaneTurn *t = turn_by_control(a.holding->frame), *u = turn_by_control(b.holding->frame);
    if (t == nullptr || u == nullptr) return;
    const std::string what = "the rotary axes turn to the tilted plane into " + words(*t) + "; in the other into ";
    if (turn_otherwise(*t, *u))
        found().add(turn_aspect, &a, &b, number(), what + words(*u));
    else if (may_turn_otherwise(*t, *u, like))
        found().add(unsaid_turn_aspect, &a, &b, number(), what + words(*u));
}

/// A call of the tool in the spindle changes nothing of it, but the machine may stop for it. What is written leaves out
/// one that has stopped nothing else than the spindle, and adds none.
void Walk::compare_calls(Found& to) const {
    const Path &a = sides[0].path(), &b = sides[1].path();
    const bool more_in_b = b.calls_again > a.calls_again, more_in_a = a.calls_again > b.calls_again;
    const bool is_done = more_in_b && like.is_written_from_a();
    const bool is_said = (more_in_a || more_in_b) && like.same_control() && !like.is_written_from_a();
    if ((!is_done && !is_said) || to.has(Aspect::events)) return;
    const Item& call = more_in_a ? *a.called_again : *b.called_again;
    const auto* none = static_cast<const Item*>(nullptr);
    to.add(Aspect::events, more_in_a ? &call : none, more_in_a ? none : &call, call.moves,
           words(call.step) +
               (more_in_a ? " is called again, in the other it is not as often" : " is called again in the other"));
    to.all.back().is_done = is_done;
}

/// What still turns or flows where both programs are over without saying so: an end that is said stops it.
void Walk::compare_ends(Found& to) const {
    const Path &a = sides[0].path(), &b = sides[1].path();
    if (a.says_its_end() || b.says_its_end()) return;
    const motion::State &s = a.state(), &t = b.state();
    const auto* none = static_cast<const Item*>(nullptr);
    const auto left = [&](Aspect aspect, const auto& x, const auto& y) {
        if (!like(x, y))
            to.add(aspect, none, none, number(),
                   "where the program is over: " + words(x) + "; in the other " + words(y));
    };
    left(Aspect::spindle, s.spindle, t.spindle);
    left(Aspect::coolant, s.coolant, t.coolant);
}

Result Walk::finish() {
    for (Follower& s : sides) s.end();
    advance();
    compare_items(true);
    Result out;
    out.moves_a = sides[0].number(), out.moves_b = sides[1].number();
    Found all = firm_;
    if (!lone_at_) all.add(behind_);
    if (lone_at_) out.looked_to = differs_at_.value_or(*lone_at_);
    if (lone_at_) all.add(lone_);
    // A program of another control that compensates no length at all counts from other zeros, but where it was to do
    // the same, and where it has several tools: no zero is right for all of them.
    const bool in_a = sides[0].path().compensates_length, in_b = sides[1].path().compensates_length;
    const bool alone_in_a = in_a && (like.is_written_from_a() || sides[1].path().has_several_tools);
    const bool alone_in_b = in_b && !like.is_written_from_a() && sides[0].path().has_several_tools;
    const bool both = like.same_control() || (in_a && in_b) || alone_in_a || alone_in_b;
    const bool doubtful = like.is_written_from_a() && !in_a && in_b && sides[0].path().has_several_tools;
    Found sorted;
    for (Difference d : all.all) {
        if (d.aspect == length_aspect && doubtful && !like.same_control()) {
            d.aspect = Aspect::tool;
            out.lengths = std::move(d);
            continue;
        }
        if (d.aspect == unsaid_turn_aspect) {
            d.aspect = Aspect::frame;
            out.turns = std::move(d);
            continue;
        }
        if (d.aspect == turn_aspect) {
            d.aspect = Aspect::frame, d.is_done = true;
            std::erase_if(sorted.all, [](const Difference& said) { return said.aspect == Aspect::frame; });
        }
        if (d.aspect == length_aspect) d.aspect = both ? Aspect::tool : Aspect::datum, d.is_done = is_done(d.aspect);
        // The words for it are other ones on every control, and each begins with another one.
        if (d.aspect == Aspect::tolerance) d.is_done = like.same_control();
        if (!sorted.has(d.aspect)) sorted.all.push_back(std::move(d));
    }
    for (const Found& found : between_) sorted.add(found);
    compare_ends(sorted);
    compare_calls(sorted);
    out.first = std::move(sorted.all);
    return out;
}

}  // namespace obrys::compare
