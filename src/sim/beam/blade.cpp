#include "sim/beam/blade.hpp"

#include <algorithm>

#include "base/whole.hpp"
#include "sim/beam/beam.hpp"

namespace obrys::sim::beam {

namespace {

constexpr int modes = 3;
constexpr double tonnes = 1e-12;  ///< kg/m3 to t/mm3
constexpr double minute = 60;

/// Where the finished part begins.
double edge_of(const shop::Blade& b, double finished) { return b.length * (1 - finished); }

double thickness(const shop::Blade& b, double finished, double x) {
    return value_at(x < edge_of(b, finished) ? b.blank : b.finished, x, b.length);
}

Beam beam_of(const shop::Blade& b, double finished) {
    Beam beam;
    beam.length = b.length;
    beam.breaks = {edge_of(b, finished)};
    constexpr double millimetres = 1000;
    if (b.root_stiffness) beam.root_stiffness = millimetres * *b.root_stiffness;
    beam.section = [&b, finished](double x) {
        const double h = thickness(b, finished, x), w = value_at(b.width, x, b.length);
        return Section{b.bending_factor * b.elasticity * w * h * h * h / 12, tonnes * b.density * w * h};
    };
    for (const shop::BladeForm* form : {&b.width, &b.blank, &b.finished})
        for (const auto& station : form->stations) beam.breaks.push_back(station.at);
    std::sort(beam.breaks.begin(), beam.breaks.end());
    return beam;
}

/// Of bending by a load at the tip, over the length but its outermost fiftieth, which carries nothing.
double stress_ratio(const shop::Blade& b, double finished) {
    constexpr int places = 101;
    constexpr double part = 0.98;
    double sum = 0, most = 0;
    for (int i = 0; i < places; ++i) {
        const double x = part * b.length * i / (places - 1), h = thickness(b, finished, x);
        const double stress = (b.length - x) / (value_at(b.width, x, b.length) * h * h);
        sum += stress;
        most = std::max(most, stress);
    }
    return most * places / sum;
}

bool rings(const Stage& s, double tooth_passing, int harmonics) {
    for (const double f : s.frequencies)
        for (int k = 1; k <= harmonics; ++k)
            if (std::abs(k * tooth_passing / f - 1) < too_near) return true;
    return false;
}

/// The nearest speed at which a stage, or none of them, rings: from half of it to one and a half.
template <typename Rings>
std::optional<double> speed_near(const shop::Blade& b, Rings rings_at) {
    constexpr int steps = 500;
    constexpr double step = 1e-3;
    for (int i = 0; i <= steps; ++i)
        for (const double sense : {-1.0, 1.0}) {
            const double n = *b.speed * (1 + sense * step * i);
            if (b.most_speed && n > *b.most_speed) continue;
            if (!rings_at(n * *b.teeth / minute)) return n;
        }
    return std::nullopt;
}

Stage stage_of(const shop::Blade& b, double finished, int elements) {
    Stage s;
    s.finished = finished;
    const Model model(beam_of(b, finished), elements);
    s.frequencies = model.frequencies(modes);
    s.tip_stiffness = model.stiffness_at(b.length);
    // At the root itself nothing gives way: the cut then is what lies next to it.
    constexpr double least = 0.05;
    s.cut_stiffness = model.stiffness_at(std::max(edge_of(b, finished), least * b.length));
    constexpr double grams = 1e6;
    s.mass_g = grams * model.mass();
    s.root = thickness(b, finished, 0);
    s.middle = thickness(b, finished, b.length / 2);
    s.tip = value_at(finished > 0 ? b.finished : b.blank, b.length, b.length);
    s.stress_ratio = stress_ratio(b, finished);
    if (!b.speed || !b.teeth) return s;
    Excitation e = excitation(*b.speed, *b.teeth, s.frequencies.front(), b.damping);
    e.rings = rings(s, e.tooth_passing, b.harmonics);
    if (b.force) e.amplitude = *b.force / s.cut_stiffness * e.amplification;
    if (e.rings) e.better_speed = speed_near(b, [&](double hz) { return rings(s, hz, b.harmonics); });
    s.excitation = e;
    return s;
}

}  // namespace

Excitation excitation(double speed, int teeth, double natural, double damping) {
    Excitation e;
    e.tooth_passing = speed * teeth / minute;
    e.harmonic = base::clipped<int>(std::round(natural / e.tooth_passing), 1, 1'000'000);
    e.ratio = natural / (e.harmonic * e.tooth_passing);
    const double r = 1 / e.ratio;
    e.amplification = 1 / std::hypot(1 - r * r, 2 * damping * r);
    return e;
}

BladeResult study(const shop::Blade& b, int elements) {
    BladeResult result;
    for (const double finished : b.stages) result.stages.push_back(stage_of(b, finished, elements));
    if (b.speed && b.teeth)
        result.common_speed = speed_near(b, [&](double hz) {
            return std::any_of(result.stages.begin(), result.stages.end(),
                               [&](const Stage& s) { return rings(s, hz, b.harmonics); });
        });
    return result;
}

}  // namespace obrys::sim::beam
