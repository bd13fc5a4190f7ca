/// Arcs: CIRCLE/centre, axis before the points of the arc, and APT's own form with the line at which it ends.

#include <cmath>

#include "base/whole.hpp"
#include "read/apt/state.hpp"

namespace obrys::read::apt {

using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

constexpr double on_circle = 0.01;  ///< of a text's unit: CAM systems round points and radii
constexpr double same_point = 1e-6;

Vec3 across(const Vec3& v, const Vec3& axis) { return v - geom::dot(v, axis) * axis; }

void emit_arc(State& s, const Circle& c, const Vec3& to, int turns) {
    begin_block(s);
    if (!s.feed_told && s.feed) {
        tell_feed(s, *s.feed);
        s.feed_told = true;
    }
    if (c.rapid) {
        assume(s, c.begin, c.end,
               "an arc behind RAPID is run at rapid; what a postprocessor makes of it differs: an arc at a high feed, "
               "or a straight move",
               "let the CAM system write FEDRAT before the arc");
        s.build.modal(Modal::rapid_block, s.line.begin, s.line.end);
    }
    s.build.modal(Modal::arc_about, s.line.begin, s.line.end);
    const std::pair<Code, double> words[] = {{Code::x, to.x},       {Code::y, to.y},       {Code::z, to.z},
                                             {Code::i, c.centre.x}, {Code::j, c.centre.y}, {Code::k, c.centre.z},
                                             {Code::i1, c.axis.x},  {Code::j1, c.axis.y},  {Code::k1, c.axis.z}};
    for (const auto& [code, value] : words) s.build.literal(code, value, s.line.begin, s.line.end);
    if (turns > 0) s.build.literal(Code::turns, turns, s.line.begin, s.line.end);
    end_block(s);
    s.at = to;
    s.moved_with_tool = true;
}

/// TIMES behind the numbers of CIRCLE; 0: it is not written. Nothing after a complaint.
std::optional<int> turns_of(State& s, const Arguments& a, std::size_t numbers_before) {
    const Token* t = a.begin() + 2 * numbers_before;
    if (t >= a.end()) return 0;
    const bool form = t + 2 < a.end() + 0 && upper_of(*t) == "TIMES" && t[2].kind == TokenKind::number;
    const auto n = form ? base::whole<int>(t[2].number.value, 1, 999) : std::nullopt;
    if (!n || t + 3 != a.end()) {
        fail(s, t, "behind the numbers of CIRCLE nothing but TIMES and a whole number of turns is read");
        return std::nullopt;
    }
    return *n;
}

/// The numbers at the begin of the arguments.
std::vector<double> leading_numbers(const Arguments& a) {
    std::vector<double> n;
    for (const Token* t = a.begin(); t < a.end() && t->kind == TokenKind::number; t += 2) {
        n.push_back(t->number.value);
        if (t + 1 < a.end() && t[1].kind != TokenKind::comma) break;
    }
    return n;
}

/// The arc ends where a turn is whole.
bool ends_where_it_began(const State& s, const Circle& c, const Vec3& to) {
    return s.at && geom::length(across(to - *s.at, c.axis)) < same_point;
}

bool lies_on(const Circle& c, const Vec3& p, double radius) {
    return std::abs(geom::length(across(p - c.centre, c.axis)) - radius) < on_circle;
}

}  // namespace

void drop_circle(State& s) {
    if (!s.circle) return;
    const Circle c = *s.circle;
    s.circle.reset();
    if (c.begun) return;
    begin_block(s);
    s.build.problem(Code::unsupported, c.begin, c.end, "no point follows at which this arc would end");
    end_block(s);
}

void read_circle(State& s, const Arguments& a) {
    drop_circle(s);
    if (s.cycle)
        return refuse(s,
                      "an arc while a hole cycle is in force (there is no CYCLE/OFF before it): whether its points are "
                      "holes is not known");
    const std::vector<double> n = leading_numbers(a);
    if (n.size() < 6)
        return fail(s, a.begin(),
                    "CIRCLE wants centre and axis, six numbers: the sense of the arc is not known without",
                    "write CIRCLE/x,y,z,i,j,k,r");
    // NX and CAMplete write four more: tolerances and the tool, or the angle of the arc.
    constexpr std::size_t with_radius = 7, with_tolerances = 11;
    if (n.size() > with_radius && n.size() != with_tolerances)
        return fail(s, a.begin() + 2 * with_radius, "what the numbers behind the radius of CIRCLE say is not known");
    const auto turns = turns_of(s, a, n.size());
    if (!turns) return;
    Circle c;
    c.centre = {n[0], n[1], n[2]};
    const Vec3 axis{n[3], n[4], n[5]};
    if (!(std::abs(geom::length(axis) - 1) < on_circle))
        return fail(s, a.begin() + 6, "the axis of this circle has not the length 1");
    c.axis = (s.system.sense / geom::length(axis)) * axis;
    c.radius = n.size() > 6 ? n[6] : 0;
    c.turns = *turns;
    c.begin = s.line.begin;
    c.end = s.line.end;
    if (c.radius < 0) return fail(s, a.begin() + 12, "the radius of this circle is negative");
    s.circle = c;
}

