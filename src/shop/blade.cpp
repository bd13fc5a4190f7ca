#include "shop/blade.hpp"

#include <algorithm>

namespace obrys::shop {

namespace {

/// Half of the thickness on an arc through both ends.
double on_arc(const BladeForm& f, double x, double length) {
    const double y0 = f.root / 2, y1 = f.tip / 2;
    const double chord = std::hypot(length, y1 - y0), radius = std::abs(f.radius);
    const double off = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
    const double side = f.radius > 0 ? -1 : 1;  // where the centre lies of the chord: a bulge has it below
    const double cx = length / 2 - side * off * (y1 - y0) / chord, cy = (y0 + y1) / 2 + side * off * length / chord;
    return cy - side * std::sqrt(std::max(0.0, radius * radius - (x - cx) * (x - cx)));
}

}  // namespace

double value_at(const BladeForm& f, double x, double length) {
    switch (f.kind) {
        case BladeForm::Kind::linear: return f.root + (f.tip - f.root) * x / length;
        case BladeForm::Kind::strength: return std::max(f.tip, f.root * std::sqrt(std::max(0.0, 1 - x / length)));
        case BladeForm::Kind::arc: return 2 * on_arc(f, x, length);
        case BladeForm::Kind::stations: break;
    }
    const auto after = std::find_if(f.stations.begin(), f.stations.end(), [&](const auto& s) { return s.at >= x; });
    if (after == f.stations.begin()) return after->value;
    if (after == f.stations.end()) return f.stations.back().value;
    const auto before = after - 1;
    return before->value + (after->value - before->value) * (x - before->at) / (after->at - before->at);
}

}  // namespace obrys::shop
