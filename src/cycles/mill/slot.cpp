/// Slots. Source: HEIDENHAIN iTNC 530 cycle programming (253, 254, 210, 211); 253 also TNC7 basic, cycle 253. The
/// meaning of the position of 254 and the reciprocating plunge of 210 and 211 are from memory of that manual.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "cycles/levels.hpp"
#include "cycles/mill/families.hpp"
#include "cycles/mill/pocket_data.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {

namespace {

using geom::Contour;
using geom::Vec2;

constexpr std::string_view slot_rings =
    "the path in a slot wider than the tool: equidistant rings from the inside outwards, one tool radius apart";

/// Centre of a slot along u whose left end (1), left arc's centre (2), right arc's centre (3) or right end (4) is
/// called.
double centre_along(int position, double length, double width) {
    switch (position) {
        case 1: return length / 2;
        case 2: return (length - width) / 2;
        case 3: return -(length - width) / 2;
        case 4: return -length / 2;
        default: return 0;
    }
}

/// A slot along an arc about its origin, from one end of its middle line on the u axis over `sweep`.
struct BentSlot {
    Vec2 centre;
    double radius = 0, width = 0, from = 0, sweep = 0;

    [[nodiscard]] Contour middle() const {
        const auto at = [&](double w) { return Vec2{radius * std::cos(w), radius * std::sin(w)}; };
        const double bulge = std::tan(sweep / 8);
        return {{{at(0), bulge}, {at(sweep / 2), bulge}, {at(sweep)}}, false};
    }
    [[nodiscard]] geom::Region region() const { return round_slot(radius, width, 0, sweep); }
    [[nodiscard]] Placement where(double more = 0) const { return {from + more, centre}; }
};

template <class Cycle>
BentSlot bent_of(Course& c, const Cycle& d) {
    BentSlot r;
    r.radius = d.pitch_circle / 2;
    r.width = d.width;
    r.sweep = geom::radians(d.angle_length);
    r.from = geom::radians(d.start_angle);
    if (r.sweep == 0) c.fault(Role::angle_length, "the angular length must not be 0");
    if (std::abs(r.sweep) > 2 * geom::pi + 1e-9)
        c.fault(Role::angle_length, "the angular length is more than a full circle");
    if (r.width / 2 > r.radius) c.fault(Role::width, "the slot is wider than its pitch circle");
    return r;
}

/// Old forms: to and fro along the middle line, deeper with every pass; then the wall.
struct Reciprocation {
    Heights h;
    double radius = 0, mill = 0, plunge = 0, infeed = 0, finish_infeed = 0;
    int operation = 0;
};

Reciprocation reciprocation_of(Course& c, const ReciprocatingMilling& d, const Situation& s) {
    Reciprocation r;
    r.h = heights_of(d);
    r.radius = milling_radius(c, s);
    c.known(s.at.z, "the tool's height");
    r.mill = d.feed_mill;
    r.plunge = unless_0(d.feed_plunge, r.mill);
    r.infeed = d.infeed;
    r.finish_infeed = d.finish_infeed.value_or(0);
    r.operation = c.whole(Role::operation, d.operation, 0, 0, 2, "the machining operation");
    if (2 * r.radius > d.width + 1e-9) c.fault(Role::width, "tool radius too large: the tool is wider than the slot");
    if (2 * r.radius < d.width / 3 - 1e-9)
        c.fault(Role::width, "the tool is narrower than a third of the slot's width");
    return r;
}

Contour half_of(const Contour& chain) {
    double length = 0, done = 0;
    for (const geom::Edge& e : geom::edges(chain)) length += geom::length(e);
    Contour out{{}, false};
    for (const geom::Edge& e : geom::edges(chain)) {
        const double l = geom::length(e), part = std::min(1.0, (length / 2 - done) / l);
        const geom::Edge piece = geom::part(e, 0, part);
        out.vertices.push_back({piece.a, piece.bulge});
        done += l;
        if (part < 1 || done >= length / 2) {
            out.vertices.push_back({piece.b});
            break;
        }
    }
    return out;
}

void reciprocate(Course& c, const Reciprocation& r, const Contour& figure_middle, const geom::Region& slot,
                 const Placement& where) {
    const Contour middle = placed(figure_middle, where);
    c.assume("the reciprocating plunge takes the infeed on the way from one end to the other");
    check_size(c, placed(slot, where));
    if (!c.ready()) return;
    c.rapid_w(std::max(c.at().z, r.h.end));
    if (r.operation != 2) {
        const Vec2 left = middle.vertices.front().p;
        c.rapid({left.x, left.y, c.at().z});
        c.rapid_w(r.h.clearance);
        c.move_w(r.h.surface, r.mill);
        const std::vector<double> levels = even_levels(c, r.h.surface, r.h.bottom, r.infeed);
        bool there = true;
        for (const double level : levels) {
            if (!c.room()) return;
            // One oblique pass: the height falls in line with the way.
            const std::vector<geom::Edge> way = geom::edges(there ? middle : geom::reversed(middle));
            const double from = c.at().z;
            for (std::size_t i = 0; i < way.size(); ++i) {
                const double w = from + (level - from) * static_cast<double>(i + 1) / static_cast<double>(way.size());
                run_edge(c, way[i], w, r.mill);
            }
            there = !there;
        }
        const Contour last = there ? middle : geom::reversed(middle);
        follow(c, last, r.h.bottom, r.mill);
        follow(c, half_of(geom::reversed(last)), r.h.bottom, r.mill);
        c.rapid_w(r.h.clearance);
    }
    const geom::Region room = geom::offset(slot, -r.radius);
    if (r.operation != 1 && !room.empty()) {
        Cuts cuts{.top = r.h.surface,
                  .clearance = r.h.clearance,
                  .levels = {},
                  .lift = 0,
                  .direct = false,
                  .retract = std::numeric_limits<double>::infinity()};
        const double whole = r.h.surface - r.h.bottom;
        cuts.levels = even_levels(c, r.h.surface, r.h.bottom, r.finish_infeed > 0 ? r.finish_infeed : whole);
        if (!c.ready()) return;
        mill_walls(c, walls_of(room, {.arc = r.radius, .semicircle = true, .where = where}), cuts, r.plunge, r.mill);
    }
    c.rapid_w(r.h.end);
}

}  // namespace

