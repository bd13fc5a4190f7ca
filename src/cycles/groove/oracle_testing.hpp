#pragma once
/// Grooves with values that were computed independently of this program: contours to 1e-9 mm, what a strategy must
/// reach. Widths and angles as the columns say.

#include <array>
#include <limits>

#include "cycles/groove/strategy.hpp"

namespace obrys::cycles::groove::testing {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Right edge (x0, z0), slope, depth, width of the bottom, flanks in degrees, corners (+ radius, - chamfer),
/// allowances.
struct Measures {
    double x0, z0, a0, h, b, f1, f2, rco1, rci1, rco2, rci2, alb, alf;
    bool by_base;
};

[[nodiscard]] inline Shape shape_of(const Measures& m) {
    const auto corner = [&](double v) {
        const Corner::Form form = m.by_base ? Corner::Form::base : Corner::Form::leg;
        return v >= 0 ? Corner{v, Corner::Form::radius} : Corner{-v, form};
    };
    Shape s;
    s.p = {m.z0, m.x0};
    s.slope = geom::radians(m.a0);
    s.depth = m.h;
    s.width = m.b;
    s.flank = {geom::radians(m.f2), geom::radians(m.f1)};
    s.outer = {corner(m.rco2), corner(m.rco1)};
    s.inner = {corner(m.rci2), corner(m.rci1)};
    s.leave_bottom = m.alb;
    s.leave_flank = m.alf;
    return s;
}

struct Points {
    const char* name;
    Measures measures;
    std::array<Vec2, 4> rough;  ///< left edge, left corner, right corner, right edge of the sharp lines
    double flat_begin, flat_end, rough_area;
    std::array<Vec2, 4> finished;  ///< the same of the finished contour
    std::array<Vec2, 4> tangents;  ///< ends of its left and its right side
    double finished_area;
};

// clang-format off
inline const std::array<Points, 7> points{{
    {"kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, {{{110.476351911, 150.191158593}, {120.465032993, 10.5}, {164.554885585, 10.5}, {184.471689761, 179.788680284}}}, 120.465032993, 164.554885585, 9048.0238, {{{109.989013926, 149.996227439}, {119.999509097, 10.0}, {164.999509097, 10.0}, {185.0, 180.0}}}, {{{109.989013926, 149.996227439}, {119.999509097, 10.0}, {164.999509097, 10.0}, {185.0, 180.0}}}, 9225.8038},
    {"kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, {{{-70.513495563, 228.204813643}, {-53.136032142, 80.5}, {-9.04617955, 80.5}, {-0.487337985, 200.194931154}}}, -53.136032142, -9.04617955, 7566.8959, {{{-71.041805802, 228.416133358}, {-53.580655654, 80.0}, {-8.580655654, 80.0}, {-0.0, 200.0}}}, {{{-71.041805802, 228.416133358}, {-53.580655654, 80.0}, {-8.580655654, 80.0}, {-0.0, 200.0}}}, 7723.7859},
    {"rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, {{{-20.0, 50.0}, {-20.0, 38.0}, {0.0, 38.0}, {0.0, 50.0}}}, -20.0, 0.0, 240.0, {{{-20.0, 50.0}, {-20.0, 38.0}, {0.0, 38.0}, {0.0, 50.0}}}, {{{-20.0, 50.0}, {-20.0, 38.0}, {0.0, 38.0}, {0.0, 50.0}}}, 240.0},
    {"radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, {{{-29.075548917, 80.0}, {-27.343273379, 60.2}, {-3.69435954, 60.2}, {-0.203085322, 80.0}}}, -26.243675971, -4.365639245, 519.6191, {{{-29.276312885, 80.0}, {-27.526539614, 60.0}, {-3.526539614, 60.0}, {0.0, 80.0}}}, {{{-30.650809646, 80.0}, {-26.426942205, 60.0}, {-4.197819319, 60.0}, {0.839099631, 80.0}}}, 532.9558},
    {"chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, {{{-28.623223511, 75.977268276}, {-27.242891396, 60.2}, {-3.795902202, 60.2}, {-0.31236884, 79.956099423}}}, -26.042891396, -4.595902202, 456.6582, {{{-28.920711629, 75.935459047}, {-27.526539614, 60.0}, {-3.526539614, 60.0}, {0.0, 80.0}}}, {{{-30.406113732, 75.726699396}, {-26.326539614, 60.0}, {-4.326539614, 60.0}, {0.990268069, 80.139173101}}}, 473.8323},
    {"shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, {{{-30.428718708, 100.0}, {-30.214359354, 99.2}, {-0.214359354, 99.2}, {-0.0, 100.0}}}, -30.214359354, -0.214359354, 24.1715, {{{-30.428718708, 100.0}, {-30.214359354, 99.2}, {-0.214359354, 99.2}, {-0.0, 100.0}}}, {{{-30.428718708, 100.0}, {-30.214359354, 99.2}, {-0.214359354, 99.2}, {-0.0, 100.0}}}, 24.1715},
    {"insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, {{{-6.749773271, 40.0}, {-5.874886635, 30.0}, {-0.874886635, 30.0}, {0.0, 40.0}}}, -5.874886635, -0.874886635, 58.7489, {{{-6.749773271, 40.0}, {-5.874886635, 30.0}, {-0.874886635, 30.0}, {0.0, 40.0}}}, {{{-6.749773271, 40.0}, {-5.874886635, 30.0}, {-0.874886635, 30.0}, {0.0, 40.0}}}, 58.7489},}};
// clang-format on

/// What a strategy must reach on a groove; `none`: nothing is said. A refusal is said by `refused`.
struct Binding {
    Strategy strategy;
    const char* name;
    Measures measures;
    double width, infeed, stepover;
    bool refused;
    double area, rest, least_cut, slot, columns, full_columns, ribs, rib_width, layers, thickest_layer, least_passes;
};

// clang-format off
inline const std::array<Binding, 56> bindings{{
    {Strategy::side_stepping, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 9048.0238, 0.0, 3016.008, 2.0, none, none, none, none, none, none, none},
    {Strategy::side_stepping, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 7566.8959, 0.0, 2522.299, 2.0, none, none, none, none, none, none, none},
    {Strategy::side_stepping, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, 240.0, 0.0, 60.0, 3.0, none, none, none, none, none, none, none},
    {Strategy::side_stepping, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 519.6191, 0.0, 103.924, 3.0, none, none, none, none, none, none, none},
    {Strategy::side_stepping, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 456.6582, 0.0, 91.332, 3.0, none, none, none, none, none, none, none},
    {Strategy::side_stepping, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, 24.1715, 0.0, 4.834, 4.0, none, none, none, none, none, none, none},
    {Strategy::side_stepping, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, false, 58.7489, 0.0, 11.75, none, none, none, none, none, none, none, none},
    {Strategy::stepwise, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 9048.0238, 0.0, 3016.008, 2.0, 19.0, none, none, none, none, none, none},
    {Strategy::stepwise, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 7566.8959, 0.0, 2522.299, 2.0, 19.0, none, none, none, none, none, none},
    {Strategy::stepwise, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, 240.0, 0.0, 60.0, 3.0, 6.0, none, none, none, none, none, none},
    {Strategy::stepwise, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 519.6191, 0.0, 103.924, 3.0, 6.0, none, none, none, none, none, none},
    {Strategy::stepwise, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 456.6582, 0.0, 91.332, 3.0, 6.0, none, none, none, none, none, none},
    {Strategy::stepwise, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, 24.1715, 0.0, 4.834, 4.0, 8.0, none, none, none, none, none, none},
    {Strategy::stepwise, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, false, 58.7489, 0.0, 11.75, none, 1.0, none, none, none, none, none, none},
    {Strategy::cycle93, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 9048.0238, 0.0, 3016.008, none, 19.0, none, none, none, none, none, none},
    {Strategy::cycle93, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 7566.8959, 0.0, 2522.299, none, 19.0, none, none, none, none, none, none},
    {Strategy::cycle93, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, 240.0, 0.0, 60.0, none, 6.0, none, none, none, none, none, none},
    {Strategy::cycle93, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 519.6191, 0.0, 103.924, none, 6.0, none, none, none, none, none, none},
    {Strategy::cycle93, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 456.6582, 0.0, 91.332, none, 6.0, none, none, none, none, none, none},
    {Strategy::cycle93, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, 24.1715, 0.0, 4.834, none, 8.0, none, none, none, none, none, none},
    {Strategy::cycle93, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, false, 58.7489, 0.0, 11.75, none, 1.0, none, none, none, none, none, none},
    {Strategy::layers, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 9048.0238, 0.0, 3016.008, 1.000001, none, none, none, none, none, none, none},
    {Strategy::layers, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 7566.8959, 0.0, 2522.299, 1.000001, none, none, none, none, none, none, none},
    {Strategy::layers, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, 240.0, 0.0, 60.0, 1.500001, none, none, none, none, none, none, none},
    {Strategy::layers, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 519.6191, 0.0, 103.924, 1.500001, none, none, none, none, none, none, none},
    {Strategy::layers, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 456.6582, 0.0, 91.332, 1.500001, none, none, none, none, none, none, none},
    {Strategy::layers, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, 24.1715, 0.0, 4.834, 2.000001, none, none, none, none, none, none, none},
    {Strategy::layers, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, false, 58.7489, 0.0, 11.75, none, none, none, none, none, none, none, none},
    {Strategy::multiple, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 9048.0238, 0.0, 3016.008, none, none, 10.0, 9.0, 1.565539, none, none, none},
    {Strategy::multiple, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 7566.8959, 0.0, 2522.299, none, none, 10.0, 9.0, 1.565539, none, none, none},
    {Strategy::multiple, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, 240.0, 0.0, 60.0, none, none, 4.0, 3.0, 1.333333, none, none, none},
    {Strategy::multiple, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 519.6191, 0.0, 103.924, none, none, 3.0, 2.0, 3.439018, none, none, none},
    {Strategy::multiple, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 456.6582, 0.0, 91.332, none, none, 3.0, 2.0, 3.223495, none, none, none},
    {Strategy::multiple, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, 24.1715, 0.0, 4.834, none, none, 4.0, 3.0, 3.333333, none, none, none},
    {Strategy::multiple, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, false, 58.7489, 0.0, 11.75, none, none, 1.0, 0.0, 0.0, none, none, none},
    {Strategy::plunge_turning, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 9044.2148, 0.1, 3014.738, none, none, none, none, none, 170.0, 1.0, none},
    {Strategy::plunge_turning, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 7563.0869, 0.1, 2521.029, none, none, none, none, none, 148.0, 1.0, none},
    {Strategy::plunge_turning, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, 238.8, 0.1, 59.7, none, none, none, none, none, 8.0, 1.5, none},
    {Strategy::plunge_turning, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 518.4313, 0.1, 103.686, none, none, none, none, none, 14.0, 1.5, none},
    {Strategy::plunge_turning, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 455.5135, 0.1, 91.103, none, none, none, none, none, 14.0, 1.5, none},
    {Strategy::plunge_turning, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, 22.1715, 0.1, 4.434, none, none, none, none, none, 1.0, 2.0, none},
    {Strategy::plunge_turning, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, false, 58.7489, 0.1, 11.75, none, none, none, none, none, 10.0, 1.0, none},
    {Strategy::ramping, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 9048.0238, 0.0, 3016.008, none, none, none, none, none, none, none, 170.0},
    {Strategy::ramping, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 7566.8959, 0.0, 2522.299, none, none, none, none, none, none, none, 148.0},
    {Strategy::ramping, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, 240.0, 0.0, 60.0, none, none, none, none, none, none, none, 8.0},
    {Strategy::ramping, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 519.6191, 0.0, 103.924, none, none, none, none, none, none, none, 14.0},
    {Strategy::ramping, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 456.6582, 0.0, 91.332, none, none, none, none, none, none, none, 14.0},
    {Strategy::ramping, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, 24.1715, 0.0, 4.834, none, none, none, none, none, none, none, 1.0},
    {Strategy::ramping, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, true, none, none, none, none, none, none, none, none, none, none, none},
    {Strategy::finishing, "kod1", {180.0, 185.0, 21.801, 170.0, 45.0, 6.71, 4.09, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 177.78, 0.0, 59.26, none, none, none, none, none, none, none, none},
    {Strategy::finishing, "kod1_mirror", {200.0, 0.0, -21.801, 120.0, 45.0, 4.09, 6.71, 0.0, 0.0, 0.0, 0.0, 0.5, 0.5, false}, 3.0, 1.0, 2.4, false, 156.89, 0.0, 52.297, none, none, none, none, none, none, none, none},
    {Strategy::finishing, "rect", {50.0, 0.0, 0.0, 12.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 4.0, 1.5, 3.2, false, -0.0, 0.0, 0.0, none, none, none, none, none, none, none, none},
    {Strategy::finishing, "radii", {80.0, 0.0, 0.0, 20.0, 24.0, 10.0, 5.0, 1.0, 0.8, 1.5, 1.2, 0.2, 0.2, false}, 5.0, 1.5, 4.0, false, 13.3367, 0.0, 2.667, none, none, none, none, none, none, none, none},
    {Strategy::finishing, "chamfers_chr", {80.0, 0.0, 8.0, 20.0, 24.0, 10.0, 5.0, -1.0, -0.8, -1.5, -1.2, 0.2, 0.3, false}, 5.0, 1.5, 4.0, false, 17.1742, 0.0, 3.435, none, none, none, none, none, none, none, none},
    {Strategy::finishing, "shallow", {100.0, 0.0, 0.0, 0.8, 30.0, 15.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 2.0, 4.0, false, -0.0, 0.0, 0.0, none, none, none, none, none, none, none, none},
    {Strategy::finishing, "insert_fits_exactly", {40.0, 0.0, 0.0, 10.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, 1.0, 4.0, false, 0.0, 0.0, 0.0, none, none, none, none, none, none, none, none},}};
// clang-format on

struct Refused {
    const char* name;
    Measures measures;
    double width;
    Guard guard;
};

// clang-format off
inline const std::array<Refused, 5> refusals{{
    {"insert_wider", {0.0, 0.0, 0.0, 10.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 5.0, Guard::insert_wider},
    {"allowance_eats_bottom", {0.0, 0.0, 0.0, 10.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.1, false}, 2.0, Guard::no_groove_left},
    {"surface_below_bottom", {0.0, 0.0, 20.0, 5.0, 40.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false}, 3.0, Guard::no_groove_left},
    {"radii_overlap", {0.0, 0.0, 0.0, 5.0, 6.0, 0.0, 0.0, 0.0, 4.0, 0.0, 4.0, 0.0, 0.0, false}, 2.0, Guard::no_groove_left},
    {"radius_longer_than_flank", {0.0, 0.0, 0.0, 2.0, 20.0, 0.0, 0.0, 1.5, 1.5, 0.0, 0.0, 0.0, 0.0, false}, 2.0, Guard::no_groove_left},}};
// clang-format on

}  // namespace obrys::cycles::groove::testing
