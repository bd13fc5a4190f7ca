// Every kind of piece on random ways against brute force: the swept solid is sampled by bisection along the ray and a
// search over time that knows nothing of the formulas.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "base/seed_testing.hpp"
#include "sim/milling/rays/rows.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

/// Positive outside, negative inside, convex: from the piece's definition alone.
double level(const Piece& p, Vec3 q) {
    const double distance = std::hypot(q.x, q.y);
    const double ends = std::max(p.z0 - q.z, q.z - p.z1);
    if (p.kind == PieceKind::cone)
        return std::max(ends, distance - (p.r0 + (p.r1 - p.r0) * (q.z - p.z0) / (p.z1 - p.z0)));
    const double round = std::hypot(std::max(0.0, distance - p.ring), q.z - p.centre) - p.arc;
    return p.whole ? round : std::max(ends, round);
}

/// Least of a convex function on [a, b].
template <class F>
double least(double a, double b, F f, double& at) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double x = b - golden * (b - a), y = a + golden * (b - a), fx = f(x), fy = f(y);
    for (int i = 0; i < 120 && b - a > 1e-14; ++i) {
        if (fx < fy) {
            b = y, y = x, fy = fx;
            x = b - golden * (b - a), fx = f(x);
        } else {
            a = x, x = y, fx = fy;
            y = a + golden * (b - a), fy = f(y);
        }
    }
    at = fx < fy ? x : y;
    double best = std::min(fx, fy);
    for (const double end : {a, b})
        if (f(end) < best) best = f(end), at = end;
    return best;
}

struct Brute {
    bool hit = false;
    double low = 0, high = 0, depth = 0;
};

Brute brute(const Piece& piece, Vec3 v, Vec3 p, Vec3 d) {
    const auto along = [&](double s) {
        double t = 0;
        return least(
            0, 1, [&](double time) { return level(piece, p + s * d - time * v); }, t);
    };
    const double reach = 200;
    double middle = 0;
    Brute b;
    b.depth = -least(-reach, reach, along, middle);
    if (b.depth <= 0) return b;
    b.hit = true;
    const auto root = [&](double outside) {
        double inside = middle;
        for (int i = 0; i < 70; ++i) {
            const double half = (inside + outside) / 2;
            (along(half) <= 0 ? inside : outside) = half;
        }
        return inside;
    };
    b.low = root(-reach);
    b.high = root(reach);
    return b;
}

const auto always = [](int, double, double) { return true; };

class Rays : public ::testing::Test {
protected:
    std::mt19937_64 random;
    std::uint64_t seed = 0;
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
    Vec3 direction() {
        for (;;) {
            const Vec3 d{between(-1, 1), between(-1, 1), between(-1, 1)};
            if (length(d) > 0.1 && length(d) < 1) return (1 / length(d)) * d;
        }
    }
    void start() {
        // One seed in CI, where the change is tested and not luck; a new one when started by hand.
        seed = base::testing_seed();
        random.seed(seed);
        RecordProperty("seed", std::to_string(seed));
    }
    Piece any_piece(int kind) {
        const double z0 = between(-2, 3), h = between(0.3, 8);
        switch (kind) {
            case 0: return cylinder(z0, z0 + h, between(0.2, 5));
            case 1: return cone(z0, z0 + h, between(0, 4), between(0, 4));
            case 2: {
                const double arc = between(1, 5), c = between(-1, 1);
                const double a = between(-0.95, 0.6);
                return round(c + a * arc, c + between(a + 0.1, 1) * arc, 0, c, arc);
            }
            case 3: {
                const double arc = between(0.3, 3), a = between(-1, 0.6);
                return round(a * arc, between(a + 0.1, 1) * arc, between(0.1, 4), 0, arc);
            }
            case 4: {
                const double arc = between(0.3, 4);
                Piece p = round(-arc, arc, 0, 0, arc);
                p.whole = true;
                return p;
            }
            default: {
                const double arc = between(0.3, 3);
                Piece p = round(-arc, arc, between(0.1, 4), 0, arc);
                p.whole = true;
                return p;
            }
        }
    }
    Vec3 any_way(int kind) {
        switch (kind) {
            case 0: return {between(-6, 6), between(-6, 6), 0};
            case 1: return {0, 0, between(-6, 6)};
            case 2: return {between(-6, 6), 0, 0};
            case 3: return between(1e-6, 1e-2) * direction();
            case 4: return {between(-1e-7, 1e-7), between(-6, 6), between(-6, 6)};
            default: return between(0.1, 12) * direction();
        }
    }
    Vec3 any_ray(int kind) {
        switch (kind) {
            case 0: return {0, 0, 1};
            case 1: return {0, 0, -1};
            case 2: return {1, 0, 0};
            case 3: return {0, -1, 0};
            default: return direction();
        }
    }
    /// A grazing ray has a short part inside, ill-conditioned in its ends: compared by how deep it goes.
    void compare(const Brute& b, bool hit, double low, double high, const std::string& what) {
        if (b.depth < 1e-7) {
            if (hit) {
                EXPECT_LT(high - low, 0.1) << what;
            }
            return;
        }
        ASSERT_TRUE(hit) << what << " depth " << b.depth;
        const double slack = 1e-6;
        EXPECT_NEAR(low, b.low, slack) << what;
        EXPECT_NEAR(high, b.high, slack) << what;
    }
};

