#include "sim/milling/cut/covered.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/whole.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double same_place = 1e-9;  ///< mm
constexpr double grid = 1e-6;        ///< mm: ways are looked for among those that are the same to so much

struct Way {
    std::uint64_t key = 0;  ///< equal where tool and way, seen along the axis, and slope are the same
    double height = 0;      ///< of the first tip along the axis
    std::uint32_t number = 0;
};

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    a = (a ^ b) * 0x9E3779B97F4A7C15U;
    return a ^ a >> 29U;
}

std::uint64_t mixed(std::uint64_t key, double length) {
    return mixed(key, static_cast<std::uint64_t>(
                          base::clipped<std::int64_t>(std::round(length / grid), -(1LL << 60), 1LL << 60)));
}

Way way_of(const Air::Sweep& body, std::uint32_t number) {
    const Vec3 from = body.frame.to_tool(body.from);
    Way w{body.shape->pieces.size(), from.z, number};
    for (const double at : {body.shape->radius, body.frame.z.x, body.frame.z.y, from.x, from.y, body.track.v.x,
                            body.track.v.y, body.track.v.z, body.track.circular ? body.track.radius : -1.0})
        w.key = mixed(w.key, at);
    return w;
}

/// The same but for its height.
bool is_level_of(const Air::Sweep& a, const Air::Sweep& b) {
    const auto near = [](geom::Vec2 p, geom::Vec2 q) { return geom::distance(p, q) <= same_place; };
    if (a.shape != b.shape || !(a.frame.z == b.frame.z) || !(a.frame.x == b.frame.x)) return false;
    const Vec3 p = a.frame.to_tool(a.from), q = b.frame.to_tool(b.from);
    const Track &s = a.track, &t = b.track;
    if (!near({p.x, p.y}, {q.x, q.y}) || geom::distance(s.v, t.v) > same_place || s.circular != t.circular)
        return false;
    return !s.circular || (near(s.centre, t.centre) && s.turn == t.turn && std::abs(s.radius - t.radius) <= same_place);
}

/// All along its way the tool stands out of the stock.
bool reaches_out(const Air::Sweep& body, const Box3& stock) {
    const double first = dot(body.frame.z, body.from), lowest = first + std::min(0.0, body.track.v.z);
    return lowest + body.shape->top >= heights_along(body.frame.z, stock).high;
}

}  // namespace

std::vector<std::uint8_t> covered(const Simulation& simulation, std::span<const Simulation::Whole> wholes) {
    std::vector<std::uint8_t> all(wholes.size(), 0);
    std::vector<Way> ways;
    ways.reserve(wholes.size());
    for (std::uint32_t n = 0; n < wholes.size(); ++n) {
        const Air::Sweep body = simulation.body_of(wholes[n]);
        if (body.shape->rising) ways.push_back(way_of(body, n));
    }
    std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
        return std::tie(a.key, a.height, a.number) < std::tie(b.key, b.height, b.number);
    });
    const Box3 stock = box_of(simulation.stock());
    for (std::size_t i = 0, next = 0; i < ways.size(); i = next) {
        next = i + 1;
        while (next < ways.size() && ways[next].key == ways[i].key) ++next;
        if (next == i + 1) continue;
        const Air::Sweep lowest = simulation.body_of(wholes[ways[i].number]);
        if (!reaches_out(lowest, stock)) continue;
        for (std::size_t k = i + 1; k < next; ++k)
            if (is_level_of(lowest, simulation.body_of(wholes[ways[k].number]))) all[ways[k].number] = 1;
    }
    return all;
}

}  // namespace obrys::sim::milling
