/// Single cuts (Fanuc G90, G94) and pecks step by step (G74, G75). Sources: Fanuc 0i-TD operator's manual, canned
/// cycles and multiple repetitive cycles for turning; ADTECH 4620 programming manual, G75: no relief at the first peck.

#include <algorithm>
#include <cmath>

#include "cycles/turn/path.hpp"

namespace obrys::cycles {

using geom::Vec2;

namespace {

/// One cut, in the one axis or the other; `taper`: where it begins beside its end.
void box(TurningPath& path, const Ends& e, double taper, bool along) {
    if (!path.course().ready()) return;
    path.rapid(along ? Vec2{e.start.x, e.target.y + taper} : Vec2{e.target.x + taper, e.start.y});
    path.feed(e.target);
    path.feed(along ? Vec2{e.target.x, e.start.y} : Vec2{e.start.x, e.target.y});
    path.rapid(e.start);
}

/// Pecks in the one axis, steps in the other: x is the axis of the pecks here.
struct TurningPecks {
    bool along = true;
    Vec2 start, target;
    double infeed = 0, step = 0, escape = 0, relief = 0;
    [[nodiscard]] Vec2 place(Vec2 p) const { return along ? p : Vec2{p.y, p.x}; }
};

template <class Cycle>
TurningPecks pecks_of(Course& c, const Cycle& d, const Situation& s, bool along) {
    TurningPecks p;
    p.along = along;
    const Ends e = ends_of(c, d.target_u, d.target_v, s);
    p.start = p.place(e.start);
    p.target = p.place(e.target);
    p.infeed = d.infeed.value_or(0);
    p.step = d.stepover.value_or(0);
    p.escape = d.escape.value_or(0);
    const double across = std::abs(p.target.y - p.start.y), deep = std::abs(p.target.x - p.start.x);
    // Without steps its sign says the side.
    p.relief = across == 0 ? 0 : asked_or(c, d, &Cycle::relief, Must::be_at_least_0, 0);
    if (d.stepover && p.step == 0 && across > 0)
        c.fault(Role::stepover, "the step must not be 0 where the other axis moves");
    if (p.step > 0 && across / p.step > double(most_steps)) c.fault(Role::stepover, "the steps are too small");
    if (d.infeed && p.infeed == 0) c.fault(Role::infeed, "the infeed must not be 0");
    if (p.infeed > 0 && deep / p.infeed > double(most_steps)) c.fault(Role::infeed, "the infeed is too small");
    return p;
}

/// Where the pecks are made.
std::vector<double> steps_of(const TurningPecks& p) {
    std::vector<double> all{p.start.y};
    const double across = p.target.y - p.start.y, sign = across < 0 ? -1 : 1;
    if (across == 0) return all;
    for (int k = 1; p.step > 0 && k * p.step < std::abs(across) - 1e-9; ++k)
        all.push_back(p.start.y + sign * k * p.step);
    all.push_back(p.target.y);
    return all;
}

void peck_down(TurningPath& path, const TurningPecks& p, double y) {
    const double deep = std::abs(p.target.x - p.start.x), sign = p.target.x < p.start.x ? -1 : 1;
    for (int k = 1; p.infeed > 0 && k * p.infeed < deep - 1e-9 && path.course().room(); ++k) {
        const double x = p.start.x + sign * k * p.infeed;
        path.feed(p.place({x, y}));
        path.rapid(p.place({x - sign * std::min(p.escape, k * p.infeed), y}));
    }
    path.feed(p.place({p.target.x, y}));
}

void run_pecks(TurningPath& path, const TurningPecks& p) {
    Course& c = path.course();
    if (!c.ready()) return;
    if (p.relief > 0) c.assume("the first peck has no relief at its bottom");
    const double back = p.target.y < p.start.y ? 1 : -1;
    const std::vector<double> all = steps_of(p);
    for (std::size_t i = 0; i < all.size() && c.room(); ++i) {
        if (i > 0) path.rapid(p.place({p.start.x, all[i]}));
        peck_down(path, p, all[i]);
        const double y = i > 0 ? all[i] + back * p.relief : all[i];
        if (y != all[i]) path.rapid(p.place({p.target.x, y}));
        path.rapid(p.place({p.start.x, y}));
    }
    if (all.size() > 1) path.rapid(p.place(p.start));
}

}  // namespace

void write_steps(TurningPath& path, const PecksAlong& d, const TurningDemand& demand) {
    run_pecks(path, pecks_of(path.course(), d, demand.situation, true));
}
void write_steps(TurningPath& path, const PecksAcross& d, const TurningDemand& demand) {
    run_pecks(path, pecks_of(path.course(), d, demand.situation, false));
}

void write_steps(TurningPath& path, const BoxAlong& d, const TurningDemand& demand) {
    box(path, ends_of(path.course(), d.target_u, d.target_v, demand.situation), d.taper_v.value_or(0), true);
}
void write_steps(TurningPath& path, const BoxAcross& d, const TurningDemand& demand) {
    box(path, ends_of(path.course(), d.target_u, d.target_v, demand.situation), d.taper_u.value_or(0), false);
}

}  // namespace obrys::cycles
