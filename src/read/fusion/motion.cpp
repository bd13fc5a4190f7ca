/// Straight moves and arcs.

#include <array>
#include <cmath>

#include "base/whole.hpp"
#include "read/fusion/state.hpp"

namespace obrys::read::fusion {

using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

constexpr double same_axis = 1e-7;  ///< single precision of direction cosines
constexpr double nearly_unit = 1e-4;

void tell_vector(State& s, const Place& where, const std::array<Code, 3>& words, const Vec3& v) {
    const double values[3] = {v.x, v.y, v.z};
    for (std::size_t k = 0; k < 3; ++k) s.build.literal(words[k], values[k], where.begin, where.end);
}
constexpr std::array place_words{Code::x, Code::y, Code::z};
constexpr std::array centre_words{Code::i, Code::j, Code::k};
constexpr std::array direction_words{Code::i1, Code::j1, Code::k1};

/// Lathes without Y need no word of it.
void tell_point(State& s, const Place& where, const Vec3& p) {
    const double values[3] = {p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k)
        if (k != 1 || !s.context.turning || p.y != 0)
            s.build.literal(place_words[k], values[k], where.begin, where.end);
}

Side side_of(const Line& line) { return line.has("left") ? Side::left : line.has("right") ? Side::right : Side::none; }

void tell_side(State& s, const Place& where, Side side) {
    s.side = side;
    if (side == Side::none) return s.build.modal(Modal::compensation_off, where.begin, where.end);
    s.build.modal(side == Side::left ? Modal::compensation_left : Modal::compensation_right, where.begin, where.end);
}

/// Compensation that begins, ends or changes with the move at hand; the block is begun.
void take_side(State& s, const Place& where) {
    const Side side = side_of(s.line);
    if (side == s.side) return;
    const std::string_view kind = parameter(s, "operation:compensationType");
    if (side == Side::none && s.side == Side::none) return;
    if (kind == "wear" || kind == "inverse wear") {
        s.side = side;
        return assume(
            s, where,
            "the points of this operation are those of the tool's centre: what the control compensates is the "
            "tool's wear, 0 here");
    }
    if (s.context.turning) {
        s.side = side;
        if (side != Side::none)
            s.build.problem(Code::unsupported, where.begin, where.end,
                            "compensation of a turning tool's nose: where its centre lies is not in the file");
        return;
    }
    tell_side(s, where, side);
}

std::optional<Vec3> point_of(State& s, std::size_t first) {
    const auto n = s.line.numbers(first, 3);
    if (n) return Vec3{(*n)[0], (*n)[1], (*n)[2]};
    fail(s, "a coordinate of this move is no number");
    return std::nullopt;
}

/// Flags of which nothing is known.
bool has_strange_flags(State& s) {
    if (!s.line.has("flags") && !s.line.has("movement")) return false;
    refuse(s, place_of(s.line), "nothing is known of these flags");
    return true;
}

/// The tool's direction, where the tree has another one; the block is begun.
void tell_axis(State& s, const Place& where, const Vec3& axis) {
    if (geom::distance(axis, s.told_axis) < same_axis) return;
    tell_vector(s, where, direction_words, axis);
    s.build.modal(Modal::tool_along, where.begin, where.end);
    s.told_axis = axis;
}

/// The direction that the line says, in the tree's frame; nothing after a complaint.
std::optional<Vec3> axis_of(State& s, bool five_axis) {
    Vec3 axis{0, 0, 1};
    if (five_axis) {
        const auto n = s.line.numbers("axis", 3);
        if (n) axis = {(*n)[0], (*n)[1], (*n)[2]};
        if (!n || !(std::abs(geom::length(axis) - 1) < nearly_unit))
            return fail(s, "the tool's direction has not the length 1"), std::nullopt;
    }
    if (s.direct) axis = geom::apply_direction(s.context.into_setup, axis);
    return (1 / geom::length(axis)) * axis;
}

std::optional<double> feed_of(State& s) {
    const auto feed = s.line.number("feed");
    if (feed && *feed >= 0) return feed;
    fail(s, "the feed of this move is no number that a feed can have");
    return std::nullopt;
}

bool in_section(State& s) {
    if (s.in_section) return true;
    fail(s, "a move stands outside of a section");
    return false;
}

}  // namespace

