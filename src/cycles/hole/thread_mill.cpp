/// Thread milling. Source: HEIDENHAIN iTNC 530 cycle programming, chapter on thread milling (262 to 265, 267); sense of
/// rotation and work direction: TNC 320 ISO programming, helical interpolation, table "shape of the helix".
///
/// A helix of pitch P turning counter-clockwise rises by P a turn where the thread is right-handed, falls where it is
/// left-handed. The tool comes from the centre on a semicircle that is part of the helix, so that it starts half a
/// pitch before the plane where the thread begins (the manual's compensating motion of the tool axis) and may reach
/// that much below the thread's depth.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "cycles/hole/families.hpp"
#include "cycles/levels.hpp"

namespace obrys::cycles {

namespace {

constexpr double pi = geom::pi;

struct Job {
    double surface = 0, clearance = 0, end = 0;  ///< absolute w
    double depth = 0;                            ///< of the thread, negative; 0: no thread
    double pitch = 0;                            ///< negative: left hand
    double radius = 0;                           ///< of the tool centre's path on the thread
    double side = 0;                             ///< radius where the semicircle to the thread begins
    double sense = 1;                            ///< +1 counter-clockwise
    int threads_per_step = 0;
    double feed = 0, positioning = 0, approach = 0;
    geom::Vec2 axis;  ///< of the thread

