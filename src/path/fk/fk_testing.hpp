#pragma once
/// Shared by the FK tests: short names for the words of FK blocks, running a contour, random contours with all their
/// data.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "path/fk/fk.hpp"
#include "path/path_testing.hpp"

namespace obrys::path::test {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// An FK block as it is written: FL(11).an(60).beside(30, 30, 10). Degrees.
struct Block : FkElement {
    Block& to_x(double v) { return x = FkValue{v}, *this; }
    Block& to_y(double v) { return y = FkValue{v}, *this; }
    Block& to(double u, double v) { return to_x(u).to_y(v); }
    Block& angle(double degrees) { return an = FkValue{geom::radians(degrees)}, *this; }
    Block& len(double v) { return length = v, *this; }
    Block& r(double v) { return radius = v, *this; }
    Block& dr(int sign) { return sense = sign > 0 ? Sense::counter_clockwise : Sense::clockwise, *this; }
    Block& cc(double u, double v) { return ccx = FkValue{u}, ccy = FkValue{v}, *this; }
    Block& near(double u, double v, double d) { return beside = {u, v}, distance = d, *this; }
    Block& p1(double u, double v) { return on[0] = {u, v}, *this; }
    Block& about(double u, double v) { return pole = Vec2{u, v}, *this; }
    Block& clsd(int sign) { return closed = sign > 0 ? FkClosed::begins : FkClosed::ends, *this; }
};
inline Block block(std::uint64_t tag, bool is_arc, bool tangent) {
    Block b;
    b.tag = tag;
    b.arc = is_arc;
    b.tangential = tangent;
    return b;
}
inline Block fl(std::uint64_t tag) { return block(tag, false, false); }
inline Block flt(std::uint64_t tag) { return block(tag, false, true); }
inline Block fc(std::uint64_t tag) { return block(tag, true, false); }
inline Block fct(std::uint64_t tag) { return block(tag, true, true); }

/// Collects what a contour gives out.
struct FkRun {
    FkContour contour;
    std::vector<Element> out;
    std::optional<FkFault> fault;

    explicit FkRun(Vec2 start, std::optional<Vec2> direction = {}) : contour(start, direction) {}
    void keep(const FkResult& r) {
        out.insert(out.end(), r.elements.begin(), r.elements.end());
        if (!fault) fault = r.fault;
    }
    FkRun& push(const FkElement& e) { return keep(contour.push(e)), *this; }
    FkRun& select(std::size_t n) { return keep(contour.select(n)), *this; }
    FkRun& finish() { return keep(contour.finish()), *this; }
};

inline double apart(const Element& a, const Element& b) {
    double d = std::max(geom::distance(a.from, b.from), geom::distance(a.to, b.to));
    if (is_arc(a) != is_arc(b)) return std::numeric_limits<double>::infinity();
    if (is_arc(a)) d = std::max({d, geom::distance(a.centre, b.centre), std::abs(a.sweep - b.sweep)});
    return d;
}
inline double apart(const std::vector<Element>& a, const std::vector<Element>& b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double d = 0;
    for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, apart(a[i], b[i]));
    return d;
}

/// One datum of one element of a random contour: taken out or put in without touching the others.
struct Datum {
    std::size_t element = 0;
    std::string name;
    std::function<void(FkElement&)> put;
    std::function<void(FkElement&, double)> spoil;  ///< makes it wrong by so many mm
};
struct RandomContour {
    Vec2 start;
    std::vector<Element> elements;
    std::vector<FkElement> bare;  ///< kinds, tangency, DR and pole only
    std::vector<Datum> data;
};
RandomContour random_contour(Random& r, int most);

/// The blocks with the chosen data.
inline std::vector<FkElement> described(const RandomContour& c, const std::vector<bool>& chosen) {
    std::vector<FkElement> blocks = c.bare;
    for (std::size_t i = 0; i < c.data.size(); ++i)
        if (chosen[i]) c.data[i].put(blocks[c.data[i].element]);
    return blocks;
}

/// All complete solutions, or the fault.
struct Solved {
    std::vector<std::vector<Element>> contours;
    std::optional<FkFault> fault;
};
inline Solved solve(Vec2 start, const std::vector<FkElement>& blocks) {
    FkRun run(start);
    for (const FkElement& e : blocks) run.push(e);
    Solved s;
    const FkContour before = run.contour;
    const std::vector<Element> first = run.out;
    run.finish();
    if (!run.fault) {
        s.contours.push_back(run.out);
    } else if (run.fault->reason == FkReason::ambiguous) {
        for (std::size_t i = 0; i < before.solutions(); ++i) {
            s.contours.push_back(first);
            for (const Element& e : before.solution(i)) s.contours.back().push_back(e);
        }
    }
    s.fault = run.fault;
    return s;
}

}  // namespace obrys::path::test