bool run_on_circle(State& s, const Vec3& to) {
    Circle& c = *s.circle;
    const double radius = s.at ? geom::length(across(*s.at - c.centre, c.axis)) : c.radius;
    if (!c.begun) c.rapid = s.rapid;
    // A rapid, or a way along the axis, goes away from the arc.
    if (c.begun && (s.rapid || !lies_on(c, to, radius) ||
                    ends_where_it_began(s, c, to))) {  // the arc was over with the point before
        s.circle.reset();
        return false;
    }
    const Circle arc = c;
    if (!s.system.several_points) s.circle.reset();
    if (!arc.begun && s.circle) s.circle->begun = true;
    int turns = 0;
    if (arc.turns > 0) {
        if (!ends_where_it_began(s, arc, to)) {
            refuse(s,
                   "a helix of TIMES turns that does not end over its start: how far it turns is not known for "
                   "certain");
            s.at = to;
            return true;
        }
        turns = arc.turns - 1;
    } else if (!s.system.same_point_is_circle && ends_where_it_began(s, arc, to)) {
        return false;
    }
    if (arc.radius > 0 && s.at && std::abs(radius - arc.radius) > on_circle * 10)
        assume(s, arc.begin, arc.end,
               "the radius of a circle differs from the distance of its start: the centre is what counts here");
    emit_arc(s, arc, to, turns);
    return true;
}

namespace {

/// (CIRCLE/x,y,z,r),ON,[2,INTOF,](LINE/x,y,z,x,y,z)
struct AptArc {
    std::vector<double> circle, line;
    bool complete = false;
};
AptArc apt_arc_of(const Line& line) {
    AptArc arc;
    std::vector<double>* to = nullptr;
    bool foreign = false;
    for (const Token& t : line.tokens) {
        if (t.kind == TokenKind::number && to != nullptr) to->push_back(t.number.value);
        if (t.kind == TokenKind::close) to = nullptr;
        if (t.kind != TokenKind::word) continue;
        const std::string word = upper_of(t);
        if (word == "CIRCLE")
            to = &arc.circle;
        else if (word == "LINE")
            to = &arc.line;
        else
            foreign = foreign || (word != "TLON" && word != "GOFWD" && word != "ON" && word != "INTOF");
    }
    arc.complete = !foreign && arc.circle.size() == 4 && arc.line.size() == 6;
    return arc;
}

}  // namespace

void read_apt_arc(State& s) {
    const AptArc arc = apt_arc_of(s.line);
    if (!arc.complete)
        return refuse(s,
                      "of APT's own motions only TLON,GOFWD/(CIRCLE/x,y,z,r),ON,(LINE/x,y,z,x,y,z) is cutter "
                      "locations; the rest is a part program's");
    drop_circle(s);
    if (s.rapid) {
        s.rapid = false;
        return refuse(s, "RAPID before it: whether the arc is at rapid is not known");
    }
    if (!s.at || !s.along) return refuse(s, "where and in which direction it begins is not said: GOTO and INDIRV");
    need_unit(s);
    Circle c;
    c.centre = {arc.circle[0], arc.circle[1], arc.circle[2]};
    c.begin = s.line.begin;
    c.end = s.line.end;
    const Vec3 to{arc.line[3], arc.line[4], arc.line[5]};
    const Vec3 normal = geom::cross(*s.at - c.centre, *s.along);
    const double radius = arc.circle[3], length = geom::length(normal);
    const bool from_centre = geom::distance({arc.line[0], arc.line[1], arc.line[2]}, c.centre) < on_circle;
    if (!(length > 0) || !from_centre || std::abs(geom::distance(to, c.centre) - radius) > on_circle)
        return refuse(s, "the line at which this arc ends does not lead from its centre to a point of it");
    c.axis = (1 / length) * normal;
    emit_arc(s, c, to, 0);
    s.rapid = false;
}

}  // namespace obrys::read::apt