    [[nodiscard]] double rise() const { return sense * pitch; }  ///< a turn
};

/// Climb is counter-clockwise inside and clockwise outside, both with M3, as the parameter says.
double sense_of(const MilledThread& d, bool outside) {
    const double way = d.direction.value_or(1) < 0 ? -1 : 1;
    return outside ? -way : way;
}

/// Radius where the semicircle begins. Inside it is the axis, or nearer to the thread where the hole is much larger
/// than the tool; outside a place beside the stud. How near or far the manuals do not say: two pitches.
void place_start(Course& c, Job& j, double tool_radius, double diameter, bool outside) {
    const double apart = 2 * std::abs(j.pitch);
    if (outside) {
        j.side = j.radius + apart;
        c.assume("the starting point beside the stud: two pitches away from the thread milling path");
    } else if (diameter - 2 * tool_radius > 4 * std::abs(j.pitch)) {
        j.side = j.radius - apart;
        c.assume("the lateral pre-positioning in a wide hole: two pitches away from the thread milling path");
    }
}

Job job_of(Course& c, const MilledThread& d, const Situation& s, bool outside) {
    Job j;
    j.surface = d.surface;
    j.clearance = d.surface + d.clearance;
    j.end = d.surface + std::max(d.clearance, d.second_clearance.value_or(0));
    j.depth = d.depth;
    j.pitch = d.pitch;
    const double tool = c.tool_radius(s);
    j.radius = d.diameter / 2 + (outside ? tool : -tool);
    if (j.radius <= 1e-9) c.fault(Role::diameter, "tool radius too large: the thread is smaller than the tool");
    j.sense = sense_of(d, outside);
    const double per_step = d.threads_per_step.value_or(0);
    if (const auto n = base::whole<int>(per_step, 0, 1000))
        j.threads_per_step = *n;
    else if (!std::isnan(per_step))
        c.fault(Role::threads_per_step, "threads per step must be a whole number of at most 1000");
    j.feed = d.feed_mill;
    j.positioning = d.feed_position;
    j.approach = unless_0(d.feed_approach, j.feed);
    if (std::abs(j.depth / j.pitch) > most_helix_turns)
        c.fault(Role::pitch, "the thread has too many turns for its pitch");
    j.axis = {s.at.x, s.at.y};
    if (c.ready()) place_start(c, j, tool, d.diameter, outside);
    return j;
}

/// Semicircle from one radius to another on the ray where the tool stands (u+ from the axis itself).
void semicircle(Course& c, const Job& j, double from, double to, double turn, double w, double feed) {
    const geom::Vec2 out = geom::Vec2{c.at().x, c.at().y} - j.axis;
    const double away = geom::length(out);
    const geom::Vec2 ray = away > 1e-9 ? (1 / away) * out : geom::Vec2{1, 0};
    c.arc(j.axis + (from + to) / 2 * ray, turn * pi, w, feed);
}

/// One engagement: semicircle to the thread, the helix from `from` on, semicircle back. The tool stands at the start.
void mill_helix(Course& c, const Job& j, double from, double turns) {
    const double half = j.rise() / 2;
    // On the semicircle the tool turns as it does on the thread where the thread lies outside the start, else against.
    const double turn = j.side < j.radius ? j.sense : -j.sense;
    c.move_w(from - half, j.positioning);
    semicircle(c, j, j.side, j.radius, turn, from, j.approach);
    c.arc(j.axis, j.sense * turns * 2 * pi, from + turns * j.rise(), j.feed);
    semicircle(c, j, j.radius, j.side, turn, from + turns * j.rise() + half, j.feed);
}

void to_start(Course& c, const Job& j) { c.move({j.axis.x + j.side, j.axis.y, c.at().z}, j.positioning); }

/// The thread: in one turn, in one helix over its length, or in several turns (threads per step).
void mill_thread(Course& c, const Job& j) {
    if (j.depth == 0) return;
    const double bottom = j.surface + j.depth, lead = std::abs(j.pitch), length = -j.depth;
    const bool up = j.rise() > 0;
    to_start(c, j);
    if (j.threads_per_step == 1) {
        mill_helix(c, j, up ? bottom : j.surface, length / lead);
        return;
    }
    const double step = j.threads_per_step * lead;
    const int steps = j.threads_per_step == 0 ? 1 : base::clipped<int>(std::ceil(length / step - 1e-9), 1, most_steps);
    for (int k = 0; k < steps && c.room(); ++k) {
        const double low = bottom + (up ? k : steps - 1 - k) * step;
        mill_helix(c, j, up ? low : low + lead, 1);
    }
}

struct Front {
    double depth = 0, offset = 0, feed = 0;
};

/// `feed`: the member that holds the feed of it.
template <class Cycle, class Part>
Front front_of(Course& c, const Cycle& d, Said Part::*feed) {
    Front f;
    f.depth = d.front_depth.value_or(0);
    if (f.depth == 0) return f;
    f.offset = asked(c, d, &Cycle::front_offset, Must::be_at_least_0);
    f.feed = asked(c, d, feed, Must::be_feed);
    return f;
}

/// Chamfer with the tool's front: semicircle to the offset, full circle, semicircle back, all at the depth at front.
void countersink_front(Course& c, const Job& j, const Front& f) {
    if (f.depth == 0) return;
    const double w = j.surface + f.depth;
    c.move_w(w, j.positioning);
    const double from = c.at().x - j.axis.x;
    const double turn = f.offset > from ? j.sense : -j.sense;
    if (std::abs(f.offset - from) > 1e-9) semicircle(c, j, from, f.offset, turn, w, f.feed);
    if (f.offset > 1e-9) c.arc(j.axis, j.sense * 2 * pi, w, f.feed);
    if (std::abs(f.offset - from) > 1e-9) semicircle(c, j, f.offset, from, turn, w, f.feed);
}

void retract(Course& c, const Job& j) {
    c.rapid_w(j.clearance);
    if (j.side < j.radius) c.rapid({j.axis.x, j.axis.y, j.clearance});
    c.rapid_w(j.end);
}

/// Drilling before the thread.
struct ThreadHole {
    Pecking pecking;
    std::vector<double> levels;
};

ThreadHole hole_of(Course& c, const DrilledThreadMilling& d, const Job& j) {
    using Cycle = DrilledThreadMilling;
    ThreadHole h{{.top = j.surface, .retract_to = j.clearance}, {}};
    const double depth = d.hole_depth.value_or(0);
    if (!(depth < 0)) return h;
    const double infeed = asked(c, d, &Cycle::infeed, Must::be_above_0);
    Pecking& p = h.pecking;
    p.first_stop = p.last_stop = asked_or(c, d, &Cycle::stop_distance_first, Must::be_at_least_0, 0);
    p.break_every = asked_or(c, d, &Cycle::chip_break_depth, Must::be_at_least_0, 0);
    check_breaks(c, p.break_every, -depth);
    p.break_distance = asked_or(c, d, &Cycle::chip_break_distance, Must::be_at_least_0, 0);
    p.feed = asked(c, d, &Cycle::feed_plunge, Must::be_feed);
    if (c.ready()) h.levels = levels_of(c, j.surface, j.surface + depth, {.first = infeed});
    return h;
}

}  // namespace

void write_steps(Course& c, const ThreadMilling& d, const Situation& s) {
    const Job j = job_of(c, d, s, false);
    if (j.depth == 0) return c.not_executed(Role::depth);
    if (!c.ready()) return;
    c.rapid_w(j.clearance);
    mill_thread(c, j);
    retract(c, j);
}

void write_steps(Course& c, const CountersunkThreadMilling& d, const Situation& s) {
    Job j = job_of(c, d, s, false);
    j.threads_per_step = 0;
    const Front front = front_of(c, d, &CountersunkThreadMilling::feed_countersink);
    if (d.countersink_depth.value_or(0) < 0)
        c.not_simulated("countersinking along the core diameter is not simulated",
                        "the core diameter that the control takes is not documented");
    if (!c.ready()) return;
    c.rapid_w(j.clearance);
    countersink_front(c, j, front);
    mill_thread(c, j);
    retract(c, j);
}

void write_steps(Course& c, const DrilledThreadMilling& d, const Situation& s) {
    Job j = job_of(c, d, s, false);
    j.threads_per_step = 0;
    const Front front = front_of(c, d, &DrilledThreadMilling::feed_plunge);
    const ThreadHole hole = hole_of(c, d, j);
    if (!c.ready()) return;
    c.rapid_w(j.clearance);
    peck_down(c, hole.levels, hole.pecking);
    c.rapid_w(j.clearance);
    countersink_front(c, j, front);
    mill_thread(c, j);
    retract(c, j);
}

/// Continuous helix from the surface down to the depth; the hand decides the sense.
void write_steps(Course& c, const HelicalThreadMilling& d, const Situation& s) {
    Job j = job_of(c, d, s, false);
    j.threads_per_step = 1;
    j.sense = j.pitch > 0 ? -1 : 1;
    const Front front = front_of(c, d, &HelicalThreadMilling::feed_countersink);
    const bool after = d.countersink_order.value_or(0) != 0;
    if (!c.ready()) return;
    c.rapid_w(j.clearance);
    if (!after) countersink_front(c, j, front);
    mill_thread(c, j);
    if (after) {
        if (front.depth != 0) c.move({j.axis.x, j.axis.y, c.at().z}, j.positioning);
        countersink_front(c, j, front);
    }
    retract(c, j);
}

void write_steps(Course& c, const OutsideThreadMilling& d, const Situation& s) {
    const Job j = job_of(c, d, s, true);
    const Front front = front_of(c, d, &OutsideThreadMilling::feed_countersink);
    if (!c.ready()) return;
    c.rapid_w(j.clearance);
    to_start(c, j);
    countersink_front(c, j, front);
    mill_thread(c, j);
    retract(c, j);
}

}  // namespace obrys::cycles
