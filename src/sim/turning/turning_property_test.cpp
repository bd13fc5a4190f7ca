#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/boolean.hpp"
#include "geom/random_contours_testing.hpp"
#include "geom/sweep.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::sim::turning {
namespace {

using geom::Contour;
using geom::Region;
using geom::Vec2;

rc::Gen<Contour> tool() {
    return rc::gen::element(
        Contour{{{{0, 0}}, {{1, 0}}, {{1, 3}}, {{0, 3}}}, true},                      // blade
        Contour{{{{-1, 0}, 1}, {{1, 0}, 1}}, true},                                   // round
        Contour{{{{0, 0}}, {{2, 1}}, {{1, 3}}}, true},                                // pointed
        Contour{{{{0, 0}}, {{3, 0}}, {{3, 3}}, {{2, 3}}, {{2, 1}}, {{0, 1}}}, true},  // hooked
        Contour{{{{0, 0}}, {{2, 0}, 0.41421356237309503}, {{3, 1}}, {{3, 2}, -1}, {{1, 2}}, {{0, 2}}}, true});
}
double lattice() { return static_cast<double>(*rc::gen::inRange(0, 12)); }

Move any_move() {
    const Vec2 a{lattice(), lattice()}, b{lattice(), lattice()};
    if (*rc::gen::inRange(0, 3) > 0 || a == b) return {a, b, {}, 0};
    // about b, a quarter or a half turn
    const double turn = *rc::gen::element(geom::pi / 2, -geom::pi / 2, geom::pi, -geom::pi);
    const Vec2 r = a - b;
    const double c = std::cos(turn), s = std::sin(turn);
    return {a, b + Vec2{c * r.x - s * r.y, s * r.x + c * r.y}, b, turn};
}

Region swept(const Contour& outline, const Move& m) {
    if (m.sweep == 0) {
        Region r = geom::sweep_straight(outline, m.to - m.from);
        for (Contour& c : r.contours) c = geom::moved(c, m.from);
        return r;
    }
    const Vec2 r = m.from - m.centre;
    return geom::sweep_round(outline, m.centre, geom::length(r), std::atan2(r.y, r.x), m.sweep);
}

/// With what passes below the axis turned up.
Region both_sides(const Region& r) {
    Region turned = r;
    for (Contour& c : turned.contours) {
        for (geom::Vertex& v : c.vertices) v = {{v.p.x, -v.p.y}, -v.bulge};
        c = geom::reversed(c);
    }
    return geom::unite(r, turned);
}

// The local cut held against the set operations on the whole stock, which keep no links and no grid.
RC_GTEST_PROP(TurningProperty, LocalCutIsTheSetDifference, ()) {
    const Region above{{{{{{-20, 0}, 0}, {{40, 0}, 0}, {{40, 40}, 0}, {{-20, 40}, 0}}, true}}};
    Region whole = geom::intersect(*geom::testing::lattice_region(12, 10), above);
    Workpiece w(whole);
    const Contour outline = *tool();
    for (int k = 0; k < 15; ++k) {
        const Move m = any_move();
        const Region s = both_sides(swept(outline, m));
        const double removed = geom::area(geom::intersect(whole, s));
        whole = geom::subtract(whole, s);
        const Cut c = w.cut(outline, m);
        RC_ASSERT(std::abs(c.area - removed) < 1e-6);
        RC_ASSERT(std::abs(w.area() - geom::area(whole)) < 1e-6);
        RC_ASSERT(std::abs(w.volume() - geom::volume(whole)) < 1e-4);
        RC_ASSERT(std::abs(geom::area(w.region()) - w.area()) < 1e-6);
    }
}

RC_GTEST_PROP(TurningProperty, ACopyGoesOnFromWhereItWasMade, ()) {
    const Region above{{{{{{-20, 0}, 0}, {{40, 0}, 0}, {{40, 40}, 0}, {{-20, 40}, 0}}, true}}};
    Workpiece w(geom::intersect(*geom::testing::lattice_region(12, 10), above));
    struct Pass {
        Contour outline;
        Move move;
    };
    std::vector<Pass> passes;
    for (int i = 0; i < 6; ++i) passes.push_back({*tool(), any_move()});
    const auto copied_at = static_cast<std::size_t>(*rc::gen::inRange(0, 6));
    std::optional<Workpiece> copy;
    std::vector<Region> removed, left;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        if (i == copied_at) copy = w;
        removed.push_back(w.cut(passes[i].outline, passes[i].move).removed);
        left.push_back(w.region());
    }
    const auto same = [](const Region& a, const Region& b) {
        RC_ASSERT(a.contours.size() == b.contours.size());
        for (std::size_t i = 0; i < a.contours.size(); ++i)
            for (std::size_t k = 0; k < a.contours[i].vertices.size(); ++k)
                RC_ASSERT(a.contours[i].vertices[k].p == b.contours[i].vertices[k].p);
    };
    for (std::size_t i = copied_at; i < passes.size(); ++i) {
        same(copy->cut(passes[i].outline, passes[i].move).removed, removed[i]);
        same(copy->region(), left[i]);
    }
}

