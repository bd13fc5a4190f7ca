/// Threads in passes. Sources: cycles/turn/turning.hpp. Each pass: to the start at rapid, in at rapid, the thread, out
/// at rapid.

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "cycles/turn/path.hpp"

namespace obrys::cycles {

using geom::Vec2;

namespace {

constexpr double most_thread_passes = 10'000;

/// A thread whose passes go deeper by a power of their number. All in the unit of the program.
struct Degressive {
    double unit = 1;
    Vec2 start, end;  ///< end.x: end of the drive line; end.y: where the tool goes afterwards
    double pitch = 0, crest = 0, first = 0, depth = 0, degression = 1;
    double angle = 0;  ///< radians, positive: towards the end
    double springs = 0;
    double taper = 0;  ///< signed along the way back
    bool entry = false, exit = false;
    double taper_pitch = 0;
};

void take_taper(Course& c, const DegressiveThread& said, Degressive& d) {
    d.taper = said.taper_length.value_or(0) / d.unit;
    const int ends = c.whole(Role::taper_ends, said.taper_ends, 0, 0, 9, "the ends with a taper");
    d.entry = d.taper > 0 && (ends & 1) != 0;
    d.exit = d.taper > 0 && (ends & 2) != 0;
    if (d.taper > 0) d.taper_pitch = d.pitch * std::hypot(d.taper, d.depth) / d.taper;
    if (d.end.x > d.start.x) d.taper = -d.taper;
}

Degressive degressive_of(Course& c, const DegressiveThread& said, const Situation& situation) {
    Degressive d;
    d.unit = said.length_unit.value_or(1);
    const Ends ends = ends_of(c, said.target_u, said.target_v, situation);
    d.start = (1 / d.unit) * ends.start;
    d.end = (1 / d.unit) * ends.target;
    d.pitch = said.pitch / d.unit;
    d.crest = said.crest_offset / d.unit;
    d.first = said.first_depth / d.unit;
    d.depth = said.thread_depth / d.unit;
    d.degression = std::max(1.0, said.degression.value_or(1));
    d.angle = geom::radians(said.infeed_angle.value_or(0)) * (d.end.x > d.start.x ? -1 : 1);
    d.springs = whole_passes(c, Role::spring_passes, said.spring_passes, 0);
    take_taper(c, said, d);
    if (d.pitch == 0) c.fault(Role::pitch, "the thread pitch must not be 0");
    if (d.crest == 0) c.fault(Role::crest_offset, "the offset of the thread's crest must not be 0");
    if (d.first <= 0) c.fault(Role::first_depth, "the depth of the first cut must be greater than 0");
    if (d.depth <= d.first) c.fault(Role::thread_depth, "the thread must be deeper than its first cut");
    if (std::pow(d.depth / d.first, d.degression) > most_thread_passes)
        c.fault(Role::first_depth, "the depth of the first cut is too small");
    if (situation.spindle_direction == 0) c.fault("the spindle does not turn", "program M3 or M4 before the cycle");
    return d;
}

/// One pass `in` beside the drive line.
class DegressivePass {
public:
    DegressivePass(TurningPath& path, const Degressive& d, double in)
        : path_(path), d_(d), in_(in), back_((in - std::abs(d.crest)) * std::tan(d.angle)) {}
    void cut() {
        const double full = std::abs(d_.depth) + std::abs(d_.crest), begin = d_.start.x - back_;
        const double end = d_.end.x + std::abs(d_.depth) * std::tan(d_.angle) - back_;
        rapid(begin, in_ - full);
        if (d_.entry) {
            thread(begin, in_ - d_.depth, d_.taper_pitch);
            thread(begin - d_.taper, in_, d_.taper_pitch);
        } else {
            rapid(begin, in_);
        }
        if (d_.exit) {
            thread(end + d_.taper, in_, d_.pitch);
            thread(end, in_ - d_.depth, d_.taper_pitch);
        } else {
            thread(end, in_, d_.pitch);
        }
        rapid(end, in_ - full);
    }

private:
    [[nodiscard]] Vec2 place(double u, double in) const {
        return d_.unit * Vec2{u, d_.crest > 0 ? d_.start.y + in : d_.start.y - in};
    }
    void rapid(double u, double in) { path_.rapid(place(u, in)); }
    void thread(double u, double in, double pitch) { path_.thread(place(u, in), d_.unit * pitch); }