TEST_F(Rays, OneRayAgainstAnyPieceOnAnyWay) {
    start();
    int hits = 0;
    for (int n = 0; n < 3000 && !HasFailure(); ++n) {
        const int kind = n % 6, way = (n / 6) % 6, lie = static_cast<int>(between(0, 6));
        const Piece piece = any_piece(kind);
        const Vec3 v = any_way(way), d = any_ray(lie);
        const Vec3 p = Vec3{between(-5, 5), between(-5, 5), between(-3, 6)} + between(0, 1) * v;
        const Brute b = brute(piece, v, p, d);
        double low = 0, high = 0;
        const bool hit = cut_ray(piece, v, p, d, low, high);
        hits += hit;
        compare(b, hit, low, high,
                "seed " + std::to_string(seed) + " case " + std::to_string(n) + " kind " + std::to_string(kind) +
                    " way " + std::to_string(way) + " ray " + std::to_string(lie));
    }
    EXPECT_GT(hits, 900);
}

/// Rows as tiles use them: along, across and skew, of whole tools.
TEST_F(Rays, RowsAgainstTheUnionOfTheirPieces) {
    start();
    int compared = 0;
    for (int n = 0; n < 1200 && !HasFailure(); ++n) {
        std::vector<Piece> pieces;
        const int tool = n % 6;
        const double r = between(0.5, 4), h = between(5, 20), corner = between(0.05, 0.95) * r;
        if (tool == 0) pieces = {cylinder(0, h, r)};
        if (tool == 1) pieces = {round(0, r, 0, r, r), cylinder(r, h, r)};
        if (tool == 2) pieces = {round(0, corner, r - corner, corner, corner), cylinder(corner, h, r)};
        if (tool == 3) pieces = {cone(0, corner, 0, r), cylinder(corner, h, r)};
        if (tool == 4) pieces = {cylinder(0, 2, r), cylinder(2, h, r / 2)};
        if (tool == 5) pieces = {cone(0, 2, corner, r), cone(2, h, r, corner / 2)};
        const Shape shape = make_shape(pieces);
        Track track;
        track.v = any_way((n / 6) % 6);
        const int lie = static_cast<int>(between(0, 3));
        Row row;
        row.count = 1 + static_cast<int>(between(0, Row::most - 0.01));
        const double angle = between(0, 6.3);
        row.d = lie == 0   ? Vec3{0, 0, between(0, 1) < 0.5 ? 1.0 : -1.0}
                : lie == 1 ? Vec3{std::cos(angle), std::sin(angle), 0}
                           : direction();
        Vec3 step = lie == 1 ? Vec3{-row.d.y, row.d.x, 0} : cross(row.d, direction());
        row.step = (between(0.05, 0.5) / length(step)) * step;
        Vec3 p{between(-5, 5), between(-5, 5), between(-3, 6)};
        row.p = p - dot(p, row.d) * row.d;
        const Aims aims = aims_of(track, row.d, lie == 0 ? Lie::along : lie == 1 ? Lie::across : Lie::skew);
        std::vector<std::vector<std::pair<double, double>>> parts(static_cast<std::size_t>(row.count));
        cut_row(shape, track, row, aims, always, [&](const Spans& s) {
            for (std::size_t i = 0; i < parts.size(); ++i)
                if (s.low[i] < s.high[i]) parts[i].push_back({s.low[i], s.high[i]});
        });
        Spans above;
        const bool from_above = lie == 0 && row.d.z > 0 && shape.rising;
        if (from_above) cut_row_from_above(shape, track, row, aims, above);
        for (std::size_t i = 0; i < parts.size(); i += 3) {
            const std::string what = "seed " + std::to_string(seed) + " case " + std::to_string(n) + " tool " +
                                     std::to_string(tool) + " lie " + std::to_string(lie) + " way " +
                                     std::to_string((n / 6) % 6);
            const Vec3 q = row.p + static_cast<double>(i) * row.step;
            std::vector<Brute> truth;
            double lowest = 1e9;
            for (const Piece& piece : shape.pieces) {
                Piece plain = piece;
                plain.whole = false;
                truth.push_back(brute(plain, track.v, q, row.d));
                if (truth.back().depth > 1e-7) lowest = std::min(lowest, truth.back().low);
            }
            const auto in = [](double s, double a, double b) { return s > a && s < b; };
            for (double s = -12; s < 12; s += 0.0173) {
                bool inside = false, surely = false;
                for (const Brute& b : truth) {
                    inside = inside || (b.hit && in(s, b.low - 1e-6, b.high + 1e-6));
                    surely = surely || (b.hit && b.depth > 1e-7 && in(s, b.low + 1e-6, b.high - 1e-6));
                }
                bool found = false;
                for (const auto& [a, b] : parts[i]) found = found || in(s, a, b);
                if (found) {
                    EXPECT_TRUE(inside) << what << " at " << s;
                }
                if (surely) {
                    EXPECT_TRUE(found) << what << " at " << s;
                }
                if (HasFailure()) return;
                ++compared;
            }
            if (from_above && lowest < 1e8 && lowest < above.high[i] - 1e-6) {
                EXPECT_NEAR(above.low[i], lowest, 1e-6) << what << " from above";
            }
        }
    }
    EXPECT_GT(compared, 1'000'000);
}

