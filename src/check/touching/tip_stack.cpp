#include "check/touching/tip_stack.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mesh.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr int places = 32;           ///< along a way, before it is halved about the highest
constexpr int halvings = 12;         ///< there
constexpr double step = 1e-4;        ///< mm: no material is thinner
constexpr double on_face = 1e-9;     ///< mm: air on both sides that touches
constexpr std::size_t most = 20000;  ///< steps on one line

/// What is not there, before a pass.
class AirBefore {
public:
    AirBefore(const milling::Simulation& simulation, const TipWay& way) : air_(simulation.air_in(box_of(way))) {
        bodies_.push_back(0);
        for (std::size_t i = 1; i < air_.bodies(); ++i)
            if (simulation.pass_of(air_.cut(i)) < way.number) bodies_.push_back(i);
    }
    /// So far around a place is air; 0: it lies in material.
    [[nodiscard]] double around(Vec3 p) const {
        double in = 0;
        for (const std::size_t b : bodies_) in = std::max(in, -air_.outside(b, p));
        return in;
    }

private:
    static milling::Box3 box_of(const TipWay& way) {
        mesh::Box box;
        for (int i = 0; i <= places; ++i)
            for (const double z : {way.along.low, way.along.high})
                box.add(geom::point_at(way.path, static_cast<double>(i) / places) + z * way.axis);
        const double around = 0.01 * length(box.size());  // arcs stand off between the places
        return {box.lo - Vec3{around, around, around}, box.hi + Vec3{around, around, around}};
    }

    milling::Air air_;
    std::vector<std::size_t> bodies_;
};

/// How far from a point along a direction material begins; more than `far`: nowhere before that.
double to_material(const AirBefore& air, Vec3 from, Vec3 direction, double far) {
    double at = 0;
    for (std::size_t i = 0; i < most && at <= far; ++i) {
        const double in = air.around(from + at * direction);
        if (in <= on_face && air.around(from + (at + step) * direction) <= on_face) return at;
        at += std::max(in, step);
    }
    return 2 * far + 1;
}

}  // namespace

TipStack highest_over_tip(const milling::Simulation& simulation, const TipWay& way) {
    const AirBefore air(simulation, way);
    const milling::Heights stock = milling::heights_along(way.axis, milling::box_of(simulation.stock()));
    TipStack highest;
    const auto look = [&](double t) {
        const Vec3 tip = geom::point_at(way.path, t);
        const double at = dot(tip, way.axis);
        const double low = std::max(at + way.along.low, stock.low), high = std::min(at + way.along.high, stock.high);
        if (!(low < high)) return 0.0;
        const Vec3 bottom = tip + (low - at) * way.axis;
        const double up = to_material(air, bottom, way.axis, high - low);
        if (up >= high - low) return 0.0;
        const double down = to_material(air, bottom + (high - low) * way.axis, -1.0 * way.axis, high - low);
        const double height = high - low - down - up;
        if (height > highest.height) highest = {height, bottom + up * way.axis};
        return height;
    };
    int best = 0;
    double most_high = -1;
    for (int i = 0; i <= places; ++i)
        if (const double h = look(static_cast<double>(i) / places); h > most_high) most_high = h, best = i;
    double middle = static_cast<double>(best) / places, half = 0.5 / places;
    for (int i = 0; i < halvings; ++i, half /= 2)
        for (const double t : {middle - half, middle + half}) {
            if (t < 0 || t > 1) continue;
            if (const double h = look(t); h > most_high) most_high = h, middle = t;
        }
    return highest;
}

}  // namespace obrys::check
