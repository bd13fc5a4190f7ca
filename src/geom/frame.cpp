#include "geom/frame.hpp"

#include <cassert>
#include <cmath>

namespace obrys::geom {

Frame Frame::shift(Vec3 by) {
    Frame f;
    f.origin = by;
    return f;
}

Frame Frame::rotation(int axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    Frame f;
    switch (axis) {
        case 0: f.linear = {1, 0, 0, 0, c, -s, 0, s, c}; break;
        case 1: f.linear = {c, 0, s, 0, 1, 0, -s, 0, c}; break;
        default: f.linear = {c, -s, 0, s, c, 0, 0, 0, 1}; break;
    }
    return f;
}

Frame Frame::scaling(Vec3 k) {
    Frame f;
    f.linear = {k.x, 0, 0, 0, k.y, 0, 0, 0, k.z};
    return f;
}

Vec3 apply_direction(const Frame& f, Vec3 v) {
    // A coordinate may be unknown (NaN): it spoils only the coordinates it takes part in, so 0 * NaN counts as 0.
    const auto row = [&](std::size_t r) {
        const auto part = [](double factor, double x) { return factor == 0 ? 0.0 : factor * x; };
        return part(f.linear[r], v.x) + part(f.linear[r + 1], v.y) + part(f.linear[r + 2], v.z);
    };
    return {row(0), row(3), row(6)};
}

Vec3 apply(const Frame& f, Vec3 point) { return apply_direction(f, point) + f.origin; }

Frame operator*(const Frame& outer, const Frame& inner) {
    Frame f;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t col = 0; col < 3; ++col)
            f.linear[3 * row + col] = outer.linear[3 * row] * inner.linear[col] +
                                      outer.linear[3 * row + 1] * inner.linear[3 + col] +
                                      outer.linear[3 * row + 2] * inner.linear[6 + col];
    f.origin = apply(outer, inner.origin);
    return f;
}

double determinant(const Frame& f) {
    const auto& m = f.linear;
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

bool is_invertible(const Frame& f) { return std::isfinite(determinant(f)) && std::abs(determinant(f)) > 1e-12; }

Frame inverse(const Frame& f) {
    assert(is_invertible(f));
    const auto& m = f.linear;
    const double k = 1.0 / determinant(f);
    Frame inv;
    inv.linear = {k * (m[4] * m[8] - m[5] * m[7]), k * (m[2] * m[7] - m[1] * m[8]), k * (m[1] * m[5] - m[2] * m[4]),
                  k * (m[5] * m[6] - m[3] * m[8]), k * (m[0] * m[8] - m[2] * m[6]), k * (m[2] * m[3] - m[0] * m[5]),
                  k * (m[3] * m[7] - m[4] * m[6]), k * (m[1] * m[6] - m[0] * m[7]), k * (m[0] * m[4] - m[1] * m[3])};
    inv.origin = -1.0 * apply_direction(inv, f.origin);
    return inv;
}

bool is_shift_only(const Frame& f) { return f.linear == Frame{}.linear; }

}  // namespace obrys::geom
