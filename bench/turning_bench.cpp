// Cost of turning removal: grooves of about 575 moves cut one after another into a long bar, so that the stock's
// contour grows with the moves already made. Prints a table; the cost per move should stay flat.

#include <chrono>
#include <cstddef>
#include <cstdio>

#include "geom/region.hpp"
#include "sim/turning/turning.hpp"

namespace {

using obrys::geom::Contour;
using obrys::geom::Vec2;
using obrys::sim::turning::Workpiece;

constexpr double pitch = 100, blade_width = 3, bar = 226;  // mm

/// 575 moves: 115 passes of plunge, retract, side step, finishing step along the flank, return; walls slope, so every
/// pass leaves its own corners.
std::size_t cut_groove(Workpiece& w, const Contour& blade, double z0, std::size_t moves, double& removed) {
    std::size_t n = 0;
    Vec2 at{z0, bar + 5};
    const auto go = [&](double z, double x) {
        if (n == moves) return;
        const Vec2 to{z, x};
        removed += w.cut(blade, {at, to, {}, 0}).area;
        at = to;
        ++n;
    };
    int pass = 0;
    while (n < moves) {
        const double z = z0 + 5 + 0.7 * pass, depth = 100 - 0.6 * pass;
        go(z, bar + 1);
        go(z, bar - depth);
        go(z + 0.2, bar - depth + 0.3);
        go(z + 0.2, bar + 1);
        go(z + 0.1, bar + 5);
        ++pass;
    }
    return n;
}

void run(std::size_t moves) {
    constexpr std::size_t groove = 575;
    const std::size_t grooves = (moves + groove - 1) / groove;
    const double length = pitch * static_cast<double>(grooves) + 20;
    const Contour blade{{{{0, 0}}, {{blade_width, 0}}, {{blade_width, 400}}, {{0, 400}}}, true};
    const auto start = std::chrono::steady_clock::now();
    Workpiece w({{Contour{{{{0, 0}}, {{length, 0}}, {{length, bar}}, {{0, bar}}}, true}}});
    const double before = w.area();
    double removed = 0;
    std::size_t made = 0;
    double first = 0;
    for (std::size_t g = 0; g < grooves; ++g) {
        made += cut_groove(w, blade, pitch * static_cast<double>(g), groove, removed);
        if (g == 0) first = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::size_t edges = 0;
    for (const Contour& c : w.region().contours) edges += c.vertices.size();
    std::printf("%8zu moves %9.3f s %8.2f us/move  first groove %6.2f ms  %7zu edges  balance %.1e mm2\n", made, all,
                1e6 * all / static_cast<double>(made), 1e3 * first, edges, before - w.area() - removed);
}

}  // namespace

int main() {
    for (const std::size_t moves : {575U, 5750U, 57500U}) run(moves);
}