void write_steps(Course& c, const Slot& d, const Situation& s) {
    const PocketData p = pocket_data(c, d, s);
    if (d.width > d.length) c.fault(Role::width, "the slot is wider than long");
    if (!c.ready()) return;
    c.assume(slot_rings);
    const double u = centre_along(p.position, d.length, d.width), half = (d.length - d.width) / 2;
    const Vec2 left{u - half, 0}, right{u + half, 0};
    mill_pocket(c, p,
                {{{geom::moved(long_slot(d.length, d.width), {u, 0})}},
                 {p.rotation, p.called},
                 left,
                 true,
                 {{{left}, {right}}, false}});
}

void write_steps(Course& c, const RoundSlot& d, const Situation& s) {
    PocketData p = pocket_data(c, d, s);
    BentSlot r = bent_of(c, d);
    const int position = p.position;
    if (position == 0) {
        r.centre = {asked(c, d, &RoundSlot::centre_u, Must::be_known),
                    asked(c, d, &RoundSlot::centre_v, Must::be_known)};
    } else {
        // The called position: centre of the left arc, of the middle line, of the right arc; the angle is meant there.
        const double part = position == 1 ? 0 : position == 2 ? 0.5 : 1;
        r.centre = p.called - r.radius * Vec2{std::cos(r.from), std::sin(r.from)};
        r.from -= part * r.sweep;
    }
    if (position > 3) c.fault(Role::position, "the position must be a whole number from 0 to 3");
    const double count = c.not_below(Role::count, d.count.value_or(1), 1);
    const double step = geom::radians(d.angle_step.value_or(0));
    if (count > 1000 || count != std::floor(count))
        c.fault(Role::count, "the number of operations must be a whole number");
    if (!c.ready()) return;
    c.assume(slot_rings);
    p.position = 1;  // it does not return to the called position
    const int slots = base::clipped<int>(count, 1, 1000);
    for (int i = 0; i < slots && c.ready() && c.room(); ++i)
        mill_pocket(c, p, {r.region(), r.where(i * step), {}, false, r.middle()});
}

void write_steps(Course& c, const ReciprocatingSlot& d, const Situation& s) {
    const double angle = geom::radians(d.rotation.value_or(0));
    const Reciprocation r = reciprocation_of(c, d, s);
    if (d.width > d.length) c.fault(Role::width, "the slot is wider than long");
    if (!c.ready()) return;
    const double half = (d.length - d.width) / 2;
    reciprocate(c, r, {{{{-half, 0}}, {{half, 0}}}, false}, {{long_slot(d.length, d.width)}},
                {angle, {d.centre_u, d.centre_v}});
}

void write_steps(Course& c, const ReciprocatingRoundSlot& d, const Situation& s) {
    BentSlot slot = bent_of(c, d);
    slot.centre = {d.centre_u, d.centre_v};
    const Reciprocation r = reciprocation_of(c, d, s);
    if (!c.ready()) return;
    reciprocate(c, r, slot.middle(), slot.region(), slot.where());
}

}  // namespace obrys::cycles
