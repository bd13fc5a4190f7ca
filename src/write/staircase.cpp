#include "write/staircase.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "geom/interpolation.hpp"
#include "geom/ridge.hpp"

namespace obrys::write {

namespace {

constexpr double still = 1e-7;        ///< mm: an axis that would move less stands
constexpr double most_steps = 1e6;    ///< of one move
constexpr double level_noise = 1e-9;  ///< of a normal beside an axis

std::array<double, 3> coordinates(const geom::Vec3& v) { return {v.x, v.y, v.z}; }
geom::Vec3 vector_of(const std::array<double, 3>& c) { return {c[0], c[1], c[2]}; }
geom::Vec2 level(const geom::Vec3& v) { return {v.x, v.y}; }

/// Whole steps of a way so long that none is longer than `step`, as the thesis counts them: one more where it divides.
double steps_for(double length, double step) { return step > 0 ? std::floor(length / step) + 1 : NAN; }

/// The fewest parts of which none is more than `most`.
double parts_of_at_most(double length, double most) { return std::max(1.0, std::ceil(length / most * (1 - 1e-12))); }

}  // namespace

void Staircase::lose(const std::string& what) { output_.lost(*now_, what); }

void Staircase::lose_axes() {
    for (const cl::Record& r : std::exchange(axes_, {}))
        lose("axis " + std::string(std::get<cl::Axis>(r.step).name.data()) +
             ", which moves together with others here,");
}

void Staircase::pass(const cl::Record& record) { output_.record(record); }

void Staircase::take(const cl::Record& record) {
    now_ = &record;
    if (cl::is_move(record.step)) {
        const geom::Vec2 from{stands_[0], stands_[1]};
        take_move(record);
        if (!(from == geom::Vec2{stands_[0], stands_[1]})) leaving_.reset();
    } else {
        take_event(record);
    }
    now_ = nullptr;
}

void Staircase::take_event(const cl::Record& record) {
    const cl::Step& step = record.step;
    if (std::holds_alternative<cl::Axis>(step)) return axes_.push_back(record);
    if (std::holds_alternative<cl::MachinePlace>(step)) {
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
    const geom::Vec3 from = cursor_.position().here();
    static_cast<void>(cursor_.take(record));
    const geom::Vec3 to = cursor_.position().here();
    const auto place = std::exchange(place_, std::nullopt);
    const auto moves = moving(to);
    const auto axes = std::count(moves.begin(), moves.end(), true);
    const bool to_home = place && std::get<cl::MachinePlace>(place->step).kind != cl::PlaceKind::coordinates;
    if (to_home || forgets(to)) {
        if (place) pass(*place);
        for (const cl::Record& r : std::exchange(axes_, {})) pass(r);
        pass(record);
        stands_ = coordinates(to);
        return;
    }
    if (axes > 0) lose_axes();
    for (const cl::Record& r : std::exchange(axes_, {})) pass(r);
    rapid_ = cl::is_rapid(record.step);
    counts_ = false;
    if (std::exchange(height_waits_, false) && !std::isnan(stands_[2]) && !(axes == 1 && moves[2])) say_height();
    if (const auto* line = std::get_if<cl::Linear>(&record.step)) return take_line(record, *line, from);
    axis_ = {0, 0, 1};
    if (const auto* arc = std::get_if<cl::Arc>(&record.step)) return take_arc(*arc, from);
    if (std::holds_alternative<cl::Thread>(record.step) && axes <= 1) {
        said_ = moves;
        pass(record);
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
        stands_ = coordinates(line.to);
        return lose("a slope from a place that is not known");
    }
    begin_stairs(sums_.slopes);
    slope(from, line.to, side());
}

Staircase::Side Staircase::side() const {
    const auto& c = cursor_.state().compensation ? cursor_.state().compensation : leaving_;
    if (c && std::abs(c->normal.z) > 0.5) {
        const bool turned = (c->radius < 0) != (c->normal.z < 0);
        const double diameter = c->radius != 0 ? 2 * std::abs(c->radius) : form_.tool_diameter;
        return {true, (c->side == cl::CompensationSide::left) != turned, diameter};
    }
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
    geom::Vec3 at = from;
    for (double k = 1; k <= steps; ++k) {
        const geom::Vec3 next = k < steps ? from + (k / steps) * way : to;
        legs(next, geom::stair_corner(level(at), level(next), side.known ? side.left : true));
        at = next;
    }
    if (touches) sums_.touching += static_cast<std::uint64_t>(steps) + 1;
    if (touches) sums_.ridge = std::max(sums_.ridge, geom::ridge_of_line(length / steps, side.diameter));
    double& farthest = touches ? sums_.beside : sums_.either;
    farthest = std::max(farthest, beside / steps);
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
    const geom::Vec2 from{stands_[0], stands_[1]}, x_first{to.x, from.y};
    const Side on = side();
    legs(to, on.known && !std::isnan(from.x + from.y) ? geom::stair_corner(from, level(to), on.left) : x_first);
}

namespace {

/// The plane of an arc about an axis: its two coordinates, so that the first turns into the second about that axis.
std::optional<std::array<std::size_t, 2>> plane_of(const geom::Vec3& normal) {
    const std::array<double, 3> n{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    for (std::size_t k = 0; k < 3; ++k)
        if (n[k] > 1 - level_noise) return std::array<std::size_t, 2>{(k + 1) % 3, (k + 2) % 3};
    return std::nullopt;
}

double radius_of(const cl::Arc& arc, const geom::Vec3& from) {
    const geom::Vec3 out = from - arc.centre;
    return geom::length(out - geom::dot(out, arc.normal) * arc.normal);
}

/// Angles from the start at which an arc passes from one quadrant to the next, of all its turns.
std::vector<double> quadrant_angles(const cl::Arc& arc, const geom::Vec3& from) {
    const auto plane = *plane_of(arc.normal);
    const auto out = coordinates(from - arc.centre);
    const double quadrants = std::atan2(out[plane[1]], out[plane[0]]) / (geom::pi / 2);
    const bool ccw = (arc.normal.x + arc.normal.y + arc.normal.z) * arc.sweep > 0;
    const double first = ccw ? std::floor(quadrants) + 1 - quadrants : quadrants - std::ceil(quadrants) + 1;
    std::vector<double> angles;
    for (double k = 0; (first + k) * geom::pi / 2 < std::abs(arc.sweep); ++k)
        angles.push_back((first + k) * geom::pi / 2);
    return angles;
}

/// Steps of an arc of which none has a chord that leads farther from it than `deviation` on its way along the axes.
double chord_steps(double sweep, double radius, double deviation) {
    constexpr double share = 1.6;  // half of it the corner over the chord, a fifth of it the arc over the chord
    const double chord = std::min(share * deviation, radius);
    return parts_of_at_most(sweep, 2 * std::asin(chord / (2 * radius)));
}

/// Of a way of two legs: how near it comes to a point, and how far from it.
std::array<double, 2> reach(const geom::Vec2& a, const geom::Vec2& corner, const geom::Vec2& b, const geom::Vec2& c) {
    std::array<double, 2> out{geom::distance(a, c), geom::distance(corner, c)};
    for (const auto& [from, to] : {std::pair{a, corner}, std::pair{corner, b}}) {
        const geom::Vec2 way = to - from;
        const double length = geom::dot(way, way);
        const double t = length > 0 ? std::clamp(geom::dot(c - from, way) / length, 0.0, 1.0) : 0;
        out[0] = std::min(out[0], geom::distance(from + t * way, c));
    }
    return out;
}

}  // namespace

/// Places along an arc, each so many steps behind the last; where it passes quadrants, too, if asked.
std::vector<geom::Vec3> Staircase::places_of(const cl::Arc& arc, const geom::Vec3& from, double steps, bool quadrants) {
    const double sweep = std::abs(arc.sweep);
    std::vector<double> angles = quadrants ? quadrant_angles(arc, from) : std::vector<double>{};
    for (double k = 1; k < steps; ++k) angles.push_back(sweep * k / steps);
    std::sort(angles.begin(), angles.end());
    const geom::PathElement path = geom::Circular{from, arc.to, arc.centre, arc.normal, arc.sweep};
    std::vector<geom::Vec3> out;
    for (const double angle : angles) out.push_back(geom::point_at(path, angle / sweep));
    out.push_back(arc.to);
    return out;
}

void Staircase::take_arc(const cl::Arc& as_it_is, const geom::Vec3& begin) {
    cl::Arc arc = as_it_is;
    geom::Vec3 from = begin;
    const bool no_height = std::isnan(from.z) && std::isnan(arc.to.z) && arc.normal.z != 0;  // and needs none
    if (no_height) from.z = arc.to.z = arc.centre.z = 0;
    const bool known = geom::is_finite(from) && geom::is_finite(arc.centre) && std::isfinite(arc.sweep);
    const double radius = known ? radius_of(arc, from) : NAN;
    const auto plane = plane_of(arc.normal);
    if (!known || !plane || !(radius > still)) {
        stands_ = coordinates(arc.to);
        return lose(plane ? "an arc of which not all is known" : "an arc in a plane that is none of the axes'");
    }
    begin_stairs(sums_.arcs);
    const bool is_level = (*plane)[0] == 0;
    if (no_height) stands_[2] = 0;
    if (!(is_level ? level_arc(arc, from, radius) : standing_arc(arc, from, radius))) stands_ = coordinates(arc.to);
    if (no_height) stands_[2] = NAN;
}

/// In the plane of X and Y, or a helix along Z.
bool Staircase::level_arc(const cl::Arc& arc, const geom::Vec3& from, double radius) {
    const Side on = side();
    const double sweep = std::abs(arc.sweep), tool = on.diameter / 2;
    const bool inner = on.left == (arc.sweep * arc.normal.z > 0);
    const bool touches = on.known && tool > 0;
    const double contour = inner ? radius + tool : std::max(0.0, radius - tool);
    double steps = chord_steps(sweep, radius, form_.deviation);
    if (touches) {
        steps = steps_for(sweep, geom::ridge_step_angle(contour, {on.diameter, form_.roughness}, !inner));
        if (form_.away > 0) steps = std::max(steps, chord_steps(sweep, radius, form_.away));
    }
    const double rise = std::abs(arc.to.z - from.z);
    if (rise > still) steps = std::max(steps, parts_of_at_most(rise, form_.roughness));
    if (!may_run(steps)) return false;
    const bool outward = !on.known || !inner;
    const geom::Vec2 centre = level(arc.centre);
    geom::Vec2 at = level(from);
    double& farthest = touches ? sums_.beside : sums_.either;
    for (const geom::Vec3& place : places_of(arc, from, steps, outward)) {
        const geom::Vec2 next = level(place), a{next.x, at.y}, b{at.x, next.y};
        const bool a_is_farther = geom::distance(a, centre) > geom::distance(b, centre);
        const geom::Vec2 corner = a_is_farther == outward ? a : b;
        for (const double away : reach(at, corner, next, centre))
            farthest = std::max(farthest, std::abs(away - radius));
        legs(place, corner);
        at = next;
        if (touches) ++sums_.touching;
    }
    if (touches) sums_.ridge = std::max(sums_.ridge, geom::ridge_of_arc(contour, sweep / steps, on.diameter, !inner));
    if (rise > still) sums_.above = std::max(sums_.above, rise / steps);
    return true;
}

/// In a plane that holds Z: never below the path.
bool Staircase::standing_arc(const cl::Arc& arc, const geom::Vec3& from, double radius) {
    const double steps = chord_steps(std::abs(arc.sweep), radius, std::min(form_.deviation, form_.roughness / 1.6));
    if (!may_run(steps)) return false;
    geom::Vec3 at = from;
    for (const geom::Vec3& place : places_of(arc, from, steps, true)) {
        sums_.above = std::max(sums_.above, std::abs(place.z - at.z));
        sums_.either =
            std::max(sums_.either, std::min(std::abs(place.z - at.z), geom::distance(level(at), level(place))));
        legs(place, geom::stair_corner(level(at), level(place), true));
        at = place;
    }
    return true;
}

std::string text_of(const StaircaseSums& sums, const StaircaseForm& form) {
    const auto mm = [](double length) { return base::shortest(std::round(length * 1e4) / 1e4) + " mm"; };
    const auto count = [](std::uint64_t n, const std::string& what) {
        return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    };
    std::string out;
    if (sums.slopes + sums.arcs > 0)
        out = "staircases: " + count(sums.slopes, "slope") + " and " + count(sums.arcs, "arc") + " in " +
              count(sums.moves, "move") + " along one axis each";
    if (sums.touching > 0)
        out += "; ridges on the contour at most " + mm(sums.ridge) + " high (asked for: " + mm(form.roughness) +
               "), the tool at most " + mm(sums.beside) + " beside its path, away from the part";
    if (sums.either > 0)
        out += "; where nobody says on which side the part is, at most " + mm(sums.either) + " beside the path";
    if (sums.above > 0) out += "; at most " + mm(sums.above) + " above paths that rise or fall";
    if (sums.rapids > 0) out += (out.empty() ? "" : "; ") + count(sums.rapids, "rapid") + " axis by axis";
    return out;
}

}  // namespace obrys::write
