#include "sim/force/processes.hpp"

#include <cmath>

namespace obrys::sim::force {

namespace {

Turning of(const cutting::Law& law, double chip, double width, double speed) {
    Turning t;
    t.chip = chip;
    t.width = width;
    t.cutting = cutting::force(law, chip).tangential * width;
    t.feed = feed_ratio * t.cutting;
    t.back = back_ratio * t.cutting;
    constexpr double minute = 60;
    t.power = t.cutting * speed / minute;
    return t;
}

}  // namespace

Turning turning(const cutting::Law& law, double depth, double feed, double entering, double speed) {
    return of(law, feed * std::sin(entering), depth / std::sin(entering), speed);
}

Turning grooving(const cutting::Law& law, double width, double feed, double speed) {
    return of(law, feed, width, speed);
}

double rake_factor(double rake_deg, double law_rake_deg, double percent_a_degree) {
    return 1 - (rake_deg - law_rake_deg) * percent_a_degree / 100;
}

Drilling drilling(const cutting::Law& law, double diameter, int teeth, double feed, double point) {
    const double lean = std::sin(point / 2), chip = feed * lean;
    const double on_edge = cutting::force(law, chip).tangential * diameter / 2 / lean;  // of one tooth
    return {teeth * on_edge * diameter / 4, 0.5 * teeth * on_edge * lean};
}

double tapping_torque(const cutting::Law& law, double diameter, double pitch, int teeth) {
    // Its lead cuts the profile's height in some ten chips to each tooth.
    constexpr double chips = 10;
    const double chip = pitch / (chips * teeth);
    return pitch * pitch * diameter * cutting::force(law, chip).tangential / chip / 8;
}

}  // namespace obrys::sim::force