RC_GTEST_PROP(TurningProperty, OrderOfCutsDoesNotMatterForWhatIsLeft, ()) {
    const Region stock = *geom::testing::lattice_region(12, 10);
    Workpiece forward(stock), backward(stock);
    const Contour outline = *tool();
    std::vector<Move> moves;
    for (int k = 0; k < 8; ++k) moves.push_back(any_move());
    for (const Move& m : moves) forward.cut(outline, m);
    for (auto m = moves.rbegin(); m != moves.rend(); ++m) backward.cut(outline, *m);
    RC_ASSERT(std::abs(forward.area() - backward.area()) < 1e-6);
}

RC_GTEST_PROP(TurningProperty, AMoveInTwoPartsTakesWhatTheWholeTakes, ()) {
    const Region stock = *geom::testing::lattice_region(12, 10);
    Workpiece once(stock), twice(stock);
    const Contour outline = *tool();
    const Vec2 a{lattice(), lattice()}, b{lattice(), lattice()};
    const double t = *rc::gen::element(0.5, 0.3, 0.0, 1.0, 1e-10, 0.25);
    const Vec2 mid = a + t * (b - a);
    const double whole = once.cut(outline, {a, b, {}, 0}).area;
    const double first = twice.cut(outline, {a, mid, {}, 0}).area, second = twice.cut(outline, {mid, b, {}, 0}).area;
    RC_ASSERT(std::abs(whole - first - second) < 1e-6);
}

RC_GTEST_PROP(TurningProperty, ShiftedAlongZItIsTheSame, ()) {
    Region stock = *geom::testing::lattice_region(12, 10);
    Workpiece here(stock);
    const double by = *rc::gen::element(1000.0, -333.33, 0.1);
    for (Contour& c : stock.contours) c = geom::moved(c, {by, 0});
    Workpiece there(stock);
    const Contour outline = *tool();
    for (int k = 0; k < 8; ++k) {
        Move m = any_move();
        const Cut x = here.cut(outline, m);
        m.from.x += by;
        m.to.x += by;
        m.centre.x += by;
        const Cut y = there.cut(outline, m);
        RC_ASSERT(std::abs(x.area - y.area) < 1e-6);
        RC_ASSERT(std::abs(x.volume - y.volume) < 1e-4);
    }
}

// Depths against many points of the overlap.
RC_GTEST_PROP(DepthProperty, NoPointOfTheOverlapIsDeeper, ()) {
    const Region kept = *geom::testing::lattice_region(8), removed = *geom::testing::lattice_region(8);
    const auto d = depth_inside(removed, kept, 1e-6);
    double deepest = 0;
    for (int k = 0; k < 60; ++k) {
        const Vec2 p = *geom::testing::free_point(8);
        if (!geom::contains(kept, p) || !geom::contains(removed, p)) continue;
        double away = 1e9;
        for (const geom::Edge& e : geom::edges(kept))
            if (std::abs(e.a.y) > 1e-9 || std::abs(e.b.y) > 1e-9 || e.bulge != 0)
                away = std::min(away, geom::distance(e, p));
        deepest = std::max(deepest, away);
    }
    if (deepest < 1e-3 || deepest > 1e8) return;
    RC_ASSERT(d.has_value());
    RC_ASSERT(deepest <= d->normal + 1e-3);
    RC_ASSERT(geom::contains(kept, d->deepest) || geom::distance(kept, d->deepest) < 1e-3);
}

