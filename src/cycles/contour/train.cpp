/// Contour train. Source: parameters of 25 and 270 as in dialect/heidenhain/cycle_parameters. From memory of the iTNC
/// 530 cycle manual, not found again in the sources at hand: Q15 +1 climb, -1 up-cut, 0 both by turns (spindle
/// clockwise); Q390 1 tangential arc, 2 tangential line, 3 square on; Q391 0 none, 1 left, 2 right. The side of the
/// contour is the programmed one, so that the sense of milling decides which way the contour is run. Without 270 the
/// tool goes down on the path's first point.

#include "cycles/contour/train.hpp"

#include <algorithm>
#include <cmath>

#include "cycles/mill/milling.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {

namespace {

using geom::Contour;
using geom::Edge;
using geom::Vec2;

struct Train {
    double top = 0, bottom = 0, safe = 0, infeed = 0, plunge = 0, mill = 0;
    double away = 0;  ///< of the tool's centre from the contour
    int side = 0;
    int sense = 0;  ///< +1 climb, -1 up-cut, 0 by turns
    int approach = 0;
    double approach_radius = 0, approach_angle = 0, distance = 0;
};

Train read_train(Course& c, const Situation& s, int programmed_side) {
    Train t;
    t.top = c.need(Role::surface);
    t.bottom = t.top + c.depth();
    t.safe = c.need(Role::clearance_height);
    if (t.safe < t.top) c.fault(Role::clearance_height, "the clearance height lies below the workpiece surface");
    t.infeed = c.step(Role::infeed);
    t.plunge = c.feed(Role::feed_plunge);
    t.mill = c.feed(Role::feed_mill);
    t.sense = c.whole(Role::direction, 1, -1, 1, "the type of milling");
    const int choice =
        c.whole(Role::compensation, programmed_side < 0 ? 2 : programmed_side, 0, 2, "radius compensation");
    t.side = choice == 2 ? -1 : choice;
    const double radius = milling_radius(c, s);
    t.away = radius + c.maybe(Role::allowance_side, 0);
    if (t.away < 0) c.fault(Role::allowance_side, "the negative allowance is larger than the tool radius");
    c.known(s.at.z, "the tool's height");
    t.approach = c.whole(Role::approach, 0, 0, 3, "the type of approach");
    t.approach_radius = c.maybe_at_least(Role::approach_radius, 0, 0);
    t.approach_angle = geom::radians(c.maybe_at_least(Role::approach_angle, 0, 0));
    t.distance = c.maybe_at_least(Role::auxiliary_distance, 0, 0);
    return t;
}

/// The programmed contour, asked many times whether a point is too near to it.
class Guard {
public:
    explicit Guard(const Contour& c) : chain_(geom::edges(c)) {
        for (const Edge& e : chain_) boxes_.push_back(geom::box(e));
    }
    [[nodiscard]] const std::vector<Edge>& chain() const { return chain_; }
    [[nodiscard]] bool keeps(Vec2 p, double away) const {
        for (std::size_t i = 0; i < chain_.size(); ++i)
            if (geom::contains(boxes_[i], p, away) && geom::distance(chain_[i], p) < away - 1e-6) return false;
        return true;
    }

private:
    std::vector<Edge> chain_;
    std::vector<geom::Box> boxes_;
};

/// The element that the tool cannot follow anywhere, if there is one.
const Edge* lost_element(const Guard& guard, double by) {
    constexpr int samples = 32;
    for (const Edge& e : guard.chain()) {
        bool followed = false;
        for (int i = 0; i <= samples && !followed; ++i) {
            const double t = static_cast<double>(i) / samples;
            followed = guard.keeps(geom::point_at(e, t) + by * geom::left_of(geom::tangent_at(e, t)), std::abs(by));
        }
        if (!followed) return &e;
    }
    return nullptr;
}

/// The closed chain, cut open at the point of it nearest to `start`.
Contour opened_at(const std::vector<Edge>& chain, Vec2 start) {
    std::size_t best = 0;
    for (std::size_t i = 0; i < chain.size(); ++i)
        if (geom::distance(chain[i], start) < geom::distance(chain[best], start)) best = i;
    const double t = std::clamp(geom::parameter(chain[best], start), 0.0, 1.0);
    Contour out{{}, false};
    const auto add = [&](const Edge& e) {
        if (geom::chord(e) > 0) out.vertices.push_back({e.a, e.bulge});
    };
    if (t < 1) add(geom::part(chain[best], t, 1));
    for (std::size_t i = 1; i < chain.size(); ++i) add(chain[(best + i) % chain.size()]);
    if (t > 0) add(geom::part(chain[best], 0, t));
    out.vertices.push_back({out.vertices.front().p});
    return out;
}

/// The one path along the contour as it is programmed; empty after a complaint.
Contour path_of(Course& c, const Contour& contour, const Guard& guard, const Train& t) {
    const std::vector<Edge>& source = guard.chain();
    const double by = t.side * t.away;
    if (source.empty()) {
        c.fault("the contour has no element");
        return {};
    }
    const std::vector<Contour> found = geom::equidistants(contour, by);
    const Edge* lost = by != 0 ? lost_element(guard, by) : nullptr;
    if (lost != nullptr || found.size() != 1) {
        const Vec2 place = lost != nullptr ? geom::point_at(*lost, 0.5)
                           : found.empty() ? source.front().a
                                           : found.front().vertices.back().p;
        c.fault("tool radius too large: the tool cannot follow the contour at " + place_text(place),
                "use a smaller tool");
        return {};
    }
    if (!found[0].closed) return found[0];
    const Vec2 start = source.front().a + by * geom::left_of(geom::tangent_at(source.front(), 0));
    return opened_at(geom::edges(found[0]), start);
}

/// From a point beside the path onto its start; `side`: of the tool, seen along the path. Run back to front it leaves.
std::vector<Edge> approach_of(const Train& t, Vec2 start, Vec2 ahead, int side) {
    if (t.approach == 1 && t.approach_radius > 0 && t.approach_angle > 0) {
        const double way = side < 0 ? -1 : 1;
        const Vec2 centre = start + way * t.approach_radius * geom::left_of(ahead), r = start - centre;
        const double turn = way * t.approach_angle, cosine = std::cos(-turn), sine = std::sin(-turn);
        const Vec2 from = centre + Vec2{cosine * r.x - sine * r.y, sine * r.x + cosine * r.y};
        return {{from, start, std::tan(turn / 4)}};
    }
    if (t.approach == 2 && t.distance > 0) return {{start - t.distance * ahead, start, 0}};
    if (t.approach == 3 && t.distance > 0) return {{start + side * t.distance * geom::left_of(ahead), start, 0}};
    return {};
}

/// Path with its approach and departure, run one way.
Contour run_of(Course& c, const Contour& path, const Train& t, const Guard& guard, bool forward) {
    const Contour run = forward ? path : geom::reversed(path);
    const std::vector<Edge> chain = geom::edges(run);
    const int side = forward ? t.side : -t.side;
    std::vector<Edge> all = approach_of(t, chain.front().a, geom::tangent_at(chain.front(), 0), side);
    std::vector<Edge> leave = approach_of(t, chain.back().b, -geom::tangent_at(chain.back(), 1), -side);
    for (Edge& e : leave) e = geom::reversed(e);
    for (const auto* extra : {&all, &leave})
        for (const Edge& e : *extra)
            for (int i = 0; i <= 16; ++i)
                if (t.side != 0 && !guard.keeps(geom::point_at(e, i / 16.0), t.away)) {
                    c.fault(Role::approach, "the approach or departure would cut into the contour at " +
                                                place_text(geom::point_at(e, i / 16.0)));
                    return run;
                }
    all.insert(all.end(), chain.begin(), chain.end());
    all.insert(all.end(), leave.begin(), leave.end());
    Contour out{{}, false};
    for (const Edge& e : all) out.vertices.push_back({e.a, e.bulge});
    out.vertices.push_back({all.back().b});
    return out;
}

}  // namespace