/// A circular track against a chain of a thousand chords.
TEST_F(Rays, QuarterCirclesAgainstChords) {
    start();
    for (int n = 0; n < 300 && !HasFailure(); ++n) {
        const double r = between(0.5, 3), radius = between(0.2, 6), a0 = between(0, 6.3),
                     sweep = between(0.1, geom::pi / 2);
        const Shape shape = make_shape({cone(0, 1, r / 2, r), cylinder(1, 4, r)});
        Track track;
        track.circular = true;
        track.turn = between(0, 1) < 0.5 ? 1 : -1;
        track.radius = radius;
        track.first = {std::cos(a0), std::sin(a0)};
        const double a1 = a0 + track.turn * sweep;
        track.last = {std::cos(a1), std::sin(a1)};
        track.centre = -radius * track.first;
        const geom::Vec2 end = track.centre + radius * track.last;
        track.v = {end.x, end.y, 0};
        const bool along = n % 2 == 0;
        Row row;
        row.count = 8;
        const double angle = between(0, 6.3);
        row.d = along ? Vec3{0, 0, 1} : Vec3{std::cos(angle), std::sin(angle), 0};
        row.step = along ? Vec3{0.3, 0.1, 0} : Vec3{-0.4 * row.d.y, 0.4 * row.d.x, 0};
        const Vec3 p{track.v.x / 2 + between(-4, 2), track.v.y / 2 + between(-4, 2), between(-0.5, 4.5)};
        row.p = p - dot(p, row.d) * row.d;
        std::vector<std::vector<std::pair<double, double>>> exact(8), chords(8);
        const auto into = [](auto& parts) {
            return [&parts](const Spans& s) {
                for (std::size_t i = 0; i < 8; ++i)
                    if (s.low[i] < s.high[i]) parts[i].push_back({s.low[i], s.high[i]});
            };
        };
        cut_row(shape, track, row, aims_of(track, row.d, along ? Lie::along : Lie::across), always, into(exact));
        constexpr int pieces = 1000;
        for (int k = 0; k < pieces; ++k) {
            const auto at = [&](int i) {
                const double a = a0 + track.turn * sweep * i / pieces;
                return track.centre + radius * geom::Vec2{std::cos(a), std::sin(a)};
            };
            const geom::Vec2 from = at(k), to = at(k + 1);
            Track chord;
            chord.v = {to.x - from.x, to.y - from.y, 0};
            Row moved = row;
            moved.p = row.p - Vec3{from.x, from.y, 0};
            const double along_ray = dot(moved.p, row.d);
            moved.p = moved.p - along_ray * row.d;
            cut_row(shape, chord, moved, aims_of(chord, row.d, along ? Lie::along : Lie::across), always,
                    [&](const Spans& s) {
                        for (std::size_t i = 0; i < 8; ++i)
                            if (s.low[i] < s.high[i])
                                chords[i].push_back({s.low[i] - along_ray, s.high[i] - along_ray});
                    });
        }
        const auto covers = [](const auto& parts, double s, double slack) {
            return std::any_of(parts.begin(), parts.end(),
                               [&](const auto& x) { return s > x.first - slack && s < x.second + slack; });
        };
        for (std::size_t i = 0; i < 8; ++i) {
            for (double s = -12; s < 12; s += 0.0137) {
                if (covers(exact[i], s, -0.003)) {
                    EXPECT_TRUE(covers(chords[i], s, 0.003)) << "seed " << seed << " case " << n << " at " << s;
                }
                if (covers(chords[i], s, -0.003)) {
                    EXPECT_TRUE(covers(exact[i], s, 0.003)) << "seed " << seed << " case " << n << " at " << s;
                }
                if (HasFailure()) return;
            }
        }
    }
}

}  // namespace
}  // namespace obrys::sim::milling