// The local overlap held against the one with the whole contour.
RC_GTEST_PROP(DepthProperty, AKeptContourGivesTheDepthsOfTheWhole, ()) {
    const Region region = *geom::testing::lattice_region(12, 10);
    Kept kept(region);
    for (int k = 0; k < 10; ++k) {
        const Region removed = *geom::testing::lattice_region(*rc::gen::element(3, 12));
        const auto a = kept.depth_inside(removed, 1e-6), b = depth_inside(removed, region, 1e-6);
        RC_ASSERT(a.has_value() == b.has_value());
        if (!a) continue;
        RC_ASSERT(std::abs(a->area - b->area) < 1e-6);
        RC_ASSERT(std::abs(a->volume - b->volume) < 1e-4);
        RC_ASSERT(std::abs(a->normal - b->normal) < 5e-4);
        RC_ASSERT(std::abs(a->along_x - b->along_x) < 1e-6);
    }
}

/// Distance of a point from an edge, written anew: by the line's foot, or by the circle through three points.
double plain_distance(const geom::Edge& e, Vec2 p) {
    double away = std::min(geom::distance(p, e.a), geom::distance(p, e.b));
    const Vec2 chord = e.b - e.a;
    const double l2 = geom::dot(chord, chord), along = geom::dot(p - e.a, chord);
    if (e.bulge == 0) {
        if (along > 0 && along < l2) away = std::min(away, std::abs(geom::cross(chord, p - e.a)) / std::sqrt(l2));
        return away;
    }
    const double sweep = 4 * std::atan(e.bulge), l = std::sqrt(l2), r = l / (2 * std::sin(std::abs(sweep) / 2));
    const Vec2 left{-chord.y / l, chord.x / l}, middle = 0.5 * (e.a + e.b);
    const Vec2 centre = middle + (std::copysign(r, sweep) * std::cos(sweep / 2)) * left;
    double angle = std::atan2(p.y - centre.y, p.x - centre.x) - std::atan2(e.a.y - centre.y, e.a.x - centre.x);
    if (sweep < 0) angle = -angle;
    while (angle < 0) angle += 2 * geom::pi;
    while (angle >= 2 * geom::pi) angle -= 2 * geom::pi;
    return angle <= std::abs(sweep) ? std::min(away, std::abs(geom::distance(p, centre) - r)) : away;
}

double plain_depth(const Region& contour, Vec2 p) {
    double away = 1e9;
    for (const geom::Edge& e : geom::edges(contour))
        if (std::abs(e.a.y) > 1e-9 || std::abs(e.b.y) > 1e-9 || e.bulge != 0)
            away = std::min(away, plain_distance(e, p));
    return away;
}

/// The deepest of many points on the edges of a piece and between them.
double sampled_depth(const Region& piece, const Region& contour) {
    double deepest = 0;
    const auto edges = geom::edges(piece);
    for (const geom::Edge& e : edges)
        for (int i = 0; i <= 16; ++i) deepest = std::max(deepest, plain_depth(contour, geom::point_at(e, i / 16.0)));
    const geom::Box b = geom::box(piece);
    for (int i = 0; i < 150; ++i) {
        const Vec2 p{b.lo.x + (b.hi.x - b.lo.x) * std::fmod(0.754877666 * i, 1.0),
                     b.lo.y + (b.hi.y - b.lo.y) * std::fmod(0.569840291 * i, 1.0)};
        if (geom::contains(piece, p)) deepest = std::max(deepest, plain_depth(contour, p));
    }
    return deepest;
}

/// Films, wedges, crescents and rings: a profile and the same shifted by little, in one direction or in four.
Region nearly(const Region& profile, double by) {
    const double angle = *rc::gen::element(0.0, 1.5707963, 0.7853982, 2.1, 3.7, 5.5);
    const bool all_round = *rc::gen::inRange(0, 3) == 0;
    Region out;
    for (int k = 0; k < (all_round ? 4 : 1); ++k) {
        Region shifted = profile;
        const double a = angle + k * geom::pi / 2;
        for (Contour& c : shifted.contours) c = geom::moved(c, {by * std::cos(a), by * std::sin(a)});
        out = k == 0 ? shifted : geom::unite(out, shifted);
    }
    return out;
}

