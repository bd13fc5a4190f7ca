/// Arcs and helices; splines: cubic curves, which controls say by coefficients (SPL) or by control points (G5).

#include <algorithm>
#include <array>
#include <cmath>

#include "cl/spline.hpp"
#include "write/lesser.hpp"
#include "write/writer.hpp"

namespace obrys::write {

namespace {

constexpr double normal_noise = 1e-9;  ///< how far a normal may lie from an axis of the frame

bool is_normal_noise(const geom::Vec3& n) {
    const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    return most > 1 - normal_noise;
}

/// How the words of straight moves write a coordinate.
const NumberStyle& style_of(const Post& post, Value coordinate) {
    static const NumberStyle exact{.decimals = 12};
    for (const Block& block : post[Command::linear])
        for (const Token& t : block)
            if (t.kind == Token::Kind::word && t.value == index_of(coordinate)) return post.styles[t.style];
    return exact;
}

/// A place as the text has it: the control counts the centre of an arc from there.
geom::Vec3 place_as_written(const geom::Vec3& p, const Post& post) {
    return {as_written(p.x, style_of(post, Value::x)), as_written(p.y, style_of(post, Value::y)),
            as_written(p.z, style_of(post, Value::z))};
}

/// In how many of the control's increments the words say it.
double counted(double value, const NumberStyle& style, double increment) {
    return std::round(as_written(value, style) * style.factor / increment);
}

/// Neither compensation nor axes that move along keep its chords from standing there instead.
bool is_free(const cl::Arc& arc, const motion::State& state) {
    return !state.compensation && !arc.rapid && arc.ends.empty();
}

/// `free`: lines may stand there instead.
Note lost_curve(std::string what, bool free) {
    Note lost{Fate::lost, std::move(what), {}, 0, 0};
    lost.may_be_lines = free;
    if (free) lost.remedy = "have it written as straight lines within a tolerance, e.g. --chord 0.005";
    return lost;
}

}  // namespace

/// The control takes both ends for one place, or the centre for its start: it would run a full circle, or none.
bool Writer::is_lost_in_increments(const cl::Arc& arc, const geom::Vec3& start, const geom::Vec3& to,
                                   const geom::Vec3& centre) const {
    const double step = least_arc(post_);
    if (step == 0 || !(std::abs(arc.sweep) < geom::pi)) return false;
    const geom::Vec3 normal = frames_.programmed_direction(arc.normal);
    const auto is_one = [&](const geom::Vec3& a, const geom::Vec3& b) {
        const auto same = [&](double along, double p, double q, Value v) {
            const NumberStyle& style = style_of(post_, v);
            return std::abs(along) > 0.5 || counted(p, style, step) == counted(q, style, step);
        };
        return same(normal.x, a.x, b.x, Value::x) && same(normal.y, a.y, b.y, Value::y) &&
               same(normal.z, a.z, b.z, Value::z);
    };
    return is_one(start, to) || is_one(start, centre);
}

/// Where an arc that the post has to write in pieces ends its pieces: angles from its start, radians, without its own
/// end.
std::vector<double> Writer::cuts_of(const cl::Arc& arc, const geom::Vec3& from) const {
    std::vector<double> cuts;
    const double sweep = std::abs(arc.sweep);
    constexpr double least = 1e-7;  // radians
    if (post_.by_quadrants) {
        const geom::Vec3 centre = frames_.programmed(arc.centre), at = frames_.programmed(from) - centre;
        const geom::Vec3 n = frames_.programmed_direction(arc.normal);
        const bool in_yz = std::abs(n.x) > 0.5, in_zx = std::abs(n.y) > 0.5;
        const double angle = in_yz ? std::atan2(at.z, at.y) : in_zx ? std::atan2(at.x, at.z) : std::atan2(at.y, at.x);
        const double along = n.x + n.y + n.z;
        const bool ccw = (frames_.mirrors() ? -1 : 1) * (along > 0 ? 1 : -1) * arc.sweep > 0;
        const double quadrants = angle / (geom::pi / 2);
        const double first = ccw ? std::floor(quadrants) + 1 - quadrants : quadrants - std::ceil(quadrants) + 1;
        for (double cut = first * geom::pi / 2; cut < sweep - least; cut += geom::pi / 2)
            if (cut > least) cuts.push_back(cut);
    } else if (post_.most_sweep > 0 && geom::degrees(sweep) > post_.most_sweep * (1 + 1e-9)) {
        const double pieces = std::ceil(geom::degrees(sweep) / post_.most_sweep - 1e-9);
        for (double n = 1; n < pieces; ++n) cuts.push_back(sweep * n / pieces);
    }
    return cuts;
}

/// In pieces, where the control's arcs end at quadrants or hold so many degrees.
void Writer::write_cut_arc(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner) {
    const geom::Vec3 rise = geom::dot(arc.to - from, arc.normal) / std::abs(arc.sweep) * arc.normal;
    const geom::Vec3 u = from - arc.centre, v = geom::cross(arc.normal, u);
    geom::Vec3 at = from;
    double done = 0;
    lose_axes();
    for (const double cut : cuts_of(arc, from)) {
        const double angle = std::copysign(cut, arc.sweep);
        cl::Arc piece = arc;
        piece.to = arc.centre + std::cos(angle) * u + std::sin(angle) * v + cut * rise;
        piece.sweep = std::copysign(cut - done, arc.sweep);
        write_turn(piece, at, nullptr);
        at = piece.to;
        done = cut;
    }
    cl::Arc rest = arc;
    rest.sweep = std::copysign(std::abs(arc.sweep) - done, arc.sweep);
    write_turn(rest, at, corner);
}

/// Turn by turn where the control has no word for several.
void Writer::write_arc(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner) {
    end_cycles();
    if (!cuts_of(arc, from).empty()) return write_cut_arc(arc, from, corner);
    const bool rises = std::abs(geom::dot(arc.to - from, arc.normal)) > 1e-9;
    const Template& form = post_[rises && post_.has(Command::helix_cw) ? Command::helix_cw : Command::arc_cw];
    const bool says_turns = says(form, index_of(Value::turns)) || says(form, index_of(Value::more_turns)) ||
                            says(form, index_of(Value::sweep));
    const double turns = std::ceil(std::abs(arc.sweep) / geom::full_turn - 1e-9);
    if (says_turns || !(turns > 1)) return write_turn(arc, from, corner);
    lose_axes();
    const geom::Vec3 rise = geom::dot(arc.to - from, arc.normal) / std::abs(arc.sweep) * geom::full_turn * arc.normal;
    geom::Vec3 at = from;
    double left = arc.sweep;
    for (double n = 1; n < turns; ++n) {
        cl::Arc turn = arc;
        turn.to = at + rise;
        turn.sweep = std::copysign(geom::full_turn, arc.sweep);
        write_turn(turn, at, nullptr);
        at = turn.to;
        left -= turn.sweep;
    }
    cl::Arc rest = arc;
    rest.sweep = left;
    write_turn(rest, at, corner);
}

/// By a point that it passes: in a plane that is none of the frame's, or that the post has no words for.
void Writer::write_arc_in_space(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner) {
    const geom::Vec3 u = from - arc.centre, v = geom::cross(arc.normal, u), rise = arc.to - from;
    const bool flat = std::abs(geom::dot(rise, arc.normal)) <= 1e-9 && std::abs(geom::dot(u, arc.normal)) <= 1e-9;
    constexpr double most = 0.99;  // of a full turn: three points must tell the circle
    const bool sayable = flat && std::abs(arc.sweep) < most * geom::full_turn && compensation_ == std::nullopt &&
                         !cursor_.state().compensation && geom::is_finite(arc.centre) && geom::is_finite(u);
    if (!post_.has(Command::arc_in_space) || !sayable)
        return note_at(lost_curve("an arc in a plane that is none of the frame's", is_free(arc, cursor_.state())));
    const geom::Vec3 to = frames_.programmed(arc.to);
    const geom::Vec3 via = frames_.programmed(arc.centre + std::cos(arc.sweep / 2) * u + std::sin(arc.sweep / 2) * v);
    values_.clear();
    const std::array values{std::pair{Value::x, to.x},      std::pair{Value::y, to.y},
                            std::pair{Value::z, to.z},      std::pair{Value::via_x, via.x},
                            std::pair{Value::via_y, via.y}, std::pair{Value::via_z, via.z}};
    for (const auto& [value, number] : values) values_.set(value, number);
    print_move(Command::arc_in_space, arc.rapid, corner);
}

void Writer::write_turn(const cl::Arc& arc, const geom::Vec3& from, const cl::Programmed* corner) {
    const geom::Vec3 start = frames_.programmed(from), to = frames_.programmed(arc.to),
                     centre = frames_.programmed(arc.centre);
    const geom::Vec3 normal = frames_.programmed_direction(arc.normal);
    if (!is_normal_noise(normal)) return write_arc_in_space(arc, from, corner);
    const bool outside_xy = std::abs(normal.z) < 0.5;
    const bool rises = std::abs(geom::dot(arc.to - from, arc.normal)) > 1e-9;
    const bool by_centre = post_.plane_by_centre && !rises && !is_compensating_;
    if (outside_xy && !by_centre && !post_.has(std::abs(normal.y) > 0.5 ? Command::plane_zx : Command::plane_yz))
        return note_at(lost_curve(std::string(rises ? "a helix" : "an arc") +
                                      " outside of the plane of X and Y: the post has no words for its plane",
                                  is_free(arc, cursor_.state())));
    if (is_lost_in_increments(arc, start, to, centre)) return print_straight(to, arc.rapid, corner, cl::Seek::nothing);
    select_plane(normal);
    const double along = normal.x + normal.y + normal.z;  // but for rounding one of them
    const double sense = (frames_.mirrors() ? -1 : 1) * (along > 0 ? 1 : -1);
    const double sweep = sense * arc.sweep;
    values_.clear();
    const std::array ends{std::pair{Value::x, to.x}, std::pair{Value::y, to.y}, std::pair{Value::z, to.z}};
    for (const auto& [value, number] : ends)
        if (!std::isnan(number)) values_.set(value, number);
    const bool in_yz = std::abs(normal.x) > 0.5, in_zx = std::abs(normal.y) > 0.5, in_xy = !in_yz && !in_zx;
    const geom::Vec3 written = place_as_written(start, post_);
    if (!in_yz) values_.set(Value::i, centre.x - written.x), values_.set(Value::centre_x, centre.x);
    if (!in_zx) values_.set(Value::j, centre.y - written.y), values_.set(Value::centre_y, centre.y);
    if (!in_xy) values_.set(Value::k, centre.z - written.z), values_.set(Value::centre_z, centre.z);
    const double radius = geom::length(start - centre - geom::dot(start - centre, normal) * normal);
    // As controls count it: negative where the arc is more than half a circle.
    if (!std::isnan(radius)) values_.set(Value::radius, std::abs(sweep) > geom::pi * (1 + 1e-9) ? -radius : radius);
    const double turns = std::ceil(std::abs(sweep) / geom::full_turn - 1e-9);
    if (turns > 1) values_.set(Value::turns, turns), values_.set(Value::more_turns, turns - 1);
    values_.set(Value::sweep, geom::degrees(sweep));
    const geom::Vec3 way = to - start;
    const double rise = in_xy ? way.z : in_zx ? way.y : way.x;
    // In its plane it says the two coordinates of that: a third one would name another plane on some controls.
    if (std::abs(rise) <= 1e-9) values_.drop(in_xy ? Value::z : in_zx ? Value::y : Value::x);
    const bool helix = std::abs(rise) > 1e-9 && post_.has(Command::helix_cw);
    const Value lead = in_xy ? Value::lead_z : in_zx ? Value::lead_y : Value::lead_x;
    if (helix) values_.set(lead, std::abs(rise / sweep) * geom::full_turn);
    if (arc.rapid && !post_.has(Command::feed_rapid)) note(Fate::lost, "an arc at rapid: the post has no feed.rapid");
    print_move(
        sweep > 0 ? (helix ? Command::helix_ccw : Command::arc_ccw) : (helix ? Command::helix_cw : Command::arc_cw),
        arc.rapid, corner);
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

namespace {

/// The curve's control points in the frame in force. Bernstein form of u in 0 … 1.
std::array<geom::Vec3, 4> control_points(const cl::Spline& spline, const Frames& frames) {
    const geom::Cubic c = cl::forward(spline);
    const std::array points{c.k0, c.k0 + 1.0 / 3 * c.k1, c.k0 + 2.0 / 3 * c.k1 + 1.0 / 3 * c.k2, spline.to};
    return {frames.programmed(points[0]), frames.programmed(points[1]), frames.programmed(points[2]),
            frames.programmed(points[3])};
}

struct PlaneOfSpline {
    Command command;
    geom::Vec3 normal;
};
constexpr std::array<PlaneOfSpline, 3> planes_of_splines{
    {{Command::spline_xy, {0, 0, 1}}, {Command::spline_zx, {0, 1, 0}}, {Command::spline_yz, {1, 0, 0}}}};

bool lies_across(const std::array<geom::Vec3, 4>& b, const geom::Vec3& normal) {
    constexpr double flat = 1e-6;  // mm
    return std::all_of(b.begin(), b.end(),
                       [&](const geom::Vec3& p) { return std::abs(geom::dot(p - b[0], normal)) <= flat; });
}

void set(Values& values, Value first, const geom::Vec3& v) {
    const auto k = static_cast<std::size_t>(first);
    values.set(first, v.x);
    values.set(static_cast<Value>(k + 1), v.y);
    values.set(static_cast<Value>(k + 2), v.z);
}

}  // namespace

/// Coordinates that nobody knows have no curve.
void Writer::write_spline(const cl::Spline& spline) {
    end_cycles();
    const auto b = control_points(spline, frames_);
    if (!std::all_of(b.begin(), b.end(), [](const geom::Vec3& p) { return geom::is_finite(p); }))
        return note(Fate::lost, "a spline through a place that is not known");
    for (const cl::SplineAxis& axis : spline.axes)
        note(Fate::lost, "axis " + std::string(axis.name.data()) + " along a spline");
    note_direction(spline.axis);
    const auto in_plane = std::find_if(planes_of_splines.begin(), planes_of_splines.end(), [&](const PlaneOfSpline& p) {
        return post_.has(p.command) && lies_across(b, p.normal);
    });
    const bool anywhere = post_.has(Command::spline);
    if (!anywhere && in_plane == planes_of_splines.end()) {
        const bool planes = std::any_of(planes_of_splines.begin(), planes_of_splines.end(),
                                        [&](const PlaneOfSpline& p) { return post_.has(p.command); });
        return note_at(lost_curve(planes ? "a spline that leaves the planes which the post has words for"
                                         : "a spline: the post has no motion.spline",
                                  spline.axes.empty() && spline.ends.empty()));
    }
    if (!anywhere) select_plane(in_plane->normal);
    values_.clear();
    set(values_, Value::x, b[3]);
    set(values_, Value::first_x, b[0]);
    set(values_, Value::second_x, b[1]);
    set(values_, Value::third_x, b[2]);
    set(values_, Value::handle_i, b[1] - b[0]);
    set(values_, Value::handle_p, b[2] - b[3]);
    set(values_, Value::k1_x, 3.0 * (b[2] - b[3]));
    set(values_, Value::k2_x, 3.0 * (b[3] - 2.0 * b[2] + b[1]));
    set(values_, Value::k3_x, b[0] - 3.0 * b[1] + 3.0 * b[2] - b[3]);
    const Command command = anywhere ? Command::spline : in_plane->command;
    print_move(command, false, nullptr);
    printer_.leave(post_[command]);  // the next one says it again
}

}  // namespace obrys::write