    TurningPath& path_;
    const Degressive& d_;
    double in_, back_;
};

/// A thread between two points that belong to the end of the pass; taper_v and runout as in the header.
struct Line {
    Vec2 home;  ///< where the tool goes in and out: u of the start of this pass, v of the start point
    Vec2 end;
    double taper = 0, runout = 0, pitch = 0;
    double angle = 0;  ///< of the spindle where it begins, degrees
};

/// The lead holds along the axis; the record has it along the move.
double along_move(Vec2 move, double lead) { return move.x == 0 ? lead : lead * geom::length(move) / std::abs(move.x); }

void thread_to(TurningPath& path, Vec2 to, double lead, double start = 0) {
    path.thread(to, along_move(to - path.at(), lead), start);
}

void thread_line(TurningPath& path, const Line& l) {
    const double out = l.home.y >= l.end.y ? 1 : -1, back = l.home.x >= l.end.x ? 1 : -1;
    path.rapid({l.home.x, l.end.y + l.taper});
    const double run = std::min(l.runout, std::abs(l.home.x - l.end.x));
    if (run > 0) {
        const double part = 1 - run / std::abs(l.home.x - l.end.x);
        const Vec2 leave{l.end.x + back * run, l.end.y + l.taper * (1 - part)};
        thread_to(path, leave, l.pitch, l.angle);
        thread_to(path, {l.end.x, leave.y + out * std::min(run, std::abs(l.home.y - leave.y))}, l.pitch);
    } else {
        thread_to(path, l.end, l.pitch, l.angle);
    }
    path.rapid({l.end.x, l.home.y});
}

Line line_of(Course& c, const ThreadLine& d, const Ends& ends) {
    if (ends.start.x == ends.target.x) c.fault(Role::target_u, "the thread has no length");
    Line l{ends.start, ends.target, d.taper_v.value_or(0), d.runout.value_or(0), d.pitch};
    l.angle = d.spindle_angle.value_or(0);
    return l;
}

struct Depths {
    double whole = 0, first = 0, least = 0;
    double left = 0;       ///< for the finishing
    double finishing = 1;  ///< passes
    bool equal = false;    ///< depths; else areas
};

/// Depths of all passes: no step below the least; what the finishing leaves last; then the finishing.
std::vector<double> depths_of(Course& c, const Depths& d) {
    std::vector<double> depths;
    double depth = d.first;
    for (int n = 2; depth < d.whole - d.left - 1e-9; ++n) {
        if (double(depths.size()) > most_thread_passes) {
            c.fault(Role::first_depth, "the depth of the first cut is too small");
            return {};
        }
        depths.push_back(depth);
        depth = std::max(d.first * (d.equal ? double(n) : std::sqrt(double(n))), depth + d.least);
    }
    if (d.left > 0) depths.push_back(d.whole - d.left);
    for (double i = 0; i < d.finishing; i += 1) depths.push_back(d.whole);
    return depths;
}

}  // namespace

void write_steps(TurningPath& path, const DegressiveThread& said, const TurningDemand& demand) {
    Course& c = path.course();
    const Degressive d = degressive_of(c, said, demand.situation);
    if (!c.ready()) return;
    const double crest = std::abs(d.crest), full = d.depth + crest;
    int pass = 1;
    for (double in = crest + d.first; in < full && c.room();) {
        DegressivePass(path, d, in).cut();
        in = crest + d.first * std::pow(++pass, 1.0 / d.degression);
    }
    for (double i = 0; i < d.springs + 1; i += 1) DegressivePass(path, d, full).cut();
    path.rapid(d.unit * d.end);
}

void write_steps(TurningPath& path, const BoxThread& d, const TurningDemand& demand) {
    Course& c = path.course();
    const Line l = line_of(c, d, ends_of(c, d.target_u, d.target_v, demand.situation));
    if (!c.ready()) return;
    thread_line(path, l);
    path.rapid(l.home);
}

void write_steps(TurningPath& path, const ThreadPasses& d, const TurningDemand& demand) {
    Course& c = path.course();
    const Ends ends = ends_of(c, d.target_u, d.target_v, demand.situation);
    Line l = line_of(c, d, ends);
    const double whole = d.thread_depth, least = d.min_infeed.value_or(0), left = d.finish_allowance.value_or(0);
    const double finishing = std::max(1.0, whole_passes(c, Role::finish_passes, d.finish_passes, 1));
    const double angle = d.infeed_angle.value_or(0);
    const int method = c.whole(Role::infeed_method, d.infeed_method, 1, 1, 4, "the method of infeed");
    if (l.runout == 0) l.runout = d.runout_leads.value_or(0) * l.pitch;
    if (least > whole) c.fault(Role::min_infeed, "the smallest depth of cut is more than the depth of the thread");
    if (d.first_depth > whole)
        c.doubt(Role::first_depth,
                "the first cut of " + base::shortest(d.first_depth) + " mm is deeper than the thread, which is " +
                    base::shortest(whole) + " mm deep: it is cut to full depth in one pass",
                "look at the depth of the first cut and the height of the thread");
    if (angle < 0 || angle > 60) c.fault(Role::infeed_angle, "the infeed angle must lie between 0 and 60 degrees");
    if (left >= whole) c.fault(Role::finish_allowance, "the finishing allowance is not less than the depth");
    if (!c.ready()) return;
    const auto depths = depths_of(c, {whole, d.first_depth, least, left, finishing, method >= 3});
    if (!c.ready()) return;
    const bool both = method == 2 || method == 4;
    if (angle > 0)
        c.assume(both ? "all passes end at the same place; the first one is on the flank behind"
                      : "all passes end at the same place; their starts are shifted by the infeed angle");
    const double out = ends.start.y >= ends.target.y ? 1 : -1, on = ends.target.x < ends.start.x ? -1 : 1;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (!c.room()) return;
        // The flank behind is touched where the start moves ahead by depth * tan; the other one is its mirror image
        // about the last pass.
        const double depth = depths[i], ahead = both && i % 2 != 0 ? 2 * whole - depth : depth;
        l.home.x = ends.start.x + on * ahead * std::tan(geom::radians(angle));
        l.end.y = ends.target.y + out * (whole - depth);
        path.rapid(l.home);
        thread_line(path, l);
    }
    path.rapid(ends.start);
}

}  // namespace obrys::cycles