void expand_contour_train(Course& c, const Situation& s, const ContourTrain& train) {
    const Train t = read_train(c, s, train.side);
    if (!c.ready()) return;
    const std::vector<double> levels = even_levels(c, t.top, t.bottom, t.infeed);
    const Guard guard(train.contour);
    const Contour path = path_of(c, train.contour, guard, t);
    if (!c.ready()) return;
    if (t.approach == 0) c.assume("the tool goes down on the first point of the compensated contour");
    // Climb: the tool on the left of its way; on the contour itself as it is programmed.
    const bool climb_is_forward = t.side >= 0;
    const bool first = t.side == 0 || (t.sense >= 0) == climb_is_forward;
    const Contour there = run_of(c, path, t, guard, first);
    const Contour back = t.sense == 0 ? run_of(c, path, t, guard, !first) : there;
    if (!c.ready()) return;
    bool forward = true;
    for (const double level : levels) {
        if (!c.room()) return;
        const Contour& run = forward ? there : back;
        const Vec2 start = run.vertices.front().p;
        if (geom::distance(start, {c.at().x, c.at().y}) > 1e-9 || level == levels.front()) {
            c.rapid_w(std::max(t.safe, c.at().z));
            c.rapid({start.x, start.y, c.at().z});
            c.rapid_w(t.safe);
        }
        c.move_w(level, t.plunge);
        follow(c, run, level, t.mill);
        if (t.sense == 0) forward = !forward;
    }
    c.rapid_w(t.safe);
}

}  // namespace obrys::cycles