Region profile_away_from_the_axis() {
    Region r = *geom::testing::lattice_region(9, 7);
    const double scale = *rc::gen::element(1.0, 0.05, 7.0), up = *rc::gen::element(0.0, 0.0, 30.0);
    for (Contour& c : r.contours)
        for (geom::Vertex& v : c.vertices) v.p = {scale * v.p.x, scale * v.p.y + up};
    return r;
}

// A depth is that of a point of the piece, and no other point lies deeper: by points sampled densely.
RC_GTEST_PROP(DepthProperty, SliversAreAsDeepAsTheyAre, ()) {
    const Region wanted = profile_away_from_the_axis();
    const Region other = nearly(wanted, *rc::gen::element(1e-4, 1e-3, 0.004, 0.02, 0.3));
    const double tolerance = *rc::gen::element(0.01, 0.001, 0.05);
    for (const Region& piece : geom::pieces(geom::subtract(other, wanted))) {
        const double deepest = sampled_depth(piece, wanted);
        if (deepest > 1e8) continue;
        const auto rest = pieces_outside(geom::unite(wanted, piece), wanted, tolerance);
        double found = 0;
        for (const Depth& d : rest) {
            RC_ASSERT(geom::contains(d.region, d.deepest) || geom::distance(d.region, d.deepest) < 3e-5);
            RC_ASSERT(std::abs(plain_depth(wanted, d.deepest) - d.normal) < 1e-7);
            found = std::max(found, d.normal);
        }
        if (deepest > tolerance && deepest > 2 * tolerance / 10) RC_ASSERT(found > deepest - 6e-5 || rest.empty());
        if (found > 0) RC_ASSERT(found > tolerance);
    }
    const auto gouge = depth_inside(geom::subtract(wanted, other), wanted, 1e-3);
    if (!gouge) return;
    RC_ASSERT(std::abs(plain_depth(wanted, gouge->deepest) - gouge->normal) < 1e-7);
    RC_ASSERT(geom::distance(gouge->region, gouge->deepest) < 3e-5 || geom::contains(gouge->region, gouge->deepest));
    RC_ASSERT(gouge->normal > sampled_depth(gouge->region, wanted) - 6e-5);
}

/// The x at which a line upright at z meets the contour, sampled.
std::vector<double> met(const Region& r, double z, bool with_axis) {
    std::vector<double> out;
    for (const geom::Edge& e : geom::edges(r)) {
        if (!with_axis && std::abs(e.a.y) < 1e-9 && std::abs(e.b.y) < 1e-9 && e.bulge == 0) continue;
        constexpr int parts = 120;
        for (int i = 0; i < parts; ++i) {
            const Vec2 p = geom::point_at(e, static_cast<double>(i) / parts);
            const Vec2 q = geom::point_at(e, static_cast<double>(i + 1) / parts);
            if ((p.x <= z) != (q.x <= z)) out.push_back(p.y + (z - p.x) / (q.x - p.x) * (q.y - p.y));
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

// Along x against columns one by one.
RC_GTEST_PROP(DepthProperty, AlongXIsTheDeepestColumn, ()) {
    const Region kept = *geom::testing::lattice_region(8), removed = *geom::testing::lattice_region(8);
    const auto d = depth_inside(removed, kept, 1e-6);
    if (!d) return;
    double deepest = 0;
    const geom::Box b = geom::box(d->region);
    constexpr int columns = 60;
    for (int k = 0; k < columns; ++k) {
        const double z = b.lo.x + (b.hi.x - b.lo.x) * (k + 0.4142) / columns;
        const std::vector<double> own = met(d->region, z, true), walls = met(kept, z, false);
        for (std::size_t i = 0; i + 1 < own.size(); i += 2)
            for (int j = 0; j <= 20; ++j) {
                const double x = own[i] + (own[i + 1] - own[i]) * j / 20;
                double way = 1e9;
                for (const double w : walls) way = std::min(way, std::abs(w - x));
                if (way < 1e8) deepest = std::max(deepest, way);
            }
    }
    RC_ASSERT(d->along_x >= deepest - 5e-3);
    RC_ASSERT(d->along_x <= deepest + 0.6);
}

}  // namespace
}  // namespace obrys::sim::turning
