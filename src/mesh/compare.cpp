#include "mesh/compare.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"
#include "base/whole.hpp"

namespace obrys::mesh {

using geom::Vec3;
namespace {

/// The lowest and the highest of a triangle's deviations: of its corners (0 … 2) and its centre (3).
struct Extremes {
    double low = 0, high = 0;
    std::uint8_t low_at = 3, high_at = 3;

    [[nodiscard]] double largest() const { return std::abs(low) > std::abs(high) ? low : high; }
};

Vec3 place_of(const Mesh& m, std::size_t triangle, std::uint8_t at) {
    return at < 3 ? m.vertices[m.triangles[triangle][at]] : centre(m, triangle);
}

double judged(Vec3 p, double deviation, const CompareOptions& options) {
    if (!options.judged || (deviation >= -options.gouge && deviation <= options.excess)) return deviation;
    return options.judged(p, deviation);
}

/// From a place one can be no farther off than from another one, and the way between them.
double farthest_after(double deviation, Vec3 before, Vec3 place) {
    return std::nextafter((std::abs(deviation) + distance(before, place)) * (1 + 1e-12), HUGE_VAL);
}

std::vector<double> of_vertices(const Mesh& result, const Distance& part) {
    std::vector<double> d(result.vertices.size());
    base::in_pieces(d.size(), 1024, [&](const base::Piece& some) {
        double reach = HUGE_VAL;  // as far as the vertex before, and the way from there: they follow each other
        for (std::size_t v = some.begin(); v < some.end(); ++v) {
            if (v > some.begin()) reach = farthest_after(d[v - 1], result.vertices[v - 1], result.vertices[v]);
            d[v] = part.signed_distance(result.vertices[v], reach);
        }
    });
    return d;
}

Extremes extremes_of(const Mesh& result, std::size_t triangle, std::span<const double> vertices, const Distance& part,
                     const CompareOptions& options) {
    const Triangle& t = result.triangles[triangle];
    const Vec3 middle = centre(result, triangle);
    const double off = part.signed_distance(middle, farthest_after(vertices[t[0]], result.vertices[t[0]], middle));
    const double there = judged(middle, off, options);
    Extremes e{there, there, 3, 3};
    for (std::uint8_t c = 0; c < 3; ++c) {
        const double d = judged(result.vertices[t[c]], vertices[t[c]], options);
        if (d < e.low) e.low = d, e.low_at = c;
        if (d > e.high) e.high = d, e.high_at = c;
    }
    return e;
}

/// Vertices that belong together.
class Groups {
public:
    explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
    std::uint32_t root(std::uint32_t v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t ra = root(a), rb = root(b);
        parent_[std::max(ra, rb)] = std::min(ra, rb);
    }

private:
    std::vector<std::uint32_t> parent_;
};

struct Places {
    std::vector<Place> worst;
    std::size_t count = 0;
};

constexpr std::uint32_t none = 0xffffffff;
/// Triangles count for `Place::peak` whose corners or centre lie at least so far off, of the worst.
constexpr double near_worst = 0.9;

/// The tags of all places, of the triangles for which `counts(triangle, place)`. `place_of_root`: index in `places` by
/// the root of a triangle's group, `none` where it is not listed.
template <class Counts>
void share_out(const Mesh& m, Groups& groups, std::span<const std::uint32_t> place_of_root, Counts counts,
               std::vector<Place>& places, std::vector<TagShare> Place::*into) {
    struct Piece {
        std::uint32_t place, tag;
        double area;
    };
    std::vector<Piece> pieces;
    for (std::uint32_t t = 0; t < m.triangles.size(); ++t) {
        const std::uint32_t place = place_of_root[groups.root(m.triangles[t][0])];
        if (place != none && counts(t, places[place]))
            pieces.push_back({place, m.tag(t), 0.5 * length(area_vector(m, t))});
    }
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return a.place != b.place ? a.place < b.place : a.tag < b.tag;
    });
    for (const Piece& p : pieces) {
        std::vector<TagShare>& shares = places[p.place].*into;
        if (shares.empty() || shares.back().tag != p.tag) shares.push_back({p.tag, 0});
        shares.back().area += p.area;
    }
    for (Place& p : places)
        std::stable_sort((p.*into).begin(), (p.*into).end(),
                         [](const TagShare& a, const TagShare& b) { return a.area > b.area; });
}

