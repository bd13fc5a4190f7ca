/// Points, the tool's axis and where the coordinates count from.

#include <algorithm>
#include <cmath>

#include "read/apt/state.hpp"

namespace obrys::read::apt {

using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

constexpr double same_axis = 1e-9;
constexpr Code axis_words[3] = {Code::x, Code::y, Code::z};
constexpr Code vector_words[3] = {Code::i1, Code::j1, Code::k1};

/// Lengths of vectors as CAM systems round them.
constexpr double nearly_unit = 0.01;

std::optional<Vec3> unit_vector(const Vec3& v) {
    const double length = geom::length(v);
    if (!(std::abs(length - 1) < nearly_unit)) return std::nullopt;
    return (1 / length) * v;
}

void tell_coordinates(State& s, const Vec3& to, const Token* tokens) {
    const double values[3] = {to.x, to.y, to.z};
    for (int k = 0; k < 3; ++k) {
        const Token* t = tokens == nullptr ? nullptr : tokens + std::ptrdiff_t{2} * k;
        if (t != nullptr && t->number.value == values[k])
            s.build.literal(axis_words[k], t->number, false, t->begin, t->end);
        else
            s.build.literal(axis_words[k], values[k], s.line.begin, s.line.end);
    }
}

/// The tool's axis, where the tree has another one.
void tell_axis(State& s) {
    if (geom::distance(s.axis, s.told_axis) < same_axis) return;
    const double values[3] = {s.axis.x, s.axis.y, s.axis.z};
    for (int k = 0; k < 3; ++k) s.build.literal(vector_words[k], values[k], s.line.begin, s.line.end);
    s.build.modal(Modal::tool_along, s.line.begin, s.line.end);
    s.told_axis = s.axis;
}

void tell_feed_again(State& s) {
    if (s.feed_told || !s.feed) return;
    tell_feed(s, *s.feed);
    s.feed_told = true;
}

/// A straight move. `tokens`: the coordinates as they stand in the text; null: they do not.
void run_straight(State& s, const Vec3& to, const Token* tokens) {
    begin_block(s);
    if (!s.rapid) tell_feed_again(s);
    tell_axis(s);
    s.build.modal(s.rapid ? Modal::rapid : Modal::linear, s.line.begin, s.line.end);
    tell_coordinates(s, to, tokens);
    end_block(s);
    s.at = to;
    s.moved_with_tool = true;
}

bool axis_changes(const State& s) { return geom::distance(s.axis, s.told_axis) >= same_axis; }

void run_point(State& s, const Vec3& to, const Token* tokens) {
    need_unit(s);
    if (s.cycle && s.rapid) {
        refuse(s, "a point at rapid while a hole cycle is in force: whether it is a hole is not known");
        s.at = to;
    } else if (s.cycle) {
        run_hole(s, to);
    } else if (s.circle && run_on_circle(s, to)) {
        if (axis_changes(s)) refuse(s, "the tool's axis turns while it runs an arc");
    } else {
        run_straight(s, to, tokens);
    }
    s.rapid = false;
}

/// x y z, or x y z i j k.
void run_numbers(State& s, const Arguments& a, const std::vector<double>& n) {
    if (n.size() == 6) {
        const auto axis = unit_vector({n[3], n[4], n[5]});
        if (!axis) return fail(s, a.begin() + 6, "this vector of the tool's axis has not the length 1");
        s.axis = *axis;
    }
    run_point(s, {n[0], n[1], n[2]}, a.begin());
}

}  // namespace

void tell_upright(State& s, const Vec3& to) {
    if (!s.at) return;
    begin_block(s);
    tell_axis(s);
    s.build.modal(Modal::rapid, s.line.begin, s.line.end);
    tell_coordinates(s, {to.x, to.y, s.at->z}, nullptr);
    end_block(s);
    s.at = Vec3{to.x, to.y, s.at->z};
}

namespace {

/// x,y,z, as nearly all points stand.
bool is_plain_point(const Arguments& a) {
    if (a.end() - a.begin() != 5) return false;
    const Token* t = a.begin();
    return t[0].kind == TokenKind::number && t[1].kind == TokenKind::comma && t[2].kind == TokenKind::number &&
           t[3].kind == TokenKind::comma && t[4].kind == TokenKind::number;
}

}  // namespace

