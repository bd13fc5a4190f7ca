#include "cycles/turn/turning.hpp"

#include <cmath>

#include "cycles/turn/path.hpp"

namespace obrys::cycles {

namespace {

struct TurningRow {
    std::span<const Role> roles{};
    void (*family)(TurningPath&, const TurningDemand&) = nullptr;
};

template <class Cycle>
void expand_turned(TurningPath& path, const TurningDemand& demand) {
    write_steps(path, read<Cycle>(path.course(), demand.cycle), demand);
}

template <class... Cycle>
constexpr auto turning_table() {
    std::array<TurningRow, static_cast<std::size_t>(Kind::probe) + 1> out{};
    ((out[static_cast<std::size_t>(Cycle::kind)] = {roles_of_cycle<Cycle>, &expand_turned<Cycle>}), ...);
    return out;
}

constexpr auto kinds = turning_table<OffsetFinishing, RoughingAlong, RoughingAcross, ContourFinishing, RemovalAlong,
                                     RemovalAcross, PatternRepeating, PecksAlong, PecksAcross, BoxAlong, BoxAcross,
                                     BoxThread, ThreadPasses, DegressiveThread>();

const TurningRow& row_of(Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }

constexpr std::size_t most_elements = 5000;  ///< of a contour

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

bool is_turning_cycle(Kind kind) { return row_of(kind).family != nullptr; }

std::span<const Role> roles_of_turning(Kind kind) { return row_of(kind).roles; }

Expansion expand_turning(const TurningDemand& demand) {
    Course course(demand.cycle, demand.situation, true);
    const TurningRow& row = row_of(demand.cycle.kind);
    if (row.family == nullptr) {
        course.not_simulated("this cycle is not simulated");
        return course.finish();
    }
    check_contour(course, demand.contour);
    TurningPath path(course);
    row.family(path, demand);
    return course.finish();
}

}  // namespace obrys::cycles
