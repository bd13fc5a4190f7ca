#include "write/staircase.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/ridge.hpp"
#include "write/staircase_steps.hpp"

namespace obrys::write {

void Staircase::lose(const std::string& what) { output_.lost(*now_, what); }

void Staircase::lose_axes() {
    for (const cl::AxisEnd& end : std::exchange(axes_, {}))
        lose("axis " + std::string(end.name.data()) + ", which moves together with others here,");
}

void Staircase::pass(const cl::Record& record) { output_.record(record); }

/// A contour waits for its end: then it is known what stands beside each part of it.
void Staircase::take(const cl::Record& record) {
    const auto* begin = std::get_if<cl::CompensationBegin>(&record.step);
    if (!waits_ && (begin == nullptr || !acts(*begin))) return run(record);
    waits_ = true;
    waiting_.push_back(record);
    constexpr std::size_t most_waiting = 50'000;
    if (std::holds_alternative<cl::CompensationEnd>(record.step) || waiting_.size() >= most_waiting) finish();
}

void Staircase::finish() {
    if (!std::exchange(waits_, false)) return;
    watch_contour();
    const std::vector<cl::Record> records = std::exchange(waiting_, {});
    for (const cl::Record& record : records) run(record);
}

void Staircase::run(const cl::Record& record) {
    now_ = &record;
    if (cl::is_move(record.step)) {
        const geom::Vec2 from{stands_[0], stands_[1]};
        take_move(record);
        const bool stood = from == geom::Vec2{stands_[0], stands_[1]};
        if (!stood && leaving_) leaving_.reset(), walls_.reset();
    } else {
        take_event(record);
    }
    now_ = nullptr;
}

/// The walls of what waits. The ways onto the contour and off it have none.
void Staircase::watch_contour() {
    const auto& begin = std::get<cl::CompensationBegin>(waiting_.front().step);
    const Side on = side_of(begin);
    walls_.reset();
    if (!(on.diameter > 0)) return;
    walls_.emplace(on.diameter / 2);
    motion::Cursor cursor = cursor_;
    bool approaches = true;
    for (const cl::Record& record : waiting_) {
        const geom::Vec3 from = cursor.position().here();
        static_cast<void>(cursor.take(record));
        if (!cl::is_move(record.step)) continue;
        const bool leads = cursor.state().leads;
        if (!leads && !approaches) add_wall(*walls_, record, from, on);
        approaches = false;
    }
    if (walls_->is_full()) output_.lost(waiting_.front(), "walls of a contour too long to be watched");
}

/// Of a move along the contour: what the tool touches, its radius beside the way.
void Staircase::add_wall(Walls& walls, const cl::Record& move, const geom::Vec3& from, const Side& on) const {
    const double tool = on.diameter / 2;
    const auto* line = std::get_if<cl::Linear>(&move.step);
    const auto* arc = std::get_if<cl::Arc>(&move.step);
    const geom::Vec2 a = level(from);
    if (line != nullptr) {
        const geom::Vec2 b = level(line->to), way = b - a;
        const double length = geom::length(way);
        if (!(length > still)) return;  // not known, or no way
        const geom::Vec2 out = (on.left ? -tool : tool) / length * geom::left_of(way);
        walls.add_line(a + out, b + out);
    } else if (arc != nullptr && std::abs(arc->normal.z) > 0.5 && geom::is_finite(arc->centre)) {
        const geom::Vec2 centre = level(arc->centre), spoke = a - centre;
        const double sweep = arc->sweep * (arc->normal.z > 0 ? 1 : -1), radius = geom::length(spoke);
        const bool inner = on.left == (sweep > 0);
        if (!std::isfinite(radius) || !std::isfinite(sweep)) return;
        walls.add_arc(centre, inner ? radius + tool : std::max(0.0, radius - tool), std::atan2(spoke.y, spoke.x),
                      sweep);
    }
}

/// From one place of a way to another, and halved where that would cut into another part of the contour.
void Staircase::step(const Way& way, double from, double to, int halved) {
    constexpr int most_halved = 12;
    const geom::Vec3 a = way.at(from), b = way.at(to);
    const geom::Vec2 corner = way.corner(level(a), level(b));
    const double cut = walls_ ? walls_->cut(level(a), corner, level(b)) : 0;
    if (cut > wall_noise && halved < most_halved) {
        step(way, from, (from + to) / 2, halved + 1);
        return step(way, (from + to) / 2, to, halved + 1);
    }
    if (cut > wall_noise) sums_.into = std::max(sums_.into, cut);
    double& farthest = way.touches ? sums_.beside : sums_.either;
    farthest = std::max(farthest, way.beside(level(a), corner, level(b)));
    if (way.touches) ++sums_.touching;
    legs(b, corner);
}

void Staircase::take_event(const cl::Record& record) {
    const cl::Step& step = record.step;
    if (const auto* place = std::get_if<cl::MachinePlace>(&step)) {
        if (place->kind == cl::PlaceKind::frame) return;  // each axis is said alone here
        place_ = record;
        return;
    }
    if (std::holds_alternative<cl::CompensationEnd>(step)) leaving_ = cursor_.state().compensation;
    static_cast<void>(cursor_.take(record));
    if (std::holds_alternative<cl::CompensationBegin>(step))
        output_.expanded(record, "radius compensation: the tool's path along the contour");
    const bool of_compensation =
        std::holds_alternative<cl::CompensationBegin>(step) || std::holds_alternative<cl::CompensationEnd>(step) ||
        std::holds_alternative<cl::Programmed>(step) || std::holds_alternative<cl::LeadBegin>(step) ||
        std::holds_alternative<cl::LeadEnd>(step);
    if (of_compensation) return;
    if (std::holds_alternative<cl::Datum>(step)) stands_ = coordinates(cursor_.position().here());
    height_waits_ = height_waits_ || std::holds_alternative<cl::ToolChange>(step);
    pass(record);
}

std::array<bool, 3> Staircase::moving(const geom::Vec3& to) const {
    const auto there = coordinates(to);
    std::array<bool, 3> out{};
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = !std::isnan(there[k]) && !(std::abs(held(there[k]) - held(stands_[k])) <= still);
    return out;
}

/// As near as the word comes to it.
double Staircase::held(double coordinate) const {
    return form_.units > 0 ? std::round(coordinate * form_.units) / form_.units : coordinate;
}

void Staircase::take_move(const cl::Record& record) {
    axes_ = *cl::ends_of(record.step);
    const geom::Vec3 from = cursor_.position().here();
    static_cast<void>(cursor_.take(record));
    const geom::Vec3 to = cursor_.position().here();
    const auto place = std::exchange(place_, std::nullopt);
    const auto moves = moving(to);
    const auto axes = std::count(moves.begin(), moves.end(), true);
    rapid_ = cl::is_rapid(record.step);
    counts_ = false;
    if (forgets(to) || (place && !geom::is_finite(to))) return leave_known(record, place, to);
    const auto kind = place ? std::get<cl::MachinePlace>(place->step).kind : cl::PlaceKind::coordinates;
    const bool to_home = kind == cl::PlaceKind::home || kind == cl::PlaceKind::fixed;
    if (to_home && axes <= 1) pass(*place);
    if (axes > 0) lose_axes();
    if (std::exchange(height_waits_, false) && !std::isnan(stands_[2]) && !(axes == 1 && moves[2])) say_height();
    if (const auto* line = std::get_if<cl::Linear>(&record.step)) return take_line(record, *line, from);
    axis_ = {0, 0, 1};
    if (const auto* arc = std::get_if<cl::Arc>(&record.step)) return take_arc(*arc, from);
    if (std::holds_alternative<cl::Thread>(record.step) && axes <= 1) {
        cl::Record along = record;
        *cl::ends_of(along.step) = std::exchange(axes_, {});
        said_ = moves;
        pass(along);
        said_.reset();
        stands_ = coordinates(to);
        return;
    }
    lose(std::holds_alternative<cl::Thread>(record.step) ? "a thread along several axes" : "a spline");
    stands_ = coordinates(to);
}

void Staircase::take_line(const cl::Record& record, const cl::Linear& line, const geom::Vec3& from) {
    axis_ = line.axis;
    const auto moves = moving(line.to);
    if (std::count(moves.begin(), moves.end(), true) <= 1) {
        cl::Record along = record;
        auto& out = std::get<cl::Linear>(along.step);
        const auto there = coordinates(line.to);
        for (std::size_t k = 0; k < 3; ++k)
            if (moves[k] || std::isnan(stands_[k])) stands_[k] = held(there[k]);
        out.to = vector_of(stands_);
        out.ends = std::exchange(axes_, {});
        said_ = moves;
        pass(along);
        said_.reset();
        return;
    }
    if (line.seek != cl::Seek::nothing) {
        stands_ = coordinates(line.to);
        return lose("a probing move along several axes");
    }
    if (line.rapid) return rapid_legs(line.to);
    const auto at = coordinates(from);
    if ((moves[0] && std::isnan(at[0])) || (moves[1] && std::isnan(at[1])) || (moves[2] && std::isnan(at[2]))) {
        output_.expanded(record, "a move from a place that is not known, axis by axis,");
        return rapid_legs(line.to);
    }
    begin_stairs(sums_.slopes);
    slope(from, line.to, side());
}

Staircase::Side Staircase::side_of(const cl::CompensationBegin& c) const {
    const bool turned = (c.radius < 0) != (c.normal.z < 0);
    const double diameter = c.radius != 0 ? 2 * std::abs(c.radius) : form_.tool_diameter;
    return {true, (c.side == cl::CompensationSide::left) != turned, diameter};
}

Staircase::Side Staircase::side() const {
    const auto& c = cursor_.state().compensation ? cursor_.state().compensation : leaving_;
    if (c && acts(*c)) return side_of(*c);
    return {form_.part != StaircaseForm::Part::not_known, form_.part == StaircaseForm::Part::right,
            form_.tool_diameter};
}

void Staircase::begin_stairs(std::uint64_t& counter) {
    counts_ = true;
    if (sums_.slopes + sums_.arcs == 0)
        output_.expanded(*now_, "the first slope or arc, which becomes a staircase as those that follow,");
    ++counter;
    if (!rapid_ && cursor_.state().feed.mode == cl::FeedMode::inverse_time)
        lose("a feed in inverse time, of a move that becomes several,");
}

bool Staircase::may_run(double steps) {
    if (steps <= most_steps) return true;
    lose("a move that would be more than 1000000 steps");
    return false;
}

/// From one place to the next in as many equal steps as it needs: the tool touches the contour behind each of them.
void Staircase::slope(const geom::Vec3& from, const geom::Vec3& to, const Side& side) {
    const geom::Vec3 way = to - from;
    const double length = geom::length(level(way));
    const double beside = length > 0 ? std::abs(way.x * way.y) / length : 0;  // of a single step's corner
    const bool touches = side.known && side.diameter > 0 && beside > still;
    double steps = 1;
    if (touches) {
        steps = steps_for(length, 2 * geom::half_ridge_step({side.diameter, form_.roughness}));
        if (form_.away > 0) steps = std::max(steps, parts_of_at_most(beside, form_.away));
    } else {
        steps = parts_of_at_most(beside, form_.deviation);
    }
    const double rise = std::isnan(way.z) ? 0 : std::abs(way.z);
    steps = std::max(steps, parts_of_at_most(rise, form_.roughness));
    if (!may_run(steps)) {
        stands_ = coordinates(to);
        return;
    }
    const Way stairs{[&](double t) { return t < 1 ? from + t * way : to; },
                     [&](geom::Vec2 a, geom::Vec2 b) { return geom::stair_corner(a, b, !side.known || side.left); },
                     [](geom::Vec2 a, geom::Vec2, geom::Vec2 b) {
                         const geom::Vec2 chord = b - a;
                         const double width = geom::length(chord);
                         return width > 0 ? std::abs(chord.x * chord.y) / width : 0;
                     },
                     touches};
    for (double k = 0; k < steps; ++k) step(stairs, k / steps, (k + 1) / steps);
    if (touches) ++sums_.touching;
    if (touches) sums_.ridge = std::max(sums_.ridge, geom::ridge_of_line(length / steps, side.diameter));
    if (rise > still) sums_.above = std::max(sums_.above, rise / steps);
}

void Staircase::go(std::size_t axis, double to) {
    const double there = held(to);
    if (std::isnan(there) || std::abs(there - stands_[axis]) <= still) return;
    stands_[axis] = there;
    if (counts_) ++sums_.moves;
    said_ = std::array<bool, 3>{};
    (*said_)[axis] = true;
    pass({cl::Linear{vector_of(stands_), axis_, rapid_}, now_->from, now_->stack});
    said_.reset();
}

/// Another tool: Z is said anew, since it stands elsewhere for the control.
void Staircase::say_height() {
    said_ = std::array<bool, 3>{false, false, true};
    pass({cl::Linear{vector_of(stands_), {0, 0, 1}, true}, now_->from, now_->stack});
    said_.reset();
}

/// A move to where nobody knows: what is known of it is made, the control's own way to a place of the machine is its
/// own.
void Staircase::leave_known(const cl::Record& record, const std::optional<cl::Record>& place, const geom::Vec3& to) {
    const auto there = coordinates(to);
    if (place) {
        pass(*place);
        said_ = std::array<bool, 3>{};
        pass(record);
        said_.reset();
    } else {
        lose_axes();
        lose("a move to a coordinate that is not known");
        rapid_legs(to);
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (std::isnan(there[k])) stands_[k] = NAN;
}

/// It leads to a coordinate that is not known, from one that is.
bool Staircase::forgets(const geom::Vec3& to) const {
    const auto there = coordinates(to);
    for (std::size_t k = 0; k < 3; ++k)
        if (std::isnan(there[k]) && !std::isnan(stands_[k])) return true;
    return false;
}

/// By a corner in the plane of X and Y; up before that, down behind it, so that nothing runs below the way.
void Staircase::legs(const geom::Vec3& to, const geom::Vec2& corner) {
    if (to.z > stands_[2]) go(2, to.z);
    const bool y_first = std::abs(held(corner.x) - stands_[0]) <= still;
    go(y_first ? 1 : 0, y_first ? to.y : to.x);
    go(y_first ? 0 : 1, y_first ? to.x : to.y);
    go(2, to.z);
}

/// A way that needs no straightness: axis by axis, away from a contour that is there, else X before Y.
void Staircase::rapid_legs(const geom::Vec3& to) {
    ++sums_.rapids;
    const geom::Vec2 from{stands_[0], stands_[1]}, end = level(to), x_first{end.x, from.y}, y_first{from.x, end.y};
    const Side on = side();
    if (!on.known || std::isnan(from.x + from.y + end.x + end.y)) return legs(to, x_first);
    const geom::Vec2 free = geom::stair_corner(from, end, on.left), other = free == x_first ? y_first : x_first;
    const auto cuts = [&](const geom::Vec2& corner) { return walls_ && walls_->cut(from, corner, end) > wall_noise; };
    if (cuts(free) && cuts(other)) return slope(vector_of(stands_), to, on);
    legs(to, cuts(free) ? other : free);
}

}  // namespace obrys::write
