#include "check/turning/turned_thread.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "check/words.hpp"
#include "geom/boolean.hpp"
#include "geom/region.hpp"

namespace obrys::check {

using geom::Edge;
using geom::Region;
using geom::Vec2;

namespace {

// Shares of the pitch.
constexpr double turned_off = 0.15;     ///< that a turned diameter may be off what the contour shows
constexpr double root_tolerance = 0.1;  ///< of the root below a core that the contour shows: 6g has 0.08 there
constexpr double din_run_out = 2.5;     ///< where a thread ends in a shaft; DIN 76-1, x1
constexpr double root = 0.05;           ///< height in which an insert's width at the bottom is looked at

constexpr double beside_slope = 0.1;       ///< slope against the pass of what runs beside it
constexpr double step = 0.002;             ///< mm between two pieces of one surface
constexpr double steep = 0.36;             ///< slope from which a pass leads in or out: tan 20 degrees
constexpr double far = 1e5;                ///< mm
constexpr double thinnest_surface = 1e-6;  ///< mm

Vec2 mirrored(Vec2 p) { return {p.x, -p.y}; }

/// Work on the far side of the axis is met where it turns up.
bool is_beyond(const sim::turning::Move& way) { return way.from.y <= 0 && way.to.y <= 0 && way.from.y + way.to.y < 0; }

sim::turning::Move line_of(const sim::turning::Move& way) {
    return is_beyond(way) ? sim::turning::Move{mirrored(way.from), mirrored(way.to), {}, 0} : way;
}

/// The side of the pass on which the insert goes on: it comes from outside.
Vec2 out_of(const ThreadPass& pass, Vec2 along) {
    const geom::Box b = geom::box(pass.outline);
    const Vec2 middle = 0.5 * (b.lo + b.hi), left = geom::left_of(along);
    return geom::dot(is_beyond(pass.way) ? mirrored(middle) : middle, left) < 0 ? -left : left;
}

/// Heights in which a column across the pass meets a contour, from outside inwards.
class Columns {
public:
    Columns(const Region& region, Vec2 along, Vec2 out) : along_(along), out_(out) {
        for (const Edge& e : geom::edges(region)) {
            const double a = geom::dot(e.a, along), b = geom::dot(e.b, along);
            const double bulge = std::abs(geom::sagitta(e));
            walls_.push_back({e, std::min(a, b) - bulge, std::max(a, b) + bulge});
        }
    }
    [[nodiscard]] std::vector<double> at(double s) const {
        const Vec2 foot = s * along_;
        std::vector<double> heights;
        for (const Wall& w : walls_) {
            if (w.lo > s || w.hi < s) continue;
            const geom::Crossings c = geom::crossings(w.edge, {foot + far * out_, foot - far * out_, 0}, 1e-9);
            for (int i = 0; i < c.count; ++i) heights.push_back(geom::dot(c.points[static_cast<std::size_t>(i)], out_));
        }
        std::sort(heights.begin(), heights.end(), std::greater<>());
        return heights;
    }
    void add_corners(double lo, double hi, std::vector<double>& out) const {
        for (const Wall& w : walls_)
            for (const Vec2 p : {w.edge.a, w.edge.b})
                if (const double s = geom::dot(p, along_); s > lo && s < hi) out.push_back(s);
    }

private:
    struct Wall {
        Edge edge;
        double lo, hi;
    };
    Vec2 along_, out_;
    std::vector<Wall> walls_;
};

struct Surface {
    double crest = NAN, contour = NAN;
    [[nodiscard]] bool known() const { return std::isfinite(crest) && std::isfinite(contour); }
};

Surface surface_at(const Columns& band, const Columns& part, double s) {
    Surface out;
    if (const auto met = band.at(s); !met.empty()) out.crest = met.front();
    const auto walls = part.at(s);
    for (std::size_t i = 0; i + 1 < walls.size() && std::isnan(out.contour); i += 2)
        if (walls[i + 1] < out.crest) out.contour = std::min(walls[i], out.crest);
    return out;
}

/// A run along which neither stock nor contour has a step.
struct Run {
    double length = 0, crest = -INFINITY, contour = -INFINITY;
    void add(double width, const Surface& a, const Surface& b) {
        length += width;
        crest = std::max({crest, a.crest, b.crest});
        contour = std::max({contour, a.contour, b.contour});
    }
};

bool goes_on(const Surface& a, const Surface& b, double slope, double width) {
    const double most = step + slope * width;
    return a.known() && b.known() && std::abs(a.crest - b.crest) <= most && std::abs(a.contour - b.contour) <= most;
}

std::optional<Run> first_run(const Columns& band, const Columns& part, std::vector<double> corners, double wanted) {
    std::sort(corners.begin(), corners.end());
    Run run, longest;
    Surface last;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const double s0 = corners[i], s1 = corners[i + 1];
        if (s1 - s0 <= 3 * thinnest_surface) continue;
        const Surface a = surface_at(band, part, s0 + thinnest_surface),
                      b = surface_at(band, part, s1 - thinnest_surface);
        if (run.length > 0 && !goes_on(last, a, 0, 0)) run = {};
        last = b;
        if (!goes_on(a, b, beside_slope, s1 - s0)) {
            run = {};
            continue;
        }
        run.add(s1 - s0, a, b);
        if (run.length > longest.length) longest = run;
        if (longest.length >= wanted) break;
    }
    if (longest.length == 0) return std::nullopt;
    return longest;
}

/// What lies between two heights and two places along the pass.
Region block(const ThreadGround& g, double s0, double s1, double low, double high) {
    const auto at = [&](double s, double h) { return s * g.along + h * g.out; };
    geom::Contour c{{{at(s0, low)}, {at(s1, low)}, {at(s1, high)}, {at(s0, high)}}, true};
    if (geom::cross(g.along, g.out) < 0) c = geom::reversed(c);
    return {{c}};
}

struct Extent {
    double s0 = INFINITY, s1 = -INFINITY, high = -INFINITY;
};
Extent extent_of(const Region& region, const ThreadGround& g) {
    Extent out;
    for (const Edge& e : geom::edges(region))
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            const Vec2 p = geom::point_at(e, t);
            out.s0 = std::min(out.s0, geom::dot(p, g.along));
            out.s1 = std::max(out.s1, geom::dot(p, g.along));
            out.high = std::max(out.high, geom::dot(p, g.out));
        }
    return out;
}

