/// Single cuts (Fanuc G90, G94) and pecks step by step (G74, G75). Sources: Fanuc 0i-TD operator's manual, canned
/// cycles and multiple repetitive cycles for turning; ADTECH 4620 programming manual, G75: no relief at the first peck.

#include <algorithm>
#include <cmath>

#include "cycles/turn/path.hpp"

namespace obrys::cycles {

using geom::Vec2;

namespace {

void box(TurningPath& path, const TurningDemand& demand) {
    Course& c = path.course();
    const bool along = demand.cycle.kind == Kind::lathe_box_along;
    const Ends e = read_ends(c, demand.situation);
    c.need(Role::target_u);
    c.need(Role::target_v);
    const double taper = c.maybe(along ? Role::taper_v : Role::taper_u, 0);
    if (!c.ready()) return;
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

TurningPecks read_turning_pecks(Course& c, const TurningDemand& demand) {
    TurningPecks p;
    p.along = demand.cycle.kind == Kind::lathe_peck_along;
    const Ends e = read_ends(c, demand.situation);
    c.need(p.along ? Role::target_u : Role::target_v);
    p.start = p.place(e.start);
    p.target = p.place(e.target);
    p.infeed = c.maybe_at_least(Role::infeed, 0, 0);
    p.step = c.maybe_at_least(Role::stepover, 0, 0);
    p.escape = c.maybe_at_least(Role::escape, 0, 0);
    const double across = std::abs(p.target.y - p.start.y), deep = std::abs(p.target.x - p.start.x);
    // Without steps its sign says the side.
    p.relief = across == 0 ? 0 : c.maybe_at_least(Role::relief, 0, 0);
    if (demand.cycle.find(Role::stepover) && p.step == 0 && across > 0)
        c.fault(Role::stepover, "the step must not be 0 where the other axis moves");
    if (p.step > 0 && across / p.step > double(most_steps)) c.fault(Role::stepover, "the steps are too small");
    if (demand.cycle.find(Role::infeed) && p.infeed == 0) c.fault(Role::infeed, "the infeed must not be 0");
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

void turning_pecks(TurningPath& path, const TurningDemand& demand) {
    Course& c = path.course();
    const TurningPecks p = read_turning_pecks(c, demand);
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

void lathe_simple(TurningPath& path, const TurningDemand& demand) {
    const Kind kind = demand.cycle.kind;
    if (kind == Kind::lathe_box_along || kind == Kind::lathe_box_across) return box(path, demand);
    turning_pecks(path, demand);
}

}  // namespace obrys::cycles
