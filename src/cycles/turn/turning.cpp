#include "cycles/turn/turning.hpp"

#include <cmath>

#include "cycles/turn/path.hpp"

namespace obrys::cycles {

namespace {

using TurningFamily = void (*)(TurningPath&, const TurningDemand&);

constexpr std::size_t most_elements = 5000;  ///< of a contour

TurningFamily turning_family_of(Kind kind) {
    switch (kind) {
        case Kind::lathe_finish_offset: return lathe_offset_passes;
        case Kind::lathe_rough_along:
        case Kind::lathe_rough_across: return lathe_rough;
        case Kind::lathe_thread_degressive:
        case Kind::lathe_thread_passes:
        case Kind::lathe_box_thread: return lathe_thread;
        case Kind::lathe_finish:
        case Kind::lathe_remove_along:
        case Kind::lathe_remove_across:
        case Kind::lathe_repeat_pattern: return lathe_removal;
        case Kind::lathe_peck_along:
        case Kind::lathe_peck_across:
        case Kind::lathe_box_along:
        case Kind::lathe_box_across: return lathe_simple;
        default: return nullptr;
    }
}

bool in_range(double v) { return std::abs(v) <= largest_input; }
bool in_range(geom::Vec2 p) { return in_range(p.x) && in_range(p.y); }

void check_contour(Course& c, const std::vector<TurningElement>& contour) {
    if (contour.size() > most_elements) c.fault("the contour has too many elements");
    for (const TurningElement& e : contour) {
        const double sum = e.to.x + e.to.y + e.fillet + e.chamfer + (e.turn != 0 ? e.centre.x + e.centre.y : 0);
        if (std::isnan(sum)) return void(c.not_simulated("the contour is not known"));
        if (!in_range(e.to) || !in_range(e.fillet) || !in_range(e.chamfer) || (e.turn != 0 && !in_range(e.centre)))
            return c.fault("the contour is out of range");
        if (e.feed && !(e.feed->value > 0 && std::isfinite(e.feed->value)))
            return c.fault("a feed rate of the contour is out of range");
    }
}

}  // namespace

bool is_turning_cycle(Kind kind) { return turning_family_of(kind) != nullptr; }

Expansion expand_turning(const TurningDemand& demand) {
    Course course(demand.cycle, demand.situation, true);
    const TurningFamily family = turning_family_of(demand.cycle.kind);
    if (family == nullptr) {
        course.not_simulated("this cycle is not simulated");
        return course.finish();
    }
    check_contour(course, demand.contour);
    TurningPath path(course);
    family(path, demand);
    return course.finish();
}

}  // namespace obrys::cycles