void read_point(State& s, const Arguments& a) {
    const Token* t = a.begin();
    if (is_plain_point(a)) return run_point(s, {t[0].number.value, t[2].number.value, t[4].number.value}, t);
    const auto n = numbers(a);
    if (!n) return fail(s, a.begin(), "a point is written as numbers with commas between", "write GOTO/x,y,z");
    if (n->size() == 3 || n->size() == 6) return run_numbers(s, a, *n);
    // Creo writes all points of an arc behind one GOTO.
    if (!s.system.several_points || n->size() % 3 != 0)
        return fail(s, a.begin(), "a point has three coordinates, and three numbers more for the tool's axis");
    for (std::size_t i = 0; i < n->size(); i += 3) run_point(s, {(*n)[i], (*n)[i + 1], (*n)[i + 2]}, nullptr);
}

void read_from(State& s, const Arguments& a) {
    assume(s, s.line.begin, s.line.end,
           "FROM says where the tool stands: it is taken to come there at rapid, and no postprocessor need write that");
    s.rapid = true;
    read_point(s, a);
}

void read_delta(State& s, const Arguments& a) {
    const auto n = numbers(a);
    if (!n || (n->size() != 1 && n->size() != 3 && n->size() != 6))
        return fail(s, a.begin(), "GODLTA wants one number, along the tool, or three");
    if (!s.at) {
        s.rapid = false;
        return refuse(s, "where it begins is not known: no point stands before it");
    }
    if (s.cycle) return refuse(s, "a point by its distance, while a cycle is in force");
    const Vec3 by = n->size() == 1 ? (*n)[0] * s.axis : Vec3{(*n)[0], (*n)[1], (*n)[2]};
    if (n->size() == 6) {
        const auto axis = unit_vector({(*n)[3], (*n)[4], (*n)[5]});
        if (!axis) return fail(s, a.begin() + 6, "this vector of the tool's axis has not the length 1");
        s.axis = *axis;
    }
    run_point(s, *s.at + by, nullptr);
}

void read_direction(State& s, const Arguments& a, bool of_tool) {
    const auto n = numbers(a);
    if (!n || n->size() != 3) return fail(s, a.begin(), "a direction has three numbers");
    const Vec3 v{(*n)[0], (*n)[1], (*n)[2]};
    if (!(geom::length(v) > 0)) return fail(s, a.begin(), "this vector has no direction");
    const Vec3 unit = (1 / geom::length(v)) * v;
    if (!of_tool)
        s.along = unit;
    else
        s.axis = unit;
}

void read_shift(State& s, const Arguments& a, bool origin) {
    const auto n = numbers(a);
    if (!n || n->size() > 3) return refuse(s, "only a shift by numbers is run");
    need_unit(s);
    program::FrameCall call;
    call.op = program::FrameOp::shift;
    s.build.unit().frames.push_back(call);
    s.build.begin_block();
    s.build.control(program::StatementKind::frame, s.build.unit().frames.size() - 1, s.line.begin, s.line.end);
    for (std::size_t k = 0; k < n->size(); ++k)
        s.build.literal(axis_words[k], origin ? -(*n)[k] : (*n)[k], s.line.begin, s.line.end);
    end_block(s);
    assume(s, s.line.begin, s.line.end,
           origin ? "ORIGIN is taken as the machine's zero: points behind it count from there"
                  : "TRANS is taken to be added to the points behind it");
}

void read_system(State& s, const Arguments& a) {
    const auto n = numbers(a);
    if (!s.system.system_aims_tool) return refuse(s, "the system in which points are written is another one behind it");
    if (!n || n->size() != 12) return fail(s, a.begin(), "CSYS wants twelve numbers");
    const auto axis = unit_vector({(*n)[2], (*n)[6], (*n)[10]});
    if (!axis) return fail(s, a.begin(), "the third column of CSYS is no vector of length 1");
    s.axis = *axis;
    s.build.ignored("CSYS", s.line.begin, s.line.end);
}

void read_placement(State& s, const Arguments& a) {
    const auto n = numbers(a);
    if (!n || (n->size() != 9 && n->size() != 12)) return fail(s, a.begin(), "MSYS wants nine numbers");
    place_part(s, *n);
    s.build.ignored("MSYS", s.line.begin, s.line.end);
}

void place_part(State& s, const std::vector<double>& n) {
    std::array<double, 12> place{};
    std::copy(n.begin(), n.end(), place.begin());
    if (s.placement && *s.placement != place)
        return refuse(s, "the machine's zero lies elsewhere from here on, and how the part then lies is not followed");
    s.placement = place;
}

}  // namespace obrys::read::apt