/// The lowest height that the programmed point reaches.
double tip_of(const ThreadPass& pass, const ThreadGround& g) {
    const sim::turning::Move line = line_of(pass.way);
    return std::min(geom::dot(line.from, g.out), geom::dot(line.to, g.out));
}

/// How far a thread may reach below the contour.
double room_below(const ThreadGround& g) {
    const double deepest = deepest_thread * g.lead;
    if (!g.shows_core()) return deepest;
    return std::clamp(deepest - (g.crest - g.contour), 0.0, root_tolerance * g.lead);
}

/// Where the part stands higher than the thread does, over more than a run-out or higher than a thread is deep.
Region in_shoulder(const Region& met, const ThreadGround& g, double tip, double tolerance) {
    const double skin = (g.shows_core() ? g.contour : g.crest) + tolerance;
    Region all;
    for (const Region& piece : geom::pieces(geom::intersect(met, block(g, -far, far, skin, far)))) {
        const Extent e = extent_of(piece, g);
        const bool runs_out =
            e.s1 - e.s0 <= din_run_out * g.lead && e.high - tip <= deepest_thread * g.lead + tolerance;
        if (runs_out) continue;
        const Region part = geom::intersect(met, block(g, e.s0, e.s1, -far, far));
        all = all.empty() ? part : geom::unite(all, part);
    }
    return all;
}

}  // namespace

std::string too_deep(double lead) {
    return "a thread of " + plain(lead) + " mm pitch is at most " + mm(deepest_thread * lead) + " deep";
}

bool ThreadGround::shows_core() const { return crest - contour > turned_off * lead; }

Vec2 thread_direction(const sim::turning::Move& way) {
    const sim::turning::Move line = line_of(way);
    const Vec2 d = line.to - line.from;
    const double z = std::abs(d.x), x = std::abs(d.y);
    if (!(geom::length(d) > 0) || (x > steep * z && z > steep * x)) return {d.x < 0 ? -1.0 : 1.0, 0};
    return (1 / geom::length(d)) * d;
}

std::optional<ThreadGround> thread_ground(const ThreadPass& pass, const Region& part,
                                          const std::optional<ThreadGround>& before) {
    const sim::turning::Move line = line_of(pass.way);
    if (geom::distance(line.from, line.to) < thinnest_surface || pass.lead <= 0 || before) return before;
    ThreadGround g;
    g.along = thread_direction(pass.way);
    g.out = out_of(pass, g.along);
    g.lead = pass.lead * std::abs(geom::dot(g.along, line.to - line.from)) / geom::distance(line.from, line.to);
    const Columns band(pass.band, g.along, g.out), contour(part, g.along, g.out);
    std::vector<double> corners;
    band.add_corners(-far, far, corners);
    if (corners.empty()) return std::nullopt;
    const auto [lo, hi] = std::minmax_element(corners.begin(), corners.end());
    contour.add_corners(*lo, *hi, corners);
    const auto run = first_run(band, contour, corners, g.lead);
    if (!run) return std::nullopt;
    g.crest = run->crest;
    g.contour = run->contour;
    return g;
}

std::optional<ThreadFault> thread_fault(const ThreadPass& pass, const ThreadGround& g, const Region& part,
                                        double tolerance) {
    const Region met = geom::intersect(pass.band, part);
    const double tip = tip_of(pass, g), below = g.contour - tip;
    if (below > room_below(g) + tolerance) {
        ThreadFault fault{geom::intersect(met, block(g, -far, far, -far, g.contour)), {}, {}};
        if (!g.shows_core()) {
            fault.why = too_deep(g.lead);
        } else {
            fault.why = "the part's contour lies " + mm(g.crest - g.contour) +
                        " below the surface that the thread is cut into, so it shows the bottom of the thread";
            fault.remedy = "correct the depth of the thread; where the contour is to show the crest, draw it there";
        }
        return fault;
    }
    if (Region shoulder = in_shoulder(met, g, tip, tolerance); !shoulder.empty())
        return ThreadFault{std::move(shoulder), "the part is higher there than where the thread begins",
                           "end the thread before the shoulder, or draw the part as far as the thread goes"};
    return std::nullopt;
}

Region thread_ridges(const ThreadPass& pass, const ThreadGround& g) {
    if (!g.shows_core()) return {};
    return geom::intersect(pass.band, block(g, -far, far, -far, g.contour + deepest_thread * g.lead));
}

double root_width(const ThreadPass& pass, const ThreadGround& g) {
    const geom::Contour shape = pass.outline;
    Region outline{{shape}};
    if (is_beyond(pass.way)) {
        for (geom::Vertex& v : outline.contours[0].vertices) v = {mirrored(v.p), -v.bulge};
        outline.contours[0] = geom::reversed(outline.contours[0]);
    }
    double low = INFINITY;
    for (const Edge& e : geom::edges(outline)) low = std::min(low, geom::dot(e.a, g.out));
    const Extent e = extent_of(geom::intersect(outline, block(g, -far, far, low - 1, low + root * g.lead)), g);
    return std::max(0.0, e.s1 - e.s0);
}

}  // namespace obrys::check