Vec3 into_frame(const State& s, const Vec3& p) { return s.direct ? geom::apply(s.context.into_setup, p) : p + s.shift; }

void tell_feed(State& s, const Place& where, double feed) {
    if (s.feed && *s.feed == feed && s.told_per_turn == s.feed_per_turn) return;
    s.build.modal(s.feed_per_turn ? Modal::feed_per_rev : Modal::feed_per_minute, where.begin, where.end);
    s.build.literal(Code::feed, feed, where.begin, where.end);
    s.feed = feed;
    s.told_per_turn = s.feed_per_turn;
}

void run_straight(State& s, const Place& where, const Vec3& to, bool rapid) {
    begin_block(s, where);
    s.build.modal(rapid ? Modal::rapid : Modal::linear, where.begin, where.end);
    tell_point(s, where, to);
    end_block(s, where);
    s.at = to;
}

void read_linear(State& s, bool rapid, bool five_axis) {
    const Place where = place_of(s.line);
    if (s.cycle && s.cycle->refused) return;
    if (!in_section(s) || has_strange_flags(s)) return;
    const auto point = point_of(s, 0);
    const auto axis = point ? axis_of(s, five_axis) : std::nullopt;
    const auto feed = rapid || !axis ? std::optional(0.0) : feed_of(s);
    if (!point || !axis || !feed) return s.at.reset();
    const Vec3 to = into_frame(s, *point);
    if (s.cycle) {
        if (five_axis || rapid)
            return refuse(s, where, "only straight moves with the tool along Z are points of a cycle");
        return run_point(s, to);
    }
    if (s.thread_pitch && !rapid) return run_thread(s, where, to);
    begin_block(s, where);
    if (!rapid) tell_feed(s, where, *feed);
    take_side(s, where);
    tell_axis(s, where, *axis);
    s.build.modal(rapid ? Modal::rapid : Modal::linear, where.begin, where.end);
    tell_point(s, where, to);
    end_block(s, where);
    s.at = to;
}

void read_arc(State& s, bool clockwise) {
    const Place where = place_of(s.line);
    if (s.cycle && s.cycle->refused) return;
    if (!in_section(s) || has_strange_flags(s)) return;
    if (s.cycle) return refuse(s, where, "an arc is no point of a cycle");
    const auto point = point_of(s, 0);
    const auto centre = s.line.numbers("centre", 3), normal = s.line.numbers("normal", 3);
    const auto feed = point ? feed_of(s) : std::nullopt;
    if (!point || !feed) return s.at.reset();
    if (!centre || !normal) return fail(s, "centre or normal of this arc is no number"), s.at.reset();
    Vec3 n{(*normal)[0], (*normal)[1], (*normal)[2]};
    if (!(std::abs(geom::length(n) - 1) < nearly_unit)) return fail(s, "the normal of this arc has not the length 1");
    const auto axis = axis_of(s, false);
    if (axis && geom::distance(*axis, s.told_axis) >= same_axis)
        return refuse(s, where, "the tool's axis turns while it runs an arc"), s.at.reset();
    n = (clockwise ? -1 / geom::length(n) : 1 / geom::length(n)) * n;
    if (s.direct) n = geom::apply_direction(s.context.into_setup, n);
    const Vec3 to = into_frame(s, *point);
    begin_block(s, where);
    tell_feed(s, where, *feed);
    take_side(s, where);
    s.build.modal(Modal::arc_about, where.begin, where.end);
    tell_vector(s, where, direction_words, n);
    tell_vector(s, where, centre_words, into_frame(s, {(*centre)[0], (*centre)[1], (*centre)[2]}));
    tell_point(s, where, to);
    end_block(s, where);
    s.at = to;
}

}  // namespace obrys::read::fusion