/// Triangles that share vertices, one place each. `gouges`: those lower than -allowed, else those higher than allowed.
Places cluster(const Mesh& m, std::span<const Extremes> extremes, bool gouges, double allowed, std::size_t most) {
    const auto deviation = [&](std::size_t t) { return gouges ? -extremes[t].low : extremes[t].high; };
    Groups groups(m.vertices.size());
    for (std::size_t t = 0; t < extremes.size(); ++t) {
        if (!(deviation(t) > allowed)) continue;
        groups.join(m.triangles[t][0], m.triangles[t][1]);
        groups.join(m.triangles[t][0], m.triangles[t][2]);
    }
    Places places;
    std::vector<std::uint32_t> number(m.vertices.size(), none);
    for (std::uint32_t t = 0; t < extremes.size(); ++t) {
        if (!(deviation(t) > allowed)) continue;
        std::uint32_t& n = number[groups.root(m.triangles[t][0])];
        if (n == none) {
            n = static_cast<std::uint32_t>(places.worst.size());
            places.worst.emplace_back();
        }
        Place& p = places.worst[n];
        // Of triangles that meet in the worst point, one that a cut made rather than the stock's own.
        if (deviation(t) > std::abs(p.deviation) ||
            (deviation(t) == std::abs(p.deviation) && p.tag == 0 && m.tag(t) != 0)) {
            p.deviation = gouges ? extremes[t].low : extremes[t].high;
            p.at = place_of(m, t, gouges ? extremes[t].low_at : extremes[t].high_at);
            p.triangle = t;
            p.tag = m.tag(t);
        }
        ++p.triangles;
        p.area += 0.5 * length(area_vector(m, t));
        for (const Vec3& c : corners(m, t)) p.extent.add(c);
    }
    places.count = places.worst.size();
    std::vector<std::uint32_t> order(places.worst.size()), rank(places.worst.size(), none);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::abs(places.worst[a].deviation) > std::abs(places.worst[b].deviation);
    });
    order.resize(std::min(order.size(), most));
    std::vector<Place> worst;
    for (const std::uint32_t n : order) {
        rank[n] = static_cast<std::uint32_t>(worst.size());
        worst.push_back(std::move(places.worst[n]));
    }
    places.worst = std::move(worst);
    for (std::uint32_t& n : number)
        if (n != none) n = rank[n];
    share_out(
        m, groups, number, [&](std::size_t t, const Place&) { return deviation(t) > allowed; }, places.worst,
        &Place::shares);
    const auto is_peak = [&](std::size_t t, const Place& p) {
        return deviation(t) > allowed && deviation(t) >= near_worst * std::abs(p.deviation);
    };
    share_out(m, groups, number, is_peak, places.worst, &Place::peak);
    return places;
}

Colour mix(Colour a, Colour b, double t) {
    const auto between = [&](std::uint8_t x, std::uint8_t y) {
        return base::clipped<std::uint8_t>(x + t * (y - x), 0, 255);
    };
    return {between(a.red, b.red), between(a.green, b.green), between(a.blue, b.blue)};
}

}  // namespace

Comparison compare(const Mesh& result, const Distance& part, const CompareOptions& options) {
    const std::vector<double> vertices = of_vertices(result, part);
    std::vector<Extremes> extremes(result.triangles.size());
    base::in_pieces(extremes.size(), 512, [&](const base::Piece& some) {
        for (std::size_t t = some.begin(); t < some.end(); ++t)
            extremes[t] = extremes_of(result, t, vertices, part, options);
    });
    Comparison c;
    c.deviation.reserve(extremes.size());
    for (const Extremes& e : extremes) {
        c.deviation.push_back(e.largest());
        c.largest_gouge = std::max(c.largest_gouge, -e.low);
        c.largest_excess = std::max(c.largest_excess, e.high);
    }
    Places gouges = cluster(result, extremes, true, options.gouge, options.places);
    Places excesses = cluster(result, extremes, false, options.excess, options.places);
    if (options.doubt < 1) {
        const auto doubtful = [&](bool deep, double allowed) {
            Places all = cluster(result, extremes, deep, options.doubt * allowed, options.places);
            std::erase_if(all.worst, [&](const Place& p) { return std::abs(p.deviation) > allowed; });
            return std::move(all.worst);
        };
        c.doubtful_gouges = doubtful(true, options.gouge);
        c.doubtful_excesses = doubtful(false, options.excess);
    }
    c.gouges = std::move(gouges.worst), c.gouge_count = gouges.count;
    c.excesses = std::move(excesses.worst), c.excess_count = excesses.count;
    return c;
}

DeviationColours deviation_colours(std::span<const double> deviation, const CompareOptions& allowed, double full,
                                   std::size_t steps) {
    DeviationColours out;
    steps = std::clamp<std::size_t>(steps, 1, 1000);
    const auto share = [&](std::size_t i) {
        return steps > 1 ? static_cast<double>(i) / static_cast<double>(steps - 1) : 1;
    };
    out.palette.push_back(grey);
    for (std::size_t i = 0; i < steps; ++i) out.palette.push_back(mix({255, 214, 64}, {176, 0, 24}, share(i)));
    for (std::size_t i = 0; i < steps; ++i) out.palette.push_back(mix({150, 200, 255}, {16, 40, 140}, share(i)));
    const auto step = [&](double beyond, double range) {
        if (!(range > 0)) return steps - 1;
        return base::clipped<std::size_t>(beyond / range * static_cast<double>(steps), 0, steps - 1);
    };
    for (const double d : deviation) {
        std::size_t tag = 0;
        if (d < -allowed.gouge) tag = 1 + step(-d - allowed.gouge, full - allowed.gouge);
        if (d > allowed.excess) tag = 1 + steps + step(d - allowed.excess, full - allowed.excess);
        out.tags.push_back(static_cast<std::uint32_t>(tag));
    }
    return out;
}

}  // namespace obrys::mesh
