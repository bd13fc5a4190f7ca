#include "driver/timing/test_program.hpp"

#include "base/number.hpp"

namespace obrys::driver {
namespace {

std::string n(double v) { return base::shortest(v); }

}  // namespace

std::string test_program(double size, double feed) {
    // Each part ends in an optional stop: with it on, the parts can be timed one by one (columns first and last).
    constexpr int rapids = 10, zigzags = 100, circles = 5;
    constexpr double step = 1, wide = 2;  // mm of a zigzag: short enough that corners decide
    std::string out = "(times for obrys calibrate, needs " + n(size) +
                      " mm above and beside the zero)\nG21 G17 G90 G94 G40\nT1 M6\n"
                      "G0 X0 Y0 Z" +
                      n(size / 2) + "\nM1\n";
    for (const double length : {size / 10, size / 2.5, size}) {
        out += "(rapids of " + n(length) + " mm, " + std::to_string(rapids) + " in X, Y and Z)\n";
        for (int i = 0; i < rapids / 2; ++i) out += "G0 X" + n(length) + "\nG0 X0\n";
        for (int i = 0; i < rapids / 2; ++i) out += "G0 Y" + n(length) + "\nG0 Y0\n";
        const double top = size / 2;
        for (int i = 0; i < rapids / 2; ++i) out += "G0 Z" + n(top - length / 2) + "\nG0 Z" + n(top) + "\n";
        out += "M1\n";
    }
    for (const double f : {feed / 10, feed / 3, feed}) {
        out += "(zigzag at F" + n(f) + ", " + std::to_string(2 * zigzags) + " blocks)\nG0 X0 Y0\n";
        for (int i = 0; i < 2 * zigzags; ++i) {
            const double x = (i < zigzags ? i + 1 : 2 * zigzags - i - 1) * step * size / 2 / zigzags;
            out += "G1 X" + n(x) + " Y" + n(i % 2 == 0 ? wide : 0) + (i == 0 ? " F" + n(f) : "") + "\n";
        }
        out += "M1\n";
    }
    for (const double radius : {size / 20, size / 8, size / 2.5}) {
        out += "(circles of radius " + n(radius) + " at F" + n(feed) + ")\nG0 X0 Y0\n";
        for (int i = 0; i < circles; ++i)
            out += "G2 X0 Y0 I" + n(radius) + " J0" + (i == 0 ? " F" + n(feed) : "") + "\n";
        out += "M1\n";
    }
    return out + "M2\n";
}

}  // namespace obrys::driver
