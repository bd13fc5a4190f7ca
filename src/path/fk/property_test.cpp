#include <gtest/gtest.h>

#include <chrono>

#include "path/fk/fk_testing.hpp"

namespace obrys::path::test {

namespace {

std::vector<bool> some(Random& r, const RandomContour& c, int of_ten) {
    std::vector<bool> chosen(c.data.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = r.upto(9) < of_ten;
    return chosen;
}

/// Turned about the origin, then moved; or mirrored at the first axis.
struct Motion {
    double angle = 0;
    Vec2 shift;
    bool mirror = false;

    [[nodiscard]] Vec2 vector(Vec2 v) const { return rotated({v.x, mirror ? -v.y : v.y}, angle); }
    [[nodiscard]] Vec2 point(Vec2 v) const { return vector(v) + shift; }
    [[nodiscard]] Element element(Element e) const {
        e.from = point(e.from);
        e.to = point(e.to);
        if (is_arc(e)) e.centre = point(e.centre);
        if (mirror) e.sweep = -e.sweep;
        return e;
    }
    void at(FkPoint& p) const {
        if (!p.x || !p.y) return;
        const Vec2 v = point({*p.x, *p.y});
        p = {v.x, v.y};
    }
    void direction(std::optional<FkValue>& v) const {
        if (!v) return;
        if (mirror) v->value = -v->value;
        if (v->base == FkBase::absolute) v->value += angle;
    }
    /// Single coordinates: only for motions that keep the axes.
    void coordinates(std::optional<FkValue>& x, std::optional<FkValue>& y) const {
        if (y && mirror) y->value = -y->value;
        if (x && x->base == FkBase::absolute) x->value += shift.x;
        if (y && y->base == FkBase::absolute) y->value += shift.y;
    }
    [[nodiscard]] FkElement block(FkElement e) const {
        coordinates(e.x, e.y);
        coordinates(e.ccx, e.ccy);
        for (std::optional<FkValue>* v : {&e.pa, &e.ccpa, &e.an}) direction(*v);
        if (e.cca && e.cca->base == FkBase::absolute) direction(e.cca);
        for (FkPoint& p : e.on) at(p);
        at(e.beside);
        if (e.pole) e.pole = point(*e.pole);
        if (mirror && e.sense) e.sense = *e.sense == Sense::clockwise ? Sense::counter_clockwise : Sense::clockwise;
        return e;
    }
};

Solved moved(const Motion& m, Vec2 start, const std::vector<FkElement>& blocks) {
    std::vector<FkElement> there;
    for (const FkElement& e : blocks) there.push_back(m.block(e));
    return solve(m.point(start), there);
}

std::vector<Element> moved(const Motion& m, std::vector<Element> contour) {
    for (Element& e : contour) e = m.element(e);
    return contour;
}

/// Any datum whatever in any element, most of them senseless together.
FkElement nonsense(Random& r, std::uint64_t tag) {
    const auto value = [&r, tag]() -> std::optional<FkValue> {
        if (r.upto(7) > 0) return {};
        FkValue v{r.in(-50, 50), FkBase::absolute, tag - 1 - static_cast<std::uint64_t>(r.upto(2))};
        if (r.upto(3) == 0) v.base = tag > 12 && r.upto(1) == 0 ? FkBase::block : FkBase::incremental;
        if (r.upto(3) == 0) v.value = std::round(v.value / 10) * 10;
        return v;
    };
    const auto number = [&r]() -> std::optional<double> {
        if (r.upto(7) > 0) return {};
        return r.upto(1) == 0 ? r.in(0, 40) : 10.0 * r.upto(5);
    };
    FkElement e = block(tag, r.upto(1) == 0, r.upto(2) == 0);
    e.x = value(), e.y = value(), e.pr = value(), e.pa = value(), e.an = value();
    e.length = number();
    if (e.arc) {
        e.radius = number();
        e.ccx = value(), e.ccy = value(), e.ccpr = value(), e.ccpa = value(), e.cca = value();
        if (r.upto(2) > 0) e.sense = static_cast<Sense>(r.upto(1));
    } else if (tag > 10 && r.upto(5) == 0) {
        e.parallel = tag - 1;
        e.parallel_distance = number();
    }
    if (r.upto(5) == 0) e.on[0] = {r.in(-50, 50), r.in(-50, 50)};
    if (r.upto(5) == 0) e.beside = {r.in(-50, 50), r.in(-50, 50)}, e.distance = r.in(0, 20);
    e.closed = tag == 10 ? FkClosed::begins : r.upto(15) == 0 ? FkClosed::ends : FkClosed::no;
    e.pole = Vec2{10.0 * r.upto(3), 10.0 * r.upto(3)};
    return e;
}

}  // namespace

TEST(FkProperty, ARedundantDatumThatIsWrongIsAContradiction) {
    const std::uint32_t seed = 407;
    std::printf("seed %u\n", seed);
    Random r(seed);
    int cases = 0, other = 0;
    for (int i = 0; i < 400; ++i) {
        const RandomContour c = random_contour(r, 4);
        std::vector<bool> chosen = some(r, c, 8);
        const auto wrong = static_cast<std::size_t>(r.upto(static_cast<int>(c.data.size()) - 1));
        chosen[wrong] = false;
        if (solve(c.start, described(c, chosen)).contours.size() != 1) continue;
        chosen[wrong] = true;
        std::vector<FkElement> blocks = described(c, chosen);
        const Datum& d = c.data[wrong];
        d.spoil(blocks[d.element], r.upto(1) == 0 ? 0.1 : -0.1);
        const Solved s = solve(c.start, blocks);
        ++cases;
        ASSERT_TRUE(s.fault && s.contours.empty()) << i << " " << d.name << " of element " << d.element;
        if (s.fault->reason != FkReason::contradictory) {
            ++other;
            EXPECT_EQ(s.fault->reason, FkReason::bad_value);
            continue;
        }
        EXPECT_GT(s.fault->miss, fk_tolerance);
    }
    std::printf("%d contradictions\n", cases);
    EXPECT_GT(cases, 200);
    EXPECT_LT(other, 5);
}

TEST(FkProperty, MovedAndTurnedDataGiveTheMovedContoursInTheSameOrder) {
    const std::uint32_t seed = 320;
    std::printf("seed %u\n", seed);
    Random r(seed);
    int finite = 0, several = 0;
    for (int i = 0; i < 600; ++i) {
        const RandomContour c = random_contour(r, 4);
        std::vector<bool> chosen = some(r, c, 5);
        const bool turn = r.upto(1) == 0;
        for (std::size_t k = 0; k < chosen.size(); ++k)
            if (turn && (c.data[k].name.back() == 'X' || c.data[k].name.back() == 'Y')) chosen[k] = false;
        const Motion m{turn ? r.in(-3, 3) : 0, {r.in(-100, 100), r.in(-100, 100)}, false};
        const auto blocks = described(c, chosen);
        const Solved here = solve(c.start, blocks), there = moved(m, c.start, blocks);
        ASSERT_EQ(here.contours.size(), there.contours.size()) << i;
        ASSERT_EQ(here.fault.has_value(), there.fault.has_value()) << i;
        for (std::size_t k = 0; k < here.contours.size(); ++k)
            EXPECT_LT(apart(moved(m, here.contours[k]), there.contours[k]), 1e-5) << i << ", solution " << k;
        finite += here.contours.empty() ? 0 : 1;
        several += here.contours.size() > 1 ? 1 : 0;
    }
    std::printf("%d solved, %d in several ways\n", finite, several);
    EXPECT_GT(several, 30);
}

TEST(FkProperty, MirroredDataGiveTheMirroredContours) {
    const std::uint32_t seed = 426;
    std::printf("seed %u\n", seed);
    Random r(seed);
    const Motion m{0, {}, true};
    for (int i = 0; i < 600; ++i) {
        const RandomContour c = random_contour(r, 4);
        const auto blocks = described(c, some(r, c, 5));
        const Solved here = solve(c.start, blocks), there = moved(m, c.start, blocks);
        ASSERT_EQ(here.contours.size(), there.contours.size()) << i;
        for (const auto& contour : here.contours) {
            double best = std::numeric_limits<double>::infinity();
            for (const auto& other : there.contours) best = std::min(best, apart(moved(m, contour), other));
            EXPECT_LT(best, 1e-5) << i;
        }
    }
}

TEST(FkProperty, NonsenseEndsInBoundedTimeWithFiniteContours) {
    const std::uint32_t seed = 1;
    std::printf("seed %u\n", seed);
    Random r(seed);
    double slowest = 0;
    int elements = 0;
    for (int i = 0; i < 1500; ++i) {
        FkRun run({r.in(-50, 50), 0}, Vec2{1, 0});
        for (std::uint64_t tag = 10; tag < 22 && !run.fault; ++tag) {
            const auto begin = std::chrono::steady_clock::now();
            run.push(nonsense(r, tag));
            if (r.upto(3) == 0 && run.contour.solutions() > 1) run.select(1 + static_cast<std::size_t>(r.upto(1)));
            slowest =
                std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        }
        run.finish();
        for (const Element& e : run.out) {
            ++elements;
            ASSERT_TRUE(std::isfinite(e.to.x) && std::isfinite(e.to.y) && std::isfinite(e.sweep)) << i;
            ASSERT_TRUE(geom::length(e.to) < 1e8);
        }
    }
    std::printf("%d elements, slowest call %.3f s\n", elements, slowest);
    EXPECT_LT(slowest, 5);
}

TEST(FkProperty, SparseNonsenseIsBoundedToo) {
    const std::uint32_t seed = 2;
    std::printf("seed %u\n", seed);
    Random r(seed);
    double slowest = 0;
    for (int i = 0; i < 150; ++i) {
        const RandomContour c = random_contour(r, 16);
        const auto begin = std::chrono::steady_clock::now();
        const Solved s = solve(c.start, described(c, some(r, c, 1 + r.upto(2))));
        slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        if (s.contours.size() == 1) {
            EXPECT_LT(apart(s.contours[0], c.elements), 1e-5) << i;
        }
    }
    std::printf("slowest contour %.3f s\n", slowest);
    EXPECT_LT(slowest, 5);
}

TEST(FkProperty, ANumberNotKnownNeverGivesAContour) {
    const std::uint32_t seed = 3;
    std::printf("seed %u\n", seed);
    Random r(seed);
    for (int i = 0; i < 300; ++i) {
        const RandomContour c = random_contour(r, 3);
        const auto which = static_cast<std::size_t>(r.upto(static_cast<int>(c.data.size()) - 1));
        std::vector<bool> chosen = some(r, c, 7);
        chosen[which] = true;
        std::vector<FkElement> blocks = described(c, chosen);
        c.data[which].spoil(blocks[c.data[which].element], not_given);
        const Solved s = solve(c.start, blocks);
        ASSERT_TRUE(s.fault) << i;
        EXPECT_TRUE(s.contours.empty());
        EXPECT_EQ(s.fault->reason, FkReason::not_known) << i << " " << c.data[which].name;
    }
}

}  // namespace obrys::path::test
